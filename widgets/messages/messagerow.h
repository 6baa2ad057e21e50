// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "widgets/messages/messagelines.h"

class QLabel;

namespace nmc {

class FlowLayout;
class GlyphLabel;

/// One entry in the message list: when it happened last, how often, and what to do about it.
class MessageRow : public QFrame {
    Q_OBJECT

public:
    explicit MessageRow(const MessageEntry& entry, QWidget* parent = nullptr);

    void showEntry(const MessageEntry& entry);

    [[nodiscard]] const MessageEntry& entry() const { return m_entry; }
    [[nodiscard]] const Message& message() const { return m_entry.message; }
    [[nodiscard]] int count() const { return m_entry.count; }
    [[nodiscard]] bool over() const { return m_entry.ended(); }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);

private:
    MessageEntry m_entry;
    GlyphLabel* m_glyph;
    QLabel* m_when;
    QLabel* m_headline;
    QLabel* m_body;
    FlowLayout* m_actions;
};

}  // namespace nmc
