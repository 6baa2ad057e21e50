// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scope/spectrum.h"
#include "widgets/scope/recordplot.h"

namespace nmc {

/// The amplitudes of a signal over the frequency, with its peak marked. What its base classes call time is
/// frequency here, in Hz.
class SpectrumPlot : public RecordPlot {
    Q_OBJECT

public:
    explicit SpectrumPlot(QWidget* parent = nullptr);

    /// `label`: of the signal, with its unit.
    void showSpectrum(const Spectrum& spectrum, const QString& label);

protected:
    void paintTraces(QPainter& painter) override;
    void showEverything() override;
    /// Up to ten times the frequency of the peak.
    [[nodiscard]] View fitted() const override;

private:
    Spectrum m_spectrum;
};

}  // namespace nmc
