// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>

#include "widgets/common/texts.h"

class QLabel;
class QBoxLayout;
class QToolButton;

namespace nmc {

class GlyphLabel;

/// The most important message that is not over, above the panel, with its actions. Never modal.
class Banner : public QFrame {
    Q_OBJECT

public:
    explicit Banner(QWidget* parent = nullptr);

    void showMessage(const Message& message);
    /// Other words for what it has already.
    void amendMessage(const Message& message);
    void endMessage(const QString& key);

signals:
    void actionTriggered(const QString& key, const QString& actionId);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void present();
    [[nodiscard]] const Message* current() const;

    QList<Message> m_active;  ///< oldest first
    QString m_shown;
    GlyphLabel* m_glyph;
    QLabel* m_headline;
    QLabel* m_body;
    QBoxLayout* m_actions;
    QToolButton* m_dismiss;
};

}  // namespace nmc
