// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QList>
#include <QScrollArea>

#include "widgets/messages/messagelines.h"

class QVBoxLayout;
class QLabel;

namespace nmc {

class MessageRow;

/// What happened in this session, newest first; one row for one cause, repeats are counted. The same key with
/// another headline is another cause, unless it replaces what was told before.
class MessageList : public QScrollArea {
    Q_OBJECT

public:
    explicit MessageList(QWidget* parent = nullptr);

    void showMessage(const Message& message, const QDateTime& time = QDateTime::currentDateTime());
    /// Other words for what is told already; not counted.
    void amendMessage(const Message& message);
    /// Says that it is over. A message that comes again later starts a row of its own.
    void endMessage(const QString& key, const QDateTime& time = QDateTime::currentDateTime());

    /// What may not be done in this connection is not offered any more.
    void review(const LinkState& link);
    /// Scrolls to it, if it is not over.
    void reveal(const QString& key);

    void setFilter(const MessageFilter& filter);
    /// Of the rows that the filter lets pass, newest first.
    [[nodiscard]] std::vector<MessageEntry> shownEntries() const;
    /// Of all rows, newest first.
    [[nodiscard]] std::vector<MessageEntry> entries() const;
    /// The rows, newest first; those that are filtered out are hidden.
    [[nodiscard]] const QList<MessageRow*>& rows() const { return m_rows; }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);
    /// For whoever keeps it: a cause was told, or told again; or it is over.
    void told(const nmc::MessageEntry& entry);
    void ended(const nmc::MessageEntry& entry);

private:
    [[nodiscard]] MessageRow* active(const QString& key) const;
    void endRow(MessageRow& row, const QDateTime& time);
    void showRow(MessageRow& row);
    void showWhetherEmpty();

    QList<MessageRow*> m_rows;
    QVBoxLayout* m_layout;
    QLabel* m_empty;
    MessageFilter m_filter;
};

}  // namespace nmc
