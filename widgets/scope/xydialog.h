// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/scope/stretchdialog.h"

class QLabel;

namespace nmc {

class XyPlot;

/// One of the signals in the strips over another one, between the cursors. GUI thread.
class XyDialog : public StretchDialog {
    Q_OBJECT

public:
    explicit XyDialog(QWidget* parent);

protected:
    void showSamples(const std::vector<Samples>& samples) override;

private:
    TraceBox* m_x;
    TraceBox* m_y;
    XyPlot* m_plot;
    QLabel* m_hint;
};

}  // namespace nmc
