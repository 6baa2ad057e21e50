// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scope/xycurve.h"
#include "widgets/scope/recordplot.h"

namespace nmc {

/// One signal over another. What its base classes call time is the other signal here, in its unit.
class XyPlot : public RecordPlot {
    Q_OBJECT

public:
    explicit XyPlot(QWidget* parent = nullptr);

    /// `label`: both signals, with their units.
    void showCurve(std::vector<XyPoint> curve, const QString& label);

protected:
    void paintTraces(QPainter& painter) override;
    [[nodiscard]] View fitted() const override;

private:
    std::vector<XyPoint> m_curve;
};

}  // namespace nmc
