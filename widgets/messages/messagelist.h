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

/// What happened in this session, newest first: one row per cause, with its repeats counted. The same key
/// with another headline is another cause, unless the message replaces the previous one.
class MessageList : public QScrollArea {
    Q_OBJECT

public:
    explicit MessageList(QWidget* parent = nullptr);

    void showMessage(const Message& message, const QDateTime& time = QDateTime::currentDateTime());
    /// Changes the words of a message that has not ended; this is not counted as a repeat.
    void amendMessage(const Message& message);
    /// Marks a message as ended. If it comes again later, it gets a new row.
    void endMessage(const QString& key, const QDateTime& time = QDateTime::currentDateTime());

    /// Removes the buttons that may not act in this connection, and disables those that an operator may not
    /// use.
    void review(const LinkState& link);
    /// Scrolls to the message, if it has not ended.
    void reveal(const QString& key);

    void setFilter(const MessageFilter& filter);
    /// The entries that pass the filter, newest first.
    [[nodiscard]] std::vector<MessageEntry> shownEntries() const;
    /// All entries, newest first.
    [[nodiscard]] std::vector<MessageEntry> entries() const;
    /// The rows, newest first; those that are filtered out are hidden.
    [[nodiscard]] const QList<MessageRow*>& rows() const { return m_rows; }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);
    /// For the log: told() when a cause is reported, repeated or reworded; ended() when it has ended.
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
