// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "bus/exchange.h"

namespace nmc::bus {

/// The engine's purpose in an exchange.
enum class Purpose : std::uint8_t {
    Connect,    ///< searches for the chain, or assigns addresses
    Poll,       ///< the regular query
    Operation,  ///< a command of the user
    Check,      ///< a status that a command is waiting for
    Hold,       ///< held motion, and its stop
    Stop,       ///< stop all
    Challenge,  ///< verifies whether the link can be trusted again
    Flush,      ///< nulls, or a packet without a reply
    Lent,       ///< of the program that the line is lent to
};

/// An exchange as the packet monitor shows it: its bytes and the engine's result. A value type.
struct ExchangeRecord {
    std::uint64_t number = 0;  ///< counted from 1 while recording
    TimePoint sent;            ///< when the command was passed to the port
    TimePoint ended;
    Purpose purpose = Purpose::Poll;
    std::uint32_t baud = 0;             ///< nominal rate of the port
    std::optional<ModuleIndex> module;  ///< empty for groups and while the chain is being searched for
    std::vector<std::uint8_t> command;  ///< as sent, including header and sum; nulls for a flush
    std::vector<std::uint8_t> reply;    ///< as received, including surplus bytes
    ReplyLayout layout;                 ///< layout by which the reply was decoded
    ReplyResult end = ReplyResult::Accepted;
    std::optional<Rejection> rejection;
};

}  // namespace nmc::bus
