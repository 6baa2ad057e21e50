// SPDX-License-Identifier: MIT
#include "bus/commandlane.h"

#include <algorithm>

namespace nmc::bus {

namespace {

[[nodiscard]] bool isLoad(const Order& order) {
    return is<servo::LoadTrajectory>(order.command) || is<stepper::LoadTrajectory>(order.command);
}

}  // namespace

OperationFinished rejected(const Operation& operation, Outcome outcome) {
    OperationFinished event{operation.id, outcome, {}, 0};
    if (!operation.orders.empty()) {
        event.module = operation.orders.front().module;
        event.commandByte = payloadOf(operation.orders.front().command).commandByte();
    }
    return event;
}

bool CommandLane::submit(Operation operation) {
    return push({operation.id, std::move(operation.orders), std::nullopt, operation.sine});
}

bool CommandLane::submit(GroupOperation operation) {
    return push({operation.id, {}, operation});
}

bool CommandLane::push(Waiting waiting) {
    if (m_waiting.size() == kCapacity)
        return false;
    m_waiting.push_back(std::move(waiting));
    if (m_waiting.size() == 1)
        beginFront();
    return true;
}

const GroupOperation* CommandLane::group() const {
    if (m_waiting.empty() || !m_waiting.front().group)
        return nullptr;
    return &*m_waiting.front().group;
}

void CommandLane::beginStep(TimePoint now) {
    if (std::exchange(m_begun, true))
        return;
    m_began = now;
    if (m_sine)
        m_waiting.front().orders.front().command = m_sine->commandAt(now);
}

std::vector<ModuleIndex> CommandLane::loaded() const {
    std::vector<ModuleIndex> modules;
    for (std::size_t i = 0; i < m_order; ++i) {  // carried out
        const Order& order = m_waiting.front().orders[i];
        if (isLoad(order))
            modules.push_back(order.module);
        else if (is<StartMotion>(order.command))
            std::erase(modules, order.module);
    }
    return modules;
}

std::optional<TimePoint> CommandLane::due() const {
    if (empty())
        return std::nullopt;
    return m_sine && !m_begun && !sineOver() && !endedByChip() ? m_sine->due() : TimePoint{};
}

std::optional<Event> CommandLane::accepted(const ReplyEnd& end) {
    if (m_sine) {
        m_sine->note(end);
        m_begun = m_sent = false;
        if (!m_sine->over(m_began) && !sineOver())
            return std::nullopt;
        return finish(m_sine->over(m_began) ? Outcome::Done : Outcome::Cancelled);
    }
    if (m_order + 1 == m_waiting.front().orders.size())
        return finish(Outcome::Done);
    ++m_order;
    m_begun = m_sent = false;
    return std::nullopt;
}

std::vector<Event> CommandLane::cancelAll() {
    std::vector<Event> events;
    while (!empty())
        events.push_back(finish(Outcome::Cancelled));
    return events;
}

bool CommandLane::concerns(const Waiting& waiting, const std::vector<ModuleIndex>& modules) {
    const auto toOne = [&](const Order& order) {
        return std::ranges::find(modules, order.module) != modules.end();
    };
    return waiting.group || std::ranges::any_of(waiting.orders, toOne);
}

bool CommandLane::concerns(ModuleIndex module) const {
    return std::ranges::any_of(m_waiting,
                               [&](const Waiting& waiting) { return concerns(waiting, {module}); });
}

std::vector<Event> CommandLane::cancelFor(const std::vector<ModuleIndex>& modules) {
    std::vector<Event> events;
    while (isFor(modules))
        events.push_back(finish(Outcome::Cancelled));
    for (const Waiting& waiting : m_waiting) {
        if (!concerns(waiting, modules))
            continue;
        if (waiting.group)
            events.emplace_back(
                GroupFinished{waiting.id, Outcome::Cancelled, waiting.group->what, {}, false});
        else
            events.emplace_back(rejected({waiting.id, waiting.orders}, Outcome::Cancelled));
    }
    std::erase_if(m_waiting, [&](const Waiting& waiting) { return concerns(waiting, modules); });
    return events;
}

Event CommandLane::finish(Outcome outcome) {
    if (group() != nullptr)
        return finishGroup(outcome, membersOfChange(outcome));
    const Order& last = order();
    OperationFinished event{m_waiting.front().id, outcome, last.module,
                            payloadOf(last.command).commandByte()};
    event.sent = m_sent;
    if (outcome != Outcome::Done)
        event.unloaded = loaded();
    if (isLoad(last) && (outcome == Outcome::Refused || outcome == Outcome::NoAnswer))
        event.unloaded.push_back(last.module);
    if (m_sine)
        event.sine = m_sine->takeRecord();
    next();
    return event;
}

GroupFinished CommandLane::finishGroup(Outcome outcome, std::vector<GroupMember> members) {
    const GroupOperation& operation = *group();
    GroupFinished event{operation.id, outcome, operation.what, std::move(members), false};
    next();
    return event;
}

/// The outcomes of a group change, whose orders were sent to one module after the other.
std::vector<GroupMember> CommandLane::membersOfChange(Outcome outcome) const {
    const std::vector<Order>& orders = m_waiting.front().orders;
    std::vector<GroupMember> members;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        const bool before = i < m_order || outcome == Outcome::Done;
        const bool open = i == m_order && (outcome == Outcome::NoAnswer || outcome == Outcome::Cancelled);
        members.push_back({orders[i].module, before ? MemberOutcome::Done
                                             : open ? MemberOutcome::NoAnswer
                                                    : MemberOutcome::NotDone});
    }
    return members;
}

void CommandLane::next() {
    m_waiting.pop_front();
    m_order = 0;
    m_begun = m_sent = false;
    beginFront();
}

void CommandLane::beginFront() {
    m_sine.reset();
    if (!empty() && m_waiting.front().sine)
        m_sine.emplace(*m_waiting.front().sine, m_waiting.front().orders.front().command);
}

}  // namespace nmc::bus
