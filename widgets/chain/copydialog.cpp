// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/copydialog.h"

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

int numberOf(ModuleIndex module) {
    return module.value();
}
int numberOf(MachinePart part) {
    return static_cast<int>(part);
}

/// Adds it once; ticked if it is `wanted`.
template <typename T>
void offer(QListWidget* list, const QString& text, T value, const std::vector<T>& wanted) {
    const QVariant data(numberOf(value));
    for (int row = 0; row < list->count(); ++row)
        if (list->item(row)->data(Qt::UserRole) == data)
            return;
    auto* item = new QListWidgetItem(text, list);
    item->setData(Qt::UserRole, data);
    item->setCheckState(std::ranges::find(wanted, value) != wanted.end() ? Qt::Checked : Qt::Unchecked);
}

template <typename T>
std::vector<T> ticked(const QListWidget* list) {
    std::vector<T> values;
    for (int row = 0; row < list->count(); ++row)
        if (const QListWidgetItem* item = list->item(row); item->checkState() == Qt::Checked)
            values.push_back(static_cast<T>(static_cast<std::uint8_t>(item->data(Qt::UserRole).toUInt())));
    return values;
}

}  // namespace

CopyDialog::CopyDialog(const Machine& machine, const LinkState& link, std::optional<ModuleIndex> from,
                       Requests& requests, QWidget* window)
    : QDialog(window),
      m_machine(machine),
      m_link(link),
      m_from(form::newChoice(
          {u"copyFromBox"_s, tr("Axis to copy from"), {}, tr("The axis whose settings are copied.")}, this)),
      m_to(new QListWidget(this)),
      m_parts(new QListWidget(this)),
      m_hint(form::newParagraph(u"copyHint"_s, {}, this)),
      m_show(form::newPush({u"copyShowButton"_s, tr("&Show differences")}, this)) {
    look::name(this, u"copyDialog"_s, tr("Copy settings to other axes"));
    setWindowTitle(tr("Copy settings to other axes"));
    setAttribute(Qt::WA_DeleteOnClose);
    look::name(m_to, u"copyToList"_s, tr("Axes to copy to"));
    m_to->setToolTip(tr("Axes with the same type of module and other settings."));
    look::name(m_parts, u"copyPartsList"_s, tr("Settings to copy"));
    m_parts->setToolTip(tr("Settings in which at least one of these axes differs."));
    for (const ModuleState& module : m_link.modules)
        m_from->addItem(texts::moduleName(module.info.index), module.info.index.value());
    if (from)
        form::choose(m_from, from->value());
    auto* cancel = form::newPush({u"copyCancelButton"_s, tr("&Cancel"), Common::tr("Cancel")}, this);
    cancel->setAutoDefault(false);
    m_show->setDefault(true);
    auto* text = form::newParagraph(u"copyText"_s, {}, this);
    text->setText(tr(
        "The differences are shown before anything is changed or sent. Numbers are copied in the units of the module: counts or steps."));
    auto* to = form::newColumn(this, {form::newLabel(tr("&To"), m_to), {m_to, 1}}, 0.5);
    auto* parts = form::newColumn(this, {form::newLabel(tr("S&ettings"), m_parts), {m_parts, 1}}, 0.5);
    auto* lists = form::newLine(this, {to, parts}, 2);
    form::fill(
        this,
        form::newColumn(this, {text,
                               form::newLine(this, {form::newLabel(tr("&From"), m_from), m_from, nullptr}),
                               {lists, 1},
                               m_hint,
                               form::newLine(this, {nullptr, m_show, cancel})}),
        2);
    const int em = fontMetrics().height();
    resize(em * 36, em * 26);
    connect(m_from, &QComboBox::currentIndexChanged, this, &CopyDialog::fill);
    for (const QListWidget* list : {m_to, m_parts})
        connect(list, &QListWidget::itemChanged, this, &CopyDialog::refresh);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_show, &QPushButton::clicked, this, [this, &requests] {
        const AxisCopy copy = chosen();
        accept();
        emit requests.copyAxis(copy);
    });
    fill();
}

bool CopyDialog::isFor(const LinkState& link) const {
    return link.connection == m_link.connection &&
           std::ranges::equal(
               link.modules, m_link.modules, {},
               [](const ModuleState& module) { return module.info.identity; },
               [](const ModuleState& module) { return module.info.identity; });
}

ModuleIndex CopyDialog::from() const {
    return ModuleIndex(form::chosen<std::uint8_t>(m_from));
}

AxisCopy CopyDialog::chosen() const {
    return {from(), m_machine.axis(from()), ticked<ModuleIndex>(m_to), ticked<MachinePart>(m_parts)};
}

void CopyDialog::showMachine(const Machine& machine) {
    if (machine == m_machine)
        return;
    m_machine = machine;
    fill();
}

/// Offers what differs from the axis to copy from.
void CopyDialog::fill() {
    const QSignalBlocker toBlocker(m_to);
    const QSignalBlocker partsBlocker(m_parts);
    const AxisCopy before = chosen();
    m_to->clear();
    m_parts->clear();
    const AxisCopy all{from(), before.settings, copyTargets(from(), m_machine, m_link.modules), {}};
    for (const Difference& row : copyDifferences(all, m_machine, m_link.modules)) {
        offer(m_to, texts::moduleName(*row.id.module), *row.id.module, before.to);
        offer(m_parts, texts::machinePart(row.id.part), row.id.part, before.parts);
    }
    refresh();
}

void CopyDialog::refresh() {
    const AxisCopy copy = chosen();
    const QString reason = m_to->count() == 0
                               ? tr("No other axis with this type of module has other settings.")
                           : copy.to.empty()    ? tr("Select the axes to copy to.")
                           : copy.parts.empty() ? tr("Select the settings to copy.")
                           : copyDifferences(copy, m_machine, m_link.modules).empty()
                               ? tr("These settings are the same already.")
                               : QString();
    look::setText(m_hint, reason);
    look::setPossible(m_show, reason, tr("Shows what would change. Nothing is sent."));
}

}  // namespace nmc
