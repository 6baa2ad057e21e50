// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>

#include "bus/exchangerecord.h"

namespace nmc::testing_support {

/// A poll of module 1 for position and velocity, sent `microseconds` after TimePoint{}: position 1234,
/// velocity 2, move_done power_on.
inline bus::ExchangeRecord pollRecord(std::uint64_t number, std::int64_t microseconds = 0,
                                      std::uint8_t module = 0) {
    bus::ExchangeRecord record;
    record.number = number;
    record.sent = TimePoint(std::chrono::microseconds(microseconds));
    record.ended = record.sent + std::chrono::microseconds(1'450);
    record.purpose = bus::Purpose::Poll;
    record.baud = 115'200;
    record.module = ModuleIndex(module);
    const auto address = static_cast<std::uint8_t>(module + 1);
    record.command = {0xAA, address, 0x13, 0x05, static_cast<std::uint8_t>(address + 0x18)};
    record.reply = {0x09, 0xD2, 0x04, 0x00, 0x00, 0xFE, 0xFF, 0xDC};
    record.layout = {{ModuleType::Servo, 0}, StatusItems(0x05)};
    return record;
}

/// A Hard Reset of all modules, which none of them answers.
inline bus::ExchangeRecord resetRecord(std::uint64_t number, std::int64_t microseconds = 0) {
    bus::ExchangeRecord record;
    record.number = number;
    record.sent = TimePoint(std::chrono::microseconds(microseconds));
    record.ended = record.sent + std::chrono::milliseconds(25);
    record.purpose = bus::Purpose::Connect;
    record.baud = 19'200;
    record.command = {0xAA, 0xFF, 0x0F, 0x0E};
    record.end = bus::ReplyResult::NotAsked;
    return record;
}

inline bus::ExchangeRecord with(bus::ExchangeRecord record, bus::Purpose purpose, bus::ReplyResult end) {
    record.purpose = purpose;
    record.end = end;
    return record;
}

}  // namespace nmc::testing_support
