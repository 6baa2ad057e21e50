// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

/// The engine on a chain on which faults are injected by the words of simulator.md, and the chain's own count
/// of what it did.
namespace nmc::test {

/// The rate of most of the chains on which faults are injected.
inline constexpr std::uint32_t kFast = 115'200;

class FaultyBus : public VirtualBus {
public:
    explicit FaultyBus(const std::vector<ModuleIdentity>& modules, bus::EngineConfig config = {},
                       std::uint64_t seed = 1);
    FaultyBus(const std::vector<ModuleIdentity>& modules, std::uint32_t baud, std::uint64_t seed = 1);
    /// As `options` say; faults are enabled whatever they say of them.
    FaultyBus(const std::vector<ModuleIdentity>& modules, bus::EngineConfig config,
              sim::ChainOptions options);

    /// A line such as "bus drop cmd p=.01"; a test failure when the simulator refuses it.
    void fault(const std::string& line);
    void clearFaults() { chain.clearFaults(now); }
    /// How often the faults since the last clearFaults() have struck.
    [[nodiscard]] std::uint64_t struck() const;

    /// Gives addresses whatever the chain has been through: a reset first.
    [[nodiscard]] bool restart();

    /// Connects, gives the simulator's gains to every servo and switches it on.
    [[nodiscard]] bool connectAndEnable();

    [[nodiscard]] std::uint64_t executed(std::uint8_t module, CommandCode code) const {
        return chain.statistics().modules[module].executions(code);
    }
    /// How often the code went out to the module, by its address or to all.
    [[nodiscard]] std::uint64_t sentTo(std::uint8_t module, CommandCode code, std::size_t from = 0) const;
    /// Every command was executed no more often than it was sent since the chain was powered up.
    void expectOnlyExecutedWhatWasSent() const;
    /// Nothing went out from the given entry of `sent` on that moves, enables or tunes a motor, or that
    /// gives addresses, rates or a reset.
    void expectOnlyQuestions(std::size_t from = 0) const;

    /// Packets from the given entry on: nulls do not count.
    [[nodiscard]] std::size_t packets(std::size_t from = 0) const;
    /// The latest health of the bus that was told, Good before; Lost also when only one module is the cause.
    [[nodiscard]] bus::LinkHealth health() const;
    [[nodiscard]] std::size_t motionSuspects(std::uint8_t module) const;
    /// Its command velocity is 0, and it moves by less than the velocity item can tell: one count per tick.
    [[nodiscard]] bool stands(std::uint8_t module);
    /// Listed as stopped.
    [[nodiscard]] static bool stopped(const bus::StopFinished& event, std::uint8_t module);
};

/// The code of a packet; nothing for nulls.
[[nodiscard]] std::optional<CommandCode> codeOf(ByteSpan packet);
/// What changes a motor, its tuning or the chain, Stop Motor apart.
[[nodiscard]] bool changesSomething(CommandCode code);

/// Not the link to one module only, where the engine tells these apart.
template <typename HealthChanged>
[[nodiscard]] bool ofWholeBus(const HealthChanged& event) {
    if constexpr (requires { event.module.has_value(); })
        return !event.module.has_value();
    else
        return true;
}

/// The engine with restart(), and the one whose connect() is that.
template <typename Engine>
void restartNetwork(Engine& engine, TimePoint now) {
    if constexpr (requires { engine.restart(now); })
        engine.restart(now);
    else
        engine.connect(now);
}

}  // namespace nmc::test
