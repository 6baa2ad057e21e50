// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace nmc {

/// A bar across the whole width, in the palette's inverted colours, that shows what kind of session this is.
/// Always visible while that is so; hidden at first.
class Ribbon : public QFrame {
    Q_OBJECT

public:
    Ribbon(const QString& objectName, const QString& accessibleName, const QString& text, QWidget* parent);

    void setText(const QString& text);
    /// Adds a button after the text. It keeps its room while it is hidden: STOP ALL is below the bar.
    QPushButton* addButton(const QString& objectName, const QString& text, const QString& meaning);

protected:
    void changeEvent(QEvent* event) override;

private:
    void invert();

    QHBoxLayout* m_layout;
    QLabel* m_text;
};

}  // namespace nmc
