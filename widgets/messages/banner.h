// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>
#include <chrono>

#include "widgets/common/message.h"

class QHBoxLayout;
class QPushButton;
class QToolButton;

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
    explicit Banner(QWidget* parent = nullptr);

    void showMessage(const Message& message);
    /// Changes the words of a message that it already has.
    void amendMessage(const Message& message);
    void endMessage(const QString& key);
    /// Removes the buttons that may not act in this connection, and disables those that an operator may not
    /// use.
    void review(const LinkState& link);
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
    [[nodiscard]] const Message* current() const;

    struct Shown {
        Message message;
        unsigned number = 0;  ///< consecutive number of the message
    };
    void forgetWhenOld(unsigned number);

    QList<Shown> m_active;  ///< oldest first
    unsigned m_count = 0;
    std::chrono::milliseconds m_newsLife = std::chrono::minutes(10);
    QString m_shown;
    GlyphLabel* m_glyph;
    ElidedLabel* m_headline;
    ElidedLabel* m_body;
    QHBoxLayout* m_actions;
    QPushButton* m_all;
    QToolButton* m_dismiss;
};

}  // namespace nmc
