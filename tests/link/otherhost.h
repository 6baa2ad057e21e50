// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QTest>
#include <cstdint>
#include <vector>

#include "tests/support/nmcsimprocess.h"
#include "tests/support/port.h"

namespace nmc::testing_support {

/// Another program on nmcsim's terminal: gives the servos of a fresh chain their addresses, sets the last one
/// in motion, so many counts per tick without an end, and is gone.
inline void leaveRunning(NmcsimProcess& sim, std::uint8_t modules, std::uint8_t velocity) {
    constexpr int kHostPatienceMs = 10'000;
    constexpr int kNotYetMs = 200;  // a module is deaf for some ms after its power-up
    Port host(sim.terminal().toStdString());
    host.setRate(B19200);
    const auto answers = [&host](int patienceMs, std::vector<std::uint8_t> bytes) {
        std::uint8_t sum = 0;
        for (std::size_t i = 1; i < bytes.size(); ++i)
            sum = static_cast<std::uint8_t>(sum + bytes[i]);
        bytes.push_back(sum);
        host.flush();
        host.write(bytes);
        // Status and sum, which need not come together.
        return !host.read(1, patienceMs).empty() && !host.read(1, kHostPatienceMs).empty();
    };
    host.write(std::vector<std::uint8_t>(16, 0));
    for (std::uint8_t address = 1; address <= modules; ++address) {
        ASSERT_TRUE(QTest::qWaitFor([&] { return answers(kNotYetMs, {0xAA, 0x00, 0x0E}); }, kHostPatienceMs));
        ASSERT_TRUE(answers(kHostPatienceMs, {0xAA, 0x00, 0x21, address, 0xFF}));
    }
    ASSERT_TRUE(answers(kHostPatienceMs,
                        {0xAA, modules, 0xE6, 200, 0, 0xD0, 0x07, 20, 0, 200, 0, 255, 0, 0xA0, 0x0F, 1, 0}));
    ASSERT_TRUE(answers(kHostPatienceMs, {0xAA, modules, 0x17, 0x05})) << "amplifier and servo on";
    ASSERT_TRUE(answers(kHostPatienceMs, {0xAA, modules, 0x94, 0xB6, 0, 0, velocity, 0, 0x1F, 0x05, 0, 0}))
        << "velocity mode, now";
    const auto runs = [&] {
        const double commanded = sim.state(modules)[QStringLiteral("command_velocity")].toDouble();
        return std::abs(commanded - velocity) < 0.01;
    };
    ASSERT_TRUE(QTest::qWaitFor(runs, kHostPatienceMs));
}

/// So much later by the simulator's own time, in seconds.
[[nodiscard]] inline bool passes(NmcsimProcess& sim, double seconds) {
    const auto now = [&sim] {
        return sim.control(QStringLiteral("stats"))[QStringLiteral("time")].toDouble();
    };
    const double until = now() + seconds;
    return QTest::qWaitFor([&] { return now() >= until; }, 60'000);
}

}  // namespace nmc::testing_support
