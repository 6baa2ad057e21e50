// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/panelview.h"
#include "widgets/panels/statustable.h"

namespace nmc {

/// Every bit that a PIC-STEP tells by its data sheet name, the other status items, and the raw bytes.
class StepDetailsBox : public StatusTable {
    Q_OBJECT

public:
    explicit StepDetailsBox(QWidget* parent = nullptr);

    void showModule(const PanelView& view);
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    void showValues(const PanelView& view);
    void refresh();

    QLabel* m_mode = nullptr;
    QLabel* m_timer = nullptr;
    QLabel* m_analog = nullptr;
    QLabel* m_home = nullptr;
    QLabel* m_raw = nullptr;
    QPushButton* m_zero;
    QPushButton* m_saveHome;
    std::optional<Refusal> m_whyNotZero = Refusal::NotConnected;
    std::optional<Refusal> m_whyNotHome = Refusal::NotConnected;
    QString m_zeroMeaning;
    bool m_busy = false;
};

}  // namespace nmc
