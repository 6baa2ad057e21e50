// SPDX-License-Identifier: MIT
#include "bus/holdtask.h"

#include <algorithm>
#include <utility>

#include "bus/gate.h"
#include "bus/standstill.h"
#include "module/commandfacts.h"
#include "module/profiledload.h"

namespace nmc::bus {

namespace {

/// Consecutive refused starts after which it is unknown whether the module moves as wanted.
constexpr unsigned kAttempts = 3;

/// With acceleration 0, a PIC-SERVO cannot decelerate (link.md 2.6).
[[nodiscard]] StopManner mannerFor(const HoldToMove& held) {
    return held.pace || held.acceleration.value() != 0 ? StopManner::Smoothly : StopManner::Abruptly;
}

/// True if that load was answered, and waits for its start.
[[nodiscard]] bool hasLoaded(const Belief& module, const ModuleCommand& command) {
    if (const auto* load = getIf<stepper::LoadTrajectory>(command))
        return module.stepperLoad() == *load;
    return module.servoLoad() == *getIf<servo::LoadTrajectory>(command);
}

}  // namespace

void HoldTask::hold(const HoldToMove& hold, TimePoint now) {
    if (over(hold.press))
        return;
    if (m_wanted && m_wanted->module != hold.module)
        release();
    if (over(hold.press))
        return;  // a press that moves to another module ends
    if (m_wanted && m_wanted->press != hold.press)
        endPress(m_wanted->press);  // of two buttons that are held at once, the one pressed last counts
    m_wanted = hold;
    if (m_sent)
        m_sent->press = hold.press;  // the same motion need not be sent twice
    m_until = now + m_timeout;
}

void HoldTask::endPress(std::uint32_t press) {
    m_over = std::max(press, m_over.value_or(press));
}

std::optional<HoldToMove> HoldTask::leave() {
    m_refusals = 0;
    if (m_wanted)
        endPress(m_wanted->press);
    const bool loaded = std::exchange(m_loaded, false);
    const auto wanted = std::exchange(m_wanted, std::nullopt);
    const auto sent = std::exchange(m_sent, std::nullopt);
    return loaded && !sent ? wanted : sent;
}

void HoldTask::end(StopCause cause) {
    if (const auto released = leave(); released && m_chain.has(released->module))
        m_chain.owe(released->module, cause, mannerFor(*released));
}

void HoldTask::expire(TimePoint now) {
    if (!m_wanted || now < m_until)
        return;
    // If there is nothing to stop, nothing had been started.
    if (m_sent)
        m_events.emplace_back(HoldExpired{.module = m_wanted->module, .press = m_wanted->press});
    end(StopCause::HoldExpired);
}

bool HoldTask::onChange(const Change& change) {
    using enum Change::Kind;
    if (change.kind == StopAll || change.kind == GivenUp ||
        std::ranges::any_of(change.modules, [this](auto module) { return holds(module); }))
        leave();
    else if (change.cancelsAll())
        release();
    return change.cancelsAll();
}

std::optional<Order> HoldTask::toSend() const {
    if (!m_wanted || m_wanted == m_sent)
        return std::nullopt;
    const HoldToMove& hold = *m_wanted;
    const auto goal = m_sent ? std::nullopt : hold.goal;
    if (hold.pace) {
        auto load = profiledLoad(hold.pace->speed, hold.pace->accelerationTime, goal, hold.reverse);
        load.startNow = !goal;
        return Order{hold.module, StepperCommand(load)};
    }
    auto load = profiledLoad(hold.velocity, hold.acceleration, goal, hold.reverse);
    load.startNow = !goal;
    return Order{hold.module, ServoCommand(load)};
}

Order HoldTask::startLoaded() const {
    return {m_wanted->module,
            forChip(m_wanted->pace ? ModuleType::Stepper : ModuleType::Servo, StartMotion{})};
}

bool HoldTask::wants(TimePoint /*now*/) const {
    return toSend().has_value();
}

Next HoldTask::next(TimePoint /*now*/) {
    const Order start = *toSend();
    const Belief& module = m_chain.belief(start.module);
    if (!module.fresh() || !module.items())
        return m_chain.look(Purpose::Hold, start.module);
    if (m_chain.at(start.module).forbidsStart())
        return Idle{};
    // Load Trajectory would switch a servo on, which a hold must never do.
    if (!module.on()) {
        giveUp(HoldExpired::Reason::NotPossible);
        return Again{};
    }
    // A motion begun with a goal does not continue with another one, or without.
    if (m_sent && m_sent->goal != m_wanted->goal) {
        giveUp(HoldExpired::Reason::GoalChanged);
        return Again{};
    }
    const HoldToMove& wanted = *m_wanted;
    if (wanted.goal && !m_sent)
        return nextTowards(*wanted.goal, start);
    if (wanted.goal && !mayRunOn(wanted)) {
        m_wanted = m_sent;  // it keeps the velocity that it has
        return Again{};
    }
    return sendOrder(start);
}

Next HoldTask::nextTowards(std::int32_t goal, const Order& load) {
    const ModuleIndex index = load.module;
    const Belief& module = m_chain.belief(index);
    if (m_chain.at(index).owed)
        return Idle{};  // until the motor is seen at rest
    if (module.mayMove() && !m_sent) {
        m_chain.owe(index, StopCause::HoldReleased, mannerFor(*m_wanted));
        return Again{};
    }
    if (!leadsTo(goal, module)) {
        giveUp(HoldExpired::Reason::NotPossible);
        return Again{};
    }
    return sendOrder(hasLoaded(module, load.command) ? startLoaded() : load);
}

/// From a trapezoid, a PIC-STEP takes up another speed only at once, without a ramp (DS-S 5.1, Table 4).
bool HoldTask::mayRunOn(const HoldToMove& wanted) const {
    const Belief& module = m_chain.belief(wanted.module);
    // While SR is unknown, the shortest tick is assumed.
    const double ticks = ticksPerSecond(module.servoRegisters().servoRate.value_or(1));
    return !wanted.pace && m_chain.at(wanted.module)
                               .travel.mayRunOn(wanted.reverse, toCounts(wanted.velocity) * ticks, module);
}

bool HoldTask::leadsTo(std::int32_t goal, const Belief& module) const {
    if (!module.position())
        return false;
    const std::int64_t distance = std::int64_t{goal} - *module.position();
    return m_wanted->reverse ? distance < -kStillCounts : distance > kStillCounts;
}

Next HoldTask::sendOrder(const Order& order) {
    if (permit(m_chain.belief(order.module), order.command) != Permission::Allowed) {
        giveUp(HoldExpired::Reason::NotPossible);
        return Again{};
    }
    m_chain.at(order.module).owed.reset();  // the user wants it to move again
    m_sentBefore = m_sent;
    Ask ask = m_chain.command(Purpose::Hold, order);
    if (mayStartMotion(order.command))
        m_sent = m_wanted;
    else
        m_loaded = true;
    ask.reported = true;
    // Not retried: the next request is made for the state that the module is in by then.
    ask.silentRepeats = 0;
    ask.refusedAttempts = 1;
    return ask;
}

void HoldTask::giveUp(HoldExpired::Reason reason) {
    if (m_wanted)
        m_events.emplace_back(HoldExpired{m_wanted->module, reason, m_sent || m_loaded, m_wanted->press});
    end(StopCause::HoldExpired);
}

Line::Script HoldTask::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint /*now*/) {
    if (!m_wanted || ask.module != m_wanted->module)
        return {};  // that hold has ended, and its motor is owed a stop
    if (!ask.reported) {
        // Unknown: nothing is started, and what was started is stopped.
        if (end.result != ReplyResult::Accepted)
            giveUp(HoldExpired::Reason::NoAnswer);
        return {};
    }
    if (end.result == ReplyResult::Accepted) {
        m_refusals = 0;
        return {};
    }
    if (end.result == ReplyResult::Refused) {
        m_sent = m_sentBefore;  // it was certainly not carried out
        if (++m_refusals < kAttempts)
            return {};
    }
    giveUp(HoldExpired::Reason::NoAnswer);  // it is unknown whether the module moves as wanted
    return {};
}

}  // namespace nmc::bus
