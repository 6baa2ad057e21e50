// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "bus/exchange.h"
#include "bus/rejection.h"

namespace nmc::bus {

/// What the engine wanted with an exchange.
enum class Purpose : std::uint8_t {
    Connect,    ///< looks for the chain, or gives addresses
    Poll,       ///< the regular question
    Operation,  ///< a command of the operator
    Check,      ///< a status that a command waits for
    Hold,       ///< held motion, and its stop
    Stop,       ///< stop all
    Challenge,  ///< is the link to be trusted again?
    Flush,      ///< nulls, or a packet that nobody answers
};

/// What became of it.
enum class ExchangeEnd : std::uint8_t {
    Accepted,
    Refused,       ///< communication-error bit
    Unresponsive,  ///< not one byte
    Partial,       ///< too few bytes
    BadChecksum,   ///< as many as expected, wrong sum
    Rejected,      ///< right sum, not believed: see `rejection`
    Abandoned,     ///< a stop went past it
    NotAsked,      ///< no reply was expected; `reply` holds what came all the same
};

/// One exchange as the packet monitor shows it: bytes and what the engine made of them. A value.
struct ExchangeRecord {
    std::uint64_t number = 0;  ///< counts up from 1 while recording
    TimePoint sent;            ///< when the command was handed to the port
    TimePoint ended;
    Purpose purpose = Purpose::Poll;
    std::uint32_t baud = 0;             ///< nominal rate of the port
    std::optional<ModuleIndex> module;  ///< none for groups and while the chain is being looked for
    std::vector<std::uint8_t> command;  ///< as sent, header and sum included; nulls for a flush
    std::vector<std::uint8_t> reply;    ///< as received, surplus bytes included
    ReplyLayout layout;                 ///< what the reply was taken for
    ExchangeEnd end = ExchangeEnd::Accepted;
    std::optional<Rejection> rejection;
};

}  // namespace nmc::bus
