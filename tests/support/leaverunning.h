// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QJsonObject>
#include <QString>
#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/time.h"

namespace nmc::testing_support {

/// Acts as another program on the line of a fresh chain: assigns addresses to its servos, starts the last one
/// at `velocity` counts per tick without an end, and is gone. The bytes are taken from DS-V 5.2, not from the
/// encoder. nmcsim needs --enable-faults for it.
template <typename Simulator>
void leaveRunning(Simulator& chain, std::uint8_t modules, std::uint8_t velocity) {
    static constexpr Duration kForAnAnswer = std::chrono::milliseconds(30);
    const auto send = [&chain](std::vector<std::uint8_t> bytes) {
        std::uint8_t sum = 0;
        for (std::size_t i = 1; i < bytes.size(); ++i)
            sum = static_cast<std::uint8_t>(sum + bytes[i]);
        bytes.push_back(sum);
        const QJsonObject answer =
            chain.control(QStringLiteral("foreign ") + QString::fromStdString(toHex(bytes)));
        ASSERT_FALSE(answer.contains(QStringLiteral("error")));
        letPass(chain, kForAnAnswer);
    };
    letPass(chain, kForAnAnswer);  // a module does not listen for some ms after its power-up
    for (std::uint8_t address = 1; address <= modules; ++address)
        send({0xAA, 0x00, 0x21, address, 0xFF});
    send({0xAA, modules, 0xE6, 200, 0, 0xD0, 0x07, 20, 0, 200, 0, 255, 0, 0xA0, 0x0F, 1, 0});
    send({0xAA, modules, 0x17, 0x05});                                       // amplifier and servo on
    send({0xAA, modules, 0x94, 0xB6, 0, 0, velocity, 0, 0x1F, 0x05, 0, 0});  // velocity mode, start now
    // It accelerates by 0.02 counts per tick in each tick, which is 0x51F / 65 536.
    letPass(chain, kServoTick * (velocity * 50 + 100));
    ASSERT_NEAR(chain.state(modules)[QStringLiteral("command_velocity")].toDouble(), velocity, 0.01);
}

}  // namespace nmc::testing_support
