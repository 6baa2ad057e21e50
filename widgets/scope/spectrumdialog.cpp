// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/spectrumdialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopestrips.h"
#include "widgets/scope/spectrumplot.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Frames between two spectra while samples arrive or a cursor is dragged: one takes up to 50 ms.
constexpr int kPause = 12;

/// Velocity and acceleration are made of several positions, which would hide what oscillates faster, so their
/// spectra are calculated from the positions.
unsigned derivativeOf(ScopeSignal signal) {
    return signal == ScopeSignal::Velocity ? 1 : signal == ScopeSignal::Acceleration ? 2 : 0;
}
}  // namespace

SpectrumDialog::SpectrumDialog(QWidget* parent)
    : QDialog(parent),
      m_signal(form::newChoice({.name = u"spectrumSignalBox"_s, .accessible = Common::tr("Signal")}, this)),
      m_plot(new SpectrumPlot(this)),
      m_peak(form::newParagraph(u"spectrumPeak"_s, tr("Peak"), this, 1)),
      m_range(form::newParagraph(u"spectrumRange"_s, {}, this, 1)) {
    setWindowTitle(tr("Spectrum between the cursors"));
    look::name(this, u"spectrumDialog"_s, windowTitle());
    m_signal->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_signal, &QComboBox::activated, this, &SpectrumDialog::frameWanted);
    form::fill(this,
               form::newColumn(
                   this, {form::newLine(this, {form::newLabel(tr("&Signal"), m_signal), m_signal, nullptr}),
                          form::Item(m_plot, 1), m_peak, m_range, buttons}),
               1);
}

void SpectrumDialog::fillSignals(const std::vector<ScopePlot::Trace>& traces) {
    const auto wanted = m_signal->currentIndex() >= 0
                            ? std::optional(m_signals[static_cast<std::size_t>(m_signal->currentIndex())])
                            : std::nullopt;
    QStringList labels;
    m_signals.clear();
    for (const ScopePlot::Trace& trace : traces) {
        labels << (trace.tag.isEmpty() ? trace.label : trace.label + u' ' + trace.tag);
        m_signals.push_back({trace.module, trace.signal});
    }
    QStringList before;
    for (int i = 0; i < m_signal->count(); ++i)
        before << m_signal->itemText(i);
    const QSignalBlocker quiet(m_signal);
    if (before != labels) {
        m_signal->clear();
        m_signal->addItems(labels);
    }
    const auto again = std::find(m_signals.begin(), m_signals.end(), wanted);
    if (!labels.empty())
        m_signal->setCurrentIndex(again != m_signals.end() ? static_cast<int>(again - m_signals.begin()) : 0);
}

bool SpectrumDialog::showSpectrum(const ScopeStrips& strips, const History& history) {
    if (!strips.cursors() || !history.zero())
        return true;
    std::vector<ScopePlot::Trace> traces;
    for (const ScopePlot* plot : strips.shownPlots())
        traces.insert(traces.end(), plot->traces().begin(), plot->traces().end());
    fillSignals(traces);
    if (traces.empty())
        return true;
    const ScopePlot::Trace& trace = traces[static_cast<std::size_t>(m_signal->currentIndex())];
    const unsigned derivative = derivativeOf(trace.signal);
    const auto source = strips.derived().source(
        history, {trace.module, derivative > 0 ? ScopeSignal::Position : trace.signal});
    if (source.samples == nullptr)
        return true;
    const ScopeStretch stretch = stretchOf(trace, *strips.cursors(), source, *history.zero());
    if (stretch == m_shown)
        return true;
    if (m_shown && m_shown->of == stretch.of && m_pause-- > 0)
        return false;
    m_shown = stretch;
    const bool kept = stretch.read(m_points);
    calculate(trace, derivative, texts::signalUnit(trace.signal, strips.modules()[trace.module.value()]),
              kept);
    m_pause = kPause;
    return true;
}

void SpectrumDialog::calculate(const ScopePlot::Trace& trace, unsigned derivative, const QString& unit,
                               bool kept) {
    const auto spectrum = spectrumOf(m_points, derivative);
    m_plot->showSpectrum(spectrum.value_or(Spectrum{}), trace.label);
    if (!spectrum) {
        look::setText(m_peak, {});
        look::setText(
            m_range,
            !kept ? tr("These samples are no longer kept individually. Move the cursors to newer ones.")
            : m_points.size() > kMostSpectrumSamples
                ? tr("%1 samples are between the cursors, and %2 are the most. Move the cursors closer together.")
                      .arg(texts::readout(static_cast<double>(m_points.size()), 6),
                           texts::readout(kMostSpectrumSamples, 6))
                : tr("Too few samples are between the cursors. Move them farther apart."));
        return;
    }
    look::setText(m_peak, spectrum->peak ? tr("Peak: %1 Hz, amplitude %2 %3")
                                               .arg(texts::readout(spectrum->peak->hertz, 4),
                                                    texts::readout(spectrum->peak->amplitude, 4), unit)
                                         : tr("No oscillation stands out from the noise."));
    look::setText(
        m_range,
        tr("From %1 Hz, two periods between the cursors, to %2 Hz, nearly half the rate of the samples.")
            .arg(texts::readout(spectrum->points.front().hertz, 3),
                 texts::readout(spectrum->points.back().hertz, 3)));
}

}  // namespace nmc
