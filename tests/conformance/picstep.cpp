// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/conformance/picstep.h"

#include <algorithm>

namespace nmc::conformance {

// For the tests of all step_*_test.cpp.
INSTANTIATE_TEST_SUITE_P(, PicStep, kPlaces, nameOf);

void PicStep::fresh(const std::string& chain, const std::vector<std::string>& options) {
    make(chain, options);
    rig->address(static_cast<unsigned>(std::count(chain.begin(), chain.end(), ',')) + 1);
    stop(0x01);
}

void PicStep::parameters(unsigned mode, unsigned minimum, unsigned run, unsigned hold, unsigned thermal) {
    Bytes data;
    for (const unsigned value : {mode, minimum, run, hold, thermal})
        append(data, value, 1);
    EXPECT_EQ(command(0x56, data).size(), 2U);
}

void PicStep::load(const Load& l) {
    const Bytes data = loadData(l);
    EXPECT_EQ(command(loadByte(data), data).size(), 2U);
}

void PicStep::moveTo(std::int32_t goal) {
    load({.position = goal, .count = kCount, .nearest = kNearest});
    static_cast<void>(secondsToStop());
    EXPECT_EQ(position(), goal);
}

StepperReport PicStep::report() {
    const Bytes r = command(0x13, {0x3F});
    EXPECT_EQ(r.size(), kReportSize);
    return r.size() == kReportSize ? readReport(r) : StepperReport{};
}

double PicStep::stepsIn(Duration time) {
    const std::int64_t before = position();
    rig->wait(time);
    return static_cast<double>(position() - before);
}

double PicStep::secondsToStop() {
    constexpr int kPatience = 60'000;
    int ticks = 0;
    for (; moving() && ticks < kPatience; ++ticks)
        rig->wait(kTick);
    EXPECT_LT(ticks, kPatience) << "it does not stop";
    return toSeconds(kTick * ticks);
}

double PicStep::secondsToSpeed(unsigned wanted) {
    constexpr int kPatience = 20'000;
    int ticks = 0;
    for (; speed() != wanted && ticks < kPatience; ++ticks)
        rig->wait(kTick);
    EXPECT_LT(ticks, kPatience) << "it does not reach " << wanted;
    return toSeconds(kTick * ticks);
}

void PicStep::expectForm(const char* name, unsigned byte, const Bytes& data, unsigned address) {
    const auto executed = [this, name] {
        return rig->control("stats")["modules"][0]["executed"].value(name, 0);
    };
    const int before = executed();
    rig->command(address, byte, data);
    EXPECT_EQ(executed(), before + 1) << name;
    expectNoViolations();
    rig->command(address, byte + 0x10, data + Bytes{0});
    expectViolations({"wrong_length"});
}

void PicStep::expectInput(const std::string& pin, unsigned bit) {
    for (const unsigned level : {1U, 0U}) {
        set(pin + " " + std::to_string(level));
        EXPECT_EQ(byteAt(command(0x13, {0x08}), 1), level * bit) << pin;
    }
}

}  // namespace nmc::conformance
