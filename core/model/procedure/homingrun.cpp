// SPDX-License-Identifier: MIT
#include "model/procedure/homingrun.h"

#include <algorithm>
#include <cmath>

#include "model/intent/homingplan.h"

namespace nmc {

namespace {

using Stop = HomingRecipe::Stop;

/// The maximum delay from the servo being reported off until home is reported found (bus/trust.h).
constexpr Duration kReportedLater = std::chrono::milliseconds(500);
/// The time within which a servo is on after the command, and a position is 0 after its reset.
constexpr Duration kTakesEffect = std::chrono::seconds(2);
/// The time for a servo to settle on its last count, whatever its Ki.
constexpr Duration kLastCount = std::chrono::seconds(5);

/// How far a search may go beyond the limits, or beyond the former home, in counts: home is reported after
/// kReportedLater, and then the motor slows down. A search for the index is preceded by one for its
/// neighbourhood, which may lie beyond the index by as much as the recipe allows.
[[nodiscard]] double slackOf(const HomingRecipe& recipe, double perSecond) {
    const double slowingDown = recipe.velocity * recipe.velocity / (2.0 * recipe.acceleration);
    return recipe.velocity * perSecond * toSeconds(kReportedLater) + slowingDown + kStillCounts +
           (recipe.thenIndex ? recipe.travelLimit : 0.0);
}

[[nodiscard]] std::optional<TravelRange> rangeOf(const HomingRecipe& recipe, const ModuleState& module) {
    auto range = travelRange(module);
    if (!range)
        return std::nullopt;
    // The velocity of a PIC-STEP is in steps per second.
    const double perSecond = module.isServo() ? ticksPerSecond(module.servoRate.value_or(1)) : 1.0;
    const auto slack = static_cast<std::int64_t>(std::ceil(slackOf(recipe, perSecond)));
    const std::int64_t home = module.home.place()->counts;
    const auto counter = [](std::int64_t place) {
        return static_cast<std::int32_t>(
            std::clamp<std::int64_t>(place, servo::kPositionRange.min, servo::kPositionRange.max));
    };
    if (range->lowest)
        range->lowest = counter(std::min<std::int64_t>(*range->lowest, home) - slack);
    if (range->highest)
        range->highest = counter(std::max<std::int64_t>(*range->highest, home) + slack);
    return range;
}

/// The distance of two positions, which wrap at 32 bits.
[[nodiscard]] double distance(std::int32_t from, std::int32_t to) {
    return std::abs(static_cast<double>(countsBetween(from, to)));
}

}  // namespace

HomingRun::HomingRun(ProcedureKind kind, HomingRecipe recipe, std::int32_t tolerance,
                     const ModuleState& module)
    : Procedure(module.info.index, kind),
      m_recipe(effective(std::move(recipe), module.info.identity)),
      m_tolerance(tolerance),
      m_range(rangeOf(m_recipe, module)),
      m_chip(module) {
    m_goesOff = m_chip.goesOff(m_recipe);
    m_mayRun = true;
}

HomingRun::Next HomingRun::proceed(const ModuleState& module, TimePoint now) {
    if (m_sent == Sent::LastWord)
        return finish();
    if (module.silent)
        return fail(ProcedureFailure::ModuleUnresponsive);
    const auto seen = m_chip.look(module);
    if (!seen)
        return Wait{};
    if (m_sent != Sent::Nothing && m_sent != Sent::FirstRead && m_sent != Sent::SecondRead) {
        m_sent = Sent::Nothing;
        m_endedAt = now;
        m_standstill.reset();
    }
    if (m_report.stage == ProcedureStage::Reading) {
        if (m_sent == Sent::FirstRead)
            m_firstReading = module.latest->home;
        else if (m_sent == Sent::SecondRead)
            m_report.home = module.latest->home;
        return read(*seen, now);
    }
    return seen->time > m_endedAt ? decide(*seen, now) : Next(Wait{});
}

HomingRun::Next HomingRun::decide(const HomingLook& seen, TimePoint now) {
    using enum ProcedureStage;
    const ProcedureStage stage = m_report.stage;
    return stage == Preparing    ? prepare(seen, now)
           : stage == BackingOff ? backOff(seen, now)
           : stage == Stopping   ? settle(seen, now)
           : stage == GoingHome  ? goHome(seen, now)
           : stage == Zeroing    ? makeZero(seen, now)
                                 : search(seen, now);
}

HomingRun::Next HomingRun::prepare(const HomingLook& seen, TimePoint now) {
    if (!seen.on)
        return fail(ProcedureFailure::WentOff);
    const HomeConditions wanted = conditions();
    if (!std::exchange(m_prepared, true) && (wanted.positionError || wanted.currentLimit))
        return sendOrders(m_chip.clearStickyBits());
    return beginSearch(seen, now);
}

HomingRun::Next HomingRun::beginSearch(const HomingLook& seen, TimePoint now) {
    if (!m_backedOff)
        m_from = seen.position;
    HomingChip::Motion ahead = motion();
    if (leavesFirst(seen)) {
        // The chip looks for a change from now on: it would find the place where the switch is left.
        ahead.reverse = !ahead.reverse;
        const bool again = std::exchange(m_backedOff, true);
        const TimePoint began = again ? m_began : now;
        Next run = enter(ProcedureStage::BackingOff, now, m_chip.run(ahead));
        m_began = began;
        return run;
    }
    m_backedOff = false;
    m_from = seen.position;
    const auto stage = inIndexSearch() ? ProcedureStage::SearchingIndex : ProcedureStage::Searching;
    m_watching = !startsUnwatched();
    return enter(stage, now,
                 m_watching ? m_chip.search(conditions(), m_recipe.stop, ahead) : m_chip.run(ahead));
}

/// Starting takes current too, and that is not home, so the chip is set to watch the current only at full
/// speed. A switch could change before that and would then be missed, so switches are watched from the start.
bool HomingRun::startsUnwatched() const {
    return conditions() == HomeConditions{.currentLimit = true};
}

HomingRun::Next HomingRun::backOff(const HomingLook& seen, TimePoint now) {
    if (!seen.on)
        return fail(ProcedureFailure::WentOff);
    if (m_stepSent) {  // the stop has been sent
        if (tooLong(now))
            return fail(ProcedureFailure::SwitchActive);
        return stands(seen) ? beginSearch(seen, now) : Next(Wait{});
    }
    if (beyondTravel(seen))
        return fail(ProcedureFailure::SoftLimit);
    if (!anyActive(seen)) {
        m_stepSent = true;
        return sendOrders(m_chip.stop(Stop::Smoothly));
    }
    // The chip has stopped the motion, for example at the opposite limit, or it has gone far enough: the
    // switch stays active.
    const bool blocked = m_chip.stopsMotionItself() && !seen.moving && stands(seen);
    if (blocked || tooFar(seen) || tooLong(now))
        return fail(ProcedureFailure::SwitchActive);
    return Wait{};
}

HomingRun::Next HomingRun::search(const HomingLook& seen, TimePoint now) {
    if (m_watching && !seen.waiting) {
        // If the chip has stopped by itself, this changes nothing; otherwise this is the stop.
        return enter(ProcedureStage::Stopping, now,
                     seen.on ? m_chip.stop(m_recipe.stop) : HomingChip::Orders{});
    }
    if (!seen.on) {
        if (!m_offSince)
            m_offSince = now;
        if (!m_watching || !m_goesOff || now - *m_offSince > kReportedLater)
            return fail(ProcedureFailure::WentOff);
        return Wait{};
    }
    if (beyondTravel(seen))
        return fail(ProcedureFailure::SoftLimit);
    if (tooFar(seen))
        return fail(ProcedureFailure::TravelLimit);
    if (tooLong(now))
        return fail(ProcedureFailure::TimeLimit);
    if (!m_watching && !seen.moving) {
        m_watching = true;
        return sendOrders(m_chip.watch(conditions(), m_recipe.stop));
    }
    if (m_chip.stopsMotionItself() && !seen.moving && stands(seen))
        return fail(ProcedureFailure::NotFound);
    return Wait{};
}

HomingRun::Next HomingRun::settle(const HomingLook& seen, TimePoint now) {
    if (!seen.on && !m_goesOff)
        return fail(ProcedureFailure::WentOff);
    if (!stands(seen))
        return tooLong(now) ? fail(ProcedureFailure::TimeLimit) : Next(Wait{});
    if (m_recipe.thenIndex && !inIndexSearch()) {
        m_round = 2;
        m_backedOff = false;
        if (!seen.on)
            return enter(ProcedureStage::Preparing, now, m_chip.enable());
        return beginSearch(seen, now);
    }
    m_report.stage = ProcedureStage::Reading;
    return read(seen, now);
}

HomingRun::Next HomingRun::read(const HomingLook& seen, TimePoint now) {
    if (m_sent == Sent::Nothing)
        return sendOrders(m_chip.read(false), Sent::FirstRead);
    if (m_sent == Sent::FirstRead)
        return sendOrders(m_chip.read(true), Sent::SecondRead);
    m_sent = Sent::Nothing;
    if (!m_report.home || m_report.home != m_firstReading) {
        m_report.home.reset();
        return fail(ProcedureFailure::ReadingsDiffer);
    }
    return found(seen, now);
}

HomingRun::Next HomingRun::found(const HomingLook& seen, TimePoint now) {
    if (!m_recipe.goToHome)
        return disarm();
    return enter(ProcedureStage::GoingHome, now, seen.on ? HomingChip::Orders{} : m_chip.enable());
}

HomingRun::Next HomingRun::goHome(const HomingLook& seen, TimePoint now) {
    if (!seen.on)
        return now - m_endedAt > kTakesEffect ? fail(ProcedureFailure::WentOff) : Next(Wait{});
    const std::int32_t home = *m_report.home;
    if (!m_stepSent) {
        m_stepSent = true;
        if (seen.position != home) {
            HomingChip::Motion slowly = motion();
            slowly.velocity = m_recipe.velocity;
            return sendOrders(m_chip.run(slowly, home));
        }
    }
    if (!stands(seen))
        return tooLong(now) ? fail(ProcedureFailure::TimeLimit) : Next(Wait{});
    if (!m_stillSince)
        m_stillSince = now;
    if (!m_recipe.makeZero)
        return disarm();
    if (seen.position == home)
        return enter(ProcedureStage::Zeroing, now, m_chip.zero());
    if (now - *m_stillSince <= kLastCount)
        return Wait{};
    // The error at the time of the reset remains in the zero: the chip sets the motor's position to 0, not
    // the goal.
    m_report.offHome = countsBetween(home, seen.position);
    return std::abs(m_report.offHome) <= m_tolerance ? enter(ProcedureStage::Zeroing, now, m_chip.zero())
                                                     : fail(ProcedureFailure::NotAtHome);
}

HomingRun::Next HomingRun::makeZero(const HomingLook& seen, TimePoint now) {
    if (samePlace(0, seen.position))
        return disarm();
    return now - m_endedAt > kTakesEffect ? fail(ProcedureFailure::Refused) : Next(Wait{});
}

/// Afterwards, a safety stop or a hand on the switch must not look like home.
HomingRun::Next HomingRun::disarm() {
    return sendOrders(m_chip.disarm(), Sent::LastWord);
}

/// Stops a motion that this run may have started, and disarms the chip's search.
std::vector<bus::Order> HomingRun::lastWord(const ModuleState& module) const {
    const auto seen = m_chip.look(module);
    HomingChip::Orders orders;
    // To a drive that is off, a stop would switch it on.
    if (m_mayRun && seen && seen->on)
        orders = m_chip.stop(Stop::Smoothly);
    const HomingChip::Orders disarm = m_chip.disarm();
    orders.insert(orders.end(), disarm.begin(), disarm.end());
    return orders;
}

HomingRun::Next HomingRun::sendOrders(HomingChip::Orders orders, Sent what) {
    m_sent = what;
    return send(std::move(orders));
}

HomingRun::Next HomingRun::enter(ProcedureStage stage, TimePoint now, HomingChip::Orders orders) {
    m_report.stage = stage;
    m_stepSent = false;
    m_began = m_endedAt = now;
    m_standstill.reset();
    m_offSince.reset();
    return orders.empty() ? Next(Wait{}) : sendOrders(std::move(orders));
}

HomeConditions HomingRun::conditions() const {
    if (inIndexSearch())
        return {.index = true};
    return {.limit1 = m_recipe.onLimit1,
            .limit2 = m_recipe.onLimit2,
            .index = m_recipe.onIndex,
            .positionError = m_recipe.onPositionError,
            .currentLimit = m_recipe.onCurrentLimit,
            .homeSwitch = m_recipe.onHomeSwitch};
}

HomingChip::Motion HomingRun::motion() const {
    if (inIndexSearch())
        return {!m_recipe.reverse, m_recipe.indexVelocity, m_recipe.acceleration};
    return {m_recipe.reverse, m_recipe.velocity, m_recipe.acceleration};
}

bool HomingRun::anyActive(const HomingLook& seen) const {
    const HomeConditions wanted = conditions();
    return (wanted.limit1 && seen.active.limit1) || (wanted.limit2 && seen.active.limit2) ||
           (wanted.index && seen.active.index) || (wanted.homeSwitch && seen.active.homeSwitch);
}

bool HomingRun::tooFar(const HomingLook& seen) const {
    return distance(m_from, seen.position) > m_recipe.travelLimit;
}

/// Only the limit in the direction of motion applies: the motor may return from beyond the other one.
bool HomingRun::beyondTravel(const HomingLook& seen) const {
    if (!m_range)
        return false;
    const bool down = motion().reverse != (m_report.stage == ProcedureStage::BackingOff);
    return down ? m_range->lowest && seen.position < *m_range->lowest
                : m_range->highest && seen.position > *m_range->highest;
}

bool HomingRun::tooLong(TimePoint now) const {
    return toSeconds(now - m_began) > m_recipe.timeLimit;
}

bool HomingRun::stands(const HomingLook& seen) {
    return m_standstill.look(seen.time, seen.position, seen.moving);
}

}  // namespace nmc
