// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/homingbox.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>

#include "model/intent/homingplan.h"
#include "model/module/stepspeed.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/texts.h"
#include "widgets/common/unitwords.h"
#include "widgets/panels/homingform.h"
#include "widgets/panels/limitstopbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

double speedUnit(const ModuleState& module) {
    const auto& parameters = module.stepper.parameters();
    return StepSpeed(parameters ? parameters->speedMode : step::SpeedMode::X1).unit();
}

/// What a search goes through, as far as its recipe tells beforehand.
QList<ProcedureStage> stagesOf(const HomingRecipe& recipe) {
    QList<ProcedureStage> list{ProcedureStage::Searching};
    if (recipe.thenIndex)
        list << ProcedureStage::SearchingIndex;
    list << ProcedureStage::Reading;
    if (recipe.goToHome)
        list << ProcedureStage::GoingHome;
    if (recipe.makeZero)
        list << ProcedureStage::Zeroing;
    return list;
}

}  // namespace

HomingBox::HomingBox(QWidget* parent, ModuleType type)
    : QWidget(parent),
      m_form(new HomingForm(type, this)),
      m_home(new QPushButton(icons::tinted(u"home"_s), tr("Home"), this)),
      m_cancel(new QPushButton(icons::tinted(u"x"_s), tr("Cancel search"), this)),
      m_stages(new QLabel(this)),
      m_result(new QLabel(this)),
      m_hint(look::newMutedLabel({}, this)) {
    const auto named = [type](const QString& name) {
        return type == ModuleType::Step ? u"step"_s + name.left(1).toUpper() + name.mid(1) : name;
    };
    look::name(this, named(u"homingBox"_s), tr("Homing"));
    look::name(m_home, named(u"homeButton"_s), tr("Search for home"));
    look::name(m_cancel, named(u"cancelHomingButton"_s), tr("Cancel the search for home"));
    look::nameText(m_stages, named(u"homingStagesLabel"_s), tr("Stages of the search"));
    look::nameText(m_result, named(u"homingResultLabel"_s), tr("How the search goes"));
    m_hint->setObjectName(named(u"homingHint"_s));
    m_home->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_H));
    m_cancel->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H));
    for (QLabel* label : {m_stages, m_result, m_hint}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    const int unit = look::gridUnit(this);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(unit);
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_home);
    // What ends a search, and how it goes, stays in sight; the rest gives way where there is little room.
    auto* content = new QWidget(this);
    auto* inner = new QVBoxLayout(content);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(unit);
    inner->addWidget(m_form);
    if (type != ModuleType::Step) {
        m_limitStop = new LimitStopBox(content);
        inner->addWidget(m_limitStop);
        connect(m_limitStop, &LimitStopBox::intentRequested, this, &HomingBox::intentRequested);
    }
    inner->addStretch(1);
    auto* scroll = new QScrollArea(this);
    look::name(scroll, named(u"homingScroll"_s), tr("Settings of the search"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    scroll->setMinimumWidth(content->minimumSizeHint().width() +
                            scroll->verticalScrollBar()->sizeHint().width());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit, unit, 0, 0);
    layout->setSpacing(unit / 2);
    layout->addLayout(buttons);
    layout->addWidget(m_stages);
    layout->addWidget(m_result);
    layout->addSpacing(unit / 2);
    layout->addWidget(scroll, 1);
    layout->addWidget(m_hint);  // it comes and goes, and nothing may move under the pointer

    connect(m_form, &HomingForm::edited, this, &HomingBox::keepRecipe);
    connect(m_home, &QPushButton::clicked, this, [this] {
        emit intentRequested(intent::Home{m_form->recipe(), homeTolerance(m_settings.unit)});
    });
    connect(m_cancel, &QPushButton::clicked, this,
            [this] { emit intentRequested(intent::CancelProcedure{}); });
    refresh();
}

void HomingBox::keepRecipe() {
    if (m_module && m_settings.homing != m_form->recipe()) {
        m_settings.homing = m_shown = m_form->recipe();
        emit settingsEdited([recipe = m_form->recipe()](AxisSettings& axis) { axis.homing = recipe; });
    }
    refresh();
}

void HomingBox::adoptRecipe(const PanelView& view) {
    const HomingRecipe recipe = view.settings.homing.value_or(firstRecipe(view.module.info.identity));
    const bool other = m_module != view.module.info.index;
    // What is being typed stays: only what was changed elsewhere is shown anew.
    if (other || (view.settings.homing != m_shown && recipe != m_form->recipe()))
        m_form->showRecipe(recipe);
    m_shown = view.settings.homing;
}

void HomingBox::showModule(const PanelView& view) {
    const ModuleIndex module = view.module.info.index;
    adoptRecipe(view);
    if (m_module != module) {
        m_report.reset();
        m_reached = -1;
    }
    m_module = module;
    m_settings = view.settings;
    m_scale = view.scale();
    m_state = view.module;
    m_connected = view.connected;
    if (!m_connected)
        m_report.reset();
    else if (view.procedure != nullptr && view.procedure->kind == ProcedureKind::Homing)
        m_report = *view.procedure;
    m_form->showChip(m_scale, view.module.info.identity.version, speedUnit(view.module));
    if (m_limitStop != nullptr)
        m_limitStop->showModule(view);
    refresh();
}

void HomingBox::setBusy(bool busy) {
    if (m_limitStop != nullptr)
        m_limitStop->setBusy(busy);
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

bool HomingBox::running() const {
    return m_report && !m_report->over();
}

QString HomingBox::whyNotNow() const {
    if (!m_connected)
        return texts::refusal(Refusal::NotConnected);
    if (running())
        return tr("A search for home is under way.");
    if (const auto refusal = whyNotHome(m_state))
        return texts::refusal(*refusal);
    if (!m_form->problemText().isEmpty())
        return m_form->problemText();
    if (const auto refusal = whyNotHome(m_form->recipe(), m_state))
        return texts::refusal(*refusal);
    return m_busy ? tr("Waiting for the module's answer.") : QString();
}

void HomingBox::refresh() {
    m_form->setLocked(running());
    look::setPossible(m_home, whyNotNow(), tr("Moves the motor: it searches for home as set above."));
    look::setPossible(m_cancel, running() ? QString() : tr("No search for home is under way."),
                      tr("Stops the motor smoothly; it is not homed then."));
    const QString problem = m_form->problemText();
    look::setText(m_hint, problem);
    m_hint->setVisible(!problem.isEmpty());
    refreshProgress();
}

/// "✓ Searching  ▶ Going to home  · Making home zero": shape, then word.
QString HomingBox::stages() const {
    const QList<ProcedureStage> list = stagesOf(effective(m_form->recipe(), m_state.info.identity));
    QStringList words;
    for (int i = 0; i < list.size(); ++i) {
        ProcedureReport stage;
        stage.stage = list[i];
        const bool done = m_report && (m_report->stage == ProcedureStage::Done || i < m_reached);
        const bool now = running() && i == m_reached;
        const QString mark = done ? u"✓"_s : now ? u"▶"_s : u"·"_s;
        words << mark + u'\u00A0' + texts::procedureStage(stage).replace(u' ', u'\u00A0');
    }
    return words.join(u"   "_s);
}

void HomingBox::refreshProgress() {
    if (m_report) {
        const QList<ProcedureStage> list = stagesOf(effective(m_form->recipe(), m_state.info.identity));
        if (m_report->stage == ProcedureStage::Preparing)
            m_reached = 0;
        else if (list.contains(m_report->stage))
            m_reached = static_cast<int>(list.indexOf(m_report->stage));
    } else {
        m_reached = -1;
    }
    look::setText(m_stages, stages());
    QString result;
    if (m_report && m_report->stage == ProcedureStage::Done && m_report->home)
        result = tr("Done: home was at %1.").arg(texts::position(m_scale, *m_report->home));
    else if (m_report && m_report->failure)
        result =
            u"%1: %2"_s.arg(texts::procedureStage(*m_report), texts::procedureFailure(*m_report->failure));
    else if (m_report)
        result = texts::procedureStage(*m_report);
    else
        result = tr("No search yet.");
    look::setText(m_result, result);
}

}  // namespace nmc
