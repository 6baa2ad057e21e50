// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bus/engine.h"
#include "protocol/baud.h"
#include "protocol/frame.h"
#include "tests/support/hexbytes.h"

namespace nmc::test {

/// The bit servo_on of the auxiliary status byte (DS-V 5.3).
inline constexpr std::uint8_t kServoOn = 0x04;

using testing_support::fromHex;

/// Appends the sum to a reply.
[[nodiscard]] inline std::vector<std::uint8_t> withSum(std::vector<std::uint8_t> bytes) {
    bytes.push_back(sum8(bytes));
    return bytes;
}

/// An engine whose other end is a function of the test: exact bytes, exact times, no simulator. By default it
/// is a chain of PIC-SERVOs that answers everything: servo off, at rest, power on.
class ScriptedBus {
public:
    struct Sent {
        TimePoint time;
        std::string hex;
    };

    explicit ScriptedBus(std::uint8_t modules, bus::EngineConfig config = {})
        : engine(config), m_config(config), m_modules(modules) {
        answer = [this](ByteSpan packet) { return likeAServo(packet); };
    }

    bus::Engine engine;
    TimePoint now{};
    std::vector<Sent> sent;  ///< packets and nulls
    std::vector<bus::Event> events;
    /// Bytes that come back, all at once; empty for silence.
    std::function<std::vector<std::uint8_t>(ByteSpan packet)> answer;
    /// Counted from the last byte of the command.
    Duration replyDelay = std::chrono::milliseconds(2);
    std::uint8_t status = 0x19;  ///< move_done, power_on, pos_error
    std::uint8_t aux = 0x00;     ///< servo off
    std::uint8_t version = 4;
    std::uint8_t type = 0;

    void pump() {
        for (const bus::Output& output : engine.takeOutput()) {
            if (const auto* rate = std::get_if<bus::SetHostBaud>(&output))
                m_byteTime = byteTimeAtBaud(rate->baud);
            if (const auto* send = std::get_if<bus::Send>(&output))
                carry(send->bytes);
        }
        for (bus::Event& event : engine.takeEvents())
            events.push_back(std::move(event));
    }

    void runFor(Duration time) {
        const TimePoint end = now + time;
        pump();
        while (now < end)
            order(end);
    }

    template <typename Condition>
    [[nodiscard]] bool runUntil(Condition condition, Duration limit = std::chrono::seconds(10)) {
        const TimePoint end = now + limit;
        pump();
        while (!condition()) {
            if (now >= end)
                return false;
            order(end);
        }
        return true;
    }

    [[nodiscard]] bool connect() {
        engine.restart(now);
        return runUntil([&] { return count<bus::ChainFound>() + count<bus::ConnectFailed>() > 0; }) &&
               count<bus::ChainFound>() == 1;
    }

    template <typename T>
    [[nodiscard]] std::size_t count() const {
        return all<T>().size();
    }
    template <typename T>
    [[nodiscard]] std::vector<T> all() const {
        std::vector<T> found;
        for (const bus::Event& event : events)
            if (const T* e = std::get_if<T>(&event))
                found.push_back(*e);
        return found;
    }
    /// How often these exact bytes went out since the given entry.
    [[nodiscard]] std::size_t sends(const std::string& hex, std::size_t from = 0) const {
        std::size_t n = 0;
        for (std::size_t i = from; i < sent.size(); ++i)
            n += sent[i].hex == hex ? 1U : 0U;
        return n;
    }

    [[nodiscard]] std::vector<std::uint8_t> likeAServo(ByteSpan packet) {
        const auto frame = parsePacket(packet);
        if (!frame || frame->address.value() == 0xFF)
            return {};
        const Payload& command = frame->payload;
        if (frame->address.value() == 0) {
            if (command.data[0] > m_modules)
                return {};
            return withSum({status});
        }
        if (frame->address.value() > m_modules)
            return {};
        StatusItems& defined = m_items[frame->address.value()];
        if (command.code == CommandCode::DefineStatus)
            defined = StatusItems(command.data[0]);
        return reply(command.code == CommandCode::ReadStatus ? StatusItems(command.data[0]) : defined);
    }

    /// Position 0, A/D 0, velocity 0, home 0, position error 0, no path points.
    [[nodiscard]] std::vector<std::uint8_t> reply(StatusItems items) const {
        std::vector<std::uint8_t> bytes{status};
        const auto add = [&](std::uint8_t item, std::vector<std::uint8_t> data) {
            if (items.has(item))
                bytes.insert(bytes.end(), data.begin(), data.end());
        };
        add(StatusItems::Position, {0, 0, 0, 0});
        add(StatusItems::Analog, {0});
        add(StatusItems::Velocity, {0, 0});
        add(StatusItems::Aux, {aux});
        add(StatusItems::Home, {0, 0, 0, 0});
        add(StatusItems::Identity, {type, version});
        add(StatusItems::PositionError, {0, 0});
        add(StatusItems::PathPoints, {0});
        return withSum(bytes);
    }

    /// True for nulls that only keep two packets apart: too few to empty a command buffer.
    [[nodiscard]] static bool isSpacer(ByteSpan bytes) { return bytes.front() == 0 && bytes.size() < 16; }
    static constexpr const char* kNulls = "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00";

private:
    struct Arrival {
        TimePoint time;
        std::vector<std::uint8_t> bytes;
    };

    void carry(const std::vector<std::uint8_t>& bytes) {
        if (!isSpacer(bytes))
            sent.push_back({now, toHex(bytes)});
        m_free = std::max(m_free, now) + m_byteTime * static_cast<Duration::rep>(bytes.size());
        auto back = bytes.front() == kHeader ? answer(bytes) : std::vector<std::uint8_t>{};
        if (!back.empty())
            m_arriving.push_back({m_free + replyDelay, std::move(back)});
    }

    void order(TimePoint end) {
        TimePoint next = end;
        if (const auto deadline = engine.nextDeadline())
            next = std::min(next, *deadline);
        if (!m_arriving.empty())
            next = std::min(next, m_arriving.front().time);
        m_stuck = next <= now ? m_stuck + 1 : 0;
        if (m_stuck > 1000) {
            ADD_FAILURE() << "time stands still";
            next = end;
        }
        now = std::max(now, next);
        if (!m_arriving.empty() && m_arriving.front().time <= now) {
            const Arrival arrival = m_arriving.front();
            m_arriving.erase(m_arriving.begin());
            engine.onBytes(arrival.bytes, now);
        } else if (const auto deadline = engine.nextDeadline(); deadline && *deadline <= now) {
            engine.onDeadline(now);
        }
        pump();
    }

    bus::EngineConfig m_config;
    std::uint8_t m_modules;
    Duration m_byteTime = byteTimeAtBaud(kPowerUpBaud);
    TimePoint m_free;
    std::map<std::uint8_t, StatusItems> m_items;
    std::vector<Arrival> m_arriving;
    unsigned m_stuck = 0;
};

}  // namespace nmc::test
