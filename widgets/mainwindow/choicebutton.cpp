// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/choicebutton.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

ChoiceButton::ChoiceButton(const QString& objectName, const QString& icon, QWidget* parent)
    : QPushButton(parent),
      m_iconName(icon),
      m_icon(new QLabel(this)),
      m_title(new QLabel(this)),
      m_needs(new QLabel(this)) {
    setObjectName(objectName);
    setAutoDefault(true);  // Enter as well as Space
    QFont large = look::scaled(font(), 1.3);
    large.setBold(true);
    m_title->setFont(large);
    m_title->setObjectName(objectName + u"Title"_s);
    m_needs->setObjectName(objectName + u"Needs"_s);
    for (QLabel* label : {m_icon, m_title, m_needs}) {
        label->setForegroundRole(QPalette::ButtonText);
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    for (QLabel* label : {m_title, m_needs})
        label->setWordWrap(true);
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit * 2, unit * 2, unit * 2, unit * 2);
    grid->setHorizontalSpacing(unit * 2);
    grid->setVerticalSpacing(unit / 2);
    grid->addWidget(m_icon, 0, 0, 2, 1);
    grid->addWidget(m_title, 0, 1);
    grid->addWidget(m_needs, 1, 1);
    grid->setColumnStretch(1, 1);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    paintIcon();
}

void ChoiceButton::showChoice(const QString& title, const QString& needs) {
    look::setText(m_title, title);
    look::setText(m_needs, needs);
    setAccessibleName(title);
    setAccessibleDescription(needs);
}

QSize ChoiceButton::sizeHint() const {
    return layout()->totalSizeHint();
}

QSize ChoiceButton::minimumSizeHint() const {
    return layout()->totalMinimumSize();
}

int ChoiceButton::heightForWidth(int width) const {
    return layout()->totalHeightForWidth(width);
}

void ChoiceButton::changeEvent(QEvent* event) {
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        paintIcon();
}

void ChoiceButton::paintIcon() {
    m_icon->setPixmap(icons::pixmap(m_iconName, palette().color(QPalette::Active, QPalette::ButtonText),
                                    look::gridUnit(this) * 4, devicePixelRatioF()));
}

}  // namespace nmc
