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
    // Damage to frames on their way.
    Drop,      ///< one byte is lost
    Dup,       ///< one byte comes twice
    Flip,      ///< one bit is wrong
    Collide,   ///< two bits are wrong and the sum is right
    Truncate,  ///< the rest is lost
    Garbage,   ///< every byte is a random one
    Overrun,   ///< a module loses one byte of a packet and knows it
    // What becomes of a whole command or reply.
    Delay,   ///< the reply comes later: held up on the line (bus), or begun later (module)
    Silent,  ///< the command is carried out and not answered
    Cksum,   ///< a good packet is refused as damaged
    Ignore,  ///< the command is not heard
    Stuck,   ///< a reply that has the length of an earlier one is that earlier one
    // The line.
    Noise,    ///< random bytes
    Break,    ///< held low: 00 instead of every byte
    MuteRx,   ///< what modules send does not reach the host
    MuteTx,   ///< what the host sends does not reach modules
    Echo,     ///< the host hears what it sends
    Foreign,  ///< another host sends commands
    // The module.
    PowerCycle,
    Stall,         ///< something holds the shaft
    Reverse,       ///< the encoder counts the wrong way
    SameAddress,   ///< the modules have the address of the first one
    DefineStatus,  ///< the status items are others
};

/// The directions that a fault strikes.
struct FaultSides {
    bool command = true;
    bool status = true;
};

/// One `fault` line. What it may hold together with what is faultspec.cpp's table.
struct FaultSpec {
    FaultKind kind = FaultKind::Drop;
    std::vector<std::uint8_t> modules;  ///< from 0; empty: the bus
    FaultSides sides;
    std::optional<CommandCode> command;   ///< only packets with it, and their replies
    double probability = 1.0;             ///< of each frame
    std::optional<std::uint64_t> count;   ///< strikes no more often
    std::optional<Duration> least, most;  ///< delay, or time between two bytes or packets
    std::optional<TimePoint> at;          ///< begins; nothing: at once
    std::optional<Duration> lasts;        ///< nothing: until cleared
    std::optional<unsigned> bit;          ///< of the frame, from bit 0 of its first byte
    std::string text;                     ///< as it was given

    [[nodiscard]] bool onBus() const { return modules.empty(); }
};

/// A fault that has been injected.
struct FaultReport {
    unsigned number = 0;
    std::string text;
    std::uint64_t struck = 0;  ///< frames, bytes or events
    bool active = false;       ///< begun and not yet over
};

}  // namespace nmc::sim
