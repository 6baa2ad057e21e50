// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <deque>

#include "widgets/messages/messagelines.h"

namespace nmc {

/// What happened in this session: one entry per cause, with its repeats counted (Message::Relation). The
/// banner, the list and the log listen to it.
class MessageModel : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void report(const Message& message, const QDateTime& time = QDateTime::currentDateTime());
    /// Changes the words of a message that has not ended; this is not counted as a repeat.
    void amend(const Message& message);
    /// Marks a message as ended. If it is reported again later, it gets a new entry.
    void end(const QString& key, const QDateTime& time = QDateTime::currentDateTime());
    /// Removes the buttons that may not act in this connection, and disables those that an operator may not
    /// use.
    void review(const LinkState& link);

    /// The one reported last first; at most kMost.
    [[nodiscard]] const std::deque<MessageEntry>& entries() const { return m_entries; }
    static constexpr std::size_t kMost = 200;

signals:
    /// Entries are valid during the signal. A repeated entry has become the first one.
    void reported(const nmc::MessageEntry& entry);
    void amended(const nmc::MessageEntry& entry);
    void ended(const nmc::MessageEntry& entry);
    /// The buttons of any entries have changed.
    void reviewed();

private:
    using Entries = std::deque<MessageEntry>;

    [[nodiscard]] Entries::iterator active(const QString& key);
    void endAt(Entries::iterator entry, const QDateTime& time);

    Entries m_entries;
    unsigned m_number = 0;
};

}  // namespace nmc
