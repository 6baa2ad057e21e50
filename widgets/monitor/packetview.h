// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>
#include <vector>

#include "bus/exchangerecord.h"

namespace nmc {

class PacketModel;

/// The packets as they arrive: follows the newest until the user scrolls up, and again once the user has
/// scrolled back to the end.
class PacketView : public QTableView {
    Q_OBJECT

public:
    PacketView(PacketModel& model, QWidget* parent);

    void append(std::vector<bus::ExchangeRecord> records);
    /// The selected rows, or all rows if none is selected, one line each; empty if there are none.
    [[nodiscard]] QString selectedText() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

signals:
    void copyRequested();

private:
    void fitRows();
    void fitColumns();

    PacketModel& m_model;
};

}  // namespace nmc
