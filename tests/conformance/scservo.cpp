// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/conformance/scservo.h"

namespace nmc::conformance {

INSTANTIATE_TEST_SUITE_P(, ScServo, kPlaces, nameOf);

void ScServo::points(const std::vector<unsigned>& words, unsigned at) {
    Bytes data;
    for (const unsigned word : words)
        data = data + little(word, 2);
    command(static_cast<unsigned>(data.size()) << 4U | 0x0DU, data, at);
}

void ScServo::leanOnAnError() {
    servoOn({.kp = 100, .kd = 1000});
    rig->must("set 1 load 0.1");
    rig->wait(std::chrono::seconds(1));
    ASSERT_GT(place().error, 5);
}

std::vector<double> ScServo::followPath(int ticks) {
    const double from = number("command_position");
    rig->send(packet(1, 0x0D));
    for (int i = 0; i < 100 && number("command_position") == from; ++i)
        rig->waitTicks(1);
    std::vector<double> course;
    for (int i = 0; i < ticks; ++i) {
        course.push_back(number("command_position") - from);
        rig->waitTicks(1);
    }
    return course;
}

void ScServo::runForward(std::int32_t countsPerTick) {
    servoOn();
    velocity(countsPerTick * static_cast<std::int32_t>(kOne), kOne);
    rig->wait(std::chrono::milliseconds(100));
}

}  // namespace nmc::conformance
