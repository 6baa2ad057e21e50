// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "protocol/commands.h"
#include "protocol/frame.h"
#include "tests/support/nmcsimprocess.h"
#include "tests/support/port.h"

namespace nmc::testing_support {

/// As another program would: address 1, gains, servo on, and off at 4 counts/tick.
inline void setGoing(const NmcsimProcess& sim) {
    Port port(sim.terminal().toStdString());
    port.setRate(B19200);
    const auto answers = [&port](const std::vector<std::uint8_t>& bytes, int ms) {
        port.write(bytes);
        std::vector<std::uint8_t> answer = port.read(2, ms);
        while (answer.size() == 1)
            answer.push_back(port.read(1, ms).at(0));
        return answer.size() == 2;
    };
    // What was written before the simulator knew the rate is noise to it; nulls end it.
    for (bool heard = false; !heard; heard = answers({0xAA, 0x00, 0x21, 0x01, 0xFF, 0x21}, 500))
        port.write(std::vector<std::uint8_t>(16, 0));
    const auto command = [&answers](const ServoCommand& what) {
        const PacketBytes bytes = toPacket({BusAddress(1), encode(what)});
        ASSERT_TRUE(answers({bytes.begin(), bytes.end()}, 20'000));
    };
    command(servo::SetGain{200, 2'000, 20, 200, 255, 0, 8'000, 1, std::uint8_t{0}});
    command(servo::StopMotor{true, servo::StopManner::Abruptly, {}});
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(4 << 16);
    load.acceleration = CountsPerTickSquared(1'311);
    load.profile = servo::ProfileMode::Velocity;
    load.startNow = true;
    command(load);
}

}  // namespace nmc::testing_support
