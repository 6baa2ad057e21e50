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
    /// How long a module does not listen after power-up or Hard Reset (protocol.md 1, a choice).
    Duration resetDeadTime = std::chrono::milliseconds(8);
    /// Replies take no wire time; used by tests in which timing does not matter.
    bool unpaced = false;
    /// Determines the phase of the modules' ticks and the garbling of bytes at a wrong rate.
    std::uint64_t seed = 1;
    /// The data sheets do not say whether a module that was awake stops listening when its ADDR_IN rises
    /// again.
    bool deafWhenAddressInputRises = false;
    bool enableFaults = false;  ///< control lines may inject faults
    /// The host is another process at a terminal, with a clock of its own. A Stop Motor may cut a reply short
    /// one tick after its command: the host times that by its clock, and the computer may have held the
    /// command back for longer than the stop, so the stop is not blamed for overwriting it.
    bool hostHasOwnClock = false;
    double lineMargin = kCleanLineMargin;  ///< margin for garbleProbability(); smaller where edges are slow
    MotorParameters motor{};               ///< parameters of every PIC-SERVO's motor
    /// Called with the ground truth in the very tick in which a module has executed a command and latched the
    /// status for its answer. It must not call the chain.
    std::function<void(ModuleIndex, const ModuleSnapshot&)> onExecuted{};
};

/// A byte that arrives at the host; `due` is the end of its stop bit.
struct HostByte {
    TimePoint due;
    std::uint8_t value = 0;
};

/// The maximum number of bytes that wait for takeHostBytes(); further bytes are lost and counted.
inline constexpr std::size_t kMaxWaitingHostBytes = 65'536;

/// A chain of modules and the line to the host: the other end of the wire.
///
/// It is pure: bytes and time points go in, bytes with due times come out; there is no thread and no clock.
/// The chain is powered up at TimePoint{}. Time does not go back: a time earlier than one already given
/// counts as that one. Only one thread may use the chain at a time. ModuleIndex arguments must be below
/// moduleCount().
class Chain {
public:
    explicit Chain(const std::vector<ModuleIdentity>& modules, ChainOptions options = {});
    ~Chain();
    Chain(Chain&&) noexcept;
    Chain& operator=(Chain&&) noexcept;

    /// Sets the rate of the host's port, from the next byte on. It is 19 200 initially.
    void setHostBaud(std::uint32_t baud);
    /// True when at least one module receives most bytes of that rate correctly.
    [[nodiscard]] bool understands(std::uint32_t baud) const;

    /// The host's port takes `bytes` at `now` and sends them back to back, after any bytes still being sent.
    /// The line holds 65 536 bytes; further bytes are lost and counted. `readLate`: the host wrote them at an
    /// unknown time before `now`. Whether it waits for its answers (CommandInFlight, CommandOverwritten) is
    /// then not checked until two commands that were in time have found no module busy: a host that gave up
    /// on the late answer and repeated its command takes it for the answer to that, and sends the next one
    /// early.
    void hostSends(ByteSpan bytes, TimePoint now, bool readLate = false);

    /// The time at which the last byte sent by any host leaves the line, or left it.
    [[nodiscard]] TimePoint hostLineFreeAt() const;

    /// Another host on the same line sends `bytes`, after any bytes still being sent; they are executed and
    /// answered like this host's. Returns an error sentence when faults are not enabled.
    tl::expected<void, std::string> foreignSends(ByteSpan bytes, TimePoint now);

    /// Runs everything up to and including `now`.
    void advanceTo(TimePoint now);

    /// The bytes that have reached the host since the last call, in the order of arrival.
    [[nodiscard]] std::vector<HostByte> takeHostBytes();

    /// The time at which the host's side can next see something happen; nothing while the line is idle.
    /// Motors keep moving between events; advanceTo() brings them up to date.
    [[nodiscard]] std::optional<TimePoint> nextEvent() const;

    // State that a test, a scope or `nmcsim`'s control lines read and change. `now` is as in advanceTo().

    [[nodiscard]] std::size_t moduleCount() const;
    [[nodiscard]] ModuleIdentity identity(ModuleIndex module) const;
    /// The ground truth about a module after its last tick.
    [[nodiscard]] ModuleSnapshot snapshot(ModuleIndex module, TimePoint now);
    /// Sets an input or the load of a module; the value must be in the range that Input states. `number`
    /// selects one of several, from 1 (see Input).
    void set(ModuleIndex module, Input input, std::optional<double> value, TimePoint now,
             unsigned number = 0);
    /// Switches the supply of the module's logic off and on: the chip restarts, while the motor's shaft keeps
    /// its state.
    void powerCycle(ModuleIndex module, TimePoint now);
    /// Breaks or mends the ADDR line between the module and its neighbour towards the host. While it is
    /// broken, the neighbour's ADDR_IN is high.
    void breakAddressLine(ModuleIndex module, TimePoint now);
    void mendAddressLine(ModuleIndex module, TimePoint now);

    /// Injects a fault (simulator.md, Faults) and returns its number, or an error sentence when faults are
    /// not enabled or this one is not possible. Faults remain until they are over or cleared.
    tl::expected<unsigned, std::string> inject(const FaultSpec& fault, TimePoint now);
    void clearFaults(TimePoint now);
    /// All faults injected since the last clearFaults(), in that order.
    [[nodiscard]] std::vector<FaultReport> faults() const;

    [[nodiscard]] ChainStatistics statistics() const;
    [[nodiscard]] const ViolationLog& violations() const;
    /// Resets all counters to 0 and clears the violations.
    void clearStatistics(TimePoint now);

private:
    class Private;
    std::unique_ptr<Private> d;
};

}  // namespace nmc::sim
