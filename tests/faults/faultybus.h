// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

/// The engine on a chain in which faults are injected in the notation of simulator.md, and the chain's own
/// count of what it carried out.
namespace nmc::test {

/// The rate of most of the chains on which faults are injected.
inline constexpr std::uint32_t kFast = 115'200;

class FaultyBus : public VirtualBus {
public:
    explicit FaultyBus(const std::vector<ModuleIdentity>& modules, bus::EngineConfig config = {},
                       std::uint64_t seed = 1);
    FaultyBus(const std::vector<ModuleIdentity>& modules, std::uint32_t baud, std::uint64_t seed = 1);
    /// As `options` require, except that faults are always enabled.
    FaultyBus(const std::vector<ModuleIdentity>& modules, bus::EngineConfig config,
              sim::ChainOptions options);

    /// Injects a fault such as "bus drop cmd p=.01"; fails the test if the simulator refuses the line.
    void fault(const std::string& line);
    void clearFaults() { chain.clearFaults(now); }
    /// How often the faults since the last clearFaults() have struck.
    [[nodiscard]] std::uint64_t struck() const;

    /// Assigns addresses after a reset, whatever the chain has been through.
    [[nodiscard]] bool restart();

    /// Connects, gives the simulator's gains to every servo and switches it on.
    [[nodiscard]] bool connectAndEnable();

    [[nodiscard]] std::uint64_t executed(std::uint8_t module, CommandCode code) const {
        return chain.statistics().modules[module].executions(code);
    }
    /// How often the code was sent to the module: by its address, to address 0, or to a group.
    [[nodiscard]] std::uint64_t sentTo(std::uint8_t module, CommandCode code, std::size_t from = 0) const;
    /// Expects that no command was executed more often than it was sent since the chain was powered up.
    void expectOnlyExecutedWhatWasSent() const;
    /// Expects that nothing was sent, from the given entry of `sent` on, that moves, enables or tunes a
    /// motor, or that assigns addresses, changes the rate or resets.
    void expectOnlyQuestions(std::size_t from = 0) const;

    /// Number of packets from the given entry on; nulls do not count.
    [[nodiscard]] std::size_t packets(std::size_t from = 0) const;
    /// The last reported health of the bus, at first Good; also Lost if only one module is the cause.
    [[nodiscard]] bus::LinkHealth health() const;
    [[nodiscard]] std::size_t motionSuspects(std::uint8_t module) const;
    /// True if nothing commands it to move and it moves by less than the velocity item can show: one count
    /// per tick.
    [[nodiscard]] bool stands(std::uint8_t module);
    /// True if the module is listed as stopped.
    [[nodiscard]] static bool stopped(const bus::StopFinished& event, std::uint8_t module);
};

/// The code of a packet; empty for nulls.
[[nodiscard]] std::optional<CommandCode> codeOf(ByteSpan packet);
/// True for whatever changes a motor, its tuning or the chain, except Stop Motor.
[[nodiscard]] bool changesSomething(CommandCode code);

/// True unless the event concerns the link to one module only, if the engine makes that distinction.
template <typename HealthChanged>
[[nodiscard]] bool ofWholeBus(const HealthChanged& event) {
    if constexpr (requires { event.module.has_value(); })
        return !event.module.has_value();
    else
        return true;
}

/// Calls restart(), or connect() of an engine that has no restart().
template <typename Engine>
void restartNetwork(Engine& engine, TimePoint now) {
    if constexpr (requires { engine.restart(now); })
        engine.restart(now);
    else
        engine.connect(now);
}

}  // namespace nmc::test
