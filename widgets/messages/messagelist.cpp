// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messagelist.h"

#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/messages/messagerow.h"

namespace nmc {

using namespace Qt::StringLiterals;

MessageList::MessageList(const MessageModel& model, QWidget* parent) : QScrollArea(parent), m_model(model) {
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
    m_empty = form::newRemark({}, page, u"noMessagesLabel"_s);
    m_empty->setMargin(look::gridUnit(this));
    m_layout->addWidget(m_empty);
    m_layout->addStretch(1);
    setWidget(page);
    connect(&m_model, &MessageModel::reported, this, &MessageList::showReported);
    connect(&m_model, &MessageModel::amended, this, &MessageList::showEntry);
    connect(&m_model, &MessageModel::ended, this, &MessageList::showEntry);
    connect(&m_model, &MessageModel::reviewed, this, &MessageList::showReviewed);
    showWhetherEmpty();
}

MessageRow* MessageList::rowOf(const MessageEntry& entry) const {
    const auto found = std::ranges::find_if(
        m_rows, [&entry](const MessageRow* row) { return row->entry().number == entry.number; });
    return found != m_rows.end() ? *found : nullptr;
}

void MessageList::showReported(const MessageEntry& entry) {
    MessageRow* row = rowOf(entry);
    if (row != nullptr) {
        row->showEntry(entry);
        m_rows.removeOne(row);
        m_layout->removeWidget(row);
    } else {
        row = new MessageRow(entry, widget());
        connect(row, &MessageRow::actionTriggered, this, &MessageList::actionTriggered);
    }
    m_rows.prepend(row);
    m_layout->insertWidget(0, row);
    filterRow(*row);
    verticalScrollBar()->setValue(0);
    const auto dropped = std::ranges::find_if_not(m_rows, [this](const MessageRow* shown) {
        return std::ranges::count(m_model.entries(), shown->entry().number, &MessageEntry::number) > 0;
    });
    if (dropped != m_rows.end()) {
        // The message may be reported by the click on a button of this row, which has not returned yet.
        (*dropped)->hide();
        (*dropped)->deleteLater();
        m_rows.erase(dropped);
    }
    showWhetherEmpty();
}

void MessageList::showEntry(const MessageEntry& entry) {
    if (MessageRow* row = rowOf(entry)) {
        row->showEntry(entry);
        filterRow(*row);
        showWhetherEmpty();
    }
}

void MessageList::showReviewed() {
    for (const MessageEntry& entry : m_model.entries())
        if (MessageRow* row = entry.ended() ? nullptr : rowOf(entry))
            row->showEntry(entry);
}

void MessageList::filterRow(MessageRow& row) {
    row.setVisible(m_filter.passes(row.entry()));
}

void MessageList::setFilter(const MessageFilter& filter) {
    m_filter = filter;
    for (MessageRow* row : m_rows)
        filterRow(*row);
    showWhetherEmpty();
}

std::vector<MessageEntry> MessageList::shownEntries() const {
    std::vector<MessageEntry> shown;
    std::ranges::copy_if(m_model.entries(), std::back_inserter(shown),
                         [this](const MessageEntry& entry) { return m_filter.passes(entry); });
    return shown;
}

void MessageList::showWhetherEmpty() {
    m_empty->setVisible(shownEntries().empty());
    look::setText(m_empty, m_rows.isEmpty()
                               ? tr("No messages. Problems are listed here, with the time when they ended.")
                               : tr("No message matches the filter above."));
}

void MessageList::reveal(const QString& key) {
    for (MessageRow* row : m_rows)
        if (row->message().key == key && !row->over())
            return ensureWidgetVisible(row);
}

}  // namespace nmc
