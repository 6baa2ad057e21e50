// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/conformance/conformance.h"
#include "tests/conformance/steppercommands.h"

namespace nmc::conformance {

using namespace stepperchip;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// The integer speed next to kCount: 1000 / 25.
inline constexpr std::uint8_t kNearest = 40;

/// A whole number of ticks that is a whole number of seconds, so that results are not uncertain by a tick.
inline constexpr Duration kEightSeconds = kTick * 15'625;
/// 64 ms.
inline constexpr Duration k125Ticks = kTick * 125;

using Kinds = std::vector<std::string>;

/// The statements of DS-S (statements-step.md): a stepper at address 1, its amplifier enabled.
class PicStep : public Statement {
protected:
    PicStep() { fresh(); }

    /// Makes a fresh chain with nothing logged: a stepper at address 1, its amplifier enabled.
    void fresh(const std::string& chain = "step", const std::vector<std::string>& options = {});
    /// Makes a fresh chain with modules that have no addresses yet.
    void powerUp(const std::string& chain = "step") { make(chain); }

    /// Sends a command to module 1.
    Bytes command(unsigned byte, const Bytes& data = {}) { return rig->command(1, byte, data); }
    void parameters(unsigned mode, unsigned minimum = 1, unsigned run = 200, unsigned hold = 80,
                    unsigned thermal = 0);
    void load(const Load& l);
    void stop(unsigned control) { EXPECT_EQ(command(0x17, {static_cast<std::uint8_t>(control)}).size(), 2U); }
    /// Runs at kCount, without a stop.
    void run(bool reverse = false) { load({.count = kCount, .nearest = kNearest, .reverse = reverse}); }
    void moveTo(std::int32_t goal);

    unsigned status() { return byteAt(command(0x0E), 0); }
    StepperReport report();
    void set(const std::string& nameAndValue) { rig->must("set 1 " + nameAndValue); }

    template <typename T>
    T truth(const char* key) {
        return rig->state().at(key).get<T>();
    }
    bool moving() { return truth<bool>("moving"); }
    std::int64_t position() { return truth<std::int64_t>("position"); }
    unsigned speed() { return truth<unsigned>("speed"); }
    bool amplifier() { return (status() & 0x04U) != 0; }
    /// The steps made within `time`.
    double stepsIn(Duration time);
    /// Waits until the motor is at rest; returns how long that took, in seconds, to the tick.
    double secondsToStop();
    /// Waits until a profile has reached an integer speed; returns how long that took, in seconds, to the
    /// tick.
    double secondsToSpeed(unsigned wanted);

    /// Checks that the command is executed once as `name`, and that one more data byte is a wrong length.
    void expectForm(const char* name, unsigned byte, const Bytes& data, unsigned address = 1);
    /// Checks that a pin is one bit of the inputs byte, high and low again.
    void expectInput(const std::string& pin, unsigned bit);
    void expectViolations(const Kinds& kinds) { EXPECT_EQ(rig->violations(), kinds); }
    void expectNoViolations() { expectViolations({}); }
};

}  // namespace nmc::conformance
