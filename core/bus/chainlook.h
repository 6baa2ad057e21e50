// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "bus/exchange.h"
#include "bus/line.h"
#include "bus/types.h"

namespace nmc::bus {

/// Searches for an existing chain at any of the rates at which it may have been left, with nulls and No
/// Operation only, so that nothing is changed and no motion is disturbed. The first two addresses at each
/// rate come first, because hardly any host counts differently, together with the first two of the addresses
/// known from the last time; other addresses follow at every rate only if there is no answer. If the answer
/// is zeros, type and version are queried. Two lost answers do not hide a module: where one should be but
/// does not answer, before a chain is considered fresh, and before no module is considered present,
/// everything is queried three times; unusual addresses at rates where nothing else answers, twice. If no
/// module has answered then, the usual places are queried once more with patience: what was sent may have
/// been read too late, at the rate of a later query. The last query for a missing module is patient, too.
/// Returns the next action and is informed of its outcome. Pure.
class ChainLook {
public:
    /// `rates`: where to look, in this order. `addresses`: those of the last time, if known, in addition to
    /// the usual ones.
    ChainLook(std::vector<std::uint32_t> rates, std::vector<BusAddress> addresses);

    /// A script to run or a query to send; monostate when the search is over.
    using Next = std::variant<std::monostate, Line::Script, Request>;
    [[nodiscard]] Next next();
    void onReply(const ReplyEnd& end);
    /// An answer was too late (Discovery::onLateBytes).
    void onLateBytes() { m_doubtful = true; }

    /// The rate at which the chain answers; empty if no module with an address does.
    [[nodiscard]] std::optional<std::uint32_t> rate() const { return m_rate; }
    [[nodiscard]] const std::vector<BusAddress>& addresses() const { return m_found; }
    /// Indices, from 0, of modules at whose address two answer at once.
    [[nodiscard]] const std::vector<std::size_t>& collided() const { return m_collided; }
    /// The caller should wait longer than usual for each answer.
    [[nodiscard]] bool patient() const { return m_patient; }
    /// A module without an address answers at the power-up rate; unaddressedIdentity() is its identity.
    [[nodiscard]] bool unaddressed() const { return m_unaddressed; }
    [[nodiscard]] std::optional<ModuleIdentity> unaddressedIdentity() const { return m_unaddressedIdentity; }
    /// Why the chain cannot be used: no answer, noise, zeros, or two modules at once.
    [[nodiscard]] std::optional<ConnectFailure> trouble() const;

private:
    enum class Stage : std::uint8_t {
        First,       ///< the usual places of a chain, and a module without an address
        Rest,        ///< other addresses at the chain's rate
        Everywhere,  ///< nothing has answered yet
        Patiently,   ///< still nothing: the usual places again
        Missing,     ///< addresses between and next to those that answered, and those known before
        Over
    };
    struct Probe {
        std::uint32_t rate;
        BusAddress address;
    };

    void refill();
    void refillUsual();
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
    unsigned m_round = 0;  ///< rounds of this stage so far
    bool m_patient = false;
    bool m_doubtful = false;      ///< whether all that are missing have been found
    std::vector<Probe> m_probes;  ///< of this stage
    std::size_t m_at = 0;
    std::optional<std::uint32_t> m_hostRate;
    std::optional<std::uint32_t> m_rate;
    std::vector<BusAddress> m_found;
    bool m_unaddressed = false;   ///< never cleared during this search
    bool m_asksIdentity = false;  ///< queries the module without an address
    unsigned m_identityAsks = 0;  ///< unanswered ones
    std::optional<ModuleIdentity> m_unaddressedIdentity;
    bool m_again = false;       ///< the present probe was already answered with noise
    bool m_waits = false;       ///< for late bytes before the probe is repeated
    bool m_zerosHeard = false;  ///< the present probe was already answered with zeros, by a module or by a
                                ///< line that is held low
    unsigned m_noise = 0;
    std::vector<std::size_t> m_collided;
    unsigned m_zeros = 0;
};

}  // namespace nmc::bus
