// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messagelist.h"

#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/messages/messagerow.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr qsizetype kMaxRows = 200;
}  // namespace

MessageList::MessageList(QWidget* parent) : QScrollArea(parent) {
    look::name(this, u"messageList"_s, Common::tr("Messages"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    auto* page = new QWidget(this);
    page->setBackgroundRole(QPalette::Base);
    page->setAutoFillBackground(true);
    m_layout = new QVBoxLayout(page);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(0);
    m_empty = look::newMutedLabel({}, page);
    m_empty->setObjectName(u"noMessagesLabel"_s);
    m_empty->setWordWrap(true);
    m_empty->setMargin(look::gridUnit(this));
    m_layout->addWidget(m_empty);
    m_layout->addStretch(1);
    setWidget(page);
    showWhetherEmpty();
}

MessageRow* MessageList::active(const QString& key) const {
    for (MessageRow* row : m_rows)
        if (row->message().key == key && !row->over())
            return row;
    return nullptr;
}

void MessageList::showMessage(const Message& message, const QDateTime& time) {
    MessageRow* row = active(message.key);
    if (row != nullptr && row->message().headline != message.headline && !message.replaces) {
        endRow(*row, time);
        row = nullptr;
    }
    if (row != nullptr) {
        row->repeat(message, time);
        m_rows.removeOne(row);
        m_layout->removeWidget(row);
    } else {
        row = new MessageRow(message, time, widget());
        connect(row, &MessageRow::actionTriggered, this, &MessageList::actionTriggered);
    }
    m_rows.prepend(row);
    m_layout->insertWidget(0, row);
    showRow(*row);
    verticalScrollBar()->setValue(0);
    while (m_rows.size() > kMaxRows)
        delete m_rows.takeLast();
    showWhetherEmpty();
    emit told(row->entry());
}

void MessageList::showRow(MessageRow& row) {
    row.setVisible(m_filter.passes(row.entry()));
}

void MessageList::setFilter(const MessageFilter& filter) {
    m_filter = filter;
    for (MessageRow* row : m_rows)
        showRow(*row);
    showWhetherEmpty();
}

std::vector<MessageEntry> MessageList::shownEntries() const {
    std::vector<MessageEntry> entries;
    for (const MessageRow* row : m_rows)
        if (m_filter.passes(row->entry()))
            entries.push_back(row->entry());
    return entries;
}

std::vector<MessageEntry> MessageList::entries() const {
    std::vector<MessageEntry> entries;
    for (const MessageRow* row : m_rows)
        entries.push_back(row->entry());
    return entries;
}

void MessageList::showWhetherEmpty() {
    m_empty->setVisible(shownEntries().empty());
    look::setText(m_empty, m_rows.isEmpty()
                               ? tr("No messages. Problems are listed here, with the time when they ended.")
                               : tr("No message matches the filter above."));
}

void MessageList::amendMessage(const Message& message) {
    if (MessageRow* row = active(message.key)) {
        row->amend(message);
        emit told(row->entry());
    }
}

void MessageList::endMessage(const QString& key, const QDateTime& time) {
    if (MessageRow* row = active(key))
        endRow(*row, time);
}

void MessageList::endRow(MessageRow& row, const QDateTime& time) {
    row.end(time);
    showRow(row);
    showWhetherEmpty();
    emit ended(row.entry());
}

void MessageList::review(const LinkState& link) {
    for (MessageRow* row : m_rows)
        if (!row->over())
            row->amend(withoutImpossible(row->message(), link));
}

void MessageList::reveal(const QString& key) {
    if (MessageRow* row = active(key))
        ensureWidgetVisible(row);
}

}  // namespace nmc
