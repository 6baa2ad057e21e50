// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "widgets/scope/scopestretch.h"

class QComboBox;
class QLabel;

namespace nmc {

class ScopeStrips;
class SpectrumPlot;

/// The spectrum of one of the signals in the strips, between the cursors. It follows the cursors, and new
/// samples between them, as long as it is open. GUI thread.
class SpectrumDialog : public QDialog {
    Q_OBJECT

public:
    explicit SpectrumDialog(QWidget* parent);

    /// Returns false if the spectrum is not up to date yet, which needs another call.
    bool showSpectrum(const ScopeStrips& strips, const History& history);

signals:
    /// showSpectrum() must be called soon.
    void frameWanted();

private:
    void fillSignals(const std::vector<ScopePlot::Trace>& traces);
    /// Calculates the spectrum of m_points, and shows it, or why there is none.
    void calculate(const ScopePlot::Trace& trace, unsigned derivative, const QString& unit, bool kept);

    QComboBox* m_signal;
    SpectrumPlot* m_plot;
    QLabel* m_peak;
    QLabel* m_range;
    std::vector<ModuleSignal> m_signals;  ///< in the order of the box
    std::optional<ScopeStretch> m_shown;
    int m_pause = 0;                    ///< calls until the next spectrum of the same signal
    std::vector<SignalPoint> m_points;  ///< kept only so that its memory is used again
};

}  // namespace nmc
