// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/time.h"
#include "protocol/moduletype.h"

namespace nmc::sim {

struct ChainOptions {
    /// How long a module is deaf after power-up or Hard Reset (protocol.md 1, a choice).
    Duration resetDeadTime = std::chrono::milliseconds(8);
    /// Replies take no wire time; for tests of other things.
    bool unpaced = false;
    /// Phase of the modules' ticks and the garbling of bytes at a wrong rate come from it.
    std::uint64_t seed = 1;
};

/// A byte that arrives at the host; `due` is the end of its stop bit.
struct HostByte {
    TimePoint due;
    std::uint8_t value = 0;
};

/// A chain of modules and the line to the host: the other end of the wire.
///
/// Pure: bytes and time points in, bytes with due times out; no thread, no clock. Time must not go back.
/// The chain is powered up at TimePoint{}. One thread at a time.
class Chain {
public:
    explicit Chain(const std::vector<ModuleIdentity>& modules, ChainOptions options = {});
    ~Chain();
    Chain(Chain&&) noexcept;
    Chain& operator=(Chain&&) noexcept;

    /// The rate the host's port is set to, from the next byte on. 19 200 at first.
    void setHostBaud(std::uint32_t baud);

    /// The host's port takes `bytes` at `now`; they leave it back to back, behind what is still leaving.
    void hostSends(ByteSpan bytes, TimePoint now);

    /// Runs everything up to and including `now`.
    void advanceTo(TimePoint now);

    /// The bytes that have reached the host since the last call, in the order of arrival.
    [[nodiscard]] std::vector<HostByte> takeHostBytes();

    /// When the host's side can next see something happen; nothing while the line is idle. Motors move on
    /// between events without being asked: advanceTo() catches up.
    [[nodiscard]] std::optional<TimePoint> nextEvent() const;

private:
    class Private;
    std::unique_ptr<Private> d;
};

}  // namespace nmc::sim
