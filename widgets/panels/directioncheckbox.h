// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;

namespace nmc {

/// Whether motor and encoder of a PIC-SERVO go the same way, to be found out before it is enabled for the
/// first time (model/procedure/directioncheck.h). It asks before the motor is pushed, and forbids nothing.
class DirectionCheckBox : public QGroupBox {
    Q_OBJECT

public:
    explicit DirectionCheckBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    /// A click was passed on; another check waits for the module's next word.
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    void ask();
    void refresh();
    [[nodiscard]] bool running() const;
    [[nodiscard]] QString whyNotNow() const;
    [[nodiscard]] QString question() const;
    [[nodiscard]] QString state() const;

    QPushButton* m_check;
    QPushButton* m_cancel;
    QLabel* m_state;
    ModuleState m_module;
    AxisUnit m_unit;
    AxisScale m_scale;
    std::optional<ProcedureReport> m_report;  ///< of the last check of this module
    bool m_known = false;                     ///< a module is shown
    bool m_connected = false;
    bool m_busy = false;
};

}  // namespace nmc
