// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/bytes.h"
#include "base/strong.h"
#include "base/time.h"
#include "protocol/moduletype.h"
#include "sim/fault.h"
#include "sim/line.h"
#include "sim/motorplant.h"
#include "sim/snapshot.h"
#include "sim/statistics.h"
#include "sim/violations.h"

namespace nmc::sim {

struct ChainOptions {
    /// How long a module is deaf after power-up or Hard Reset (protocol.md 1, a choice).
    Duration resetDeadTime = std::chrono::milliseconds(8);
    /// Replies take no wire time; for tests of other things.
    bool unpaced = false;
    /// Phase of the modules' ticks and the garbling of bytes at a wrong rate come from it.
    std::uint64_t seed = 1;
    /// The sheets are silent on whether a module that was awake goes deaf when its ADDR_IN rises again.
    bool deafWhenAddressInputRises = false;
    bool enableFaults = false;             ///< control lines may inject faults
    double lineMargin = kCleanLineMargin;  ///< as garbleProbability()'s; less where edges are slow
    MotorParameters motor{};               ///< of each PIC-SERVO
    /// Told the ground truth in the very tick in which a module has carried out a command and latched the
    /// status of its answer. Must not call the chain.
    std::function<void(ModuleIndex, const ModuleSnapshot&)> onExecuted{};
};

/// A byte that arrives at the host; `due` is the end of its stop bit.
struct HostByte {
    TimePoint due;
    std::uint8_t value = 0;
};

/// Most bytes that wait for takeHostBytes(); more are lost and counted.
inline constexpr std::size_t kMaxWaitingHostBytes = 65'536;

/// A chain of modules and the line to the host: the other end of the wire.
///
/// Pure: bytes and time points in, bytes with due times out; no thread, no clock. Time must not go back.
/// The chain is powered up at TimePoint{}. One thread at a time. A time that lies before one already given is
/// taken as that one. ModuleIndex arguments must be below moduleCount().
class Chain {
public:
    explicit Chain(const std::vector<ModuleIdentity>& modules, ChainOptions options = {});
    ~Chain();
    Chain(Chain&&) noexcept;
    Chain& operator=(Chain&&) noexcept;

    /// The rate the host's port is set to, from the next byte on. 19 200 at first.
    void setHostBaud(std::uint32_t baud);
    /// Whether any module hears bytes of that rate rightly, mostly.
    [[nodiscard]] bool understands(std::uint32_t baud) const;

    /// The host's port takes `bytes` at `now`; they leave it back to back, behind what is still leaving. The
    /// line holds 65 536 bytes; more are lost and counted. `readLate`: the host wrote them before `now`, but
    /// nobody knows when; whether it waited for its answers (CommandInFlight, CommandOverwritten) is judged
    /// again when bytes that are in time find the chain at rest.
    void hostSends(ByteSpan bytes, TimePoint now, bool readLate = false);

    /// When the last of what hosts have sent has left, or had.
    [[nodiscard]] TimePoint hostLineFreeAt() const;

    /// Another host on the same line sends `bytes`, behind what is leaving: they are carried out and answered
    /// like this host's. A sentence when faults are not enabled.
    tl::expected<void, std::string> foreignSends(ByteSpan bytes, TimePoint now);

    /// Runs everything up to and including `now`.
    void advanceTo(TimePoint now);

    /// The bytes that have reached the host since the last call, in the order of arrival.
    [[nodiscard]] std::vector<HostByte> takeHostBytes();

    /// When the host's side can next see something happen; nothing while the line is idle. Motors move on
    /// between events without being asked: advanceTo() catches up.
    [[nodiscard]] std::optional<TimePoint> nextEvent() const;

    // What a test, a scope or `nmcsim`'s control lines want to know and change. `now` as in advanceTo().

    [[nodiscard]] std::size_t moduleCount() const;
    [[nodiscard]] ModuleIdentity identity(ModuleIndex module) const;
    /// Ground truth about a module after its last tick.
    [[nodiscard]] ModuleSnapshot snapshot(ModuleIndex module, TimePoint now);
    /// Sets an input or the load of a module; the value must be in the range that Input states.
    /// `number`: which of several, from 1 (see Input).
    void set(ModuleIndex module, Input input, std::optional<double> value, TimePoint now,
             unsigned number = 0);
    /// Switches the supply of the module's logic off and on: its chip starts anew, its motor's shaft stays.
    void powerCycle(ModuleIndex module, TimePoint now);
    /// Breaks or mends the ADDR line between the module and its neighbour towards the host. Without a
    /// connection the neighbour's ADDR_IN is high.
    void breakAddressLine(ModuleIndex module, TimePoint now);
    void mendAddressLine(ModuleIndex module, TimePoint now);

    /// Injects a fault (simulator.md, Faults) and gives its number; a sentence when faults are not enabled or
    /// it cannot be. Faults stay until they are over or cleared.
    tl::expected<unsigned, std::string> inject(const FaultSpec& fault, TimePoint now);
    void clearFaults(TimePoint now);
    /// All that have been injected since the last clearFaults(), in that order.
    [[nodiscard]] std::vector<FaultReport> faults() const;

    [[nodiscard]] ChainStatistics statistics() const;
    [[nodiscard]] const ViolationLog& violations() const;
    /// Counts from 0 again, and forgets the violations.
    void clearStatistics(TimePoint now);

private:
    class Private;
    std::unique_ptr<Private> d;
};

}  // namespace nmc::sim
