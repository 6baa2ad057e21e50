// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFrame>

#include "widgets/messages/messagelines.h"

class QLabel;
class QHBoxLayout;

namespace nmc {

class GlyphLabel;

/// One cause in the message list: when it happened last, how often, and what to do about it.
class MessageRow : public QFrame {
    Q_OBJECT

public:
    MessageRow(const Message& message, const QDateTime& time, QWidget* parent = nullptr);

    /// Repeats the cause: its words may be new, and the count is increased.
    void repeat(const Message& message, const QDateTime& time);
    /// Changes the words, but neither time nor count.
    void amend(const Message& message);
    void end(const QDateTime& time);

    [[nodiscard]] const MessageEntry& entry() const { return m_entry; }
    [[nodiscard]] const Message& message() const { return m_entry.message; }
    [[nodiscard]] int count() const { return m_entry.count; }
    [[nodiscard]] bool over() const { return m_entry.over.isValid(); }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);

private:
    void present();

    MessageEntry m_entry;
    GlyphLabel* m_glyph;
    QLabel* m_when;
    QLabel* m_headline;
    QLabel* m_body;
    QHBoxLayout* m_actions;
};

}  // namespace nmc
