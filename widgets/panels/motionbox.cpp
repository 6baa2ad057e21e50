// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/motionbox.h"

#include <limits>
#include <utility>

#include "model/intent/moveforecast.h"
#include "model/intent/travel.h"
#include "model/module/servodefaults.h"
#include "widgets/common/elidedlabel.h"
#include "widgets/common/form.h"
#include "widgets/common/homewords.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/common/workwords.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
enum GoalKind { Absolute, Relative };
constexpr double kMostCounts = std::numeric_limits<std::int32_t>::max();
}  // namespace

MotionBox::MotionBox(ModuleContext& context, QWidget* parent)
    : QGroupBox(parent), m_context(context), m_motion(servodefaults::motionOf(context.settings())) {
    look::name(this, u"motionBox"_s, Common::tr("Motion"));
    auto* grid = new FormGrid(this);
    buildMove(grid);
    buildRun(grid);
    m_hint = new ElidedLabel(1, this);
    m_hint->setObjectName(u"motionHint"_s);
    grid->addWide(m_hint);
    for (QuantityField* field : {m_goal, m_velocity, m_acceleration, m_runVelocity})
        field->setScale(m_context.scale());
    m_goal->showNative(0);
    m_velocity->showNative(m_motion.velocity);
    m_acceleration->showNative(m_motion.acceleration);
    m_runVelocity->showNative(m_motion.runVelocity);
    connect(m_acceleration, &QuantityField::nativeEdited, this, &MotionBox::accelerationEdited);
    connect(&m_context, &ModuleContext::lookedForAnew, this, &MotionBox::forgetGoal);
    m_context.whenSeen(this, [this] { showModule(); });
}

QuantityField* MotionBox::newField(const QString& objectName, const QString& name, const QString& meaning,
                                   double MotionSettings::*part) {
    const bool acceleration = part == &MotionSettings::acceleration;
    auto* field = form::newQuantity(
        {.kind = acceleration ? QuantityField::Kind::Acceleration : QuantityField::Kind::Velocity,
         .name = objectName,
         .accessible = name,
         .min = servodefaults::kSmallest,
         .max = servodefaults::kLargest,
         .step = acceleration ? 0.0005 : 0.05,
         .meaning = meaning},
        this);
    connect(field, &QuantityField::nativeEdited, this, [this, field, part] { keep(*field, part); });
    return field;
}

void MotionBox::buildMove(FormGrid* grid) {
    m_goal = form::newQuantity(
        {.kind = QuantityField::Kind::Position,
         .name = u"goalField"_s,
         .accessible = Common::tr("Goal position"),
         .words = Common::tr("The goal position"),
         .min = static_cast<double>(servo::kPositionRange.min),
         .max = static_cast<double>(servo::kPositionRange.max),
         .step = 100,
         .meaning = tr("The goal of a trapezoidal move from standstill. Press Enter to start.")},
        this);
    m_goalKind = form::newChoice(
        {.name = u"goalKindBox"_s,
         .accessible = tr("Position or distance"),
         .options = {{Common::tr("position"), Absolute}, {tr("distance"), Relative}},
         .meaning = tr("Whether the number is a position, or a distance from the present position.")},
        this);
    m_velocity = newField(u"velocityField"_s, tr("Velocity of the move"), tr("How fast the motor turns."),
                          &MotionSettings::velocity);
    m_acceleration =
        newField(u"accelerationField"_s, Common::tr("Acceleration"),
                 tr("Used by every motion here, and by a smooth stop."), &MotionSettings::acceleration);
    form::setBold(grid->addRow(tr("Go to &position"), m_goal, {m_goalKind}));
    grid->addRow(tr("Ve&locity"), m_velocity);
    grid->addRow(tr("Acceleratio&n"), m_acceleration);
    m_forecast = newMutedLine(this, u"forecastLabel"_s);
    m_nearest = new Command({.name = u"nearestGoalButton"_s,
                             .text = Common::tr("Use nearest"),
                             .accessible = Common::tr("Use nearest allowed position")},
                            this, [this] { takeNearest(); });
    look::keepRoom(m_nearest->button());
    grid->addWide(form::newLine(this, {{m_forecast, 1}, m_nearest->button()}), 1);

    m_zero = new Command({.name = u"zeroHereButton"_s,
                          .icon = u"eraser"_s,
                          .text = tr("&Zero here"),
                          .accessible = Common::tr("Zero here: set the present position to 0")},
                         this, [this] { m_context.ask(intent::ResetPosition{}); });
    m_goHome = new Command({.name = u"goHomeButton"_s,
                            .icon = u"home"_s,
                            .text = Common::tr("Go home"),
                            .key = Qt::CTRL | Qt::SHIFT | Qt::Key_G},
                           this, [this] { goHome(); });
    m_load = new Command({.name = u"loadButton"_s,
                          .icon = u"download"_s,
                          .text = Common::tr("Load"),
                          .accessible = tr("Load the move, start it later"),
                          .key = Qt::CTRL | Qt::Key_D},
                         this, [this] { move(true); });
    m_start = new Command({.name = u"startButton"_s,
                           .icon = u"player-play"_s,
                           .text = tr("Start"),
                           .accessible = tr("Start the loaded move"),
                           .key = Qt::CTRL | Qt::Key_G},
                          this, [this] { m_context.ask(intent::StartLoaded{}); });
    m_go = new Command({.name = u"goButton"_s,
                        .icon = u"arrow-bar-to-right"_s,
                        .text = Common::tr("&Go"),
                        .accessible = Common::tr("Go to the position")},
                       this, [this] { move(false); });
    grid->addWide(form::newLine(this, {m_zero->button(), m_goHome->button(), nullptr, m_load->button(),
                                       m_start->button(), m_go->button()}));
    connect(m_goal, &QuantityField::nativeEdited, this, &MotionBox::refresh);
    connect(m_goal, &QuantityField::returnPressed, m_go, &Command::act);
    connect(m_goalKind, &QComboBox::currentIndexChanged, this, [this] {
        m_goal->setZero(zero(), true);
        refresh();
    });
}

void MotionBox::buildRun(FormGrid* grid) {
    m_runVelocity =
        newField(u"runVelocityField"_s, tr("Velocity of running"),
                 tr("The velocity of a run. Press Enter to run, or to change the velocity during a run."),
                 &MotionSettings::runVelocity);
    m_runReverse = new Command({.name = u"runReverseButton"_s,
                                .icon = u"arrow-left"_s,
                                .text = Common::tr("Run &reverse"),
                                .accessible = Common::tr("Run reverse until stopped")},
                               this, [this] { run(true); });
    m_runForward = new Command({.name = u"runForwardButton"_s,
                                .icon = u"arrow-right"_s,
                                .text = Common::tr("R&un forward"),
                                .accessible = Common::tr("Run forward until stopped")},
                               this, [this] { run(false); });
    form::setBold(grid->addRow(tr("Run at velocit&y"), m_runVelocity,
                               {form::newLine(this, {m_runReverse->button(), m_runForward->button()})}));
    // During a run, Enter changes the velocity but not the direction. Any other motion it leaves alone,
    // because a run forward could turn it round: a run to a travel limit is a move, and another host may have
    // started it.
    connect(m_runVelocity, &QuantityField::returnPressed, this, [this] {
        const ModuleState& module = m_context.state();
        const bool runs = module.motion == MotionMode::Velocity && module.goalVelocity != 0.0;
        if (module.moving() && !runs)
            return;
        const bool reverse = module.moving() && m_context.chipReverse(module.goalVelocity < 0);
        (reverse ? m_runReverse : m_runForward)->act();
    });
}

std::optional<WorkZero> MotionBox::zero() const {
    return relative() ? std::nullopt : m_context.state().home.workZero();
}

bool MotionBox::relative() const {
    return form::chosen<GoalKind>(m_goalKind) == Relative;
}

std::optional<CountsPerTickSquared> MotionBox::acceleration() const {
    const auto value = m_acceleration->native();
    return value ? std::optional(CountsPerTickSquared(servodefaults::toFixed(*value))) : std::nullopt;
}

std::optional<CountsPerTick> MotionBox::velocity() const {
    const auto value = m_velocity->native();
    return value ? std::optional(CountsPerTick(servodefaults::toFixed(*value))) : std::nullopt;
}

QString MotionBox::whyNoMovesBy() const {
    if (!velocity())
        return texts::refusal(Refusal::NoVelocity);
    return acceleration() ? QString() : texts::refusal(Refusal::NoAcceleration);
}

std::optional<Intent> MotionBox::movesBy(const Rounds& moves) const {
    const auto wanted = pace();
    return wanted ? std::optional<Intent>(intent::MoveBy{moves, *wanted}) : std::nullopt;
}

std::optional<ServoPace> MotionBox::pace() const {
    const auto velocity = this->velocity();
    const auto acceleration = this->acceleration();
    return velocity && acceleration ? std::optional(ServoPace{*velocity, *acceleration}) : std::nullopt;
}

/// Keeps a typed value with the axis; what is not a valid value stays in its field only.
void MotionBox::keep(const QuantityField& field, double MotionSettings::*part) {
    if (const auto typed = field.native())
        m_context.edit([part, typed](AxisSettings& axis) { axis.motion.*part = *typed; });
    refresh();
}

/// A number in place of the typed one would be a goal that nobody chose, one press of Enter away.
void MotionBox::forgetGoal() {
    m_goalKind->setCurrentIndex(Absolute);
    m_goal->showNothing();
    refresh();
}

void MotionBox::showModule() {
    const MotionSettings before = std::exchange(m_motion, servodefaults::motionOf(m_context.settings()));
    for (QuantityField* field : {m_goal, m_velocity, m_acceleration, m_runVelocity})
        field->setScale(m_context.scale());
    m_goal->setZero(zero());
    for (QuantityField* field : {m_velocity, m_runVelocity}) {
        field->setNativeRange(servodefaults::kSmallest,
                              std::min(servodefaults::fastest(m_context.state().info.identity),
                                       servodefaults::fastest(m_context.settings())));
        field->setRangeReason(texts::fastestReason(m_context.settings().travel));
    }
    m_velocity->follow(m_motion.velocity, before.velocity);
    m_acceleration->follow(m_motion.acceleration, before.acceleration);
    m_runVelocity->follow(m_motion.runVelocity, before.runVelocity);
    refresh();
}

QString MotionBox::reasonNow(IntentKind kind, std::initializer_list<const QuantityField*> fields) const {
    if (const QString reason = m_context.reasonFor(kind); !reason.isEmpty())
        return reason;
    for (const QuantityField* field : fields) {
        if (field->problem() == NumberField::Problem::None)
            continue;
        NumberField::Problem ignored = NumberField::Problem::None;
        if (field != m_goal && NumberField::parse(field->text(), false, &ignored) == 0.0)
            return texts::refusal(field == m_acceleration ? Refusal::NoAcceleration : Refusal::NoVelocity);
        return field->problemText();
    }
    return m_context.whyBusy();
}

std::optional<servomotion::Trapezoid> MotionBox::entered() const {
    const auto goal = m_goal->native();
    const auto wanted = pace();
    if (!goal || !wanted)
        return std::nullopt;
    double counts = *goal;
    if (relative()) {
        const auto& latest = m_context.state().latest;
        if (!latest || !latest->position)
            return std::nullopt;
        counts += *latest->position;
    }
    if (std::abs(counts) > kMostCounts)
        return std::nullopt;
    return servomotion::Trapezoid{Counts(static_cast<std::int32_t>(counts)), wanted->velocity,
                                  wanted->acceleration};
}

std::optional<servomotion::VelocityProfile> MotionBox::enteredRun(bool reverse) const {
    const auto velocity = m_runVelocity->native();
    const auto acceleration = this->acceleration();
    if (!velocity || !acceleration)
        return std::nullopt;
    return servomotion::VelocityProfile{CountsPerTick(servodefaults::toFixed(*velocity)), *acceleration,
                                        m_context.chipReverse(reverse)};
}

std::optional<std::int32_t> MotionBox::nearest() const {
    const auto wanted = entered();
    const auto problem = wanted ? travelProblem(intent::Move{*wanted}, m_context.state()) : std::nullopt;
    if (!problem || problem->refusal != Refusal::BeyondTravel)
        return std::nullopt;
    return problem->nearest;
}

/// Offers the nearest position within the travel limits if the goal is beyond them.
void MotionBox::offerNearest() {
    const auto goal = nearest();
    m_nearest->setVisible(goal.has_value());
    if (!goal)
        return;
    m_nearest->setText(
        Common::tr("Use %1").arg(texts::place(m_context.state().home.workZero(), m_goal->scale(), *goal)));
    m_nearest->setPossible({}, Common::tr("Sets the goal to the nearest allowed position. Nothing moves."));
}

void MotionBox::takeNearest() {
    const auto goal = nearest();
    if (!goal)
        return;
    m_goalKind->setCurrentIndex(Absolute);
    m_goal->showNative(*goal);
    m_goal->setFocus();
    refresh();
}

void MotionBox::refreshRun(Command& command, bool reverse, const QString& meaning) {
    QString reason = reasonNow(IntentKind::Run, {m_runVelocity, m_acceleration});
    if (const auto run = enteredRun(reverse); reason.isEmpty() && run)
        reason = m_context.reasonFor(intent::Move{*run});
    command.setPossible(reason, meaning);
}

void MotionBox::refreshForecast() {
    QString text;
    const auto velocity = m_velocity->native();
    const auto acceleration = m_acceleration->native();
    const ModuleState& module = m_context.state();
    const auto& latest = module.latest;
    // A moving motor has no place from which the move would start.
    if (const auto wanted = entered(); wanted && latest && latest->position && !module.moving()) {
        const AxisScale& scale = m_velocity->scale();
        const double way = static_cast<double>(wanted->position.value()) - *latest->position;
        const auto perSecond = scale.perSecond();
        const MoveForecast move = forecast(way, *velocity, *acceleration, perSecond.value_or(1.0));
        const QString seconds = tr("%1 s").arg(texts::readout(move.seconds, 3));
        const QString peak = texts::velocity(scale, move.peakVelocity, 3);
        if (way == 0.0)
            text = tr("Already there");
        else if (!perSecond)  // the length of a tick is unknown
            text =
                (move.triangular ? tr("Peak %1: too short to reach its velocity") : tr("Peak %1")).arg(peak);
        else
            text = move.triangular
                       ? tr("Takes %1, peak %2: too short to reach its velocity").arg(seconds, peak)
                       : tr("Takes %1, peak %2").arg(seconds, peak);
    }
    look::setText(m_forecast, text);
}

void MotionBox::refresh() {
    refreshForecast();
    const auto wanted = entered();
    const auto whyNo = [this, &wanted](IntentKind kind, bool later) {
        QString reason = reasonNow(kind, {m_goal, m_velocity, m_acceleration});
        if (reason.isEmpty() && !wanted)
            reason = tr("The goal is outside the position range.");
        if (reason.isEmpty())
            reason = m_context.reasonFor(later ? Intent(intent::LoadMove{*wanted}) : intent::Move{*wanted});
        return reason;
    };
    offerNearest();
    m_go->setPossible(whyNo(IntentKind::Move, false), Common::tr("Moves to the position, then holds."));
    // While the motor moves, a distance has no definite start.
    m_load->setPossible(whyNo(relative() ? IntentKind::Move : IntentKind::Load, true),
                        tr("Loads the move without starting it. Choose Start, or start the module's group."));
    m_start->setPossible(m_context.reasonNow(IntentKind::StartLoaded), tr("Starts the loaded move."));
    QString home = reasonNow(IntentKind::GoHome, {m_velocity, m_acceleration});
    if (home.isEmpty())
        home = m_context.reasonFor(intent::GoHome{*pace()});
    m_goHome->setPossible(home, tr("Moves to home."));
    m_zero->setPossible(m_context.reasonNow(IntentKind::ResetPosition),
                        texts::zeroMeaning(m_context.state(), m_goal->scale()));
    const ModuleState& module = m_context.state();
    refreshRun(*m_runForward, false,
               travelEnd(module, m_context.chipReverse(false))
                   ? tr("Runs forward until stopped, or to its highest position.")
                   : Common::tr("Runs forward until stopped."));
    refreshRun(*m_runReverse, true,
               travelEnd(module, m_context.chipReverse(true))
                   ? tr("Runs in reverse until stopped, or to its lowest position.")
                   : Common::tr("Runs in reverse until stopped."));

    QString hint;
    for (const QuantityField* field : {m_goal, m_velocity, m_acceleration, m_runVelocity})
        if (hint.isEmpty())
            hint = field->problemText();
    if (const auto problem = wanted ? travelProblem(intent::Move{*wanted}, module) : std::nullopt;
        problem && hint.isEmpty())
        hint = texts::travelProblem(*problem, module, m_goal->scale());
    look::setText(m_hint, hint);
}

void MotionBox::move(bool later) {
    if (const auto wanted = entered())
        m_context.ask(later ? Intent(intent::LoadMove{*wanted}) : intent::Move{*wanted});
}

void MotionBox::goHome() {
    if (const auto wanted = pace())
        m_context.ask(intent::GoHome{*wanted});
}

void MotionBox::run(bool reverse) {
    if (const auto run = enteredRun(reverse))
        m_context.ask(intent::Move{*run});
}

}  // namespace nmc
