// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFrame>

#include "widgets/common/message.h"

class QLabel;
class QHBoxLayout;

namespace nmc {

class GlyphLabel;

/// One cause in the message list: when it happened last, how often, and what to do about it.
class MessageRow : public QFrame {
    Q_OBJECT

public:
    MessageRow(const Message& message, const QDateTime& time, QWidget* parent = nullptr);

    /// The same cause again: its words may be new, the count goes up.
    void repeat(const Message& message, const QDateTime& time);
    /// The same time with other words.
    void amend(const Message& message);
    void end(const QDateTime& time);

    [[nodiscard]] const Message& message() const { return m_message; }
    [[nodiscard]] int count() const { return m_count; }
    [[nodiscard]] bool over() const { return m_over.isValid(); }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);

private:
    void present();

    Message m_message;
    QDateTime m_time;
    QDateTime m_over;
    int m_count = 1;
    GlyphLabel* m_glyph;
    QLabel* m_when;
    QLabel* m_headline;
    QLabel* m_body;
    QHBoxLayout* m_actions;
};

}  // namespace nmc
