// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/conformance/servocommands.h"

#include <cmath>
#include <cstdlib>

namespace nmc::conformance {

using std::chrono::seconds;

INSTANTIATE_TEST_SUITE_P(, PicServo, kPlaces, nameOf);

Bytes gainBytes(const Gains& g) {
    return little(g.kp, 2) + little(g.kd, 2) + little(g.ki, 2) + little(g.il, 2) + little(g.ol, 1) +
           little(g.cl, 1) + little(g.el, 2) + little(g.sr, 1) + little(g.db, 1);
}

Bytes position(std::int32_t counts) {
    return little(static_cast<std::uint32_t>(counts), 4);
}

void PicServo::start(const std::string& chain, unsigned count, const std::vector<std::string>& options) {
    make(chain, options);
    rig->address(count);
}

Status PicServo::status(unsigned at) {
    const Bytes answer = command(0x13, {0x1F}, at);
    EXPECT_EQ(answer.size(), 14U);
    return {byteAt(answer, 0), longAt(answer, 1),
            byteAt(answer, 5), static_cast<std::int16_t>(wordAt(answer, 6)),
            byteAt(answer, 8), longAt(answer, 9)};
}

Bytes PicServo::load(unsigned control, const Bytes& data, unsigned at) {
    const auto length = static_cast<unsigned>(data.size()) + 1;
    return command(length << 4U | 4U, Bytes{static_cast<std::uint8_t>(control)} + data, at);
}

void PicServo::trapezoid(std::int32_t goal, std::uint32_t velocity, std::uint32_t acceleration, unsigned more,
                         unsigned at) {
    load(kServo | kLoadPosition | kLoadVelocity | kLoadAcceleration | more,
         position(goal) + little(velocity, 4) + little(acceleration, 4), at);
}

void PicServo::velocity(std::int32_t velocity, std::uint32_t acceleration, unsigned more) {
    load(
        kServo | kVelocityProfile | kLoadVelocity | kLoadAcceleration | more | (velocity < 0 ? kReverse : 0U),
        little(static_cast<std::uint32_t>(std::abs(velocity)), 4) + little(acceleration, 4));
}

void PicServo::pwm(int value) {
    load(kLoadPwm | kStart | (value < 0 ? kReverse : 0U), {static_cast<std::uint8_t>(std::abs(value))});
}

void PicServo::servoOn(const Gains& with, unsigned at) {
    gains(with, at);
    stop(kAmplifier | kAbruptly, at);
    command(0x0B, {}, at);
}

void PicServo::block() {
    const double shaft = number("shaft");
    rig->must("set 1 travel_min " + std::to_string(std::floor(shaft)));
    rig->must("set 1 travel_max " + std::to_string(std::ceil(shaft)));
}

void PicServo::turnAway() {
    stop(kAmplifier | kMotorOff);
    pwm(60);
    rig->wait(std::chrono::milliseconds(100));
    pwm(0);
    rig->wait(seconds(1));
    stop(kMotorOff);
    ASSERT_GT(number("position"), 1000);
}

void PicServo::wrapPosition() {
    stop(kMotorOff);
    // Its final speed is (0.0055 - 0.004) N·m / 1e-6 N·m·s = 1500 rad/s, or 477 000 counts/s.
    rig->must("set 1 load -0.0055");
    rig->wait(seconds(4'600));
    rig->must("set 1 load 0");
    rig->wait(seconds(20));
}

}  // namespace nmc::conformance
