// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QWidget>
#include <optional>

#include "widgets/panels/panelview.h"

class QLabel;

namespace nmc {

class HoldButton;
class QuantityField;

/// Hold to move of a PIC-STEP: velocity profile mode at a speed that is low after every connect and stays
/// below a cap.
class StepHoldBox : public QWidget {
    Q_OBJECT

public:
    explicit StepHoldBox(QWidget* parent = nullptr);

    /// Emits nothing, except that a hold ends when its module or its permission goes.
    void showModule(const PanelView& view);
    void resetSpeeds();
    void endHold();
    void setHoldInterval(int milliseconds);
    /// For what stands above it in line.
    [[nodiscard]] int labelWidth() const;

signals:
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();

private:
    void showSpeed();
    void hold(const HoldButton& button, bool reverse);
    void refresh();
    [[nodiscard]] std::optional<stepmotion::VelocityProfile> motion(bool reverse) const;
    [[nodiscard]] QString reasonFor(bool reverse) const;

    QLabel* m_label;
    QuantityField* m_speed;
    QLabel* m_outcome;
    HoldButton* m_forward;
    HoldButton* m_reverse;
    QHash<int, double> m_speeds;  ///< steps/s, per module, of this connection
    std::optional<ModuleState> m_state;
    double m_slowest = 0;
    double m_cap = 0;
    int m_accelerationTime = 0;
    bool m_connected = false;
};

}  // namespace nmc
