// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <functional>
#include <vector>

#include "bus/types.h"

namespace nmc {

/// The link's counters since the chain was found, and what each of them counts (link.md 2.5).
class CounterTable : public QTableWidget {
    Q_OBJECT

public:
    explicit CounterTable(QWidget* parent = nullptr);

    void showStatistics(const bus::LinkStatistics& statistics);

private:
    using Value = std::function<QString(const bus::LinkStatistics&)>;
    void addCount(const QString& meaning, std::uint64_t bus::LinkStatistics::*counter);
    void addRow(const QString& meaning, Value value);

    std::vector<Value> m_values;  ///< of each row
};

}  // namespace nmc
