// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

class QLabel;

namespace nmc {

/// A large button that shows what it does and, below that in as many lines as necessary, what it needs.
class ChoiceButton : public QPushButton {
    Q_OBJECT

public:
    ChoiceButton(const QString& objectName, const QString& icon, QWidget* parent);

    void showChoice(const QString& title, const QString& needs);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void paintIcon();

    QString m_iconName;
    QLabel* m_icon;
    QLabel* m_title;
    QLabel* m_needs;
};

}  // namespace nmc
