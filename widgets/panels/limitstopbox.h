// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <array>

#include "widgets/panels/panelview.h"

class QAbstractButton;
class QLabel;
class QPushButton;

namespace nmc {

/// Homing used as a safety stop (DS-V 5.2), because on a PIC-SERVO a limit input does not stop the motor by
/// itself: armed, not armed, or come true.
class LimitStopBox : public QGroupBox {
    Q_OBJECT

public:
    explicit LimitStopBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    void refresh();
    void refreshState();
    [[nodiscard]] intent::ArmLimitStop wanted() const;
    [[nodiscard]] QString whyNotArmed() const;

    QAbstractButton* m_limit1;
    QAbstractButton* m_limit2;
    std::array<QAbstractButton*, 3> m_manners{};  ///< by HomingRecipe::Stop
    QPushButton* m_arm;
    QPushButton* m_disarm;
    QLabel* m_state;
    ModuleState m_module;
    bool m_connected = false;
    bool m_homing = false;
    bool m_busy = false;
};

}  // namespace nmc
