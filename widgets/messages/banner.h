// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <chrono>
#include <optional>
#include <set>
#include <vector>

#include "widgets/messages/messagemodel.h"

class QHBoxLayout;
class QPushButton;

namespace nmc {

class ElidedLabel;
class GlyphLabel;

/// Shows the most important message that has not ended, with its actions, in one line. Never modal. Its space
/// is kept while there is none, and is the same for every message, so that nothing below it ever moves under
/// the pointer. Text that does not fit and the other messages are one click away. An event that requires no
/// action is removed when it is old news.
class Banner : public QFrame {
    Q_OBJECT

public:
    /// `model` must outlive it.
    explicit Banner(const MessageModel& model, QWidget* parent = nullptr);

    /// Shows a message that is not in the model, or none, beside those that are.
    void setNotice(const std::optional<Message>& notice);
    /// How long an event is news; 10 min by default. Applies to messages shown from now on.
    void setNewsLife(std::chrono::milliseconds life) { m_newsLife = life; }

    /// The size of its space, whatever the message.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);
    /// The user wants to read all of the message that is shown, which has this key, and the other messages.
    void allWanted(const QString& key);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void present();
    void hideShown();
    void showReported(const MessageEntry& entry);
    /// What may be shown, the one reported last first.
    [[nodiscard]] std::vector<const Message*> candidates() const;

    const MessageModel& m_model;
    std::optional<Message> m_notice;
    std::set<unsigned> m_hidden;  ///< numbers of entries that the user has hidden, or that are old news
    std::chrono::milliseconds m_newsLife = std::chrono::minutes(10);
    std::optional<Message> m_shown;
    int m_others = 0;  ///< messages that could be shown instead
    GlyphLabel* m_glyph;
    ElidedLabel* m_headline;
    ElidedLabel* m_body;
    QHBoxLayout* m_actions;
    QPushButton* m_all;
};

}  // namespace nmc
