// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QScrollArea>

#include "widgets/messages/messagemodel.h"

class QVBoxLayout;
class QLabel;

namespace nmc {

class MessageRow;

/// The entries of a MessageModel, one row each, newest first.
class MessageList : public QScrollArea {
    Q_OBJECT

public:
    /// `model` must outlive it.
    explicit MessageList(const MessageModel& model, QWidget* parent = nullptr);

    /// Scrolls to the message, if it has not ended.
    void reveal(const QString& key);

    void setFilter(const MessageFilter& filter);
    /// The entries that pass the filter, newest first.
    [[nodiscard]] std::vector<MessageEntry> shownEntries() const;
    /// The rows, newest first; those that are filtered out are hidden.
    [[nodiscard]] const QList<MessageRow*>& rows() const { return m_rows; }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);

private:
    void showReported(const MessageEntry& entry);
    void showEntry(const MessageEntry& entry);
    void showReviewed();
    [[nodiscard]] MessageRow* rowOf(const MessageEntry& entry) const;
    void filterRow(MessageRow& row);
    void showWhetherEmpty();

    const MessageModel& m_model;
    QList<MessageRow*> m_rows;
    QVBoxLayout* m_layout;
    QLabel* m_empty;
    MessageFilter m_filter;
};

}  // namespace nmc
