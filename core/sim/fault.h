// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/time.h"
#include "protocol/commandcode.h"

namespace nmc::sim {

/// What can be made to go wrong (simulator.md, Faults). A *frame* is a command packet or a reply.
enum class FaultKind : std::uint8_t {
    // Damage to frames in transit.
    Drop,      ///< one byte is lost
    Dup,       ///< one byte is doubled
    Flip,      ///< one bit is wrong
    Collide,   ///< two bits are wrong but the sum is right
    Truncate,  ///< the rest is lost
    Garbage,   ///< every byte is a random one
    Overrun,   ///< a module loses one byte of a packet and detects it
    // The fate of a whole command or reply.
    Delay,   ///< the reply is late: held up on the line (bus), or begun later (module)
    Silent,  ///< the command is executed but not answered
    Cksum,   ///< a good packet is refused as damaged (NAK)
    Ignore,  ///< the command is not received
    Stuck,   ///< the module repeats an earlier reply of the same length
    // The line.
    Noise,    ///< random bytes
    Break,    ///< the line is held low: 00 instead of every byte
    MuteRx,   ///< what modules send does not reach the host
    MuteTx,   ///< what the host sends does not reach modules
    Echo,     ///< the host receives what it sends
    Foreign,  ///< another host sends commands
    // The module.
    PowerCycle,
    Stall,         ///< the shaft is held fast
    Reverse,       ///< the encoder counts the wrong way
    SameAddress,   ///< the modules take the address of the first one
    DefineStatus,  ///< the status items are changed
};

/// The directions that a fault affects.
struct FaultSides {
    bool command = true;
    bool status = true;
};

/// One `fault` line. The table in faultspec.cpp defines which fields a kind may have.
struct FaultSpec {
    FaultKind kind = FaultKind::Drop;
    std::vector<std::uint8_t> modules;  ///< counted from 0; empty: the bus
    FaultSides sides;
    std::optional<CommandCode> command;   ///< strikes only packets with this code, and their replies
    double probability = 1.0;             ///< probability for each frame
    std::optional<std::uint64_t> count;   ///< maximum number of strikes
    std::optional<Duration> least, most;  ///< range of the delay, or of the time between two bytes or packets
    std::optional<TimePoint> at;          ///< start; nothing: at once
    std::optional<Duration> lasts;        ///< duration; nothing: until cleared
    std::optional<unsigned> bit;          ///< bit of the frame, counted from bit 0 of its first byte
    std::string text;                     ///< the line as given

    [[nodiscard]] bool onBus() const { return modules.empty(); }
};

/// A fault that has been injected.
struct FaultReport {
    unsigned number = 0;
    std::string text;
    std::uint64_t struck = 0;  ///< number of frames, bytes or events struck
    bool active = false;       ///< begun and not yet over
};

}  // namespace nmc::sim
