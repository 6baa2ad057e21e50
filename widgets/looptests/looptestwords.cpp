// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/looptestwords.h"

#include <QCoreApplication>
#include <algorithm>

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
    if (std::ranges::any_of(points, &FrequencyPoint::limited))
        lines << LoopTestTexts::tr(
            "OL or IL cut off the filter's output while measuring: for small motions, the loop responds differently. Use a smaller amplitude or a lower speed.");
    return lines;
}

QString wouldDo(std::span<const FrequencyPoint> measured, std::span<const FrequencyPoint> predicted,
                LoopChange change) {
    switch (change) {
        case LoopChange::None:
            return LoopTestTexts::tr("Edit the gains to see what this loop would do with them.");
        case LoopChange::Rate:
            return LoopTestTexts::tr(
                "Not known for the gains in the fields: SR differs from that of the measurement.");
        case LoopChange::Deadband:
            return LoopTestTexts::tr(
                "Not known for the gains in the fields: DB differs from that of the measurement.");
        case LoopChange::Filter:
            break;
    }
    if (predicted.empty())
        return LoopTestTexts::tr(
            "Not known for the gains in the fields: OL or IL cut off the filter's output while measuring. Use a smaller amplitude.");
    QStringList parts = isUnstable(figuresOf(predicted))
                            ? QStringList{LoopTestTexts::tr("unstable, the motor would oscillate")}
                            : frequencyFigures(predicted).mid(1);
    if (predicted.size() == 1 && measured.size() > 1)
        parts << LoopTestTexts::tr("known only at %1 Hz").arg(readout(predicted.front().hertz, 3));
    else if (predicted.size() < measured.size())
        parts << LoopTestTexts::tr("known only from %1 to %2 Hz")
                     .arg(readout(predicted.front().hertz, 3), readout(predicted.back().hertz, 3));
    return LoopTestTexts::tr("With the gains in the fields: %1").arg(parts.join(u" · "));
}

}  // namespace nmc::texts
