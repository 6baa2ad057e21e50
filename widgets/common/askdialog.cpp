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

AskDialog::AskDialog(const Question& question, QWidget* parent) : QDialog(parent) {
    look::name(this, question.name, question.text);
    setWindowTitle(question.title);
    setAttribute(Qt::WA_DeleteOnClose);
    setModal(true);
    const int unit = look::gridUnit(this);
    auto* glyph = new GlyphLabel(this);
    glyph->setFont(look::scaled(font(), 1.6));
    glyph->showSeverity(Severity::Attention);
    auto* text = new QLabel(question.text, this);
    text->setObjectName(u"closeText"_s);
    QFont bold = font();
    bold.setBold(true);
    text->setFont(bold);
    auto* go = new QPushButton(question.go, this);
    look::name(go, question.goName, question.go);
    auto* stay = new QPushButton(question.stay, this);
    look::name(stay, question.stayName, question.stay);
    connect(go, &QPushButton::clicked, this, &QDialog::accept);
    connect(stay, &QPushButton::clicked, this, &QDialog::reject);

    auto* message = new QHBoxLayout;
    message->setSpacing(unit);
    message->addWidget(glyph);
    message->addWidget(text, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(go);
    buttons->addWidget(stay);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit * 2, unit * 2, unit * 2, unit * 2);
    layout->setSpacing(unit * 2);
    layout->addLayout(message);
    layout->addLayout(buttons);
}

}  // namespace nmc
