// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messagemodel.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace nmc {

MessageModel::Entries::iterator MessageModel::active(const QString& key) {
    return std::ranges::find_if(
        m_entries, [&key](const MessageEntry& entry) { return entry.message.key == key && !entry.ended(); });
}

void MessageModel::report(const Message& message, const QDateTime& time) {
    using enum Message::Relation;
    auto found = active(message.key);
    const bool same = found != m_entries.end() && found->message.headline == message.headline;
    if (found != m_entries.end() && !same && message.relation == NewCause) {
        endAt(found, time);
        found = m_entries.end();
    }
    MessageEntry entry{.message = message, .time = time, .number = ++m_number};
    if (found != m_entries.end()) {
        entry.number = found->number;
        if (same || message.relation == Repeat)
            entry.count = found->count + 1;
        m_entries.erase(found);
    }
    m_entries.push_front(std::move(entry));
    if (m_entries.size() > kMost) {
        // What still stands is not reported again.
        const auto over =
            std::find_if(m_entries.rbegin(), m_entries.rend(), std::mem_fn(&MessageEntry::ended));
        m_entries.erase(over != m_entries.rend() ? std::prev(over.base()) : std::prev(m_entries.end()));
    }
    emit reported(m_entries.front());
}

void MessageModel::amend(const Message& message) {
    const auto entry = active(message.key);
    if (entry == m_entries.end())
        return;
    entry->message = message;
    emit amended(*entry);
}

void MessageModel::end(const QString& key, const QDateTime& time) {
    if (const auto entry = active(key); entry != m_entries.end())
        endAt(entry, time);
}

void MessageModel::endAt(Entries::iterator entry, const QDateTime& time) {
    entry->over = time;
    emit ended(*entry);
}

void MessageModel::review(const LinkState& link) {
    for (MessageEntry& entry : m_entries)
        if (!entry.ended())
            entry.message = withoutImpossible(entry.message, link);
    emit reviewed();
}

}  // namespace nmc
