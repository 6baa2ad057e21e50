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

/// The most important message that is not over, with its actions. Never modal. Its place is kept while there
/// is none, and is the same for every message: nothing below it ever moves under the pointer. What does not
/// fit, and the other messages, are one click away. An event about which nothing can be done leaves it when
/// it is old news.
class Banner : public QFrame {
    Q_OBJECT

public:
    explicit Banner(QWidget* parent = nullptr);

    void showMessage(const Message& message);
    /// Other words for what it has already.
    void amendMessage(const Message& message);
    void endMessage(const QString& key);
    /// What may not be done in this connection is not offered any more.
    void review(const LinkState& link);
    /// How long an event is news; 10 min. For what is shown from now on.
    void setNewsLife(std::chrono::milliseconds life) { m_newsLife = life; }

    /// One line high instead of two, where the window is for something else. While nothing is pressed.
    void setCompact(bool compact);

    /// That of its place, whatever it says.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void actionTriggered(const nmc::Message& message, nmc::MessageAction action);
    /// The user wants to read all of the message that is shown, and the others.
    void allWanted(const QString& key);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void present();
    [[nodiscard]] const Message* current() const;

    struct Shown {
        Message message;
        unsigned number = 0;  ///< of all that were shown
    };
    void forgetWhenOld(unsigned number);

    QList<Shown> m_active;  ///< oldest first
    unsigned m_count = 0;
    std::chrono::milliseconds m_newsLife = std::chrono::minutes(10);
    QString m_shown;
    bool m_compact = false;
    QHBoxLayout* m_first;   ///< line
    QHBoxLayout* m_second;  ///< empty when compact
    GlyphLabel* m_glyph;
    ElidedLabel* m_headline;
    ElidedLabel* m_body;
    QHBoxLayout* m_actions;
    QPushButton* m_all;
    QToolButton* m_dismiss;
};

}  // namespace nmc
