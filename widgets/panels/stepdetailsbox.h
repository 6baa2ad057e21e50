// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "widgets/panels/panelview.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace nmc {

class GlyphLabel;

/// Every bit that a PIC-STEP tells by its data sheet name, the other status items, and the raw bytes.
class StepDetailsBox : public QWidget {
    Q_OBJECT

public:
    explicit StepDetailsBox(QWidget* parent = nullptr);

    void showModule(const PanelView& view);
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    struct Bit {
        GlyphLabel* glyph = nullptr;
        QLabel* value = nullptr;
    };
    void addBits(QGridLayout* grid, int column, const QString& title, bool inputs);
    QLabel* addValue(QGridLayout* grid, int line, const QString& label, const QString& objectName);
    static void showBit(const Bit& bit, std::optional<bool> set);
    void showValues(const PanelView& view);
    void refresh();

    std::array<Bit, 8> m_status;
    std::array<Bit, 8> m_inputs;
    QLabel* m_mode = nullptr;
    QLabel* m_timer = nullptr;
    QLabel* m_analog = nullptr;
    QLabel* m_home = nullptr;
    QLabel* m_raw = nullptr;
    QPushButton* m_zero;
    QPushButton* m_saveHome;
    std::optional<Refusal> m_whyNotZero = Refusal::NotConnected;
    std::optional<Refusal> m_whyNotHome = Refusal::NotConnected;
    bool m_busy = false;
};

}  // namespace nmc
