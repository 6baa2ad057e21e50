// SPDX-License-Identifier: MIT
#include "bus/commandlane.h"

#include <utility>

namespace nmc::bus {

Payload payloadOf(const ModuleCommand& command) {
    return std::visit([](const auto& chip) { return encode(chip); }, command);
}

OperationFinished rejected(const Operation& operation, Outcome outcome) {
    OperationFinished event{operation.id, outcome, {}, 0};
    if (!operation.steps.empty()) {
        event.module = operation.steps.front().module;
        event.commandByte = payloadOf(operation.steps.front().command).commandByte();
    }
    return event;
}

bool CommandLane::submit(Operation operation) {
    if (m_waiting.size() == kCapacity)
        return false;
    m_waiting.push_back(std::move(operation));
    return true;
}

void CommandLane::beginStep(TimePoint now) {
    if (!std::exchange(m_begun, true))
        m_began = now;
}

std::optional<OperationFinished> CommandLane::accepted() {
    if (m_step + 1 == m_waiting.front().steps.size())
        return finish(Outcome::Done);
    ++m_step;
    m_begun = false;
    return std::nullopt;
}

OperationFinished CommandLane::failed(Outcome outcome) {
    return finish(outcome);
}

std::vector<OperationFinished> CommandLane::cancelAll() {
    std::vector<OperationFinished> events;
    while (!empty())
        events.push_back(finish(Outcome::Cancelled));
    return events;
}

OperationFinished CommandLane::finish(Outcome outcome) {
    const Step& last = step();
    OperationFinished event{m_waiting.front().id, outcome, last.module,
                            payloadOf(last.command).commandByte()};
    m_waiting.pop_front();
    m_step = 0;
    m_begun = false;
    return event;
}

}  // namespace nmc::bus
