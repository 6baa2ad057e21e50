// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

/// The address of a group.
inline constexpr std::uint8_t kGroup = 0x81;

/// Adds group operations to any kind of bus.
template <typename Bus>
class WithGroups : public Bus {
public:
    using Bus::Bus;

    bus::OperationId submitGroup(std::variant<bus::GroupChange, bus::GroupCommand> what) {
        const bus::OperationId id(++m_lastGroupId);
        this->engine.submit(bus::GroupOperation{id, what}, this->now);
        return id;
    }
    /// Runs until the operation has ended.
    bus::GroupFinished finish(bus::OperationId id) {
        std::optional<bus::GroupFinished> found;
        const auto ended = [&] {
            for (const auto& finished : this->template all<bus::GroupFinished>())
                if (finished.id == id)
                    found = finished;
            return found.has_value();
        };
        EXPECT_TRUE(this->runUntil(ended, std::chrono::seconds(10)));
        return found.value_or(bus::GroupFinished{});
    }
    bus::GroupFinished put(std::uint8_t module, std::uint8_t group, bool leader = false) {
        return finish(submitGroup(bus::GroupChange{ModuleIndex(module), {group, leader}}));
    }
    bus::GroupFinished start(std::uint8_t group) {
        return finish(submitGroup(bus::GroupCommand{group, bus::GroupCommand::Action::StartMotion}));
    }

    template <typename Command>
    [[nodiscard]] std::size_t executedOnly(std::uint8_t module) const {
        std::size_t n = 0;
        for (const auto& executed : this->template all<bus::CommandExecuted>())
            if (const auto* servo = std::get_if<ServoCommand>(&executed.command))
                n += executed.module.value() == module && std::holds_alternative<Command>(*servo) ? 1U : 0U;
        return n;
    }

private:
    std::uint32_t m_lastGroupId = 10'000;
};

using GroupBus = WithGroups<VirtualBus>;

}  // namespace nmc::test
