// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;

namespace nmc {

class NumberField;

/// PWM mode, set apart from the motions: the value drives the motor directly, and nothing limits it.
class PwmBox : public QWidget {
    Q_OBJECT

public:
    explicit PwmBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    void drive(bool reverse);
    void refresh();

    NumberField* m_value;
    QLabel* m_percent;
    QPushButton* m_reverse;
    QPushButton* m_forward;
    QPushButton* m_off;
    std::optional<ModuleState> m_module;
    bool m_connected = false;
    bool m_busy = false;
};

}  // namespace nmc
