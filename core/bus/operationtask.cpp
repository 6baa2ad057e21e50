// SPDX-License-Identifier: MIT
#include "bus/operationtask.h"

#include <utility>

#include "bus/gate.h"
#include "module/commandfacts.h"
#include "module/stopmanner.h"

namespace nmc::bus {

namespace {

/// Number of retries of a command that was provably not carried out.
constexpr unsigned kRepeatsAfterLook = 2;

[[nodiscard]] bool isStart(const Ask& ask) {
    return ask.command && is<StartMotion>(*ask.command);
}

}  // namespace

bool OperationTask::onChange(const Change& change) {
    if (change.kind == Change::Kind::Stopped) {
        if (m_commands.isFor(change.modules) && !m_commands.swings())
            oweStop();  // it may not have arrived, and be firmer
        return cancelFor(change.modules);
    }
    if (!change.cancelsAll())
        return false;
    const bool stopsAll = change.kind == Change::Kind::StopAll || change.kind == Change::Kind::GivenUp;
    if (!stopsAll)
        oweStop();
    m_group.reportUnknown();
    for (Event& event : m_commands.cancelAll())
        report(std::move(event));
    m_verification.reset();
    stopsAll ? m_group.drop() : m_group.cancel({});
    return true;
}

bool OperationTask::cancelFor(const std::vector<ModuleIndex>& modules) {
    const bool underWay = m_commands.isFor(modules);
    if (underWay)
        m_group.reportUnknown();
    for (Event& event : m_commands.cancelFor(modules))
        report(std::move(event));
    if (underWay) {
        m_verification.reset();
        m_group.cancel(modules);
        m_attempts = 0;
    }
    return underWay;
}

Next OperationTask::next(TimePoint now) {
    if (m_verification)
        return verifyStep();
    if (m_commands.sineOver() || m_commands.endedByChip()) {
        const Outcome outcome = m_commands.sineOver() ? Outcome::Cancelled : Outcome::Forbidden;
        report(m_commands.finish(outcome));
        return Again{};
    }
    if (m_commands.group() != nullptr)
        if (auto next = m_group.next(now))
            return std::move(*next);
    m_commands.beginStep(now);
    const Order& order = m_commands.order();
    const bool known = m_chain.has(order.module);
    const bool change = m_commands.group() != nullptr;  // checked when it was planned
    Permission verdict = !known   ? Permission::Never
                         : change ? Permission::Allowed
                                  : permit(m_chain.belief(order.module), order.command);
    // The reason for forbidding it may be over by now: two more queries before refusing, because one reply is
    // not enough to permit.
    if (verdict == Permission::InMotion &&
        m_chain.belief(order.module).looksSince(m_commands.stepBegan()) < 2)
        verdict = Permission::NeedsStatus;
    const bool lengthUnknown = known && !m_chain.belief(order.module).items();
    if (verdict == Permission::Allowed && lengthUnknown)
        verdict = Permission::NeedsStatus;
    switch (verdict) {
        case Permission::Allowed:
            return send();
        case Permission::NeedsStatus:
            return look(order.module);
        case Permission::InMotion:
        case Permission::Never:
            break;
    }
    return forbid();
}

Next OperationTask::forbid() {
    report(m_commands.finish(Outcome::Forbidden));
    return Again{};
}

/// What was loaded for a start that does not follow must not be started by another one, such as its group's.
void OperationTask::report(Event event) {
    if (const auto* finished = std::get_if<OperationFinished>(&event))
        for (const ModuleIndex module : finished->unloaded)
            m_chain.at(module).belief.forgetLoad();
    m_events.emplace_back(std::move(event));
}

Next OperationTask::send() {
    const Order& order = m_commands.order();
    Ask ask = m_chain.command(Purpose::Operation, order);
    if (mayStartMotion(order.command)) {
        if (m_chain.at(order.module).forbidsStart())
            return forbid();
        m_chain.at(order.module).owed.reset();  // the user wants it to move again
    }
    ask.reported = true;
    ask.retry = m_attempts > 0;
    // Sent to the module's own address again, at which the preceding challenge has shown it to be (link.md
    // 2.3).
    if (ask.request.payload.code == CommandCode::SetAddress)
        ask.silentRepeats = 2;
    if (isStart(ask)) {
        // That a start was refused is known only from the module's reply; a second start would be worse than
        // a query.
        ask.refusedAttempts = 1;
        ask.refusedBefore = static_cast<std::uint8_t>(m_attempts);
    }
    m_positionBefore = m_chain.belief(order.module).position();
    m_stoodBefore = m_chain.belief(order.module).standsStill();
    m_commands.noteSent();
    return ask;
}

/// Verifies whether an unanswered command was carried out, by querying the module; otherwise its outcome
/// remains open.
Next OperationTask::verifyStep() {
    const Order& order = m_commands.order();
    // Two queries, because one reply is not enough to state that the motor stands still.
    if (m_verification->looks < 2) {
        ++m_verification->looks;
        return look(order.module);
    }
    const Verification verification = *std::exchange(m_verification, std::nullopt);
    Belief& belief = m_chain.at(order.module).belief;
    m_chain.takeUnanswered(order.module, verification.end.latched);
    switch (verify(order, belief, verification)) {
        case Carried::Out:
            belief.onExecuted(order.command);
            m_events.emplace_back(CommandExecuted{order.module, verification.end.latched, order.command,
                                                  verification.end.late});
            accept(verification.end);
            return Again{};
        case Carried::NotOut:
            if (verification.attempts < kRepeatsAfterLook) {
                m_attempts = verification.attempts + 1;
                return Again{};  // the gate checks it again
            }
            break;
        case Carried::Unknown:
            break;
    }
    fail(verification.end);
    return Again{};
}

void OperationTask::onAnswer(const Ask& ask, const ReplyEnd& end) {
    m_group.onAnswer(ask, end);
}

Line::Script OperationTask::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint /*now*/) {
    if (m_commands.empty() || m_group.onEnd(ask, end))
        return {};
    if (ask.reported)
        onStepEnd(ask, end);
    else if (end.result != ReplyResult::Accepted)
        fail(end);
    return {};
}

void OperationTask::onStepEnd(const Ask& ask, const ReplyEnd& end) {
    if (end.result == ReplyResult::Accepted)
        return accept(end);
    const bool looks =
        end.result == ReplyResult::Refused ? isStart(ask) : factsOf(*ask.command).evidence != Evidence::None;
    if (looks && m_chain.answers(*ask.module)) {
        m_verification = Verification{end, m_positionBefore, m_stoodBefore, m_attempts};
        return;
    }
    fail(end);
}

/// If the present order is a stop, it is repeated until it is answered. Not if the servo was off: it would be
/// switched on.
void OperationTask::oweStop() {
    if (m_commands.empty() || m_commands.group() != nullptr)
        return;
    const Order& order = m_commands.order();
    const auto manner = stopManner(order.command);
    if (manner && m_chain.has(order.module) &&
        (*manner == StopManner::Off || m_chain.belief(order.module).on()))
        m_chain.owe(order.module, StopCause::GroupStop, *manner);
}

void OperationTask::accept(const ReplyEnd& end) {
    m_attempts = 0;
    if (auto finished = m_commands.accepted(end))
        report(std::move(*finished));
}

void OperationTask::fail(const ReplyEnd& end) {
    m_attempts = 0;
    m_verification.reset();
    const bool refused = end.result == ReplyResult::Refused;
    if (m_commands.group() == nullptr) {
        m_chain.takeUnanswered(m_commands.order().module, end.latched);
        if (!refused)
            oweStop();
    }
    m_group.reportUnknown();
    report(m_commands.finish(refused ? Outcome::Refused : Outcome::NoAnswer));
}

}  // namespace nmc::bus
