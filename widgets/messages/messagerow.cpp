// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messagerow.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

MessageRow::MessageRow(const MessageEntry& entry, QWidget* parent)
    : QFrame(parent),
      m_glyph(new GlyphLabel(this)),
      m_when(form::newRemark({}, this, u"messageTime"_s)),
      m_headline(form::newParagraph(u"messageHeadline"_s, {}, this)),
      m_body(form::newRemark({}, this, u"messageBody"_s)),
      m_actions(new FlowLayout(look::gridUnit(this))) {
    setObjectName(u"messageRow"_s);
    m_when->setFont(look::tabular(font()));
    form::setBold(m_headline);
    for (QLabel* label : {m_headline, m_body})
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
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
    showEntry(entry);
}

void MessageRow::showEntry(const MessageEntry& entry) {
    m_entry = entry;
    const QDate today = QDate::currentDate();
    QStringList when{timeText(m_entry.time, today)};
    if (m_entry.message.severity != Severity::Normal)
        when << texts::severity(m_entry.message.severity);
    if (m_entry.count > 1)
        when << tr("%n times", nullptr, m_entry.count);
    if (m_entry.ended())
        when << Common::tr("ended at %1").arg(timeText(m_entry.over, m_entry.time.date()));
    m_when->setText(when.join(u" · "_s));
    m_glyph->showSeverity(m_entry.ended() ? Severity::Normal : m_entry.message.severity);
    m_headline->setText(m_entry.message.headline);
    m_body->setText(m_entry.message.body);
    m_body->setVisible(!m_entry.message.body.isEmpty());
    setToolTip(m_entry.message.details);
    setAccessibleName(when.join(u", "_s) + u": "_s + m_entry.message.headline);
    form::clear(*m_actions);
    for (const Message::Action& action : m_entry.message.actions) {
        // The record can still be viewed; all other actions have become pointless.
        if (m_entry.ended() && action.id != MessageAction::ShowRecord)
            continue;
        auto* button = new QPushButton(action.text, this);
        button->setFlat(true);
        look::name(button, u"listAction_"_s + nmc::objectName(action.id), action.text);
        look::setPossible(button, action.reason, {});
        connect(button, &QPushButton::clicked, this,
                [this, id = action.id] { emit actionTriggered(m_entry.message, id); });
        m_actions->addWidget(button);
    }
}

}  // namespace nmc
