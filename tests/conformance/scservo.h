// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/conformance/servocommands.h"

namespace nmc::conformance {

// I/O Control of an SC.
inline constexpr unsigned kLimitOff = 0x04, kLimitAbrupt = 0x08, kThreePhase = 0x10, kAntiphase = 0x20,
                          kFastPath = 0x40, kStepAndDirection = 0x80;

// Hard Reset's control byte.
inline constexpr unsigned kSave = 0x01, kSaveAddresses = 0x02, kSaveAmplifier = 0x04, kSaveServo = 0x08,
                          kSaveSteps = 0x10, kSaveLimits = 0x20, kSaveThreePhase = 0x40,
                          kSaveAntiphase = 0x80;

/// The statements about PIC-SERVO SC and CMC (statements-sc.md): an SC at address 1.
class ScServo : public PicServo {
protected:
    ScServo() { start("servo@10", 1); }

    void ioControl(unsigned control) { command(0x18, {static_cast<std::uint8_t>(control)}); }
    /// Position and position error, as the chip reports them.
    struct Place {
        std::int32_t position = 0;
        int error = 0;
    };
    Place place() {
        const Bytes answer = command(0x13, {0x41});
        EXPECT_EQ(answer.size(), 8U);
        return {longAt(answer, 1), static_cast<std::int16_t>(wordAt(answer, 5))};
    }
    unsigned auxiliary() { return byteAt(command(0x13, {0x08}), 1); }
    unsigned pathPoints() { return byteAt(command(0x13, {0x80}), 1); }
    void points(const std::vector<unsigned>& words, unsigned at = 1);
    void powerCycle() {
        rig->must("power-cycle 1");
        rig->wait(std::chrono::milliseconds(20));
    }
    /// Switches the servo on without integral gain under a load, which leaves an error of some counts.
    void leanOnAnError();
    /// Starts the path and returns the command position after each of `ticks` ticks, from the first one that
    /// moves it.
    std::vector<double> followPath(int ticks);
    /// Lets the motor run at about `countsPerTick`, by the profile.
    void runForward(std::int32_t countsPerTick = 5);
};

}  // namespace nmc::conformance
