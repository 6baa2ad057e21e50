// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/packetmodel.h"

#include <QFontDatabase>
#include <QGuiApplication>
#include <QPalette>

#include "protocol/describe.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString hex(const std::vector<std::uint8_t>& bytes) {
    return QString::fromStdString(toHex(bytes));
}

}  // namespace

PacketModel::PacketModel(QObject* parent)
    : QAbstractTableModel(parent), m_fixed(QFontDatabase::systemFont(QFontDatabase::FixedFont)) {}

void PacketModel::begin(const PacketSession& session) {
    beginResetModel();
    m_log.begin(session);
    m_rows.clear();
    endResetModel();
}

void PacketModel::clear() {
    beginResetModel();
    m_log.clear();
    m_rows.clear();
    endResetModel();
}

int PacketModel::append(std::vector<bus::ExchangeRecord> records) {
    const std::uint64_t from = m_log.end();
    for (bus::ExchangeRecord& record : records)
        m_log.append(std::move(record));
    const int dropped = dropRows();
    addRows(from);
    return dropped;
}

int PacketModel::dropRows() {
    const auto kept = std::lower_bound(m_rows.begin(), m_rows.end(), m_log.first());
    const int count = static_cast<int>(kept - m_rows.begin());
    if (count == 0)
        return 0;
    beginRemoveRows({}, 0, count - 1);
    m_rows.erase(m_rows.begin(), kept);
    endRemoveRows();
    return count;
}

void PacketModel::addRows(std::uint64_t from) {
    std::vector<std::uint64_t> added;
    for (std::uint64_t i = std::max(from, m_log.first()); i < m_log.end(); ++i)
        if (m_filter.passes(m_log.at(i).record))
            added.push_back(i);
    if (added.empty())
        return;
    const int first = rowCount();
    beginInsertRows({}, first, first + static_cast<int>(added.size()) - 1);
    m_rows.insert(m_rows.end(), added.begin(), added.end());
    endInsertRows();
}

void PacketModel::setFilter(const PacketFilter& filter) {
    if (filter == m_filter)
        return;
    beginResetModel();
    m_filter = filter;
    m_rows.clear();
    for (std::uint64_t i = m_log.first(); i < m_log.end(); ++i)
        if (m_filter.passes(m_log.at(i).record))
            m_rows.push_back(i);
    endResetModel();
}

int PacketModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int PacketModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QString PacketModel::text(const bus::ExchangeRecord& record, int column) const {
    switch (static_cast<Column>(column)) {
        case Time:
            return QString::fromStdString(packetTime(record.sent, m_log.session().zero));
        case Target:
            return texts::packetTarget(record);
        case Purpose:
            return texts::purpose(record.purpose);
        case Command:
            return hex(record.command);
        case Meaning:
            return QString::fromStdString(describeCommand(record.layout.module, record.command));
        case Reply:
            return hex(record.reply);
        case ReplyMeaning:
            return QString::fromStdString(packetReplyMeaning(record));
        case Verdict:
            return texts::verdict(record);
        case kColumns:
            break;
    }
    return {};
}

QVariant PacketModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const std::uint64_t number = m_rows[static_cast<std::size_t>(index.row())];
    if (number < m_log.first())
        return {};  // the log has dropped it, and the row is about to go
    const PacketEntry& entry = m_log.at(number);
    const int column = index.column();
    const bool gap = entry.afterGap && column == Time;
    if (role == Qt::DisplayRole)
        return gap ? u"⋯ "_s + text(entry.record, column) : text(entry.record, column);
    if (role == Qt::ToolTipRole)
        return gap ? texts::packetGap() : text(entry.record, column);
    if (role == Qt::FontRole && (column == Time || column == Command || column == Reply))
        return m_fixed;
    if (role == Qt::TextAlignmentRole && column == Time)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::BackgroundRole && wentWrong(entry.record))
        return look::severityTint(Severity::Attention, QGuiApplication::palette());
    return {};
}

QVariant PacketModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (static_cast<Column>(section)) {
        case Time:
            return tr("Time (s)");
        case Target:
            return tr("Sent to");
        case Purpose:
            return tr("Purpose");
        case Command:
            return Common::tr("Command");
        case Meaning:
        case ReplyMeaning:
            return tr("Meaning");
        case Reply:
            return tr("Reply");
        case Verdict:
            return tr("Result");
        case kColumns:
            break;
    }
    return {};
}

QString PacketModel::line(int row) const {
    const bus::ExchangeRecord& record = m_log.at(m_rows[static_cast<std::size_t>(row)]).record;
    return QString::fromStdString(
        packetLine(record, m_log.session().zero, texts::verdict(record).toStdString()));
}

}  // namespace nmc
