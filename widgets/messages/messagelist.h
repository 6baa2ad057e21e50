// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QList>
#include <QScrollArea>

#include "widgets/common/message.h"

class QVBoxLayout;
class QLabel;

namespace nmc {

class MessageRow;

/// What happened in this session, newest first; one row for one cause, repeats are counted.
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

    /// The rows, newest first.
    [[nodiscard]] const QList<MessageRow*>& rows() const { return m_rows; }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);

private:
    [[nodiscard]] MessageRow* active(const QString& key) const;

    QList<MessageRow*> m_rows;
    QVBoxLayout* m_layout;
    QLabel* m_empty;
};

}  // namespace nmc
