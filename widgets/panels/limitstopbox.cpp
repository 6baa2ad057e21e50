// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/limitstopbox.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QLabel>
#include <QRadioButton>

#include "model/intent/homingplan.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
using Stop = HomingRecipe::Stop;
using Watch = HomeWatch::State;
constexpr std::array kManners{Stop::Abruptly, Stop::Smoothly, Stop::Off};

QString limits(const HomeWatch& watch) {
    QStringList names;
    if (watch.onLimit1())
        names << Common::tr("limit 1");
    if (watch.onLimit2())
        names << Common::tr("limit 2");
    if (watch.onPositionError())
        names << LimitStopBox::tr("the position error limit");
    if (watch.onCurrentLimit())
        names << LimitStopBox::tr("the current limit");
    if (names.size() < 2)
        return names.join(QString());
    const QString last = names.takeLast();
    return LimitStopBox::tr("%1 or %2").arg(names.join(u", "_s), last);
}
}  // namespace

LimitStopBox::LimitStopBox(ModuleContext& context, QWidget* parent)
    : QGroupBox(Common::tr("Limit stop"), parent),
      m_context(context),
      m_conditions{{
          {form::newCheck({u"armLimit1Box"_s, Common::tr("Limit 1"), tr("Limit 1: stop there")}, this),
           &ChipStop::onLimit1, tr("The motor stops when limit switch 1 changes.")},
          {form::newCheck({u"armLimit2Box"_s, Common::tr("Limit 2"), tr("Limit 2: stop there")}, this),
           &ChipStop::onLimit2, tr("The motor stops when limit switch 2 changes.")},
          {form::newCheck(
               {u"armPositionErrorBox"_s, Common::tr("Position error"), tr("Position error stops the motor")},
               this),
           &ChipStop::onPositionError,
           tr("The motor stops when the position error exceeds EL; this always switches the servo off.")},
          {form::newCheck({u"armCurrentBox"_s, tr("Current"), tr("Current stops the motor")}, this),
           &ChipStop::onCurrentLimit, tr("The motor stops when its current exceeds CL.")},
      }},
      m_each(form::newCheck({.name = u"armEachMotionBox"_s,
                             .text = tr("for each motion of this axis"),
                             .accessible = tr("For each motion of this axis, arm the limit stop")},
                            this)),
      m_arm(new Command({.name = u"armLimitStopButton"_s,
                         .text = tr("Arm limit stop"),
                         .key = Qt::CTRL | Qt::SHIFT | Qt::Key_L},
                        this, [this] { m_context.ask(wanted()); })),
      m_disarm(new Command({.name = u"disarmLimitStopButton"_s,
                            .text = tr("Disarm"),
                            .accessible = tr("Disarm limit stop"),
                            .key = Qt::CTRL | Qt::SHIFT | Qt::Key_D},
                           this, [this] { m_context.ask(intent::ArmLimitStop{}); })),
      m_state(form::newParagraph(u"limitStopState"_s, tr("State of the limit stop"), this)) {
    look::name(this, u"limitStopBox"_s, Common::tr("Limit stop"));
    const int unit = look::gridUnit(this);
    auto* limitRow = new FlowLayout(unit * 2);
    for (const Condition& condition : m_conditions) {
        limitRow->addWidget(condition.box);
        connect(condition.box, &QAbstractButton::clicked, this, &LimitStopBox::keep);
    }
    const std::array names{u"armAbruptlyButton"_s, u"armSmoothlyButton"_s, u"armMotorOffButton"_s};
    const std::array texts{Common::tr("Abruptly"), Common::tr("Smoothly"), Common::tr("Motor off")};
    const std::array accessible{tr("Abruptly: stop at the limit"), tr("Smoothly: stop at the limit"),
                                tr("Motor off at the limit")};
    auto* mannerRow = new FlowLayout(unit * 2);
    auto* group = new QButtonGroup(this);
    for (std::size_t i = 0; i < kManners.size(); ++i) {
        m_manners[i] = form::newRadio({names[i], texts[i], accessible[i]}, this);
        group->addButton(m_manners[i]);
        mannerRow->addWidget(m_manners[i]);
    }
    auto* grid = new FormGrid(this, 2, {.across = 1});
    grid->addTitled(tr("Stop at"), limitRow);
    grid->addTitled(Common::tr("How"), mannerRow);
    grid->addTitled(tr("Armed"), m_each);
    grid->addWide(m_state);
    grid->addWide(form::newLine(this, {nullptr, m_disarm->button(), m_arm->button()}));
    grid->setColumnStretch(1, 1);

    connect(m_each, &QAbstractButton::clicked, this, &LimitStopBox::keep);
    for (QAbstractButton* button : m_manners)
        connect(button, &QAbstractButton::clicked, this, &LimitStopBox::keep);
    m_context.whenSeen(this, [this] { showSettings(); });
}

void LimitStopBox::keep() {
    const LimitStopSettings settings{m_each->isChecked(), wanted()};
    m_shown = settings;
    m_context.edit([settings](AxisSettings& axis) { axis.limitStop = settings; });
    refresh();
}

void LimitStopBox::showSettings() {
    const LimitStopSettings& settings = m_context.settings().limitStop;
    if (m_shown != settings) {
        for (const Condition& condition : m_conditions)
            condition.box->setChecked(settings.stop.*condition.flag);
        m_each->setChecked(settings.eachMotion);
        for (std::size_t i = 0; i < kManners.size(); ++i)
            if (kManners[i] == settings.stop.manner)
                m_manners[i]->setChecked(true);
        m_shown = settings;
    }
    refresh();
}

bool LimitStopBox::isReplaced(const ModuleContext& context) {
    return context.runs(ProcedureKind::Homing) || context.runs(ProcedureKind::Repeatability);
}

intent::ArmLimitStop LimitStopBox::wanted() const {
    intent::ArmLimitStop arm;
    for (const Condition& condition : m_conditions)
        arm.*condition.flag = condition.box->isChecked();
    for (std::size_t i = 0; i < kManners.size(); ++i)
        if (m_manners[i]->isChecked())
            arm.manner = kManners[i];
    return arm;
}

QString LimitStopBox::whyNotArmed() const {
    if (!m_context.connected())
        return texts::refusal(Refusal::NotConnected);
    if (isReplaced(m_context))
        return tr("A search for home or a measurement is running and uses the same function of the chip.");
    if (const auto refusal = whyNotArm(wanted(), m_context.state()))
        return texts::refusal(*refusal);
    if (!wanted().any())
        return tr("Select a limit switch first.");
    return m_context.whyBusy();
}

void LimitStopBox::refresh() {
    const ModuleState& module = m_context.state();
    const QString never = m_context.reasonFor(IntentKind::ArmLimitStop);
    for (const Condition& condition : m_conditions)
        look::setPossible(condition.box, never, condition.meaning);
    look::setPossible(
        m_each, never,
        tr("The panel arms the limit stop whenever the motor is at rest with its servo on, even after a trip, and before any motion starts. Saved with the machine."));
    const std::array meanings{tr("At the limit the motor stops at once and holds."),
                              tr("At the limit the motor slows down, stops past it and holds."),
                              tr("At the limit the motor is switched off and is free to turn.")};
    for (std::size_t i = 0; i < kManners.size(); ++i)
        look::setPossible(m_manners[i], never, meanings[i]);
    m_arm->setPossible(
        whyNotArmed(),
        tr("The chip itself then stops the motor once when a selected limit switch changes, faster than the panel could. A search for home replaces it."));
    const bool armed = module.homing.state() != Watch::Idle ||
                       (module.latest && module.latest->servoStatus().homeInProgress());
    QString reason = never;
    if (reason.isEmpty() && isReplaced(m_context))
        reason = tr("A search for home or a measurement is running and uses the same function of the chip.");
    else if (reason.isEmpty() && m_each->isChecked())
        reason = tr("The limit stop is armed for each motion. Clear that check box first.");
    else if (reason.isEmpty())
        reason = armed ? m_context.whyBusy() : tr("The limit stop is not armed.");
    m_disarm->setPossible(reason, tr("A limit switch no longer stops the motor."));
    refreshState();
}

/// Shows the state as a shape followed by words.
void LimitStopBox::refreshState() {
    const ModuleState& module = m_context.state();
    const HomeWatch& watch = module.homing;
    const bool waits = module.latest && module.latest->servoStatus().homeInProgress();
    QString state = tr("○ Not armed: a limit switch alone does not stop the motor.");
    if (module.info.identity.version < servo::kAutoStopVersion)
        state = tr("○ This chip version cannot stop at a limit switch.");
    else if (isReplaced(m_context))
        state = tr("○ Not armed: the search for home or the measurement has replaced it.");
    else if (watch.state() == Watch::Armed && watch.stops())
        state = tr("● Armed: stops at %1, once.").arg(limits(watch));
    else if (watch.state() == Watch::Tripped && watch.stops())
        state = tr("▲ Tripped by %1; the motor was stopped. No longer armed.").arg(limits(watch));
    else if (waits)
        state = tr("? The chip watches for an event that this connection did not request.");
    look::setText(m_state, state);
}

}  // namespace nmc
