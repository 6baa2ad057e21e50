// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class HoldButton;
class MotionBox;
class QuantityField;

/// Hold to move: motion only while a button is held, at a velocity that is low after every connect and never
/// above the axis's cap.
class JogBox : public QGroupBox {
    Q_OBJECT

public:
    /// The acceleration is that of `motion`.
    JogBox(ModuleContext& context, const MotionBox& motion, QWidget* parent);

private:
    void build();
    void hold(const HoldButton& button, bool reverse);
    [[nodiscard]] std::optional<bus::HoldToMove> wanted(bool reverse) const;
    [[nodiscard]] QString reasonFor(bool reverse) const;
    void endHold();
    void lookedForAnew();
    void showVelocity();
    void showModule();
    void refresh();

    ModuleContext& m_context;
    const MotionBox& m_motionBox;
    QuantityField* m_velocity = nullptr;
    HoldButton* m_forward = nullptr;
    HoldButton* m_reverse = nullptr;
    QLabel* m_hint = nullptr;
    std::optional<double> m_typed;  ///< native velocity, if it was typed since the last search for the chain
    MotionSettings m_motion;        ///< as shown
};

}  // namespace nmc
