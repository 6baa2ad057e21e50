// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class HoldButton;
class QuantityField;

/// Hold to move for a PIC-STEP: velocity profile mode at a speed that is low after every connect and never
/// above a cap.
class StepperHoldBox : public QWidget {
    Q_OBJECT

public:
    StepperHoldBox(ModuleContext& context, QWidget* parent);

    void endHold();
    /// Width of the label, for aligning the fields above it.
    [[nodiscard]] int labelWidth() const;

private:
    void lookedForAnew();
    void showModule();
    void showSpeed();
    void hold(const HoldButton& button, bool reverse);
    void refresh();
    [[nodiscard]] std::optional<steppermotion::VelocityProfile> motion(bool reverse) const;
    [[nodiscard]] QString reasonFor(bool reverse) const;

    ModuleContext& m_context;
    QLabel* m_label;
    QuantityField* m_speed;
    QLabel* m_outcome;
    HoldButton* m_forward;
    HoldButton* m_reverse;
    std::optional<double> m_typed;  ///< steps/s, if it was typed since the last search for the chain
    double m_slowest = 0;
    double m_cap = 0;
};

}  // namespace nmc
