// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>

#include "bus/types.h"

namespace nmc {

/// The link's counters since the chain was found, and what each of them counts (link.md 2.5).
class CounterTable : public QTableWidget {
    Q_OBJECT

public:
    explicit CounterTable(QWidget* parent = nullptr);

    void showStatistics(const bus::LinkStatistics& statistics);

private:
    void addRow(const QString& key, const QString& meaning);
    void setValue(int row, const QString& value);
};

}  // namespace nmc
