// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "bus/exchange.h"
#include "bus/line.h"
#include "bus/types.h"

namespace nmc::bus {

/// Looks for a chain that is there already, at any of the rates it may have been left at, with nulls and No
/// Operation only: nothing is changed and nothing that moves is disturbed. The first two addresses at every
/// rate come first, because hardly a host counts otherwise, and the first two of those that are known from
/// the last time; the others at every rate only if nobody answers there. Where zeros answer, type and version
/// are asked for. Two lost answers hide nobody: where one should be and nobody answers, before a chain is
/// taken for a fresh one and before nobody is there at all, everything is asked three times; addresses that
/// hardly a host gives, at rates where nobody else is, twice. Says what to do next and is told what came of
/// it. Pure.
class ChainLook {
public:
    /// Address and rate a module wakes up with come first.
    static constexpr std::array<std::uint32_t, 4> kRates{19'200, 115'200, 57'600, 9'600};

    /// Where it was the last time, as far as that is known: beside the rates and addresses that are usual.
    explicit ChainLook(const std::vector<std::uint32_t>& rates = {}, std::vector<BusAddress> addresses = {});

    /// A script to run or a question to ask; nothing when the look is over.
    using Next = std::variant<std::monostate, Line::Script, Request>;
    [[nodiscard]] Next next();
    void onReply(const ReplyEnd& end);

    /// Where the chain answers; nothing when no addressed module does.
    [[nodiscard]] std::optional<std::uint32_t> rate() const { return m_rate; }
    [[nodiscard]] const std::vector<BusAddress>& addresses() const { return m_found; }
    /// Modules at whose address two answer at once, counted from 0.
    [[nodiscard]] const std::vector<std::size_t>& collided() const { return m_collided; }
    /// A module without an address answers at the rate of power-up, and what it says it is.
    [[nodiscard]] bool unaddressed() const { return m_unaddressed; }
    [[nodiscard]] std::optional<ModuleIdentity> unaddressedIdentity() const { return m_unaddressedIdentity; }
    /// Why the chain cannot be used: nobody answers, or noise, zeros, or two at once do.
    [[nodiscard]] std::optional<ConnectFailure> trouble() const;

private:
    enum class Stage : std::uint8_t {
        First,       ///< where a chain usually is, and a module without an address
        Rest,        ///< at the rate of the chain
        Everywhere,  ///< nobody answered
        Missing,     ///< between those that answered, next to them, and of those that are known
        Over
    };
    struct Probe {
        std::uint32_t rate;
        BusAddress address;
    };

    void refill();
    void refillFirst();
    void refillMissing();
    [[nodiscard]] std::vector<BusAddress> missing() const;
    [[nodiscard]] bool heard(const Probe& probe, const ReplyEnd& end, bool again, bool zerosHeard);
    void found(const Probe& probe);
    void add(std::uint32_t rate, const std::vector<BusAddress>& addresses);
    void addUnaddressed();
    void enter(Stage stage) { m_stage = stage, m_round = 0; }

    std::vector<std::uint32_t> m_rates;
    std::vector<BusAddress> m_known;
    std::vector<BusAddress> m_first;  ///< addresses
    std::vector<BusAddress> m_rest;
    Stage m_stage = Stage::First;
    unsigned m_round = 0;         ///< how often this stage has been asked
    std::vector<Probe> m_probes;  ///< of this stage
    std::size_t m_at = 0;
    std::optional<std::uint32_t> m_hostRate;
    std::optional<std::uint32_t> m_rate;
    std::vector<BusAddress> m_found;
    bool m_unaddressed = false;   ///< once true, stays so for this look
    bool m_asksIdentity = false;  ///< of the module without an address
    unsigned m_identityAsks = 0;  ///< that were not answered
    std::optional<ModuleIdentity> m_unaddressedIdentity;
    bool m_again = false;       ///< the present probe has been answered with noise before
    bool m_waits = false;       ///< for what may still come, before that is asked again
    bool m_zerosHeard = false;  ///< or with zeros, from a module or from a line that is held low
    unsigned m_noise = 0;
    std::vector<std::size_t> m_collided;
    unsigned m_zeros = 0;
};

}  // namespace nmc::bus
