// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QHash>
#include <optional>

#include "widgets/panels/panelview.h"

class QLabel;

namespace nmc {

class HoldButton;
class QuantityField;

/// Hold to move: motion only while a button is held, at a velocity that is low after every connect and never
/// above the axis's cap.
class JogBox : public QGroupBox {
    Q_OBJECT

public:
    explicit JogBox(QWidget* parent = nullptr);

    /// Emits nothing, except that a hold ends when its module or its permission goes. `acceleration`: empty
    /// while there is none.
    void showModule(const PanelView& view, std::optional<CountsPerTickSquared> acceleration);
    /// A new connection: low speeds again.
    void resetSpeeds();
    void endHold();
    void setHoldInterval(int milliseconds);

signals:
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();

private:
    void build();
    void hold(const HoldButton& button, bool reverse);
    void showVelocity(const MotionSettings& motion);
    void refresh();

    QuantityField* m_velocity = nullptr;
    HoldButton* m_forward = nullptr;
    HoldButton* m_reverse = nullptr;
    QLabel* m_hint = nullptr;
    QHash<int, double> m_typed;  ///< native velocity of each module, since the connection was made
    std::optional<ModuleState> m_module;
    MotionSettings m_motion;
    std::optional<CountsPerTickSquared> m_acceleration;
    bool m_connected = false;
};

}  // namespace nmc
