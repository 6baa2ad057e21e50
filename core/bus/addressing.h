// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "bus/exchange.h"
#include "bus/recheck.h"
#include "bus/task.h"
#include "bus/types.h"

namespace nmc::bus {

/// Assigns addresses to a fresh chain, from 1 upwards (DS-V 4.1, protocol.md 1), until two numbers in a row
/// are silent while the last module still answers (link.md 2.9). No number is ever sent twice: a module that
/// took it and whose answer was lost would be followed by another at the same address. Returns the next
/// query and is informed of its outcome. Pure.
class Addressing {
public:
    /// Number of queries, at least a tenth of a second apart, that a module must leave unanswered before the
    /// line is considered disturbed.
    static constexpr unsigned kAliveAttempts = 10;

    /// `expected`: there seems to be a module to assign the first address to.
    explicit Addressing(bool expected) : m_expected(expected) {}

    struct Done {};
    struct Failed {
        ConnectFailure reason;
        std::optional<std::size_t> module{};  ///< the one concerned, from 0, if known
    };
    /// NobodyAnswers and Garbled without a module: not one was found.
    using Next = std::variant<Ask, Done, Failed>;
    [[nodiscard]] Next next();
    void onReply(const ReplyEnd& end);
    /// Bytes have arrived that answer no query (Discovery::onLateBytes).
    void onLateBytes() { m_recheck.onLateBytes(); }
    /// The next query may be answered later than usual.
    [[nodiscard]] bool expectsLateAnswers() const {
        return m_phase == Phase::Recheck || m_aliveInVain > 0 || m_wrongInRow > 0;
    }
    /// Whatever was in progress on the line was discarded.
    void resume();

    /// True once the first address has been sent.
    [[nodiscard]] bool begun() const { return m_number > 0; }
    /// True once the whole chain has addresses.
    [[nodiscard]] bool done() const { return m_phase == Phase::Done; }
    /// Those that modules have taken, ascending.
    [[nodiscard]] const std::vector<BusAddress>& addresses() const { return m_addresses; }

private:
    enum class Phase : std::uint8_t {
        Set,
        Probe,
        Alive,    ///< a number was not taken: is this the end of the chain, or is the line disturbed?
        Recheck,  ///< the numbers at which no module answered, again; then the last module that is known
        Done,
        Failed
    };

    [[nodiscard]] Ask setAddress();
    [[nodiscard]] static Ask probe(BusAddress address, std::uint8_t repeats);
    [[nodiscard]] Ask stillThere() const;
    void onAddress(const ReplyEnd& end);
    void onProbe(const ReplyEnd& end);
    void onAlive(const ReplyEnd& end);
    void onNumberUnheard();
    void onRecheck(const ReplyEnd& end);
    void onRechecked();
    void nextNumber();
    void found(BusAddress address);
    void endOfNumbers();
    void endOfChain();
    void fail(ConnectFailure reason, std::optional<std::size_t> module = {});
    void failDisturbed();

    bool m_expected;
    Phase m_phase = Phase::Set;
    std::vector<BusAddress> m_addresses;
    std::uint8_t m_number = 0;    ///< the last address sent
    unsigned m_unheardInRow = 0;  ///< numbers that no module seems to have received
    unsigned m_aliveInVain = 0;   ///< consecutive unanswered queries to a module that has answered before
    unsigned m_wrongInRow = 0;    ///< consecutive wrong answers to the last number
    Recheck m_recheck;
    bool m_heardNoise = false;  ///< finding no module is then reported as Garbled
    Failed m_failure{};
};

}  // namespace nmc::bus
