// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>

#include "widgets/common/texts.h"

class QBoxLayout;
class QPushButton;
class QToolButton;

namespace nmc {

class ElidedLabel;
class GlyphLabel;

/// The most important message that is not over, with its actions. Never modal. Its place is kept while there
/// is none, and is the same for every message: nothing below it ever moves under the pointer. What does not
/// fit, and the other messages, are one click away.
class Banner : public QFrame {
    Q_OBJECT

public:
    explicit Banner(QWidget* parent = nullptr);

    void showMessage(const Message& message);
    /// Other words for what it has already.
    void amendMessage(const Message& message);
    void endMessage(const QString& key);

    /// That of its place, whatever it says.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void actionTriggered(const QString& key, const QString& actionId);
    /// The user wants to read all of the message that is shown, and the others.
    void allWanted(const QString& key);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void present();
    [[nodiscard]] const Message* current() const;

    QList<Message> m_active;  ///< oldest first
    QString m_shown;
    GlyphLabel* m_glyph;
    ElidedLabel* m_headline;
    ElidedLabel* m_body;
    QBoxLayout* m_actions;
    QPushButton* m_all;
    QToolButton* m_dismiss;
};

}  // namespace nmc
