// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/time.h"
#include "bus/exchangerecord.h"
#include "bus/types.h"

namespace nmc::bus {

struct EngineConfig {
    /// Nominal rate to run at, one of kBaudRows. Discovery always begins at 19 200.
    std::uint32_t baud = 19'200;
    /// What the adapter adds to every reply (link.md 2.1).
    Duration adapterLatency = std::chrono::milliseconds(4);
    /// Scheduling margin of this machine (link.md 2.1).
    Duration margin = std::chrono::milliseconds(10);
    /// Wait after a Hard Reset: longer than any module's dead time seen in the field (protocol.md 1).
    Duration resetWait = std::chrono::milliseconds(25);
    /// Held motion ends this long after the last hold().
    Duration holdTimeout = std::chrono::milliseconds(250);
    /// Nothing but No Operation and Read Status is sent, and stops that somebody asks for: a chain that is
    /// there is attached to, and left to whoever runs it.
    bool readOnly = false;
};

/// The master of the bus: one exchange in flight; stops before commands before polls.
///
/// Sans-I/O: bytes and time points in; output, samples and events out. It owns no thread, port or clock.
/// After every call the caller does what takeOutput() says, in order, and arms a timer for nextDeadline().
/// One thread (the bus thread, or a test).
class Engine {
public:
    explicit Engine(EngineConfig config);
    ~Engine();
    Engine(Engine&&) noexcept;
    Engine& operator=(Engine&&) noexcept;

    /// Finds the chain: one that has its addresses, at any rate, is left as it is (ChainFound::attached;
    /// nulls and No Operation only, until it is found); a fresh one is given addresses and the configured
    /// rate. Then polls. Ends in ChainFound or ConnectFailed.
    void connect(TimePoint now);
    /// Restarts the network (Hard Reset at every rate a chain may have been left at) and gives addresses.
    /// Positions and gains of the modules are lost.
    void restart(TimePoint now);

    /// Queues an operation behind those before it. It ends in exactly one OperationFinished.
    void submit(Operation operation, TimePoint now);

    /// The same for groups; ends in exactly one GroupFinished. A command to a group is sent once, and what
    /// came of it is what each member shows; only if all groups are known.
    void submit(GroupOperation operation, TimePoint now);

    /// Takes the chain to another rate of kBaudRows; positions, gains and loads stay. Refused while anything
    /// moves; when a module does not follow, all go back. Ends in RateChanged or RateChangeFailed.
    void changeRate(std::uint32_t baud, TimePoint now);

    /// Starts or re-arms held motion: velocity mode, changed on the fly. The engine stops the motor smoothly
    /// (abruptly when the acceleration is 0) at release() or config.holdTimeout after the last hold().
    void hold(const HoldToMove& hold, TimePoint now);
    void release(TimePoint now);

    /// Stops every motor, past all queues; queued operations are cancelled and a hold ends. A servo that is
    /// on is stopped abruptly and keeps holding; one that is off stays off (link.md 2.6). Repeated until each
    /// module confirmed twice or does not answer; ends in exactly one StopFinished, also when called again.
    void stopAll(TimePoint now);

    /// Something happened to this machine, a suspend say: the link is checked before anything is believed.
    void distrust(TimePoint now);

    /// Modules that somebody looks at: they are polled as often as the wire carries, the others about five
    /// times a second. None: all alike.
    void watch(const std::vector<ModuleIndex>& modules);

    /// One module as fast as the wire carries, its position every time, for 5 s at most: the others are asked
    /// once a second, silent ones not at all. Nothing: no longer. A stop of whatever kind ends it, and so
    /// does another connect(). Calling it again begins the time anew.
    void focus(std::optional<ModuleIndex> module, TimePoint now);

    /// `bytes` arrived; `now` is when they were read.
    void onBytes(ByteSpan bytes, TimePoint now);
    /// nextDeadline() has passed.
    void onDeadline(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;

    [[nodiscard]] std::vector<Output> takeOutput();
    [[nodiscard]] std::vector<Event> takeEvents();
    [[nodiscard]] const LinkStatistics& statistics() const;
    /// Modules a stop would reach now: those that answer.
    [[nodiscard]] std::size_t stopReach() const;
    /// Some motor moves, or may.
    [[nodiscard]] bool anythingMoves() const;
    /// The whole stop as bytes that need no answer, nulls first, for a process that is about to die (link.md
    /// 2.6); empty when nothing is on. Changes only with a command or a status.
    [[nodiscard]] std::vector<std::uint8_t> stopBurst() const;
    /// The rate at which the chain hears that; the port may be at another one, in a search say.
    [[nodiscard]] std::uint32_t stopBurstBaud() const;
    /// The burst when it, or its rate, has changed since this was asked for the last time; cheap otherwise.
    /// Empty at first.
    [[nodiscard]] std::optional<std::vector<std::uint8_t>> changedStopBurst();

    /// Records every exchange from now on, for the packet monitor; off at first, and then without cost.
    void setRecording(bool on);
    [[nodiscard]] std::vector<ExchangeRecord> takeRecords();

private:
    class Private;
    std::unique_ptr<Private> d;
};

}  // namespace nmc::bus
