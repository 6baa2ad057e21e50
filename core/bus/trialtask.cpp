// SPDX-License-Identifier: MIT
#include "bus/trialtask.h"

#include <utility>

#include "bus/gate.h"
#include "bus/rejoin.h"

namespace nmc::bus {

namespace {

/// Delay after a lost answer, so that the line is recovered first.
constexpr Duration kAgain = std::chrono::milliseconds(100);

}  // namespace

bool TrialTask::begin(const Operation& operation) {
    const Order& order = operation.orders.front();
    const auto* gains = getIf<servo::SetGain>(order.command);
    if (gains == nullptr || !m_chain.has(order.module) || m_chain.at(order.module).trial ||
        permit(m_chain.belief(order.module), order.command) != Permission::Allowed)
        return false;
    m_chain.at(order.module).trial = Trial{operation.id, *gains, *operation.trial};
    return true;
}

void TrialTask::keep(ModuleIndex module) {
    if (!m_chain.has(module))
        return;
    auto& trial = m_chain.at(module).trial;
    if (!trial || trial->phase != Trial::Phase::Watching)
        return;
    trial->end = TrialEnd::Kept;
    report(module, Outcome::Done);
    trial.reset();
}

void TrialTask::leave(const std::vector<ModuleIndex>& modules) {
    for (const ModuleIndex module : modules)
        if (m_chain.has(module) && m_chain.at(module).trial)
            goBack(*m_chain.at(module).trial, std::nullopt);
}

bool TrialTask::onChange(const Change& change) {
    if (change.cancelsAll())
        for (Chain::Module& module : m_chain.modules())
            leave({module.belief.info().index});
    leave(change.modules);
    return false;
}

void TrialTask::forget(ModuleIndex module) {
    if (!m_chain.has(module) || !m_chain.at(module).trial)
        return;
    report(module, Outcome::Cancelled);
    m_chain.at(module).trial.reset();
}

bool TrialTask::isOver(const Ask& ask) const {
    const auto& trial = m_chain.at(*ask.module).trial;
    const bool returns = trial && trial->phase == Trial::Phase::Returning;
    return ask.reported &&
           (!trial || (returns && ask.command != ModuleCommand(ServoCommand(trial->net.back))));
}

void TrialTask::noteLosses() {
    for (const Chain::Module& module : m_chain.modules()) {
        const ModuleIndex index = module.belief.info().index;
        if (module.belief.restarted())
            forget(index);
        else if (!m_chain.answers(index))
            leave({index});
    }
}

void TrialTask::forgetAll() {
    for (const Chain::Module& module : m_chain.modules())
        forget(module.belief.info().index);
}

void TrialTask::rejoin(const Chain& before) {
    for (const Chain::Module& old : before.modules())
        for (Chain::Module& module : m_chain.modules())
            if (old.trial && sameModule(old.belief.info(), module.belief.info()))
                module.trial = old.trial;
}

/// Only the first reason counts.
void TrialTask::goBack(Trial& trial, std::optional<TrialEnd> why) {
    if (trial.phase == Trial::Phase::Returning)
        return;
    trial.phase = Trial::Phase::Returning;
    trial.end = why;
    trial.outcome = why ? Outcome::Done : Outcome::Cancelled;
    trial.due = {};
}

void TrialTask::onReport(ModuleIndex module, const StatusReport& report, TimePoint latched) {
    auto& trial = m_chain.at(module).trial;
    if (!trial || trial->phase != Trial::Phase::Watching)
        return;
    if (!m_chain.belief(module).on())
        return goBack(*trial, TrialEnd::WentOff);
    if (!report.position)
        return;
    if (const auto why = trial->watch.look(latched, *report.position))
        goBack(*trial, why);
}

bool TrialTask::wants(TimePoint now) const {
    const auto first = due();
    return first && *first <= now;
}

std::optional<TimePoint> TrialTask::due() const {
    std::optional<TimePoint> first;
    for (const Chain::Module& module : m_chain.modules())
        if (module.trial && m_chain.answers(module.belief.info().index))
            first = earliest({first, module.trial->due});
    return first;
}

Next TrialTask::next(TimePoint now) {
    for (Chain::Module& module : m_chain.modules()) {
        const ModuleIndex index = module.belief.info().index;
        if (!module.trial || module.trial->due > now || !m_chain.answers(index))
            continue;
        Trial& trial = *module.trial;
        if (trial.phase == Trial::Phase::Watching)
            goBack(trial, TrialEnd::TimeOver);
        if (!module.belief.items())
            return m_chain.look(Purpose::Operation, index);
        const bool back = trial.phase == Trial::Phase::Returning;
        Ask ask =
            m_chain.command(Purpose::Operation, {index, ServoCommand(back ? trial.net.back : trial.tried)});
        ask.reported = true;
        return ask;
    }
    return Idle{};
}

Line::Script TrialTask::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    auto& trial = m_chain.at(*ask.module).trial;
    if (!trial)
        return {};
    const bool accepted = end.result == ReplyResult::Accepted;
    if (!ask.reported) {  // a query
        trial->due = accepted ? now : now + kAgain;
        return {};
    }
    const bool sentBack = ask.command == ModuleCommand(ServoCommand(trial->net.back));
    if (trial->phase == Trial::Phase::Sending) {
        trial->phase = Trial::Phase::Watching;
        trial->due = end.latched + trial->net.lasts;
        if (!accepted) {
            goBack(*trial, std::nullopt);
            trial->outcome = end.result == ReplyResult::Refused ? Outcome::Refused : Outcome::NoAnswer;
        }
    } else if (trial->phase == Trial::Phase::Returning && sentBack) {
        report(*ask.module, accepted ? trial->outcome : Outcome::NoAnswer);
        if (accepted)
            trial.reset();
        else
            trial->due = now + kAgain;
    }
    return {};
}

/// Reports the end, once.
void TrialTask::report(ModuleIndex module, Outcome outcome) {
    Trial& trial = *m_chain.at(module).trial;
    if (std::exchange(trial.reported, true))
        return;
    OperationFinished finished{trial.id, outcome, module, payloadOf(ServoCommand(trial.tried)).commandByte()};
    if (outcome == Outcome::Done)
        finished.trial = trial.end;
    m_events.emplace_back(std::move(finished));
}

}  // namespace nmc::bus
