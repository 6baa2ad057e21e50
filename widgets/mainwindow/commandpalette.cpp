// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/commandpalette.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>
#include <algorithm>

#include "widgets/common/elidedlabel.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kEntry = Qt::UserRole;  ///< index of an entry
}  // namespace

CommandPalette::CommandPalette(QWidget* parent)
    : QDialog(parent),
      m_words(new QLineEdit(this)),
      m_list(new QTreeWidget(this)),
      m_reason(new ElidedLabel(2, this)) {
    look::name(this, u"commandPalette"_s, tr("Find a command"));
    setWindowTitle(tr("Find a command"));
    look::name(m_words, u"commandWords"_s, tr("Search commands"));
    m_words->setPlaceholderText(tr("Type what to do, for example: go home"));
    m_words->setClearButtonEnabled(true);
    QCoreApplication::instance()->installEventFilter(this);
    look::name(m_list, u"commandList"_s, Common::tr("Commands"));
    m_list->setColumnCount(kColumns);
    m_list->setHeaderLabels({Common::tr("Command"), tr("Where"), tr("Key")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->header()->setSectionResizeMode(What, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(Where, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(Key, QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(false);
    look::nameText(m_reason, u"commandReason"_s, tr("What it does, or why it is unavailable"));
    setLayout(form::newColumn(this, {m_words, {m_list, 1}, m_reason}, form::kUsual));
    const int em = fontMetrics().height();
    resize(em * 36, em * 26);

    connect(m_words, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_words, &QLineEdit::returnPressed, this, &CommandPalette::act);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &CommandPalette::choose);
    connect(m_list, &QTreeWidget::itemDoubleClicked, this, &CommandPalette::act);
}

void CommandPalette::showEntries(std::vector<Entry> entries) {
    m_entries = std::move(entries);
    m_list->clear();
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const Entry& entry = m_entries[i];
        auto* item = new QTreeWidgetItem(m_list, {entry.sentence, entry.place, entry.key});
        item->setData(What, kEntry, static_cast<qulonglong>(i));
        if (!entry.reason().isEmpty())
            for (int column = 0; column < kColumns; ++column)
                item->setForeground(column, look::mutedText(palette()));
    }
    m_words->clear();
    filter();
    look::showInFront(this);
    m_words->setFocus();
}

void CommandPalette::filter() {
    const QStringList words = m_words->text().split(u' ', Qt::SkipEmptyParts);
    QTreeWidgetItem* first = nullptr;
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = m_list->topLevelItem(i);
        const Entry& entry = m_entries[static_cast<std::size_t>(item->data(What, kEntry).toULongLong())];
        const QString all = entry.sentence + u' ' + entry.keywords + u' ' + entry.place;
        const bool fits = std::ranges::all_of(
            words, [&all](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
        item->setHidden(!fits);
        if (fits && first == nullptr)
            first = item;
    }
    m_list->setCurrentItem(first);
    choose();
}

const CommandPalette::Entry* CommandPalette::current() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    if (item == nullptr || item->isHidden())
        return nullptr;
    return &m_entries[static_cast<std::size_t>(item->data(What, kEntry).toULongLong())];
}

void CommandPalette::choose() {
    const Entry* entry = current();
    const QString reason = entry != nullptr ? entry->reason() : tr("No matching command.");
    look::setText(m_reason, reason.isEmpty() ? entry->meaning : reason);
}

void CommandPalette::act() {
    const Entry* entry = current();
    if (entry == nullptr)
        return;
    if (const QString reason = entry->reason(); !reason.isEmpty()) {
        look::setText(m_reason, reason);
        return;
    }
    const std::function<void()> act = entry->act;
    hide();
    parentWidget()->activateWindow();
    act();
}

/// The palette's popups belong to it, too.
bool CommandPalette::isMine(const QObject* object) const {
    while (object != nullptr && object != this)
        object = object->parent();
    return object != nullptr;
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    const bool press = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::TouchBegin;
    if (press && isVisible() && watched->isWidgetType() && !isMine(watched)) {
        hide();
        static_cast<QWidget*>(watched)->window()->activateWindow();
    }
    if (watched == m_words && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp || key == Qt::Key_PageDown) {
            QCoreApplication::sendEvent(m_list, event);
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

}  // namespace nmc
