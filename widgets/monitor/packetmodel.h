// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QFont>
#include <deque>
#include <vector>

#include "model/packets/packetlog.h"

namespace nmc {

/// The packet log as a table: one row for each exchange that passes the filter, oldest first.
class PacketModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Time, Target, Purpose, Command, Meaning, Reply, ReplyMeaning, Verdict, kColumns };

    explicit PacketModel(QObject* parent = nullptr);

    /// Starts a new connection and removes the rows of the previous one.
    void begin(const PacketSession& session);
    void clear();
    /// Notes that recording was interrupted; the next row says so.
    void interrupt() { m_log.interrupt(); }
    /// Returns how many rows were removed at the top to make room.
    int append(std::vector<bus::ExchangeRecord> records);
    void setFilter(const PacketFilter& filter);

    [[nodiscard]] const PacketLog& log() const { return m_log; }
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// The row as one line of text.
    [[nodiscard]] QString line(int row) const;

private:
    [[nodiscard]] QString text(const bus::ExchangeRecord& record, int column) const;
    int dropRows();
    void addRows(std::uint64_t from);

    PacketLog m_log;
    PacketFilter m_filter;
    std::deque<std::uint64_t> m_rows;  ///< entry numbers in the log
    QFont m_fixed;
};

}  // namespace nmc
