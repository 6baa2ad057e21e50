// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/signalsdialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <algorithm>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/scope/scopewords.h"
#include "widgets/scope/tracesdialog.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kModuleRole = Qt::UserRole;  ///< -1: the selected module
constexpr int kSignalRole = Qt::UserRole + 1;

SignalRef signalOfRow(const QTreeWidgetItem& item) {
    SignalRef signal;
    if (const int module = item.data(0, kModuleRole).toInt(); module >= 0)
        signal.module = ModuleIndex(static_cast<std::uint8_t>(module));
    signal.signal = static_cast<ScopeSignal>(item.data(0, kSignalRole).toInt());
    return signal;
}
}  // namespace

SignalsDialog::SignalsDialog(const ScopeSetup& setup, const std::vector<ScopeModule>& modules,
                             QWidget* parent)
    : QDialog(parent),
      m_setup(setup),
      m_modules(modules),
      m_filter(new QLineEdit(this)),
      m_table(new QTreeWidget(this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Signals of the scope"));
    look::name(this, u"scopeSignalsDialog"_s, windowTitle());
    look::name(m_table, u"scopeSignalsTable"_s, tr("Signals and their strips"));
    look::name(m_filter, u"scopeSignalsFilter"_s, tr("Filter"));
    m_filter->setPlaceholderText(tr("Filter by module or signal"));
    m_filter->setClearButtonEnabled(true);
    connect(m_filter, &QLineEdit::textChanged, this, &SignalsDialog::filter);
    QStringList titles{Common::tr("Signal")};
    for (std::size_t strip = 1; strip <= ScopeSetup::kStrips; ++strip)
        titles << tr("Strip %1").arg(strip);
    m_table->setHeaderLabels(titles);
    m_table->setToolTip(tr("Select the strips of each signal. Empty strips are hidden."));
    m_table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->header()->setStretchLastSection(false);
    connect(m_table, &QTreeWidget::itemChanged, this, &SignalsDialog::take);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* usual = buttons->addButton(tr("&Usual signals"), QDialogButtonBox::ResetRole);
    look::name(usual, u"scopeUsualSignalsButton"_s, tr("Usual signals"));
    usual->setToolTip(tr("Position and command position, with the error and the motor current below."));
    connect(usual, &QPushButton::clicked, this, [this] {
        m_setup.strips = ScopeSetup::usual().strips;
        showSetup();
        emit setupChosen(m_setup);
    });
    auto* custom = buttons->addButton(tr("&Custom traces…"), QDialogButtonBox::ActionRole);
    look::name(custom, u"scopeCustomTracesButton"_s, tr("Custom traces"));
    custom->setToolTip(tr("Traces of your own, from one or two signals."));
    connect(custom, &QPushButton::clicked, this, &SignalsDialog::defineTraces);
    // Enter in the filter must not close the dialog.
    for (QAbstractButton* button : buttons->buttons())
        qobject_cast<QPushButton*>(button)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setLayout(form::newColumn(this, {m_filter, m_table, buttons}, form::kUsual));
    showModules();
    const int em = fontMetrics().height();
    resize(em * 34, em * 24);
}

void SignalsDialog::showModules() {
    const std::vector<ScopeModule> modules = withTraces(m_modules, m_setup.custom);
    const QSignalBlocker blocker(m_table);
    m_table->clear();
    addRows(tr("The selected module"), std::nullopt, nullptr);
    for (std::size_t i = 0; i < modules.size(); ++i)
        addRows(modules[i].name, ModuleIndex(static_cast<std::uint8_t>(i)), &modules[i]);
    showSetup();
    filter(m_filter->text());
}

void SignalsDialog::defineTraces() {
    auto* dialog = new TracesDialog(m_setup.custom, m_modules, this);
    connect(dialog, &TracesDialog::tracesChosen, this, [this](const TraceDefinitions& traces) {
        m_setup.custom = traces;
        showModules();
        emit setupChosen(m_setup);
    });
    dialog->open();
}

void SignalsDialog::addRows(const QString& title, std::optional<ModuleIndex> module, const ScopeModule* of) {
    auto* group = new QTreeWidgetItem(m_table, {title});
    bool used = !module;
    for (const SignalInfo& info : kSignals) {
        const ScopeSignal signal = info.signal;
        const auto custom = customIndex(signal);
        if (of != nullptr ? !of->has(signal) : custom && !m_setup.custom[*custom])
            continue;
        const QString name = of != nullptr ? texts::signalName(signal, *of)
                             : custom      ? m_setup.custom[*custom]->name
                                           : texts::signalName(signal);
        auto* row = new QTreeWidgetItem(group, {name});
        row->setData(0, kModuleRole, module ? static_cast<int>(module->value()) : -1);
        row->setData(0, kSignalRole, static_cast<int>(signal));
        row->setFlags(row->flags() | Qt::ItemIsUserCheckable);
        for (std::size_t strip = 0; strip < ScopeSetup::kStrips; ++strip) {
            used = used || m_setup.shows(strip, {module, signal});
            row->setToolTip(static_cast<int>(strip) + 1,
                            tr("%1: %2 in strip %3").arg(title, name, QString::number(strip + 1)));
        }
    }
    group->setExpanded(used);
}

/// Shows the signals that have all of the words in their own name or that of their module.
void SignalsDialog::filter(const QString& text) {
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    for (int i = 0; i < m_table->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = m_table->topLevelItem(i);
        bool any = false;
        for (int k = 0; k < group->childCount(); ++k) {
            const QString name = group->text(0) + u' ' + group->child(k)->text(0);
            const bool found = std::ranges::all_of(
                words, [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
            group->child(k)->setHidden(!found);
            any = any || found;
        }
        group->setHidden(!any);
        if (any && !words.isEmpty())
            group->setExpanded(true);
    }
}

void SignalsDialog::showSetup() {
    const QSignalBlocker blocker(m_table);
    for (int i = 0; i < m_table->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = m_table->topLevelItem(i);
        for (int k = 0; k < group->childCount(); ++k)
            for (std::size_t strip = 0; strip < ScopeSetup::kStrips; ++strip)
                group->child(k)->setCheckState(
                    static_cast<int>(strip) + 1,
                    m_setup.shows(strip, signalOfRow(*group->child(k))) ? Qt::Checked : Qt::Unchecked);
    }
}

void SignalsDialog::take(QTreeWidgetItem* item, int column) {
    if (column < 1 || item->parent() == nullptr)
        return;
    m_setup.set(static_cast<std::size_t>(column - 1), signalOfRow(*item),
                item->checkState(column) == Qt::Checked);
    emit setupChosen(m_setup);
}

}  // namespace nmc
