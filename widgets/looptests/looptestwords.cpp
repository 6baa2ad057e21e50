// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/looptestwords.h"

#include <QCoreApplication>

#include "widgets/common/words.h"

namespace nmc::texts {

namespace {
class LoopTestTexts {
    Q_DECLARE_TR_FUNCTIONS(LoopTestTexts)
};
}  // namespace

QStringList frequencyFigures(std::span<const FrequencyPoint> points) {
    if (points.empty())
        return {};
    const FrequencyFigures figures = figuresOf(points);
    QStringList lines;
    lines << LoopTestTexts::tr("%n frequencies up to %1 Hz", nullptr, static_cast<int>(points.size()))
                 .arg(readout(points.back().hertz, 3));
    lines << (figures.bandwidth
                  ? LoopTestTexts::tr("Bandwidth (-3 dB) %1 Hz").arg(readout(*figures.bandwidth, 3))
                  : LoopTestTexts::tr("Bandwidth (-3 dB) not reached"));
    lines << LoopTestTexts::tr("Resonance %1 dB").arg(readout(figures.resonance, 2));
    lines << (figures.phaseMargin ? LoopTestTexts::tr("Phase margin %1° at %2 Hz")
                                        .arg(readout(*figures.phaseMargin, 2), readout(*figures.crossover, 3))
                                  : LoopTestTexts::tr("Phase margin not reached"));
    lines << (figures.gainMargin ? LoopTestTexts::tr("Gain margin %1").arg(readout(*figures.gainMargin, 2))
                                 : LoopTestTexts::tr("Gain margin not reached"));
    return lines;
}

}  // namespace nmc::texts
