// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/steppermotionbox.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QRadioButton>
#include <cmath>

#include "model/intent/pace.h"
#include "model/intent/stepperplan.h"
#include "model/intent/travel.h"
#include "model/module/stepperdefaults.h"
#include "widgets/common/elidedlabel.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/common/workwords.h"
#include "widgets/panels/command.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepperMotionBox::StepperMotionBox(ModuleContext& context, QWidget* parent)
    : QGroupBox(Common::tr("Motion"), parent), m_context(context) {
    look::name(this, u"stepperMotionBox"_s, Common::tr("Motion"));
    auto* grid = new FormGrid(this);
    buildMode(grid);
    grid->addGap(0.5);
    buildFields(grid);
    buildButtons(grid);
    connectControls();
    showMode(Mode::Trapezoid);
    m_goal->setScale(m_context.scale());
    m_goal->showNative(0);
    m_context.whenSeen(this, [this] { showModule(); });
}

void StepperMotionBox::buildMode(FormGrid* grid) {
    auto* choice = new QWidget(this);
    look::name(choice, u"stepperModeChoice"_s, tr("Kind of motion"));
    auto* row = new FlowLayout(look::gridUnit(this) * 2, choice);
    m_modes = new QButtonGroup(this);
    const auto add = [&](Mode mode, const form::Check& check) {
        auto* button = form::newRadio(check, choice);
        row->addWidget(button);
        m_modes->addButton(button, static_cast<int>(mode));
    };
    add(Mode::Trapezoid, {.name = u"stepperModeTrapezoidal"_s,
                          .text = tr("Move"),
                          .meaning = tr("Moves to a position with ramps (trapezoidal profile mode).")});
    add(Mode::Profile,
        {.name = u"stepperModeProfile"_s,
         .text = tr("Run"),
         .meaning = tr("Ramps to a speed and keeps it until stopped (velocity profile mode).")});
    add(Mode::TimedMove,
        {.name = u"stepperModeTimedMove"_s,
         .text = tr("Move without ramp"),
         .meaning = tr(
             "Moves to a position at constant speed, without ramps. At too high a speed the motor loses steps (unprofiled, with stop).")});
    add(Mode::TimedRun,
        {.name = u"stepperModeTimedRun"_s,
         .text = tr("Run without ramp"),
         .meaning = tr(
             "Runs at constant speed, without a ramp, until stopped. At too high a speed the motor loses steps (unprofiled, without stop).")});
    grid->addWide(choice);
}

void StepperMotionBox::buildFields(FormGrid* grid) {
    m_goal = form::newQuantity({.kind = QuantityField::Kind::Position,
                                .name = u"stepperGoalField"_s,
                                .accessible = Common::tr("Goal position"),
                                .words = Common::tr("The goal position"),
                                .min = static_cast<double>(stepper::kPositionRange.min),
                                .max = static_cast<double>(stepper::kPositionRange.max),
                                .step = 100},
                               this);
    m_relative = form::newCheck({.name = u"stepperRelativeBox"_s,
                                 .text = tr("b&y this distance"),
                                 .accessible = tr("By this distance from the present position")},
                                this);
    m_speed = form::newQuantity({.kind = QuantityField::Kind::Velocity,
                                 .name = u"stepperSpeedField"_s,
                                 .accessible = Common::tr("Speed"),
                                 .words = tr("The speed"),
                                 .step = 25},
                                this);
    grid->addRow(tr("&Position"), m_goal);
    grid->addWide(m_relative, 1);
    grid->addRow(tr("Trave&l speed"), m_speed);
    m_outcome = look::newMutedLabel({}, this, u"stepperSpeedOutcome"_s);
    m_outcome->setBuddy(m_speed);  // as a label with a buddy, it wraps if there is little room
    m_ramp = newMutedLine(this, u"stepperRampOutcome"_s);
    grid->addWide(form::newLine(this, {m_outcome, {m_ramp, 1}}), 1);
    m_forecast = newMutedLine(this, u"stepperForecast"_s);
    m_nearest = new Command({.name = u"stepperNearestGoalButton"_s,
                             .text = Common::tr("Use nearest"),
                             .accessible = Common::tr("Use nearest allowed position")},
                            this, [this] { takeNearest(); });
    look::keepRoom(m_nearest->button());
    grid->addWide(form::newLine(this, {{m_forecast, 1}, m_nearest->button()}), 1);
}

void StepperMotionBox::buildButtons(FormGrid* grid) {
    m_go = new Command({.name = u"stepperGoButton"_s,
                        .icon = u"arrow-bar-to-right"_s,
                        .text = Common::tr("&Go"),
                        .accessible = Common::tr("Go to the position")},
                       this, [this] { request(false); });
    m_goHome = new Command({.name = u"stepperGoHomeButton"_s,
                            .icon = u"home"_s,
                            .text = Common::tr("Go home"),
                            .key = Qt::CTRL | Qt::SHIFT | Qt::Key_G},
                           this, [this] { m_context.ask(intent::GoHome{pace()}); });
    m_runReverse = new Command({.name = u"stepperRunReverseButton"_s,
                                .icon = u"arrow-left"_s,
                                .text = Common::tr("Run &reverse"),
                                .accessible = Common::tr("Run reverse until stopped")},
                               this, [this] { request(true); });
    m_runForward = new Command({.name = u"stepperRunForwardButton"_s,
                                .icon = u"arrow-right"_s,
                                .text = Common::tr("R&un forward"),
                                .accessible = Common::tr("Run forward until stopped")},
                               this, [this] { request(false); });
    m_loadOnly = form::newCheck(
        {.name = u"stepperLoadOnlyBox"_s,
         .text = tr("Load o&nly"),
         .accessible = tr("Load only, start later"),
         .meaning =
             tr("The buttons only load the motion. Choose Start loaded, or start the module's group.")},
        this);
    m_startLoaded = new Command({.name = u"stepperStartLoadedButton"_s,
                                 .text = tr("Start loaded"),
                                 .accessible = tr("Start loaded motion"),
                                 .key = Qt::CTRL | Qt::Key_G},
                                this, [this] { m_context.ask(intent::StartLoaded{}); });
    for (const Command* command : {m_go, m_runReverse, m_runForward}) {
        QPushButton* button = command->button();
        // As wide as its longest text, so that the button for the other direction does not move under the
        // pointer.
        const QString text = button->text();
        button->setText(tr("Stop, wait: %1").arg(text));
        button->setMinimumWidth(button->sizeHint().width());
        button->setText(text);
    }
    m_hint = new ElidedLabel(2, this);
    m_hint->setObjectName(u"stepperMotionHint"_s);
    grid->addWide(
        form::newLine(this, {m_go->button(), m_runReverse->button(), m_runForward->button(), nullptr}), 1);
    grid->addWide(form::newLine(this, {m_loadOnly, m_startLoaded->button(), nullptr, m_goHome->button()}), 1);
    grid->addWide(m_hint);
}

void StepperMotionBox::connectControls() {
    connect(m_modes, &QButtonGroup::idClicked, this, &StepperMotionBox::chooseMode);
    connect(m_goal, &QuantityField::nativeEdited, this, &StepperMotionBox::refresh);
    connect(m_goal, &NumberField::returnPressed, m_go, &Command::act);
    connect(m_relative, &QCheckBox::toggled, this, [this] {
        m_goal->setZero(zero(), true);
        refresh();
    });
    connect(m_speed, &QuantityField::nativeEdited, this, &StepperMotionBox::keepSpeed);
    connect(m_loadOnly, &QCheckBox::toggled, this, &StepperMotionBox::refresh);
    connect(&m_context, &ModuleContext::lookedForAnew, this, &StepperMotionBox::lookedForAnew);
}

StepperMotionBox::Mode StepperMotionBox::mode() const {
    return static_cast<Mode>(m_modes->checkedId());
}

void StepperMotionBox::showMode(Mode mode) {
    m_modes->button(static_cast<int>(mode))->setChecked(true);
}

double MotionSettings::*StepperMotionBox::speedSetting() const {
    return hasGoal() ? &MotionSettings::velocity : &MotionSettings::runVelocity;
}

void StepperMotionBox::chooseMode() {
    emit modeChosen();
    showSpeed();
    refresh();
}

void StepperMotionBox::lookedForAnew() {
    showMode(Mode::Trapezoid);
    m_goal->showNothing();  // nobody chose any number that could be put in its place
    m_relative->setChecked(false);
    m_loadOnly->setChecked(false);
    showSpeed();
    refresh();
}

void StepperMotionBox::showSpeed() {
    const StepperSpeed speeds = stepperdefaults::speedMode(m_context.state().stepper, m_context.settings());
    const double set = m_context.settings().motion.*speedSetting();
    const double fallback = hasGoal() ? stepperdefaults::kMove : stepperdefaults::kRun;
    m_shownSpeed = set;
    m_shownSpeeds = speeds;
    const double slowest = profiled() ? speeds.slowest() : speeds.slowestTimed();
    const double chip = profiled() ? speeds.fastest() : speeds.fastestTimed();
    const double fastest = std::max(slowest, stepperdefaults::atMost(chip, m_context.settings()));
    m_shownFastest = m_context.settings().travel.fastest;
    m_speed->setNativeRange(slowest, fastest);
    m_speed->setRangeReason(texts::fastestReason(m_context.settings().travel));
    m_speed->setMeaning(
        tr("How fast the motor turns: %1 to %2 in this speed mode. The chip uses the nearest speed available.")
            .arg(texts::stepsPerSecond(slowest, m_speed->scale()),
                 texts::stepsPerSecond(fastest, m_speed->scale())));
    m_speed->showNative(set > 0 ? set : std::clamp(fallback, slowest, fastest));
}

void StepperMotionBox::keepSpeed() {
    if (const auto speed = m_speed->native()) {
        const auto part = speedSetting();
        m_context.edit([part, speed](AxisSettings& axis) { axis.motion.*part = *speed; });
    }
    refresh();
}

std::optional<WorkZero> StepperMotionBox::zero() const {
    return m_relative->isChecked() ? std::nullopt : m_context.state().home.workZero();
}

void StepperMotionBox::showModule() {
    m_goal->setScale(m_context.scale());
    m_goal->setZero(zero());
    const bool otherUnit = m_context.scale() != m_speed->scale();
    const double set = m_context.settings().motion.*speedSetting();
    const bool otherSpeed = std::exchange(m_shownSpeed, set) != set && m_speed->native() != set;
    m_speed->setScale(m_context.scale());
    if (otherUnit ||
        m_shownSpeeds != stepperdefaults::speedMode(m_context.state().stepper, m_context.settings()) ||
        otherSpeed || m_shownFastest != m_context.settings().travel.fastest)
        showSpeed();
    refresh();
}

std::uint8_t StepperMotionBox::chipSpeed(double speed) const {
    return stepperdefaults::speedFor(speed, m_context.state().stepper, m_context.settings());
}

stepper::TimerCount StepperMotionBox::chipTimer(double speed) const {
    return stepperdefaults::timerFor(speed, m_context.state().stepper, m_context.settings());
}

std::optional<StepperMotion> StepperMotionBox::motion(bool reverse) const {
    const auto goal = m_goal->native();
    const auto speed = m_speed->native();
    if (!speed || (hasGoal() && !goal))
        return std::nullopt;
    const auto position = static_cast<std::int32_t>(goal.value_or(0));
    const std::uint8_t acceleration = stepperdefaults::accelerationTime(m_context.settings());
    switch (mode()) {
        case Mode::Trapezoid:
            return steppermotion::Trapezoid{position, m_relative->isChecked(), chipSpeed(*speed),
                                            acceleration};
        case Mode::Profile:
            return steppermotion::VelocityProfile{chipSpeed(*speed), acceleration,
                                                  m_context.chipReverse(reverse)};
        case Mode::TimedMove:
            return steppermotion::UnprofiledMove{position, m_relative->isChecked(), chipTimer(*speed)};
        case Mode::TimedRun:
            return steppermotion::UnprofiledRun{chipTimer(*speed), m_context.chipReverse(reverse)};
    }
    return std::nullopt;
}

QString StepperMotionBox::whyNoMovesBy() const {
    return hasGoal() ? m_speed->problemText() : QString();
}

std::optional<Intent> StepperMotionBox::movesBy(const Rounds& moves) const {
    return intent::MoveBy{moves, pace()};
}

Pace StepperMotionBox::pace() const {
    const auto speed = hasGoal() ? m_speed->native() : std::nullopt;
    if (!speed)
        return paceOf(m_context.state(), m_context.settings());
    return bus::StepperPace{chipSpeed(*speed), stepperdefaults::accelerationTime(m_context.settings())};
}

std::optional<Refusal> StepperMotionBox::refusalOf(bool reverse) const {
    if (!m_context.connected())
        return Refusal::NotConnected;
    const auto wanted = motion(reverse);
    // While there is no complete motion, only what any motion needs is checked.
    if (!wanted)
        return m_context.whyNot(IntentKind::Run);
    if (!m_loadOnly->isChecked())
        return whyNot(*wanted, m_context.state());
    const auto load = plan(intent::LoadMove{*wanted}, m_context.state());
    return load ? std::nullopt : std::optional(load.error());
}

bool StepperMotionBox::viaStop(bool reverse) const {
    return refusalOf(reverse) == Refusal::NeedsStop && !m_loadOnly->isChecked() &&
           !whyNotFromStandstill(*motion(reverse), m_context.state());
}

QString StepperMotionBox::reasonFor(bool reverse) const {
    if (const auto refusal = refusalOf(reverse); refusal && !viaStop(reverse)) {
        const auto wanted = motion(reverse);
        return wanted ? texts::refusal(*refusal, intent::Move{*wanted}, m_context.state(), m_context.scale())
                      : texts::refusal(*refusal);
    }
    if (hasGoal() && m_goal->problem() != NumberField::Problem::None)
        return m_goal->problemText();
    return m_speed->problemText();
}

std::optional<std::int32_t> StepperMotionBox::nearest() const {
    const auto wanted = hasGoal() ? motion(false) : std::nullopt;
    const auto problem = wanted ? travelProblem(intent::Move{*wanted}, m_context.state()) : std::nullopt;
    if (!problem || problem->refusal != Refusal::BeyondTravel)
        return std::nullopt;
    return problem->nearest;
}

void StepperMotionBox::takeNearest() {
    const auto goal = nearest();
    if (!goal)
        return;
    m_relative->setChecked(false);
    m_goal->showNative(*goal);
    m_goal->setFocus();
    refresh();
}

void StepperMotionBox::offerNearest() {
    const auto goal = nearest();
    m_nearest->setVisible(goal.has_value());
    if (!goal)
        return;
    m_nearest->setText(
        Common::tr("Use %1").arg(texts::place(m_context.state().home.workZero(), m_goal->scale(), *goal)));
    m_nearest->setPossible({}, Common::tr("Sets the goal to the nearest allowed position. Nothing moves."));
}

void StepperMotionBox::request(bool reverse) {
    const auto wanted = motion(reverse);
    if (!wanted || !reasonFor(reverse).isEmpty())
        return;
    if (m_loadOnly->isChecked())
        m_context.ask(intent::LoadMove{*wanted});
    else if (viaStop(reverse))
        m_context.ask(intent::ChangeMotion{*wanted});
    else
        m_context.ask(intent::Move{*wanted});
}

QString StepperMotionBox::outcome() const {
    const auto speed = m_speed->native();
    if (!speed)
        return m_speed->problemText();
    const StepperSpeed speeds = stepperdefaults::speedMode(m_context.state().stepper, m_context.settings());
    if (!profiled())
        return texts::timedSpeed(speeds, chipTimer(*speed), m_speed->scale());
    const auto& parameters = m_context.state().stepper.parameters;
    return texts::profiledSpeed(speeds, chipSpeed(*speed), parameters ? parameters->minimumProfileSpeed : 1,
                                m_speed->scale());
}

/// Returns the duration and peak speed to show before the start.
QString StepperMotionBox::forecast() const {
    const auto speed = m_speed->native();
    const ModuleState& module = m_context.state();
    if (!speed || !module.stepper.parameters)
        return {};
    const StepperSpeed speeds = stepperdefaults::speedMode(m_context.state().stepper, m_context.settings());
    const int minimum = module.stepper.parameters->minimumProfileSpeed;
    const int acceleration = stepperdefaults::accelerationTime(m_context.settings());
    if (!hasGoal()) {
        if (!profiled())
            return tr("At constant speed, without a ramp.");
        const int units = std::max(0, chipSpeed(*speed) - minimum);
        return tr("Takes %1 s from standstill.").arg(texts::readout(units * acceleration * 0.00025, 3));
    }
    const auto goal = m_goal->native();
    const auto position = module.stepper.position();
    if (!goal || !position || module.moving())
        return {};
    const double way = m_relative->isChecked() ? *goal : *goal - *position;
    if (profiled())
        return texts::forecast(forecastMove(speeds, minimum, chipSpeed(*speed), acceleration, way),
                               m_speed->scale());
    const double rate = speeds.ofCount(chipTimer(*speed).count);
    return texts::forecast({std::abs(way) / rate, way == 0 ? 0 : rate, false}, m_speed->scale());
}

void StepperMotionBox::refreshCommand(Command& command, bool reverse, const QString& text,
                                      const QString& meaning) {
    const QString reason = reasonFor(reverse);
    const bool stopsFirst = m_context.connected() && viaStop(reverse);
    command.setText(stopsFirst ? tr("Stop, wait: %1").arg(text) : text);
    command.setPossible(
        reason.isEmpty() ? m_context.whyBusy() : reason,
        stopsFirst ? tr("Stops smoothly, waits until the motor is at rest, then: %1").arg(meaning) : meaning);
}

void StepperMotionBox::refreshCommands() {
    const bool load = m_loadOnly->isChecked();
    const QString later = tr("Loads the motion without starting it.");
    m_go->setVisible(hasGoal());
    m_runReverse->setVisible(!hasGoal());
    m_runForward->setVisible(!hasGoal());
    refreshCommand(*m_go, false, load ? Common::tr("Load") : Common::tr("&Go"),
                   load ? later : Common::tr("Moves to the position, then holds."));
    refreshCommand(*m_runReverse, true, load ? tr("Load &reverse") : Common::tr("Run &reverse"),
                   load ? later : Common::tr("Runs in reverse until stopped."));
    refreshCommand(*m_runForward, false, load ? tr("Load forward") : Common::tr("R&un forward"),
                   load ? later : Common::tr("Runs forward until stopped."));
    QString reason = m_context.reasonNow(IntentKind::GoHome);
    if (reason.isEmpty())
        reason = whyNoMovesBy();
    if (reason.isEmpty())
        reason = m_context.reasonFor(Intent(intent::GoHome{pace()}));
    m_goHome->setPossible(reason, tr("Moves to home with a ramp, at the travel speed."));
    m_startLoaded->setPossible(m_context.reasonNow(IntentKind::StartLoaded), tr("Starts the loaded motion."));
}

void StepperMotionBox::refresh() {
    const QString unused = hasGoal() ? QString() : tr("A run has no goal.");
    m_goal->setMeaning(hasGoal() ? tr("The goal of the move. Press Enter to start.") : unused);
    m_goal->setEnabled(hasGoal());
    look::setPossible(m_relative, unused, tr("The distance counts from where the motor is at the start."));
    look::setText(m_outcome, outcome());
    look::setText(
        m_ramp, profiled()
                    ? texts::ramp(stepperdefaults::speedMode(m_context.state().stepper, m_context.settings()),
                                  stepperdefaults::accelerationTime(m_context.settings()), m_speed->scale())
                    : tr("No ramp."));
    look::setText(m_forecast, forecast());
    refreshCommands();
    offerNearest();
    QString hint = hasGoal() ? m_goal->problemText() : QString();
    if (hint.isEmpty())
        hint = m_speed->problemText();
    if (hint.isEmpty() && m_context.connected())
        hint = nearest() ? reasonFor(false) : m_context.reasonFor(IntentKind::Run);
    look::setText(m_hint, hint);
}

}  // namespace nmc
