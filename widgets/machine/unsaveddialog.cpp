// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/machine/unsaveddialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

UnsavedDialog::UnsavedDialog(Before before, const QString& machine, QWidget* parent) : QDialog(parent) {
    const bool closing = before == Before::Closing;
    look::name(this, u"unsavedDialog"_s, texts::notSaved(machine));
    setWindowTitle(tr("Unsaved changes"));
    setAttribute(Qt::WA_DeleteOnClose);
    setModal(true);
    const int unit = look::gridUnit(this);
    auto* glyph = new GlyphLabel(this);
    glyph->setFont(look::scaled(font(), 1.6));
    glyph->showSeverity(Severity::Attention);
    auto* text = new QLabel(texts::notSaved(machine), this);
    text->setObjectName(u"unsavedText"_s);
    text->setTextFormat(Qt::PlainText);
    QFont bold = font();
    bold.setBold(true);
    text->setFont(bold);
    auto* save = new QPushButton(closing ? tr("&Save and close") : tr("&Save them"), this);
    look::name(save, u"saveFirstButton"_s, closing ? tr("Save and close") : tr("Save them"));
    auto* go = new QPushButton(
        closing ? tr("&Close: the next start offers them again") : tr("&Drop them: the changes are lost"),
        this);
    look::name(go, u"goOnUnsavedButton"_s, go->text().remove(u'&'));
    auto* stay = new QPushButton(tr("S&tay"), this);
    look::name(stay, u"stayUnsavedButton"_s, tr("Stay"));
    connect(save, &QPushButton::clicked, this, [this] {
        accept();
        emit saveChosen();
    });
    connect(go, &QPushButton::clicked, this, [this] {
        accept();
        emit goOnChosen();
    });
    connect(stay, &QPushButton::clicked, this, &QDialog::reject);
    save->setDefault(true);

    auto* message = new QHBoxLayout;
    message->setSpacing(unit);
    message->addWidget(glyph);
    message->addWidget(text, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    for (QPushButton* button : {save, go, stay})
        buttons->addWidget(button);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit * 2, unit * 2, unit * 2, unit * 2);
    layout->setSpacing(unit * 2);
    layout->addLayout(message);
    layout->addLayout(buttons);
}

}  // namespace nmc
