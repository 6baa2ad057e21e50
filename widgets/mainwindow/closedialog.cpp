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

CloseDialog::CloseDialog(int movingMotors, const QString& stopText, QWidget* parent)
    : AskDialog({u"closeDialog"_s, tr("Motors are moving"), texts::closing(movingMotors), stopText,
                 u"stopAndCloseButton"_s, tr("St&ay"), u"stayButton"_s},
                parent) {
    findChild<QPushButton*>(u"stopAndCloseButton"_s)->setDefault(true);
}

RestartDialog::RestartDialog(int movingMotors, QWidget* parent)
    : AskDialog({u"restartDialog"_s, tr("Restart the network"), texts::beforeRestart(movingMotors),
                 tr("&Restart the network: positions and gains are lost"), u"restartButton"_s, tr("&Cancel"),
                 u"cancelRestartButton"_s},
                parent) {
    findChild<QPushButton*>(u"cancelRestartButton"_s)->setDefault(true);
}

}  // namespace nmc
