// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/packets/packetlog.h"

/// The replayable log: everything sent over the line, in a form for programs. Plain ASCII lines, each ended
/// by a line feed. The header has eight lines, in this order:
///
///     # nmcpanel packet log 1
///     # program NMC Panel 0.3.0
///     # started 2025-06-01T12:00:00.000Z
///     # port simulator
///     # simulated yes
///     # dropped 0
///     # time_us took_us purpose module baud type:items verdict >command <reply
///     #
///
/// then one line for each exchange, its fields separated by one space:
///
///     12034.567 1450.000 poll 1 115200 0:05 accepted >AA01130519 <09D204000000FEFFDC
///
/// - time_us, took_us: when the command was passed to the port, in microseconds since `started`, and how long
///   the exchange took; always three decimals
/// - purpose: connect poll operation check hold stop challenge flush
/// - module: in addressing order, from 1; - if unknown
/// - baud: nominal rate of the port
/// - type:items: the layout of the reply, as type number and hexadecimal mask of status items; the type is
///   followed by the version if known, as in 0.10:C5
/// - verdict: accepted refused silent partial bad_checksum rejected abandoned not_asked; a rejected reply is
///   followed by a colon and its rule, as in rejected:home_changed
/// - >command, <reply: the bytes in hexadecimal as sent and received, including checksums
///
/// A line `gap` means that exchanges between its neighbours were not recorded; `dropped` counts those before
/// the first. A file without gaps and with nothing dropped can be replayed: sending the commands again at the
/// same times and rates to a chain in the same state yields the same replies.
namespace nmc {

[[nodiscard]] std::string writePacketFile(const PacketLog& log);

}  // namespace nmc
