// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/ribbon.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

Ribbon::Ribbon(const QString& objectName, const QString& accessibleName, const QString& text, QWidget* parent)
    : QFrame(parent), m_layout(new QHBoxLayout(this)), m_text(new QLabel(text, this)) {
    look::name(this, objectName, accessibleName);
    m_text->setObjectName(objectName + u"Text"_s);
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignCenter);
    const int unit = look::gridUnit(this);
    m_layout->setContentsMargins(unit, unit / 3, unit, unit / 3);
    m_layout->setSpacing(unit);
    m_layout->addWidget(m_text, 1);
    setAutoFillBackground(true);
    invert();
    hide();
}

void Ribbon::setText(const QString& text) {
    look::setText(m_text, text);
}

QPushButton* Ribbon::addButton(const QString& objectName, const QString& text, const QString& meaning) {
    auto* button = new QPushButton(text, this);
    look::name(button, objectName, text);
    look::setPossible(button, {}, meaning);
    look::keepRoom(button);
    m_layout->addWidget(button);
    m_layout->insertSpacing(0, button->sizeHint().width());  // the text stays in the middle
    return button;
}

void Ribbon::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        invert();
}

void Ribbon::invert() {
    const QPalette& around = parentWidget()->palette();
    QPalette inverted;
    inverted.setColor(QPalette::Window, around.color(QPalette::Active, QPalette::WindowText));
    inverted.setColor(QPalette::WindowText, around.color(QPalette::Active, QPalette::Window));
    setPalette(inverted);
}

}  // namespace nmc
