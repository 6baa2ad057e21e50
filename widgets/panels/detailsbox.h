// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "widgets/panels/panelview.h"

class QGridLayout;
class QLabel;
class QPushButton;

namespace nmc {

class GlyphLabel;

/// Every status bit by its data sheet name, the other status items, and the raw bytes.
class DetailsBox : public QWidget {
    Q_OBJECT

public:
    explicit DetailsBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);

private:
    struct Bit {
        GlyphLabel* glyph = nullptr;
        QLabel* value = nullptr;
    };
    void addBits(QGridLayout* grid, int column, const QString& title, bool aux);
    QLabel* addValue(QGridLayout* grid, int line, const QString& label, const QString& objectName);
    void refresh();
    static void showBit(const Bit& bit, std::optional<bool> set);

    std::array<Bit, 8> m_status;
    std::array<Bit, 8> m_aux;
    QLabel* m_analog = nullptr;
    QLabel* m_velocity = nullptr;
    QLabel* m_home = nullptr;
    QLabel* m_raw = nullptr;
    QPushButton* m_clear;
    QString m_clearReason;
    bool m_busy = false;
};

}  // namespace nmc
