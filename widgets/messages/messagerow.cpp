// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messagerow.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

MessageRow::MessageRow(const Message& message, const QDateTime& time, QWidget* parent)
    : QFrame(parent),
      m_message(message),
      m_time(time),
      m_glyph(new GlyphLabel(this)),
      m_when(look::newMutedLabel({}, this)),
      m_headline(new QLabel(this)),
      m_body(look::newMutedLabel({}, this)),
      m_actions(new QHBoxLayout) {
    setObjectName(u"messageRow"_s);
    m_when->setObjectName(u"messageTime"_s);
    m_headline->setObjectName(u"messageHeadline"_s);
    m_body->setObjectName(u"messageBody"_s);
    QFont bold = font();
    bold.setBold(true);
    m_headline->setFont(bold);
    m_when->setFont(look::tabular(font()));
    m_when->setWordWrap(true);
    for (QLabel* label : {m_headline, m_body}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    auto* grid = new QGridLayout(this);
    const int unit = look::gridUnit(this);
    grid->setContentsMargins(unit, unit / 2, unit, unit / 2);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 4);
    grid->addWidget(m_glyph, 0, 0, Qt::AlignTop);
    grid->addWidget(m_when, 0, 1);
    grid->addWidget(m_headline, 1, 1);
    grid->addWidget(m_body, 2, 1);
    grid->addLayout(m_actions, 3, 1);
    grid->setColumnStretch(1, 1);
    present();
}

void MessageRow::repeat(const Message& message, const QDateTime& time) {
    m_message = message;
    m_time = time;
    ++m_count;
    present();
}

void MessageRow::amend(const Message& message) {
    m_message = message;
    present();
}

void MessageRow::end(const QDateTime& time) {
    m_over = time;
    present();
}

void MessageRow::present() {
    const QString format = u"HH:mm:ss"_s;
    QStringList when{m_time.time().toString(format)};
    if (m_message.severity != Severity::Normal)
        when << texts::severity(m_message.severity);
    if (m_count > 1)
        when << tr("%1 times").arg(m_count);
    if (m_over.isValid())
        when << tr("over at %1").arg(m_over.time().toString(format));
    m_when->setText(when.join(u" · "_s));
    m_glyph->showSeverity(m_over.isValid() ? Severity::Normal : m_message.severity);
    m_headline->setText(m_message.headline);
    m_body->setText(m_message.body);
    m_body->setVisible(!m_message.body.isEmpty());
    setToolTip(m_message.details);
    setAccessibleName(when.join(u", "_s) + u": "_s + m_message.headline);
    while (QLayoutItem* item = m_actions->takeAt(0)) {
        // It may be the very button whose click brought us here.
        if (QWidget* button = item->widget()) {
            button->hide();
            button->setObjectName(QString());
            button->deleteLater();
        }
        delete item;
    }
    for (const Message::Action& action : m_message.actions) {
        // What was kept of it can be looked at for ever; nothing else is to be done any more.
        if (m_over.isValid() && action.id != MessageAction::ShowRecord)
            continue;
        auto* button = new QPushButton(action.text, this);
        button->setFlat(true);
        look::name(button, u"listAction_"_s + nmc::objectName(action.id), action.text);
        connect(button, &QPushButton::clicked, this,
                [this, id = action.id] { emit actionTriggered(m_message, id); });
        m_actions->addWidget(button);
    }
    m_actions->addStretch(1);
}

}  // namespace nmc
