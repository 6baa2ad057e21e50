// SPDX-License-Identifier: MIT
#include "bus/plausibility.h"

#include <algorithm>
#include <cmath>

#include "module/commandfacts.h"

namespace nmc::bus {

namespace {

constexpr std::uint8_t kHomingBit = 0x80;            // both chips
constexpr std::uint8_t kStickyStatus = 0x04 | 0x10;  // overcurrent, pos_error
constexpr std::uint8_t kStickyAux = 0x02 | 0x20;     // pos_wrap, servo_overrun
/// Undefined bits of item 3 of the motor chips.
constexpr unsigned undefinedAux(const ModuleIdentity& module) {
    return hasPathBuffer(module) ? 0x80U : 0xC0U;  // path mode
}
constexpr std::uint16_t kLongestTimerCount = 65'452;  // DS-S 4.1
/// How fast the spread of recent velocities decays, per reply.
constexpr double kFade = 0.9;
/// Unexplained speed, in counts per tick, that a uniform motion never exceeds.
constexpr double kSwings = 8.0;

[[nodiscard]] double ticks(Duration time) {
    return toSeconds(time) / toSeconds(kServoTick);
}

[[nodiscard]] double distance(std::int32_t from, std::int32_t to) {
    return countsBetween(from, to);
}

/// A reply without the item that a rule checks neither violates the rule nor confirms it.
[[nodiscard]] bool carries(Rejection rule, const StatusReport& report) {
    using enum Rejection;
    if (rule == HomeChanged)
        return report.home.has_value();
    if (rule == UndefinedBits || rule == StickyCleared)
        return report.aux.has_value();
    const bool ofMotion = rule == PositionJump || rule == VelocityJump || rule == MovedWhileStopped;
    return !ofMotion || report.position.has_value();
}

}  // namespace

struct Plausibility::Sent {
    Plausibility& p;
    const ServoRegisters& sent;
    TimePoint latched;

    void operator()(const ResetPosition&) const { p.m_counter = 0; }
    void operator()(const servo::SetPosition& set) const { p.m_counter = set.position.value(); }
    void operator()(const servo::ResetRelativeToHome&) const {
        if (p.m_known.position && p.m_known.home && !p.m_home.isOpen())
            p.m_counter = countsBetween(*p.m_known.home, *p.m_known.position);
    }
    void operator()(const SaveAsHome&) const { p.m_home.open(latched); }
    void operator()(const servo::SetHoming&) const { homing(); }
    void operator()(const stepper::SetHoming&) const { homing(); }
    void operator()(const servo::ClearStickyBits&) const { p.m_sticky.open(latched); }
    void operator()(const stepper::LoadTrajectory&) const { p.m_motion.open(latched); }
    void operator()(const stepper::StopMotor&) const { p.m_motion.open(latched); }
    void operator()(const StartMotion&) const {
        p.m_motion.open(latched);
        started();
    }
    void operator()(const servo::LoadTrajectory& load) const {
        if (load.startNow)
            started();
    }
    void operator()(const servo::StopMotor& stop) const {
        p.m_mayEnable = latched;
        p.m_mayRun = p.m_mayRun && stop.manner == servo::StopManner::AmplifierOnly;
        const bool known = stop.manner == servo::StopManner::Here && p.m_known.position;
        const double travelled = known ? std::abs(distance(*p.m_known.position, stop.here.value())) : 0.0;
        p.jerk(latched, 2 * travelled + kSwing);
    }
    void operator()(const servo::SetGain& gain) const {
        // Until the answer, the old gains may still be in use.
        if (p.m_divisor)
            p.m_divisor = std::max(*p.m_divisor, gain.sr);
        if (p.m_errorLimit)
            p.m_errorLimit = std::max(*p.m_errorLimit, gain.el);
        p.jerk(latched, kSwing);
    }
    /// A path has no acceleration: its speed may change from one point to the next.
    void operator()(const servo::AddPathPoints& add) const {
        p.m_mayRun = true;
        p.m_mayEnable = latched;
        double fastest = 0;  // counts per tick
        for (const unsigned word : add.words())
            fastest = std::max(fastest, (word & ~3U) / 256.0);
        p.jerk(latched, 1.5 * fastest * ticks(kJerkTime) + kSwing);
    }
    void operator()(const auto& /*other*/) const {}

    void started() const {
        p.m_mayRun = !sent.load.isTrapezoidal();
        p.m_mayEnable = latched;
        p.jerk(latched, p.reachOf(sent));
    }
    void homing() const {
        p.m_homing.open(latched);
        p.m_home.open(latched);
        p.m_motion.open(latched);
        p.jerk(latched, kSwing);
    }
};

void Plausibility::onAnswered(const ModuleCommand& command) {
    const auto* gain = getIf<servo::SetGain>(command);
    if (gain == nullptr)
        return;
    m_divisor = gain->sr;
    m_errorLimit = gain->el;
}

void Plausibility::jerk(TimePoint at, double reach) {
    // A motion that was commanded earlier may have been under way for all of a long time without a reply.
    const bool goesOnUnseen = m_jerk && m_commandedAt && at - m_known.from >= kJerkTime;
    m_jerk = Jerk{at, jerked(at) || goesOnUnseen ? std::max(m_jerk->reach, reach) : reach};
    m_commandedAt = at;
}

bool Plausibility::jerked(TimePoint at) const {
    // However long ago, if no position was seen since: in a long chain, a whole motion fits in between.
    return m_jerk && (at - m_jerk->since < kJerkTime || m_known.from <= m_jerk->since);
}

/// True if the motor stood still in the last reply and has not been sent a command since.
bool Plausibility::restsUncommanded(const Known& known, TimePoint at) const {
    return known.velocity == 0 && known.spread < 1 && known.swing < 1 && !m_commandedAt && !jerked(at) &&
           m_divisor == 1;
}

/// True if the servo holds a position: before it was farther from there than EL, on either side, it would
/// have switched off.
bool Plausibility::holds(const Known& known, const StatusReport& report) const {
    return m_errorLimit && !m_mayRun && known.aux && servo::AuxByte{*known.aux}.servoOn() &&
           (!report.aux || servo::AuxByte{*report.aux}.servoOn());
}

/// How far a motor may deviate from a straight line in this many ticks.
double Plausibility::bend(TimePoint at, double most) const {
    if (jerked(at))
        return std::min(kViolent * most * most / 4, m_jerk->reach * std::max(1.0, most / ticks(kJerkTime))) +
               kMargin;
    // At a low servo rate, a servo swings slowly and far, and its velocities do not refer to a single tick.
    if (m_divisor != 1)
        return std::min(kViolent * most * most / 4, kSwing) + kMargin;
    return std::min(kGentle * most * most / 4, kByHand * most) + kMargin;
}

/// How far a motion may go before the next reply: its whole distance, if that is short.
double Plausibility::reachOf(const ServoRegisters& sent) const {
    const double most = fastest() * ticks(kJerkTime);
    const servo::LoadTrajectory& load = sent.load;
    if (!load.servo)
        return most;
    if (load.profile == servo::ProfileMode::Velocity)
        return load.velocity ? 1.5 * toCounts(*load.velocity) * ticks(kJerkTime) + kSwing : most;
    if (load.relative && load.position)
        return 1.5 * std::abs(static_cast<double>(load.position->value())) + kSwing;
    if (!sent.goal || !m_known.position)
        return most;
    return 1.5 * std::abs(distance(*m_known.position, sent.goal->value())) + kSwing;
}

void Plausibility::Allowance::onReply(TimePoint latched) {
    if (replies > 0 && latched > since + kTakesEffect)
        --replies;
}

void Plausibility::onSent(const ModuleCommand& command, const ServoRegisters& sent, TimePoint latched) {
    if (setsCounter(command)) {
        m_position.open(latched);
        m_counter.reset();
    }
    visitCommand(Sent{*this, sent, latched}, command);
}

std::optional<Rejection> Plausibility::check(const ReplyEnd& end) {
    if (m_identity == kUnheardModule)
        return std::nullopt;  // nothing is known that a reply could contradict
    if (const auto impossible = structure(end))
        return impossible;
    if (const auto contradiction = against(m_known, end)) {
        const bool confirmed = m_candidate && !against(*m_candidate, end);
        if (!confirmed) {
            m_candidate = Known{};
            take(*m_candidate, end);
            m_contradiction = *contradiction;
            m_explained = explainedByItsSpeed(end);
            return contradiction;
        }
        m_known = *m_candidate;
        m_jumped = m_jumped || (*contradiction == Rejection::PositionJump && !m_explained) ||
                   *contradiction == Rejection::MovedWhileStopped;
    }
    if (carries(m_contradiction, end.report))
        m_candidate.reset();
    take(m_known, end);
    if (m_commandedAt && end.latched > *m_commandedAt + kTakesEffect && end.report.velocity == 0 &&
        end.report.servoStatus().moveDone())
        m_commandedAt.reset();
    m_homing.onReply(end.latched);
    if (end.report.home)
        m_home.onReply(end.latched);
    if (end.report.aux)
        m_sticky.onReply(end.latched);
    if (end.report.position) {
        m_position.onReply(end.latched);
        m_motion.onReply(end.latched);
    }
    // While the chip searches for home, it may find it at any time, including between two replies.
    if ((end.report.status & kHomingBit) != 0)
        m_home.open(end.latched);
    return std::nullopt;
}

std::optional<Rejection> Plausibility::structure(const ReplyEnd& end) const {
    const StatusReport& report = end.report;
    if (uniform({end.bytes.data(), end.bytes.size()}) && !repeatsZeros(report))
        return Rejection::Uniform;
    if (report.identity && *report.identity != m_identity)
        return Rejection::Identity;
    if (onWithoutPower(end))
        return Rejection::OnWithoutPower;
    if (m_identity.type == ModuleType::Servo)
        return servoStructure(report);
    if (m_identity.type == ModuleType::Stepper)
        return stepperStructure(report);
    return std::nullopt;
}

std::optional<Rejection> Plausibility::servoStructure(const StatusReport& report) const {
    const servo::StatusByte status = report.servoStatus();
    if (!report.aux)
        return std::nullopt;
    const servo::AuxByte aux{*report.aux};
    if (!aux.servoOn() && !(status.positionError() && status.moveDone()))
        return Rejection::OffWithoutBits;
    if (aux.slewDone() && !aux.accelDone())
        return Rejection::SlewWithoutAccel;
    return std::nullopt;
}

std::optional<Rejection> Plausibility::stepperStructure(const StatusReport& report) const {
    const stepper::StatusByte status = report.stepperStatus();
    if (status.velocityMode() && status.trapezoidalMode())
        return Rejection::BothModes;
    if (!status.moving())
        return std::nullopt;
    if (!status.powerOn())
        return Rejection::MovingWithoutPower;
    if (report.timerCount && (*report.timerCount < 1 || *report.timerCount > kLongestTimerCount))
        return Rejection::TimerCount;
    return std::nullopt;
}

std::optional<Rejection> Plausibility::against(const Known& known, const ReplyEnd& end) const {
    const StatusReport& report = end.report;
    if (known.aux && report.aux && ((*known.aux ^ *report.aux) & undefinedAux(m_identity)) != 0)
        return Rejection::UndefinedBits;
    if (stickyCleared(known, report))
        return Rejection::StickyCleared;
    const bool homes = m_identity.type == ModuleType::Servo || m_identity.type == ModuleType::Stepper;
    const bool rose = homes && known.status && (report.status & ~*known.status & kHomingBit) != 0;
    if (rose && !m_homing.isOpen())
        return Rejection::HomingRose;
    if (known.home && report.home && *known.home != *report.home && !m_home.isOpen())
        return Rejection::HomeChanged;
    if (!known.position || !report.position)
        return std::nullopt;
    const auto impossible = motion(known, end);
    if (!impossible || !m_position.isOpen())
        return impossible;
    if (!m_counter)
        return std::nullopt;  // it may have been set to any value
    Known set = known;
    set.position = m_counter;
    return motion(set, end);
}

std::optional<Rejection> Plausibility::motion(const Known& known, const ReplyEnd& end) const {
    if (m_identity.type == ModuleType::Servo)
        return servoMotion(known, end, restsUncommanded(known, end.latched));
    if (m_identity.type == ModuleType::Stepper)
        return stepperMotion(known, end);
    return std::nullopt;
}

/// True if zeros are what the module last reported: a PIC-STEP at rest at 0 without motor power, or a PIC-I/O
/// whose inputs are all low.
bool Plausibility::repeatsZeros(const StatusReport& report) const {
    if (m_identity.type == ModuleType::Io)
        return report.status == 0 && m_known.status == 0 && m_known.allLow;
    return m_identity.type == ModuleType::Stepper && report.status == 0 && m_known.status == 0 &&
           (!report.position || m_known.position == 0) && (!report.aux || m_known.aux == 0);
}

/// Power is checked once per tick (DS-V 4.5): the reply to a command that switches the servo on may show it
/// on, whether there is power or not. An SC reports a supply that is too high as no power, and leaves its
/// servo on (docs/family.md).
bool Plausibility::onWithoutPower(const ReplyEnd& end) const {
    if (m_identity.type != ModuleType::Servo || isSc(m_identity) || !end.report.aux ||
        end.report.servoStatus().powerOn())
        return false;
    const bool commanded = m_mayEnable && end.latched < *m_mayEnable + kTakesEffect;
    const bool homed = m_known.status && (*m_known.status & ~end.report.status & kHomingBit) != 0;
    return servo::AuxByte{*end.report.aux}.servoOn() && !commanded && !homed;
}

bool Plausibility::stickyCleared(const Known& known, const StatusReport& report) const {
    if (m_identity.type != ModuleType::Servo || m_sticky.isOpen())
        return false;
    if (known.status && (*known.status & ~report.status & kStickyStatus) != 0)
        return true;
    return known.aux && report.aux && (*known.aux & ~*report.aux & kStickyAux) != 0;
}

/// Between two replies, the position may change by as much as the velocities at both ends and the recent ones
/// allow, plus what acceleration in between can add: close to a straight line for uniform motion, within some
/// hundred counts for a swinging motor.
std::optional<Rejection> Plausibility::servoMotion(const Known& known, const ReplyEnd& end,
                                                   bool rests) const {
    const double least = ticks(std::max(end.latched - known.to, Duration{})) - 1;
    const double most = ticks(end.latchedBy - known.from) + 1;
    const double now = end.report.velocity.value_or(known.velocity.value_or(0));
    const double before = known.velocity.value_or(0);
    if (std::abs(now) > fastest() * m_divisor.value_or(kLongestServoRate))
        return Rejection::VelocityJump;
    if (end.report.velocity && known.velocity && m_divisor == 1) {
        const double a = jerked(end.latched) ? kViolent : kGentle;
        const double reach = std::abs(before) + known.spread + known.swing + kMargin + a * most;
        if (std::abs(now) > reach)
            return Rejection::VelocityJump;
    }
    // The velocity item has no fraction.
    const double slack = known.spread + 1;
    double slow = std::min(before, now) - slack;
    double fast = std::max(before, now) + slack;
    if (known.swing > kSwings) {
        // It may have swung the other way and back in between.
        const double back = std::max(known.fastest, known.swing) + slack;
        slow = std::min(slow, -back);
        fast = std::max(fast, back);
    }
    if (!m_divisor) {
        // In counts per an unknown number of ticks.
        slow = std::min(slow, 0.0);
        fast = std::max(fast, 0.0);
    }
    slow = std::max(slow, -fastest());
    fast = std::min(fast, fastest());
    const double around = bend(end.latched, most);
    const double lowest = std::min(slow * most, slow * std::max(least, 0.0)) - around;
    const double highest = std::max(fast * most, fast * std::max(least, 0.0)) + around;
    const double travelled = distance(*known.position, *end.report.position);
    // A reply that may come from another module cannot be confirmed by its own velocity.
    const double pushed = holds(known, end.report) ? 2.0 * *m_errorLimit + kMargin : kNudge + slack * most;
    if (rests && std::abs(travelled) > pushed)
        return Rejection::PositionJump;
    return travelled < lowest || travelled > highest ? std::optional(Rejection::PositionJump) : std::nullopt;
}

bool Plausibility::explainedByItsSpeed(const ReplyEnd& end) const {
    return m_identity.type == ModuleType::Servo && end.report.position && m_known.position &&
           end.report.velocity.value_or(0) != 0 && !servoMotion(m_known, end, false);
}

std::optional<Rejection> Plausibility::stepperMotion(const Known& known, const ReplyEnd& end) const {
    const double travelled = distance(*known.position, *end.report.position);
    const bool moved = known.moved || end.report.stepperStatus().moving() || m_position.isOpen();
    if (!moved && !m_motion.isOpen() && travelled != 0)
        return Rejection::MovedWhileStopped;
    const double most = ticks(end.latchedBy - known.from) + 1;
    return std::abs(travelled) > kFastestStepper * most + kMargin ? std::optional(Rejection::PositionJump)
                                                                  : std::nullopt;
}

/// The speed that the velocities at both ends of a distance do not explain: a motor that swings at about the
/// polling rate shows nearly the same velocity each time.
double Plausibility::unexplained(const Known& known, const ReplyEnd& end) const {
    if (!known.position || !known.velocity || !end.report.position || !end.report.velocity)
        return 0;
    const double time = std::max(ticks(end.latched - known.from), 1.0);
    const double reported = (*known.velocity + *end.report.velocity) / 2.0;
    return std::min(std::abs(distance(*known.position, *end.report.position) / time - reported), fastest());
}

void Plausibility::take(Known& known, const ReplyEnd& end) const {
    const StatusReport& report = end.report;
    known.status = report.status;
    // A reply to a challenge has no position: the motion that brought the motor elsewhere may end in it.
    known.moved = report.stepperStatus().moving() || (known.moved && !report.position);
    if (report.aux)
        known.aux = report.aux;
    if (report.pins)
        known.allLow = *report.pins == 0 && std::ranges::all_of(report.analogs, [](const auto& analog) {
            return analog.value_or(0) == 0;
        });
    if (report.home)
        known.home = report.home;
    if (report.velocity) {
        const double change = known.velocity ? std::abs(*report.velocity - *known.velocity) : 0.0;
        known.spread = std::max(known.spread * kFade, change);
        known.swing = std::max(known.swing * kFade, unexplained(known, end));
        known.fastest = std::max(known.fastest * kFade, std::abs(static_cast<double>(*report.velocity)));
    }
    if (report.position) {
        known.position = report.position;
        // A brief reply has no velocity; the previous reply's is the best available.
        if (report.velocity)
            known.velocity = report.velocity;
        known.from = end.latched;
        known.to = end.latchedBy;
    }
}

}  // namespace nmc::bus
