// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/scope/stretchdialog.h"

class QLabel;

namespace nmc {

class SpectrumPlot;

/// The spectrum of one of the signals in the strips, between the cursors. GUI thread.
class SpectrumDialog : public StretchDialog {
    Q_OBJECT

public:
    explicit SpectrumDialog(QWidget* parent);

protected:
    [[nodiscard]] ScopeSignal readsFor(ScopeSignal signal) const override;
    void showSamples(const std::vector<Samples>& samples) override;

private:
    TraceBox* m_signal;
    SpectrumPlot* m_plot;
    QLabel* m_peak;
    QLabel* m_range;
};

}  // namespace nmc
