// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

#include "model/intent/jog.h"
#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class HoldButton;
class QuantityField;

/// Hold to move: motion only while a button is held, at a speed that is low after every connect and never
/// above the axis's cap.
class JogBox : public QGroupBox {
    Q_OBJECT

public:
    /// The object names of a stepper's controls begin with "stepper".
    JogBox(ModuleContext& context, QWidget* parent);

    /// To be called whenever a hold in progress was requested with a value that has changed since.
    void endHold();

private:
    [[nodiscard]] HoldButton* newHold(bool reverse);
    [[nodiscard]] std::optional<bus::HoldToMove> wanted(bool reverse, double share = 1) const;
    [[nodiscard]] QString reasonFor(bool reverse) const;
    [[nodiscard]] QString outcome() const;
    void lookedForAnew();
    void showSpeed();
    void showModule();
    void refresh();

    ModuleContext& m_context;
    QuantityField* m_speed;
    HoldButton* m_reverse;
    HoldButton* m_forward;
    QLabel* m_outcome;
    std::optional<double> m_typed;  ///< native speed, if it was typed since the last search for the chain
    JogRange m_range;               ///< as shown
};

}  // namespace nmc
