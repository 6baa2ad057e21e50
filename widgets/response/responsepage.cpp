// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responsepage.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <algorithm>
#include <iterator>
#include <utility>

#include "model/machinefile/responsestore.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/focuskeeper.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/words.h"
#include "widgets/response/responseform.h"
#include "widgets/response/responseplot.h"
#include "widgets/response/responseresults.h"
#include "widgets/response/responseview.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
const QString kSaveDialog = u"responseRunsDialog"_s;
}

ResponsePage::ResponsePage(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_requests(requests),
      m_form(new ResponseForm(requests, this)),
      m_results(new ResponseResults(this)),
      m_model(new ModelBox(m_kept, *m_form, requests, this)),
      m_view(new ResponseView(requests, this)),
      m_table(new ResponseTable(this)) {
    look::name(this, u"responsePage"_s, Common::tr("Step response"));
    m_runs = newRunsPart();
    m_findings = new QTabWidget(this);
    look::name(m_findings, u"responseFindings"_s, tr("Step results"));
    m_findings->addTab(m_results, tr("Results"));
    m_findings->addTab(m_model, tr("Model"));
    keepFocusOnTabs(*m_findings);
    connect(m_model, &ModelBox::curvesChanged, this, &ResponsePage::showModelCurves);
    lay();
    connect(m_form, &ResponseForm::judgementEdited, this, &ResponsePage::judgeAll);
    connect(m_table, &ResponseTable::shownWanted, this, &ResponsePage::showAs);
    connect(m_table, &ResponseTable::chosenChanged, this, &ResponsePage::refreshButtons);
    connect(m_table, &ResponseTable::named, this, &ResponsePage::nameRun);
    connect(m_putBack, &QPushButton::clicked, this, &ResponsePage::putBack);
    connect(m_use, &QPushButton::clicked, this, &ResponsePage::useGains);
    connect(m_remove, &QPushButton::clicked, this, &ResponsePage::removeChosen);
    connect(m_save, &QPushButton::clicked, this, &ResponsePage::chooseFile);
    refreshRuns();
}

QPushButton* ResponsePage::newButton(const QString& objectName, const QString& text,
                                     const QKeySequence& shortcut) {
    auto* button = form::newPush({objectName, text}, this);
    button->setShortcut(shortcut);
    return button;
}

QWidget* ResponsePage::newRunsPart() {
    m_use = newButton(u"responseUseGainsButton"_s, tr("Use these gains"), Qt::CTRL | Qt::SHIFT | Qt::Key_U);
    m_remove = newButton(u"responseRemoveButton"_s, Common::tr("Remove"), Qt::CTRL | Qt::Key_Delete);
    m_putBack =
        newButton(u"responsePutBackButton"_s, Common::tr("Restore"), Qt::CTRL | Qt::SHIFT | Qt::Key_Delete);
    m_save =
        newButton(u"responseExportButton"_s, Common::tr("Export CSV…"), Qt::CTRL | Qt::SHIFT | Qt::Key_X);
    m_all = new QCheckBox(tr("All runs"), this);
    look::name(m_all, u"responseAllRunsBox"_s, tr("All runs of this module in the plot"));
    m_all->setToolTip(tr("Shows the other runs of this module, older runs paler."));
    connect(m_all, &QCheckBox::toggled, this, &ResponsePage::refreshRuns);
    m_view->addControl(m_all);
    auto* part = new QWidget(this);
    auto* buttons = new FlowLayout(look::gridUnit(this));
    for (QWidget* button : {m_use, m_remove, m_putBack, m_save})
        buttons->addWidget(button);
    form::fill(part, form::newColumn(this, {{m_table, 1}, buttons}, 0.5));
    return part;
}

QWidget* ResponsePage::lendForm() {
    if (m_lent == nullptr) {
        m_lent = new QWidget(this);
        look::name(m_lent, u"responseFormPlace"_s, tr("Step"));
        const int unit = look::gridUnit(this);
        m_lent->setLayout(form::newColumn(this, {m_form, m_form->stateLabel()}, 1.0 / 3));
        m_lent->layout()->setContentsMargins(unit, 0, unit, 0);
        m_form->stateLabel()->setMinimumHeight(2 * fontMetrics().height());
        lay();
    }
    return m_lent;
}

void ResponsePage::takeFormBack() {
    if (m_lent == nullptr)
        return;
    QWidget* place = std::exchange(m_lent, nullptr);
    lay();
    place->deleteLater();
}

/// Without the form, the plot has most of the room, and the results are beside it.
void ResponsePage::lay() {
    delete layout();
    QLayout* left = nullptr;
    QLayout* right = nullptr;
    if (m_lent != nullptr) {
        left = form::newColumn(this, {m_findings, {m_runs, 1}}, 0.5);
        right = form::newColumn(this, {m_view}, 0.5);
    } else {
        left = form::newColumn(this, {m_form, m_findings, nullptr}, 0.5);
        // Always reserves a line for the label, so that the plot does not jump with every step.
        m_form->stateLabel()->setMinimumHeight(fontMetrics().height());
        right = form::newColumn(this, {m_form->stateLabel(), {m_view, 3}, {m_runs, 2}}, 0.5);
    }
    form::fill(this, form::newLine(this, {left, {right, 1}}), 0.5);
    m_form->show();
    m_form->stateLabel()->show();
}

void ResponsePage::showModule(const PanelView& view) {
    m_form->showModule(view);
    m_model->showModule(view);
    m_servo = view.module.isServo() ? std::optional(view.module.info.index) : std::nullopt;
    m_locked = texts::whyLocked(view.module);
    refreshButtons();
}

void ResponsePage::showNothing() {
    m_form->showNothing();
    m_model->showNothing();
    m_servo.reset();
    refreshButtons();
}

std::vector<const KeptResponse*> ResponsePage::others() const {
    std::vector<const KeptResponse*> others;
    const KeptResponse* a = find(m_shown[0]);
    if (m_all->isChecked() && a != nullptr)
        for (const KeptResponse& kept : m_kept)
            if (kept.run.module == a->run.module && m_shown[0] != kept.number && m_shown[1] != kept.number)
                others.push_back(&kept);
    return others;
}

void ResponsePage::step() {
    m_form->step();
}

const KeptResponse* ResponsePage::find(std::optional<int> number) const {
    const auto found = std::ranges::find(m_kept, number, &KeptResponse::number);
    return found != m_kept.end() ? &*found : nullptr;
}

void ResponsePage::showRun(KeptResponse run) {
    run.number = ++m_lastNumber;
    judge(run);
    if (!m_shown[1])
        m_shown[1] = m_shown[0];
    m_shown[0] = run.number;
    m_kept.push_back(std::move(run));
    showList();
    emit m_requests.storeRuns();
}

void ResponsePage::showKept(std::vector<KeptResponse> runs) {
    int last = 0;
    for (KeptResponse& run : runs) {
        judge(run);
        last = std::max(last, run.number);
    }
    // Runs that were recorded before these were read are newer nevertheless.
    for (std::vector<KeptResponse>* made : {&m_kept, &m_removed})
        for (KeptResponse& run : *made)
            run.number += last;
    for (std::optional<int>& shown : m_shown)
        if (shown)
            *shown += last;
    m_model->renumber(last);
    m_lastNumber += last;
    m_kept.insert(m_kept.begin(), std::make_move_iterator(runs.begin()), std::make_move_iterator(runs.end()));
    showList();
}

void ResponsePage::clearRuns() {
    m_kept.clear();
    m_removed.clear();
    m_shown = {};
    m_lastNumber = 0;
    m_model->forget();  // it names its run by a number, which the next run may get
    showList();
}

/// Call when the list has changed.
void ResponsePage::showList() {
    dropOldest(m_kept, [this](const KeptResponse& kept) {
        return kept.number == m_shown[0] || kept.number == m_shown[1] || kept.number == m_lastNumber;
    });
    m_model->showRuns();
    refreshRuns();
}

void ResponsePage::nameRun(int number, const QString& name, const QString& note) {
    constexpr int kLongestName = 60, kLongestNote = 500;
    const auto found = std::ranges::find(m_kept, number, &KeptResponse::number);
    if (found == m_kept.end())
        return;
    found->name = name.simplified().left(kLongestName).toStdString();
    found->note = note.simplified().left(kLongestNote).toStdString();
    refreshRuns();
    emit m_requests.storeRuns();
}

void ResponsePage::judge(KeptResponse& kept) const {
    nmc::judge(kept.run, m_form->band(), m_form->settleWindow());
}

void ResponsePage::judgeAll() {
    for (KeptResponse& kept : m_kept)
        judge(kept);
    m_model->showRuns();
    refreshRuns();
}

void ResponsePage::showAs(int which, int run, bool shown) {
    m_shown[static_cast<std::size_t>(which)] = shown ? std::optional(run) : std::nullopt;
    refreshRuns();
}

void ResponsePage::refreshRuns() {
    const KeptResponse* a = find(m_shown[0]);
    const KeptResponse* b = find(m_shown[1]);
    m_table->showRuns(m_kept, m_shown);
    m_results->showRuns(a, b, m_kept);
    m_view->showRuns(a, b, others());
    showModelCurves();
    refreshButtons();
}

void ResponsePage::forgetModules() {
    for (std::vector<KeptResponse>* made : {&m_kept, &m_removed})
        for (KeptResponse& run : *made)
            run.earlier = true;
    m_model->forget();
}

/// Shows the curves over a run of the same module and distance: the one that they belong to, or a later one
/// made with the suggested gains.
void ResponsePage::showModelCurves() {
    const KeptResponse* about = find(m_model->about());
    const auto alike = [about](const KeptResponse* shown) {
        return shown != nullptr && shown->run.module == about->run.module && !shown->run.taken.isMove() &&
               shown->run.taken.goal - shown->run.taken.from == about->run.taken.goal - about->run.taken.from;
    };
    const bool drawn = about != nullptr && (alike(find(m_shown[0])) || alike(find(m_shown[1])));
    m_view->plot().showModel(drawn ? about : nullptr, m_model->fittedPoints(), m_model->prediction());
}

QString ResponsePage::whyNotUsable(const KeptResponse* run) const {
    if (!m_locked.isEmpty())
        return m_locked;
    if (run == nullptr)
        return tr("Select a run in the list first.");
    if (m_servo != run->run.module)
        return tr("This run belongs to %1. Select that module first.")
            .arg(texts::moduleName(run->run.module));
    return {};
}

void ResponsePage::refreshButtons() {
    const KeptResponse* chosen = find(m_table->chosen());
    look::setPossible(m_use, whyNotUsable(chosen),
                      tr("Copies the gains of this run to the Gains page. Sends nothing (Ctrl+Shift+U)."));
    look::setPossible(m_remove, chosen == nullptr ? tr("Select a run in the list first.") : QString(),
                      tr("Removes this run from the list (Ctrl+Del)."));
    look::setPossible(m_putBack, m_removed.empty() ? tr("No run was removed.") : QString(),
                      tr("Restores the run removed last (Ctrl+Shift+Del)."));
    look::setPossible(m_save, m_kept.empty() ? tr("No run yet. Record a step first.") : QString(),
                      tr("Saves all runs in the list with their gains and results (Ctrl+Shift+X)."));
}

void ResponsePage::useGains() {
    const KeptResponse* chosen = find(m_table->chosen());
    if (whyNotUsable(chosen).isEmpty())
        emit m_requests.stageGains(chosen->run.taken.gains);
}

void ResponsePage::removeChosen() {
    const std::optional<int> chosen = m_table->chosen();
    const auto found = std::ranges::find(m_kept, chosen, &KeptResponse::number);
    if (found == m_kept.end())
        return;
    m_removed.push_back(std::move(*found));
    m_kept.erase(found);
    for (std::optional<int>& shown : m_shown)
        if (shown == chosen)
            shown.reset();
    showList();
    emit m_requests.storeRuns();
}

void ResponsePage::putBack() {
    KeptResponse run = std::move(m_removed.back());
    m_removed.pop_back();
    judge(run);
    const auto place = std::ranges::lower_bound(m_kept, run.number, {}, &KeptResponse::number);
    m_kept.insert(place, std::move(run));
    showList();
    emit m_requests.storeRuns();
}

void ResponsePage::chooseFile() {
    askWhereToSave(this,
                   {.objectName = kSaveDialog,
                    .title = tr("Export step responses"),
                    .filters = {Common::tr("CSV (*.csv)")},
                    .proposed = u"step-responses"_s},
                   [this](const QString& path) {
                       const QString program = u"NMC Panel "_s + QCoreApplication::applicationVersion();
                       emit m_requests.save(path, [program = program.toStdString(), runs = m_kept] {
                           return responsesCsv(program, runs);
                       });
                   });
}

}  // namespace nmc
