// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "bus/engine.h"
#include "bus/exchange.h"
#include "bus/line.h"
#include "bus/types.h"

namespace nmc::bus {

/// Items of every poll: position, A/D value, auxiliary status (PIC-STEP: inputs).
inline constexpr StatusItems kStandingItems{StatusItems::Position | StatusItems::Analog | StatusItems::Aux};

/// A type that a data sheet here describes; others are only asked for type and version.
[[nodiscard]] constexpr bool knownType(ModuleType type) {
    return type == ModuleType::Servo || type == ModuleType::Step;
}

/// Restarts the network and finds the chain (DS-V 4.1, protocol.md 1). Says what to do next and is told what
/// came of it; repeats within one question, and the resync before them, are the engine's. Pure.
class Discovery {
public:
    static constexpr std::uint8_t kMaxModules = 32;

    explicit Discovery(const EngineConfig& config) : m_config(config) {}

    struct Ask {
        Request request;
        std::uint8_t silentRepeats = 0;
    };
    using Next = std::variant<Line::Script, Ask, ChainFound, ConnectFailed>;

    [[nodiscard]] Next next();
    /// The end of the last Ask, after its repeats.
    void onReply(const ReplyEnd& end);

    /// Once for each step forward.
    [[nodiscard]] std::optional<ConnectProgress> takeProgress();
    /// All modules have been reset, so no motor runs any more.
    [[nodiscard]] bool restarted() const { return m_phase != Phase::Restart; }
    [[nodiscard]] const std::vector<ModuleInfo>& modules() const { return m_modules; }

private:
    enum class Phase : std::uint8_t {
        Restart,
        Set,
        Probe,
        Identify,
        ChangeRate,
        Verify,
        Define,
        Done,
        Failed
    };

    [[nodiscard]] Line::Script restartScript() const;
    [[nodiscard]] Line::Script rateScript() const;
    [[nodiscard]] Ask setAddress() const;
    [[nodiscard]] Ask askModule(const Payload& payload, StatusItems items, std::uint8_t repeats) const;
    void onAddress(const ReplyEnd& end);
    void onProbe(const ReplyEnd& end);
    void found();
    void endOfChain();
    void nextModule(Phase after);
    void fail(ConnectFailure reason, std::vector<ModuleIndex> modules = {});
    void enter(Phase phase, std::optional<ConnectStage> stage = {});

    EngineConfig m_config;
    Phase m_phase = Phase::Restart;
    std::vector<ModuleInfo> m_modules;
    std::size_t m_at = 0;        ///< module that is being asked
    unsigned m_setAttempts = 0;  ///< at the present address
    bool m_heardNoise = false;
    std::vector<ModuleIndex> m_deaf;
    ConnectFailed m_failure{};
    std::optional<ConnectProgress> m_progress = ConnectProgress{ConnectStage::Restarting, 0};
};

}  // namespace nmc::bus
