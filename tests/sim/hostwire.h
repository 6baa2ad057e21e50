// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "sim/chain.h"
#include "sim/chainspec.h"

namespace nmc::sim::test {

using Bytes = std::vector<std::uint8_t>;

inline constexpr Duration kTick = std::chrono::microseconds(512);
/// One count, or one count per tick, in 16.16.
inline constexpr std::uint32_t kOne = 65536;
/// The answer of a servo that has been idle since power-up: move_done, power_on, pos_error.
inline const Bytes kIdle{0x19, 0x19};

inline Bytes values(const std::vector<HostByte>& bytes) {
    Bytes all;
    for (const HostByte& byte : bytes)
        all.push_back(byte.value);
    return all;
}

/// A command packet with its sum, made independently of the host's code.
inline Bytes packet(unsigned address, unsigned command, const Bytes& data = {}) {
    Bytes bytes{0xAA, static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(command)};
    for (const std::uint8_t byte : data)
        bytes.push_back(byte);
    unsigned sum = 0;
    for (std::size_t i = 1; i < bytes.size(); ++i)
        sum += bytes[i];
    bytes.push_back(static_cast<std::uint8_t>(sum & 0xFFU));
    return bytes;
}

inline void append(Bytes& bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU));
}

/// Set Gain's data bytes, version 4.
inline Bytes gainData(unsigned kp, unsigned kd, unsigned ki, unsigned il, unsigned ol, unsigned cl,
                      unsigned el, unsigned sr, unsigned db) {
    Bytes data;
    for (const unsigned word : {kp, kd, ki, il})
        append(data, word, 2);
    append(data, ol, 1);
    append(data, cl, 1);
    append(data, el, 2);
    append(data, sr, 1);
    append(data, db, 1);
    return data;
}

/// Items 1F: position, A/D, velocity, auxiliary byte and home.
struct Report {
    unsigned status = 0;
    std::int32_t position = 0;
    unsigned analog = 0;
    int velocityItem = 0;
    unsigned auxiliary = 0;
    std::int32_t home = 0;
    [[nodiscard]] bool moveDone() const { return (status & 0x01U) != 0; }
    [[nodiscard]] bool overcurrent() const { return (status & 0x04U) != 0; }
    [[nodiscard]] bool positionError() const { return (status & 0x10U) != 0; }
    [[nodiscard]] bool homeInProgress() const { return (status & 0x80U) != 0; }
    [[nodiscard]] bool servoOn() const { return (auxiliary & 0x04U) != 0; }
};

/// A minimal host: sends packets, waits for replies and keeps the time.
class HostWire {
public:
    explicit HostWire(std::string_view spec = "servo", ChainOptions options = {})
        : chain(parseChain(spec).value(), options) {
        wait(options.resetDeadTime + std::chrono::milliseconds(2));
    }

    /// Lets time pass; bytes that arrive meanwhile are discarded.
    void wait(Duration time) {
        now += time;
        chain.advanceTo(now);
        static_cast<void>(chain.takeHostBytes());
    }
    void waitTicks(int ticks) { wait(kTick * ticks); }

    /// Sends `bytes` and waits until the line is silent; returns what was received.
    std::vector<HostByte> exchange(const Bytes& bytes) {
        chain.hostSends(bytes, now);
        while (const auto next = chain.nextEvent()) {
            now = *next;
            chain.advanceTo(now);
        }
        return chain.takeHostBytes();
    }
    Bytes command(unsigned address, unsigned code, const Bytes& data = {}) {
        return values(exchange(packet(address, code, data)));
    }

    /// Assigns the addresses 1..count to the modules, in group FF without a leader.
    void address(unsigned count) {
        for (unsigned i = 1; i <= count; ++i)
            ASSERT_EQ(command(0, 0x21, {static_cast<std::uint8_t>(i), 0xFF}).size(), 2U) << "module " << i;
    }

    Report report(unsigned at = 1) {
        const Bytes r = command(at, 0x13, {0x1F});
        Report report;
        EXPECT_EQ(r.size(), 14U);
        if (r.size() != 14)
            return report;
        report.status = r[0];
        report.position = word(r, 1);
        report.analog = r[5];
        report.velocityItem = static_cast<std::int16_t>(r[6] | r[7] << 8);
        report.auxiliary = r[8];
        report.home = word(r, 9);
        return report;
    }

    void gains(const Bytes& data, unsigned at = 1) { command(at, data.size() == 13 ? 0xD6 : 0xE6, data); }
    /// Amplifier on, motor off.
    void enableAmplifier(unsigned at = 1) { command(at, 0x17, {0x03}); }
    /// Amplifier on, servo on at its present position.
    void servoOn(unsigned at = 1) { command(at, 0x17, {0x05}); }
    void trapezoid(std::int32_t goal, std::uint32_t velocity, std::uint32_t acceleration, unsigned at = 1) {
        Bytes data{0x97};
        append(data, static_cast<std::uint32_t>(goal), 4);
        append(data, velocity, 4);
        append(data, acceleration, 4);
        command(at, 0xD4, data);
    }
    void velocity(std::int64_t value, std::uint32_t acceleration, unsigned at = 1) {
        Bytes data{static_cast<std::uint8_t>(value < 0 ? 0xF6 : 0xB6)};
        append(data, static_cast<std::uint32_t>(value < 0 ? -value : value), 4);
        append(data, acceleration, 4);
        command(at, 0x94, data);
    }
    void pwm(int value, unsigned at = 1) {
        command(at, 0x24,
                {static_cast<std::uint8_t>(value < 0 ? 0xC8 : 0x88),
                 static_cast<std::uint8_t>(value < 0 ? -value : value)});
    }

    ModuleSnapshot truth(unsigned module = 1) {
        return chain.snapshot(ModuleIndex(static_cast<std::uint8_t>(module - 1)), now);
    }
    void set(Input input, std::optional<double> value, unsigned module = 1) {
        chain.set(ModuleIndex(static_cast<std::uint8_t>(module - 1)), input, value, now);
    }
    [[nodiscard]] std::vector<ViolationKind> violations() const {
        std::vector<ViolationKind> kinds;
        for (const Violation& violation : chain.violations().entries())
            kinds.push_back(violation.kind);
        return kinds;
    }

    Chain chain;
    TimePoint now;

private:
    static std::int32_t word(const Bytes& bytes, std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;)
            value = value << 8U | bytes[at + i];
        return static_cast<std::int32_t>(value);
    }
};

inline ChainOptions withFaults(std::uint64_t seed = 1) {
    ChainOptions options;
    options.enableFaults = true;
    options.seed = seed;
    return options;
}

/// Gains that hold the default motor well: 11 ms rise, 2 % overshoot (simulator.md, Fidelity).
inline Bytes goodGains(unsigned el = 0x3FFF) {
    return gainData(200, 2000, 20, 200, 255, 0, el, 1, 0);
}

}  // namespace nmc::sim::test
