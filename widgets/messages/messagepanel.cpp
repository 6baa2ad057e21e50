// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messagepanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDate>
#include <QLineEdit>
#include <QPushButton>

#include "widgets/common/elidedlabel.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/messages/messagelist.h"

namespace nmc {

using namespace Qt::StringLiterals;

MessagePanel::MessagePanel(const MessageModel& model, Requests& requests, QWidget* parent)
    : QWidget(parent), m_requests(requests), m_list(new MessageList(model, this)) {
    look::name(this, u"messagePanel"_s, tr("Messages and their filter"));
    m_kind = form::newChoice(
        {u"messageKindBox"_s, tr("Kind of messages shown"), {{Common::tr("All kinds"), {}}}}, this);
    m_kind->setToolTip(tr("Filters the messages by kind."));
    for (const Severity severity : {Severity::Fault, Severity::Attention, Severity::Normal})
        m_kind->addItem(severity == Severity::Normal ? tr("Notes") : texts::severity(severity),
                        QVariant::fromValue(static_cast<int>(severity)));
    m_module = form::newChoice(
        {u"messageModuleBox"_s, tr("Module whose messages are shown"), {{Common::tr("All modules"), {}}}},
        this);
    m_module->setToolTip(tr("Filters the messages by module."));
    m_notOver = form::newCheck({u"messageNotOverBox"_s, tr("Active only")}, this);
    m_notOver->setToolTip(tr("Shows only messages whose cause persists."));
    m_text = new QLineEdit(this);
    look::name(m_text, u"messageTextField"_s, tr("Search messages"));
    m_text->setPlaceholderText(tr("Search"));
    m_text->setToolTip(tr("Shows only messages that contain these words."));
    auto* save =
        form::newPush({u"messageExportButton"_s, tr("E&xport…"), tr("Export the messages shown")}, this);
    save->setToolTip(tr("Saves the messages shown to a text file."));
    m_place = new ElidedLabel(1, this);
    m_place->setObjectName(u"messageLogLabel"_s);
    m_place->setTextInteractionFlags(Qt::TextSelectableByMouse);

    for (QComboBox* box : {m_kind, m_module}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(2);
        connect(box, &QComboBox::currentIndexChanged, this, &MessagePanel::filter);
    }
    connect(m_notOver, &QCheckBox::toggled, this, &MessagePanel::filter);
    connect(m_text, &QLineEdit::textChanged, this, &MessagePanel::filter);
    connect(save, &QPushButton::clicked, this, &MessagePanel::saveAs);
    auto* first = form::newLine(this, {{m_kind, 1}, {m_module, 1}}, 0.5);
    auto* second = form::newLine(this, {m_notOver, {m_text, 1}, save}, 0.5);
    form::fill(this, form::newColumn(this, {first, second, {m_list, 1}, m_place}, 0.5), 0.5);
    showLogFile({});
}

void MessagePanel::reveal(const QString& key) {
    m_kind->setCurrentIndex(0);
    m_module->setCurrentIndex(0);
    m_text->clear();
    m_list->reveal(key);
}

void MessagePanel::showLogFile(const QString& file) {
    m_place->setText(file.isEmpty() ? tr("Kept for this session only.") : tr("Kept in %1").arg(file));
}

/// Messages of a longer chain may still be listed, so its modules stay.
void MessagePanel::offerModules(int count) {
    form::offerModules(m_module, 1, qMax(count, m_module->count() - 1));
}

void MessagePanel::filter() {
    MessageFilter filter{.text = m_text->text().trimmed(), .onlyNotOver = m_notOver->isChecked()};
    if (const QVariant kind = m_kind->currentData(); kind.isValid())
        filter.severity = static_cast<Severity>(kind.toInt());
    if (m_module->currentIndex() > 0)
        filter.module = ModuleIndex(static_cast<std::uint8_t>(m_module->currentIndex() - 1));
    m_list->setFilter(filter);
}

void MessagePanel::saveAs() {
    askWhereToSave(this,
                   {.objectName = u"messageExportDialog"_s,
                    .title = tr("Export messages"),
                    .filters = {Common::tr("Text (*.txt)")},
                    .proposed = u"messages "_s + QDate::currentDate().toString(Qt::ISODate)},
                   [this](const QString& path) {
                       emit m_requests.save(
                           path, [entries = m_list->shownEntries()] { return messageText(entries); });
                   });
}

}  // namespace nmc
