// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/packets/packetlog.h"

/// The replayable log: everything that went over the wire, to be read by a program. Plain ASCII lines, each
/// ended by a line feed. Eight lines of header, in this order:
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
/// - time_us, took_us: when the command was handed to the port, in microseconds since `started`, and how long
///   the exchange took; always three decimals
/// - purpose: connect poll operation check hold stop challenge flush
/// - module: in the order of addressing, from 1; - where that is not known
/// - baud: nominal rate of the port
/// - type:items: the reply's layout, as type number and mask of status items in hexadecimal; behind the type
///   stands the version where it is known, as in 0.10:C5
/// - verdict: accepted refused silent partial bad_checksum rejected abandoned not_asked; a rejected one names
///   its rule behind a colon, as in rejected:home_changed
/// - >command, <reply: the bytes in hexadecimal, as sent and received, checksums included
///
/// A line `gap` says that exchanges between its neighbours were not recorded; `dropped` counts those before
/// the first. A file without gap and without dropped can be replayed: the commands sent again at the same
/// times and rates to a chain in the same state get the same replies.
namespace nmc {

[[nodiscard]] std::string writePacketFile(const PacketLog& log);

}  // namespace nmc
