// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/axes/axespage.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QRadioButton>
#include <QScrollArea>
#include <algorithm>

#include "model/sequence/sequencecheck.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Step sizes in the axis's own unit.
constexpr double kSteps[] = {0.001, 0.01, 0.1, 1, 10, 100, 1'000};
constexpr int kUsualStep = 4;
}  // namespace

AxesPage::AxesPage(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_requests(requests),
      m_slow(form::newRadio(
          {u"jogSlowButton"_s, tr("Slow"), tr("Slow jog"), tr("Each axis at its own jog speed.")}, this)),
      m_fast(form::newRadio({u"jogFastButton"_s, tr("Fast"), tr("Fast jog"),
                             tr("Each axis at its own max jog speed, set on its Axis or Parameters page.")},
                            this)),
      m_step(form::newChoice({u"jogStepBox"_s, tr("Step of all axes"), {}}, this)) {
    look::name(this, u"axesPage"_s, tr("All axes"));
    m_slow->setChecked(true);
    m_step->setToolTip(tr("Distance that one click on Step moves an axis, in its own unit."));
    for (const double step : kSteps)
        m_step->addItem(tr("%1 units").arg(texts::readout(step)), step);
    m_step->setCurrentIndex(kUsualStep);
    m_enableAll = new Command({.name = u"enableAllButton"_s,
                               .icon = u"power"_s,
                               .text = tr("Enable all"),
                               .accessible = tr("Enable all motors")},
                              this, [this] { enableAll(); });
    m_homeAll = new Command({.name = u"homeAllButton"_s,
                             .icon = u"home"_s,
                             .text = Common::tr("Home all"),
                             .accessible = tr("Home all axes, one after the other")},
                            this, [this] { emit m_requests.homeAll(); });
    auto* head = new QHBoxLayout;
    head->addWidget(m_enableAll->button());
    head->addWidget(m_homeAll->button());
    head->addSpacing(look::gridUnit(this));
    head->addWidget(m_slow);
    head->addWidget(m_fast);
    head->addSpacing(look::gridUnit(this));
    head->addWidget(form::newLabel(tr("Step"), m_step));
    head->addWidget(m_step);
    head->addStretch(1);
    auto* table = new QWidget(this);
    m_grid = new QGridLayout;
    table->setLayout(form::newColumn(table, {m_grid, nullptr}, form::kUsual));
    m_grid->setHorizontalSpacing(look::gridUnit(this));
    m_grid->setColumnStretch(1, 1);
    auto* area = new QScrollArea(this);
    look::name(area, u"axesArea"_s, tr("Axes"));
    area->setWidget(table);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    setLayout(form::newColumn(this, {head, {area, 1}}, form::kUsual));
    connect(m_slow, &QRadioButton::toggled, this, &AxesPage::showJog);
    connect(m_step, &QComboBox::currentIndexChanged, this, &AxesPage::showJog);
    refresh();
}

void AxesPage::showModules(const std::vector<PanelView>& views, const Machine& machine) {
    m_machine = machine;
    const bool others =
        m_axes.size() != views.size() ||
        !std::ranges::equal(
            m_axes, views, {}, [](const AxisRow* row) { return row->context().state().info.identity; },
            [](const PanelView& view) { return view.module.info.identity; });
    if (others) {
        forgetModules();
        for (const PanelView& view : views) {
            auto* row = new AxisRow(view, m_requests, static_cast<int>(m_axes.size()) + 1, *m_grid,
                                    m_grid->parentWidget());
            connect(row, &AxisRow::earlierWanted, this, &AxesPage::makeEarlier);
            m_axes.push_back(row);
        }
    } else {
        for (std::size_t i = 0; i < views.size(); ++i)
            m_axes[i]->show(views[i]);
    }
    showJog();
}

void AxesPage::forgetModules() {
    for (AxisRow* row : std::exchange(m_axes, {}))
        row->remove();
    m_slow->setChecked(true);
}

void AxesPage::endHold() {
    for (AxisRow* row : m_axes)
        row->endHold();
}

void AxesPage::showJog() {
    const std::vector<ModuleIndex> homing = order();
    for (AxisRow* row : m_axes) {
        const auto place = std::ranges::find(homing, row->context().state().info.index);
        row->setJog(m_fast->isChecked() ? JogSpeed::Fast : JogSpeed::Slow, m_step->currentData().toDouble(),
                    place != homing.end() ? static_cast<int>(place - homing.begin()) + 1 : 0);
    }
    refresh();
}

std::vector<ModuleIndex> AxesPage::order() const {
    std::vector<ModuleState> modules;
    for (const AxisRow* row : m_axes)
        modules.push_back(row->context().state());
    return axesToHome(m_machine, modules);
}

std::vector<ModuleIndex> AxesPage::possibleToEnable() const {
    std::vector<ModuleIndex> off;
    for (const AxisRow* row : m_axes)
        if (!row->context().state().driveOn() && !row->context().whyNot(IntentKind::Enable))
            off.push_back(row->context().state().info.index);
    return off;
}

QString AxesPage::whyNotHomed() const {
    if (m_sequenceRuns)
        return Common::tr("A sequence is already running.");
    const std::vector<ModuleIndex> homing = order();
    if (homing.empty())
        return tr("Homing is not set up for any axis. Set it up on each Homing page.");
    for (const ModuleIndex module : homing) {
        const QString reason = m_axes[module.value()]->context().reasonFor(IntentKind::Home);
        if (!reason.isEmpty())
            return Common::tr("%1: %2").arg(texts::moduleName(module), reason);
    }
    return {};
}

void AxesPage::showSequence(bool running) {
    m_sequenceRuns = running;
    refresh();
}

void AxesPage::refresh() {
    const QString none = m_axes.empty() ? Common::tr("No module") : QString();
    QString reason = none;
    if (reason.isEmpty() && possibleToEnable().empty()) {
        reason = tr("All motors are already enabled.");
        for (const AxisRow* row : m_axes)
            if (!row->context().state().driveOn())
                reason = Common::tr("%1: %2").arg(texts::moduleName(row->context().state().info.index),
                                                  row->context().reasonFor(IntentKind::Enable));
    }
    m_enableAll->setPossible(reason, tr("Enables every motor at its present position."));
    m_homeAll->setPossible(
        none.isEmpty() ? whyNotHomed() : none,
        tr("Homes one axis after the other, in the order of the table, with each axis's homing settings. Any stop ends it."));
}

void AxesPage::enableAll() {
    for (const ModuleIndex module : possibleToEnable())
        emit m_requests.intent(module, intent::Enable{});
}

void AxesPage::makeEarlier(ModuleIndex module) {
    const std::vector<ModuleIndex> homing = order();
    const auto place = std::ranges::find(homing, module);
    if (place == homing.end() || place == homing.begin())
        return;
    // An axis that is absent, or has no homing recipe at the moment, keeps its place.
    std::vector<ModuleIndex> all = m_machine.homeOrder;
    for (const ModuleIndex listed : homing)
        if (!std::ranges::count(all, listed))
            all.push_back(listed);
    std::iter_swap(std::ranges::find(all, module), std::ranges::find(all, *std::prev(place)));
    emit m_requests.homeOrderEdited(all);
}

}  // namespace nmc
