// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/askdialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

AskDialog::AskDialog(const Question& question, QWidget* parent)
    : QDialog(parent), m_buttons(new QHBoxLayout) {
    look::name(this, question.name, question.text);
    setWindowTitle(question.title);
    setAttribute(Qt::WA_DeleteOnClose);
    setModal(true);
    const int unit = look::gridUnit(this);
    auto* glyph = new GlyphLabel(this);
    glyph->setFont(look::scaled(font(), 1.6));
    glyph->showSeverity(Severity::Attention);
    auto* text = new QLabel(question.text, this);
    text->setObjectName(question.textName);
    text->setTextFormat(Qt::PlainText);
    QFont bold = font();
    bold.setBold(true);
    text->setFont(bold);
    auto* stay = new QPushButton(question.stay, this);
    look::name(stay, question.stayName, QString(question.stay).remove(u'&'));
    connect(stay, &QPushButton::clicked, this, &QDialog::reject);
    m_buttons->addStretch(1);
    m_buttons->addWidget(stay);
    addChoice(question.go, question.goName);

    auto* message = new QHBoxLayout;
    message->setSpacing(unit);
    message->addWidget(glyph);
    message->addWidget(text, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit * 2, unit * 2, unit * 2, unit * 2);
    layout->setSpacing(unit * 2);
    layout->addLayout(message);
    layout->addLayout(m_buttons);
}

QPushButton* AskDialog::addChoice(const QString& text, const QString& objectName) {
    auto* button = new QPushButton(text, this);
    look::name(button, objectName, QString(text).remove(u'&'));
    connect(button, &QPushButton::clicked, this, &QDialog::accept);
    const int beforeStay = m_buttons->count() - 1;
    setTabOrder(button, qobject_cast<QPushButton*>(m_buttons->itemAt(beforeStay)->widget()));
    m_buttons->insertWidget(beforeStay, button);
    return button;
}

}  // namespace nmc
