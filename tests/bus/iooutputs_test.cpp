// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of a stop to a PIC-I/O: exactly the outputs that the machine marks go low, and only while they
// may be high.
#include "bus/iooutputs.h"

#include <gtest/gtest.h>

namespace nmc::bus {
namespace {

constexpr StopOutputs kPump{0x0004, 0};  // IO3
constexpr StopOutputs kHeater{0, 0x01};  // PWM1
constexpr std::uint16_t kPumpAndLamp = 0x0005;

[[nodiscard]] IoOutputs with(const StopOutputs& off) {
    IoOutputs outputs;
    outputs.setStopOutputs(off);
    return outputs;
}
void tell(IoOutputs& outputs, const auto& command) {
    outputs.onSent(command);
    outputs.onExecuted(command);
}
[[nodiscard]] std::optional<IoCommand> pins(std::uint16_t outputs) {
    return IoCommand(io::SetOutput{outputs});
}

TEST(IoOutputs, AreLeftAsTheyAreUnlessTheMachineSaysOtherwise) {
    IoOutputs outputs;
    tell(outputs, io::SetOutput{io::kAllPins});
    tell(outputs, io::SetPwm{255, 255});
    EXPECT_EQ(outputs.stop(), std::nullopt);
}

TEST(IoOutputs, TheOneThatIsMarkedGoesLowAndTheOthersStay) {
    IoOutputs outputs = with(kPump);
    EXPECT_EQ(outputs.stop(), std::nullopt) << "after a reset all pins are inputs";
    tell(outputs, io::SetOutput{kPumpAndLamp});
    EXPECT_EQ(outputs.stop(), pins(0x0001));
    tell(outputs, io::SetOutput{0x0001});
    EXPECT_EQ(outputs.stop(), std::nullopt) << "they are low already";
}

TEST(IoOutputs, WhatWasSentAndNotAnsweredMayBeHigh) {
    IoOutputs outputs = with(kPump);
    tell(outputs, io::SetOutput{0x0001});
    outputs.onSent(io::SetOutput{kPumpAndLamp});
    EXPECT_EQ(outputs.stop(), pins(0x0001));
}

/// Stopping the heater must not switch the fan on again.
TEST(IoOutputs, WhatWasSwitchedOffAndNotAnsweredStaysOff) {
    IoOutputs outputs = with(kHeater);
    tell(outputs, io::SetPwm{100, 200});
    outputs.onSent(io::SetPwm{100, 0});
    EXPECT_EQ(outputs.stop(), IoCommand(io::SetPwm{0, 0}));
    IoOutputs pump = with(kPump);
    tell(pump, io::SetOutput{kPumpAndLamp});
    pump.onSent(io::SetOutput{0x0004});
    EXPECT_EQ(pump.stop(), pins(0));
    EXPECT_EQ(pump.levels(), std::nullopt) << "the lamp may still be on";
    tell(pump, io::SetOutput{0x0004});
    EXPECT_EQ(pump.levels(), 0x0004);
}

/// The levels are known only from the pins, as none has been set in this connection.
TEST(IoOutputs, WhatWasSwitchedOffAndNotAnsweredStaysOffUntilItIsReadBack) {
    IoOutputs outputs = with(kPump);
    outputs.forget();
    outputs.onPins(kPumpAndLamp);
    outputs.onSent(io::SetOutput{0x0004});
    EXPECT_EQ(outputs.stop(), pins(0));
    outputs.onPins(kPumpAndLamp);
    EXPECT_EQ(outputs.stop(), pins(0x0001)) << "it was not carried out";
}

TEST(IoOutputs, APwmOutputThatWasNotToChangeKeepsItsValue) {
    IoOutputs outputs = with(kHeater);
    tell(outputs, io::SetPwm{100, 200});
    outputs.onSent(io::SetPwm{150, 200});
    EXPECT_EQ(outputs.stop(), IoCommand(io::SetPwm{0, 200}));
}

TEST(IoOutputs, AreAsBeforeWhenACommandWasNotCarriedOut) {
    IoOutputs outputs = with(kHeater);
    tell(outputs, io::SetPwm{100, 200});
    const IoOutputs before = outputs;
    outputs.onSent(io::SetPwm{100, 0});
    outputs.onNotExecuted(before);
    EXPECT_EQ(outputs.stop(), IoCommand(io::SetPwm{0, 200}));
}

TEST(IoOutputs, WhatWasStoredAndNotAnsweredMayBeAnything) {
    IoOutputs outputs = with(kPump);
    tell(outputs, io::SetOutput{0});
    tell(outputs, io::SetSynchOutput{0, 0, 0});
    outputs.onSent(io::SetSynchOutput{kPumpAndLamp, 0, 0});
    EXPECT_EQ(outputs.stored(), std::nullopt);
    tell(outputs, io::SynchOutput{});
    outputs.onPins(kPumpAndLamp);
    EXPECT_EQ(outputs.stop(), pins(0x0001));
}

TEST(IoOutputs, LeftByAnotherHostItIsReadFirst) {
    IoOutputs outputs = with(kPump);
    outputs.forget();
    EXPECT_EQ(outputs.stop(), std::nullopt) << "the other outputs would change";
    outputs.onPins(0x0805);
    EXPECT_EQ(outputs.stop(), pins(0x0801));
}

TEST(IoOutputs, PwmFollowsThePins) {
    IoOutputs outputs = with({kPump.pins, kHeater.pwm});
    tell(outputs, io::SetOutput{kPumpAndLamp});
    tell(outputs, io::SetPwm{100, 50});
    tell(outputs, io::SetOutput{0x0001});
    EXPECT_EQ(outputs.stop(), IoCommand(io::SetPwm{0, 50}));
    tell(outputs, io::SetPwm{0, 50});
    EXPECT_EQ(outputs.stop(), std::nullopt);
}

TEST(IoOutputs, WhatWasStoredCountsOnceItIsPutOut) {
    IoOutputs outputs = with(kPump);
    tell(outputs, io::SetSynchOutput{kPumpAndLamp, 0, 0});
    EXPECT_EQ(outputs.stop(), std::nullopt);
    tell(outputs, io::SynchOutput{});
    EXPECT_EQ(outputs.stop(), pins(0x0001));
}

/// Another host may have stored outputs in a module that was found as it was left.
TEST(IoOutputs, WhatNobodyHereHasStoredMayBeAnything) {
    IoOutputs outputs = with(kPump);
    tell(outputs, io::SetOutput{0});
    tell(outputs, io::SynchOutput{});
    EXPECT_EQ(outputs.levels(), std::nullopt);
    EXPECT_EQ(outputs.stop(), std::nullopt) << "the lamp may be on or off";
    outputs.onPins(kPumpAndLamp);
    EXPECT_EQ(outputs.stop(), pins(0x0001)) << "outputs read back";
}

TEST(IoOutputs, AResetMakesInputsOfThem) {
    IoOutputs outputs = with(kPump);
    tell(outputs, io::SetOutput{kPumpAndLamp});
    outputs.onReset();
    EXPECT_EQ(outputs.stop(), std::nullopt);
    EXPECT_EQ(outputs.stopOutputs(), kPump);
}

}  // namespace
}  // namespace nmc::bus
