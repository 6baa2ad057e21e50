// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/panelview.h"
#include "widgets/panels/statustable.h"

namespace nmc {

/// Every status bit of a PIC-SERVO by its data sheet name, the other status items, and the raw bytes.
class DetailsBox : public StatusTable {
    Q_OBJECT

public:
    explicit DetailsBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    void showValues(const PanelView& view);
    void refresh();

    QLabel* m_analog;
    QLabel* m_velocity;
    QLabel* m_home;
    QLabel* m_raw;
    QPushButton* m_clear;
    QPushButton* m_saveHome;
    std::optional<Refusal> m_whyNotClear = Refusal::NotConnected;
    std::optional<Refusal> m_whyNotHome = Refusal::NotConnected;
    bool m_busy = false;
};

}  // namespace nmc
