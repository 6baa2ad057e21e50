// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/closedialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

CloseDialog::CloseDialog(int movingMotors, const QString& stopText, QWidget* parent) : QDialog(parent) {
    look::name(this, u"closeDialog"_s, texts::closing(movingMotors));
    setWindowTitle(tr("Motors are moving"));
    setAttribute(Qt::WA_DeleteOnClose);
    setModal(true);
    const int unit = look::gridUnit(this);
    auto* glyph = new GlyphLabel(this);
    glyph->setFont(look::scaled(font(), 1.6));
    glyph->showSeverity(Severity::Attention);
    auto* text = new QLabel(texts::closing(movingMotors), this);
    text->setObjectName(u"closeText"_s);
    QFont bold = font();
    bold.setBold(true);
    text->setFont(bold);
    auto* stop = new QPushButton(stopText, this);
    look::name(stop, u"stopAndCloseButton"_s, stopText);
    auto* stay = new QPushButton(tr("St&ay"), this);
    look::name(stay, u"stayButton"_s, tr("Stay"));
    stop->setDefault(true);
    connect(stop, &QPushButton::clicked, this, &QDialog::accept);
    connect(stay, &QPushButton::clicked, this, &QDialog::reject);

    auto* message = new QHBoxLayout;
    message->setSpacing(unit);
    message->addWidget(glyph);
    message->addWidget(text, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(stop);
    buttons->addWidget(stay);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit * 2, unit * 2, unit * 2, unit * 2);
    layout->setSpacing(unit * 2);
    layout->addLayout(message);
    layout->addLayout(buttons);
}

}  // namespace nmc
