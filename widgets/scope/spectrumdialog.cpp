// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/spectrumdialog.h"

#include <QDialogButtonBox>
#include <QLabel>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/scope/spectrumplot.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

/// Velocity and acceleration are made of several positions, which would hide what oscillates faster, so their
/// spectra are calculated from the positions.
unsigned derivativeOf(ScopeSignal signal) {
    return signal == ScopeSignal::Velocity ? 1 : signal == ScopeSignal::Acceleration ? 2 : 0;
}

}  // namespace

SpectrumDialog::SpectrumDialog(QWidget* parent)
    : StretchDialog(u"spectrumDialog"_s, tr("Spectrum between the cursors"), parent),
      m_signal(newBox(u"spectrumSignalBox"_s, Common::tr("Signal"), 0)),
      m_plot(new SpectrumPlot(this)),
      m_peak(form::newParagraph(u"spectrumPeak"_s, tr("Peak"), this, 1)),
      m_range(form::newParagraph(u"spectrumRange"_s, {}, this, 1)) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form::fill(this,
               form::newColumn(
                   this, {form::newLine(this, {form::newLabel(tr("&Signal"), m_signal), m_signal, nullptr}),
                          form::Item(m_plot, 1), m_peak, m_range, buttons}),
               1);
}

ScopeSignal SpectrumDialog::readsFor(ScopeSignal signal) const {
    return derivativeOf(signal) > 0 ? ScopeSignal::Position : signal;
}

void SpectrumDialog::showSamples(const std::vector<Samples>& samples) {
    const Samples& signal = samples.front();
    const auto spectrum = spectrumOf(signal.points, derivativeOf(signal.trace.signal));
    m_plot->showSpectrum(spectrum.value_or(Spectrum{}), signal.trace.label);
    if (!spectrum) {
        look::setText(m_peak, {});
        // A stretch with enough samples may still be too short for two periods.
        look::setText(m_range,
                      signal.points.size() <= kMostSpectrumSamples && hasLongGap(signal.points)
                          ? tr("There is a long gap between the cursors. Move both to the same side of it.")
                          : whyNothing(signal, SIZE_MAX, kMostSpectrumSamples));
        return;
    }
    look::setText(m_peak, spectrum->peak ? tr("Peak: %1 Hz, amplitude %2 %3")
                                               .arg(texts::readout(spectrum->peak->hertz, 4),
                                                    texts::readout(spectrum->peak->amplitude, 4), signal.unit)
                                         : tr("No oscillation stands out from the noise."));
    look::setText(
        m_range,
        tr("From %1 Hz, two periods between the cursors, to %2 Hz, nearly half the rate of the samples.")
            .arg(texts::readout(spectrum->points.front().hertz, 3),
                 texts::readout(spectrum->points.back().hertz, 3)));
}

}  // namespace nmc
