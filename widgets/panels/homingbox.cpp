// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/homingbox.h"

#include <QLabel>
#include <QVBoxLayout>

#include "model/intent/homingplan.h"
#include "module/stepperspeed.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/unitwords.h"
#include "widgets/panels/command.h"
#include "widgets/panels/homingform.h"
#include "widgets/panels/limitstopbox.h"
#include "widgets/panels/repeatabilitybox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

double speedUnit(const ModuleState& module) {
    const auto& parameters = module.stepper.parameters;
    return StepperSpeed(parameters ? parameters->speedMode : stepper::SpeedMode::X1).unit();
}

/// The stages of a search, as far as its recipe determines them beforehand.
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

HomingBox::HomingBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_stages(form::newParagraph(context.named(u"homingStagesLabel"_s), tr("Progress of the search"), this)),
      m_result(form::newParagraph(context.named(u"homingResultLabel"_s), tr("Progress of the search"), this)),
      m_hint(form::newRemark({}, this, context.named(u"homingHint"_s))) {
    const ModuleType type = context.state().info.identity.type;
    m_form = new HomingForm(type, this);
    m_home = new Command(
        {.name = context.named(u"homeButton"_s),
         .icon = u"home"_s,
         .text = tr("Home"),
         .accessible = tr("Home: search for it"),
         .key = Qt::CTRL | Qt::Key_H},
        this, [this] {
            m_context.ask(intent::Home{m_form->recipe(), homeTolerance(m_context.settings().unit)});
        });
    m_cancel = new Command({.name = context.named(u"cancelHomingButton"_s),
                            .icon = u"x"_s,
                            .text = tr("Cancel search"),
                            .accessible = tr("Cancel search for home"),
                            .key = Qt::CTRL | Qt::SHIFT | Qt::Key_H},
                           this, [this] { m_context.ask(intent::CancelProcedure{}); });
    look::name(this, context.named(u"homingBox"_s), Common::tr("Homing"));
    const int unit = look::gridUnit(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit, unit, 0, 0);
    layout->setSpacing(unit / 2);
    layout->addLayout(new FlowLayout(unit, {m_cancel->button(), m_home->button()}));
    layout->addWidget(m_stages);
    layout->addWidget(m_result);
    layout->addSpacing(unit / 2);
    layout->addWidget(m_form);
    layout->addSpacing(unit / 2);
    if (type != ModuleType::Stepper) {
        m_limitStop = new LimitStopBox(m_context, this);
        layout->addWidget(m_limitStop);
        layout->addSpacing(unit / 2);
    }
    layout->addWidget(new RepeatabilityBox(m_context, this));
    layout->addWidget(m_hint);  // it appears and disappears, and nothing may move under the pointer
    layout->addStretch(1);

    m_form->showRecipe(m_context.settings().homing.value_or(firstRecipe(m_context.state().info.identity)));
    m_shown = m_context.settings().homing;
    connect(m_form, &HomingForm::edited, this, &HomingBox::keepRecipe);
    m_context.whenSeen(this, [this] { showModule(); });
}

void HomingBox::keepRecipe() {
    if (m_context.settings().homing != m_form->recipe()) {
        m_shown = m_form->recipe();
        m_context.edit([recipe = m_form->recipe()](AxisSettings& axis) { axis.homing = recipe; });
    }
    refresh();
}

void HomingBox::showModule() {
    const ModuleState& module = m_context.state();
    const std::optional<HomingRecipe>& kept = m_context.settings().homing;
    // The value being typed is kept: only what was changed elsewhere is shown again.
    const HomingRecipe recipe = kept.value_or(firstRecipe(module.info.identity));
    if (kept != m_shown && recipe != m_form->recipe())
        m_form->showRecipe(recipe);
    m_shown = kept;
    m_form->showChip(m_context.scale(), module.info.identity, speedUnit(module));
    refresh();
}

std::optional<ProcedureReport> HomingBox::report() const {
    return m_context.connected() ? m_context.procedure(ProcedureKind::Homing) : std::nullopt;
}

QString HomingBox::whyNotNow() const {
    if (!m_context.connected())
        return texts::refusal(Refusal::NotConnected);
    if (m_context.runs(ProcedureKind::Homing))
        return Common::tr("A search for home is running.");
    if (const auto refusal = whyNotHome(m_context.state()))
        return texts::refusal(*refusal);
    if (!m_form->problemText().isEmpty())
        return m_form->problemText();
    if (const auto refusal = whyNotHome(m_form->recipe(), m_context.state()))
        return texts::refusal(*refusal);
    return m_context.whyBusy();
}

/// A search already has its recipe, and an operator searches with the one that is stored.
QString HomingBox::whyLocked() const {
    return m_context.runs(ProcedureKind::Homing) ? Common::tr("A search for home is running.")
                                                 : m_context.whyLocked();
}

void HomingBox::refresh() {
    m_form->setLocked(whyLocked());
    m_home->setPossible(whyNotNow(), tr("Moves the motor to search for home, as set above."));
    m_cancel->setPossible(
        m_context.runs(ProcedureKind::Homing) ? QString() : tr("No search for home is running."),
        tr("Stops the motor smoothly, without homing it."));
    const QString problem = m_form->problemText();
    look::setText(m_hint, problem);
    m_hint->setVisible(!problem.isEmpty());
    refreshProgress();
}

/// "✓ Searching   ▶ Going to home   · Setting position to 0": each stage is a shape followed by words.
QString HomingBox::stages() const {
    const auto search = report();
    QStringList words;
    for (int i = 0; i < m_course.size(); ++i) {
        ProcedureReport stage;
        stage.stage = m_course[i];
        const bool done = search && (search->stage == ProcedureStage::Done || i < m_reached);
        const bool now = m_context.runs(ProcedureKind::Homing) && i == m_reached;
        const QString mark = done ? u"✓"_s : now ? u"▶"_s : u"·"_s;
        words << mark + u'\u00A0' + texts::procedureStage(stage).replace(u' ', u'\u00A0');
    }
    return words.join(u"   "_s);
}

void HomingBox::refreshProgress() {
    const auto search = report();
    // What is set for the next search was not done by the last one.
    if (!search || m_course.isEmpty() || m_context.runs(ProcedureKind::Homing))
        m_course = stagesOf(effective(m_form->recipe(), m_context.state().info.identity));
    if (!search)
        m_reached = -1;
    else if (search->stage == ProcedureStage::Preparing)
        m_reached = 0;
    else if (m_course.contains(search->stage))
        m_reached = static_cast<int>(m_course.indexOf(search->stage));
    look::setText(m_stages, stages());
    QString result = search ? texts::procedureStage(*search) : tr("No search yet.");
    if (search && search->stage == ProcedureStage::Done && search->home)
        result = tr("Done: home was at %1.").arg(texts::position(m_context.scale(), *search->home));
    else if (search && search->failure)
        result = u"%1: %2"_s.arg(result, texts::procedureFailure(*search->failure));
    look::setText(m_result, result);
}

}  // namespace nmc
