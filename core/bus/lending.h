// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "bus/chain.h"
#include "bus/packetsplitter.h"
#include "bus/recovery.h"
#include "bus/task.h"

namespace nmc::bus {

/// The line while it is lent to a program (docs/lending.md): follows what that program sends and what is
/// answered, from which the chain's modules, their states and the length of each reply are known. A module
/// that has not reported its type is listed as kUnheardModule, and of its replies only the status byte is
/// believed.
///
/// As a task, it sends nothing while the program has the line. Once a stop of all modules holds the program
/// off, it asks the modules of unheard type what they are, because a stop is not the same for all. Pure.
class Lending : public Task {
public:
    /// How long a stop waits for the end of a packet that the program has begun.
    static constexpr Duration kPatience = std::chrono::milliseconds(20);

    Lending(const Shared& shared, Recovery& recovery) : Task(shared), m_recovery(recovery) {}

    void begin();
    /// Modules of unheard type are forgotten: a search finds out what they are.
    void end();
    /// From begin() to end().
    [[nodiscard]] bool active() const { return m_phase != Phase::None; }
    /// The program has the line; otherwise what it sends is dropped.
    [[nodiscard]] bool passes() const { return m_phase == Phase::Passing; }
    [[nodiscard]] bool heldOff() const { return m_phase == Phase::HeldOff; }

    /// A stop of all modules is requested. Returns true if it must wait until cutBy(), or until the program
    /// is no longer in the middle of a packet; otherwise the program is held off from now on.
    [[nodiscard]] bool delays(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> cutBy() const { return m_cutBy; }
    /// The number of these bytes of the program that may pass: all, or up to the end of the packet that a
    /// stop is waiting for.
    [[nodiscard]] std::size_t passing(ByteSpan bytes) const;

    /// A packet of the program, or bytes that are none. A program may write ahead of the line.
    struct Passed {
        std::vector<std::uint8_t> bytes;
        bool whole = false;  ///< a packet
        TimePoint start;     ///< when its first byte is sent
    };
    /// These bytes have passed; the last one has been sent at `end`. Returns true if they end in the middle
    /// of a packet.
    bool onPassed(ByteSpan bytes, Duration byteTime, TimePoint end);
    /// Returns what begins by this time, one after the other.
    [[nodiscard]] std::optional<Passed> takePassed(TimePoint by);

    /// The program has sent this packet, which is latched at `latched`: the exchange to expect; empty if
    /// no module answers it.
    [[nodiscard]] std::optional<Ask> follow(const PacketBytes& packet, TimePoint latched);
    /// The modules are others than before the last call.
    [[nodiscard]] bool takeChanged() { return std::exchange(m_changed, false); }

    // ---- Task ----
    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] Next next(TimePoint now) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;
    /// When the next packet of the program is sent.
    [[nodiscard]] std::optional<TimePoint> due() const override {
        return m_passed.empty() ? std::nullopt : std::optional(m_passed.front().start);
    }

private:
    enum class Phase : std::uint8_t { None, Passing, HeldOff };

    [[nodiscard]] const Chain::Module* unheard() const;
    void followGroup(Ask& ask, bool right, TimePoint latched);
    void followReset(BusAddress address);
    void frame(Ask& ask, const Belief& module) const;
    void onAnswered(const Ask& ask, const ReplyEnd& end, TimePoint now);
    void onAddress(const Ask& ask);
    void onHeard(const Ask& ask, const ReplyEnd& end);
    void become(std::vector<ModuleInfo> modules, std::optional<BusAddress> reset = {});

    Recovery& m_recovery;
    Phase m_phase = Phase::None;
    PacketSplitter m_packets;
    std::deque<Passed> m_passed;
    std::optional<TimePoint> m_cutBy;  ///< a stop waits for the end of a packet
    std::set<BusAddress> m_asked;      ///< of unheard type, since the program was held off
    bool m_changed = false;
};

}  // namespace nmc::bus
