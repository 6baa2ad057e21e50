// SPDX-License-Identifier: GPL-3.0-or-later
// DS-V 4.5: the state after power-up and reset, PWM mode, motor power; 5.2 Hard Reset.
#include "tests/conformance/servocommands.h"

namespace nmc::conformance {
namespace {

using std::chrono::milliseconds;

/// A module in which everything that can be set has been set.
class PicServoPowerUp : public PicServo {
protected:
    /// Checks `statement` at address 0, once after a Hard Reset and once after the supply was off.
    template <typename F>
    void afterEitherRestart(F statement) {
        start("servo", 1);
        disturb();
        rig->command(1, 0x0F);
        rig->wait(milliseconds(10));
        statement("hard reset");
        start("servo", 1);
        disturb();
        rig->must("power-cycle 1");
        rig->wait(milliseconds(10));
        statement("power-up");
    }
    Bytes ask(unsigned items) { return rig->command(0, 0x13, {static_cast<std::uint8_t>(items)}); }

private:
    void disturb() {
        turnAway();
        servoOn({.kp = 200, .kd = 2000, .ki = 20, .il = 200, .cl = 101, .sr = 2, .db = 5});
        trapezoid(truth("position").get<int>() + 100, 2 * kOne, kOne);
        rig->must("set 1 analog 200");
        rig->wait(milliseconds(200));
        rig->must("set 1 analog 0");
        stop(kAmplifier | kMotorOff);
        load(kLoadPwm | kLoadVelocity | kLoadAcceleration, little(kOne, 4) + little(kOne, 4) + Bytes{90});
        load(kStart);
        load(kStart | kLoadPwm, {0});
        rig->wait(milliseconds(500));
        load(kLoadPwm, {90});
        command(0x0C);
        homing(0x01);
        command(0x12, {0x3F});
        command(0x21, {1, 0x01});
        const Status s = status();
        ASSERT_EQ(s.byte & (kOvercurrent | kHomeInProgress), kOvercurrent | kHomeInProgress);
        ASSERT_EQ(s.auxiliary & (kAccelerationDone | kSlewDone), kAccelerationDone | kSlewDone);
        ASSERT_NE(s.position, 0);
    }
};

INSTANTIATE_TEST_SUITE_P(, PicServoPowerUp, kPlaces, nameOf);

TEST_P(PicServoPowerUp, PowerUp1_TheMotorPositionIs0) {
    afterEitherRestart([this](const char* how) { EXPECT_EQ(longAt(ask(0x01), 1), 0) << how; });
}

TEST_P(PicServoPowerUp, PowerUp2_VelocityAndAccelerationAre0) {
    afterEitherRestart([this](const char* how) {
        gains(kGoodGains, 0);
        load(kServo | kVelocityProfile | kLoadVelocity | kStart, little(kOne, 4), 0);
        rig->waitTicks(100);
        EXPECT_EQ(number("command_velocity"), 0) << how << ", no acceleration";
    });
    afterEitherRestart([this](const char* how) {
        gains(kGoodGains, 0);
        load(kServo | kVelocityProfile | kLoadAcceleration | kStart, little(kOne, 4), 0);
        rig->waitTicks(100);
        EXPECT_EQ(number("command_velocity"), 0) << how << ", no velocity";
    });
}

TEST_P(PicServoPowerUp, PowerUp3_AllGainsAndLimitsAre0) {
    afterEitherRestart([this](const char* how) {
        const nlohmann::json gains = truth("gains");
        for (const char* name : {"kp", "kd", "ki", "il", "ol", "cl", "el", "db"})
            EXPECT_EQ(gains[name], 0) << how << ", " << name;
        // Seen from outside: the error limit of 0 does not let it move.
        stop(kAbruptly, 0);
        EXPECT_EQ(truth("servo_on"), true);
        rig->command(0, 0x57, Bytes{kHere} + position(1));
        EXPECT_EQ(truth("servo_on"), false) << how;
    });
}

TEST_P(PicServoPowerUp, PowerUp4_TheServoRateDivisorIs1) {
    afterEitherRestart([this](const char* how) { EXPECT_EQ(truth("gains")["sr"], 1) << how; });
}

TEST_P(PicServoPowerUp, PowerUp5_ThePwmValueIs0) {
    afterEitherRestart([this](const char* how) {
        EXPECT_EQ(truth("pwm"), 0) << how;
        load(kStart, {}, 0);
        EXPECT_EQ(truth("pwm"), 0) << how << ", the waiting value";
    });
}

TEST_P(PicServoPowerUp, PowerUp6_TheControllerIsInPwmMode) {
    afterEitherRestart([this](const char* how) {
        EXPECT_EQ(truth("mode"), "pwm") << how;
        EXPECT_EQ(truth("servo_on"), false) << how;
    });
}

TEST_P(PicServoPowerUp, PowerUp7_AmpEnableIsLow) {
    afterEitherRestart([this](const char* how) { EXPECT_EQ(truth("amp_enabled"), false) << how; });
}

TEST_P(PicServoPowerUp, PowerUp8_TheStatusDataAreTheStatusByteOnly) {
    afterEitherRestart([this](const char* how) { EXPECT_EQ(rig->command(0, 0x0E).size(), 2U) << how; });
}

TEST_P(PicServoPowerUp, PowerUp9_TheAddressIs00AndTheGroupFFWithoutLeader) {
    afterEitherRestart([this](const char* how) {
        EXPECT_EQ(rig->command(1, 0x0E), Bytes{}) << how;
        EXPECT_EQ(rig->command(0x81, 0x0E), Bytes{}) << how;
        EXPECT_EQ(rig->command(0xFF, 0x12, {0x20}), Bytes{}) << how << ", not a leader";
        EXPECT_EQ(rig->command(0, 0x0E).size(), 4U) << how << ", but a member";
    });
}

TEST_P(PicServoPowerUp, PowerUp10_CommunicationIsDisabledUntilAddrInIsLow) {
    start("servo,servo", 2);
    for (const bool cycle : {false, true}) {
        if (cycle)
            rig->must("power-cycle all");
        else
            rig->command(0xFF, 0x0F);
        rig->wait(milliseconds(10));
        EXPECT_EQ(rig->state(1)["listening"], true);
        EXPECT_EQ(rig->state(2)["listening"], false);
        EXPECT_EQ(rig->command(0, 0x21, {7, 0xFF}).size(), 2U);
        EXPECT_EQ(rig->state(2)["listening"], true);
    }
}

TEST_P(PicServoPowerUp, PowerUp11_TheBaudRateIs19200) {
    for (const bool cycle : {false, true}) {
        rig->command(0xFF, 0x1A, {10});
        rig->setBaud(115'200);
        EXPECT_EQ(rig->command(cycle ? 0 : 1, 0x0E).size(), 2U);
        if (cycle)
            rig->must("power-cycle 1");
        else
            rig->command(1, 0x0F);
        rig->wait(milliseconds(10));
        rig->setBaud(19'200);
        EXPECT_EQ(rig->command(0, 0x0E), (Bytes{0x19, 0x19}));
    }
}

TEST_P(PicServoPowerUp, PowerUp12_MoveDoneAndPositionErrorAreSetOvercurrentAndHomeInProgressClear) {
    afterEitherRestart([this](const char* how) {
        EXPECT_EQ(byteAt(ask(0), 0), kMoveDone | kPositionError | kPowerOn) << how;
    });
}

TEST_P(PicServoPowerUp, PowerUp13_InTheAuxiliaryByteAllFlagsAreClear) {
    afterEitherRestart([this](const char* how) { EXPECT_EQ(byteAt(ask(0x08), 1) & ~kIndexLow, 0U) << how; });
    start("servo", 1);
    wrapPosition();
    command(0x0F);
    rig->wait(milliseconds(10));
    EXPECT_EQ(byteAt(ask(0x08), 1) & kPositionWrap, 0U);
}

TEST_P(PicServo, HardReset1_RestoresThePowerUpState) {
    nlohmann::json fresh;
    const auto look = [this, &fresh] {
        fresh = rig->state();
        for (const char* name : {"time", "tick"})
            fresh.erase(name);
    };
    make("servo");
    look();
    const nlohmann::json before = fresh;
    rig->address(1);
    servoOn();
    command(0x12, {0x3F});
    command(0x18, {0x03});
    command(0x0F);
    rig->wait(milliseconds(10));
    look();
    EXPECT_EQ(fresh, before);
}

TEST_P(PicServo, HardReset2_ReturnsNoStatus) {
    EXPECT_EQ(command(0x0F), Bytes{});
    expectNoViolation();
}

TEST_P(PicServo, HardReset3_MayBeIssuedToAllModules) {
    start("servo,servo,servo", 3);
    EXPECT_EQ(rig->command(0xFF, 0x0F), Bytes{});
    for (int module = 1; module <= 3; ++module)
        EXPECT_EQ(rig->state(module)["address"], 0);
    expectNoViolation();
}

TEST_P(PicServo, PwmMode1_WhileTheServoIsOffThereIsNoProfile) {
    stop(kAmplifier);
    load(0x0F | kStart, position(500) + little(kOne, 4) + little(kOne, 4) + Bytes{60});
    rig->wait(milliseconds(500));
    EXPECT_GT(number("shaft"), 5000) << "neither the velocity nor the position that was loaded";
    EXPECT_EQ(truth("pwm"), 60);
}

TEST_P(PicServo, PwmMode2_TheValueIs0AfterLossOfPowerExcessErrorOrMotorOff) {
    const auto expectNothingLeft = [this](const char* cause) {
        EXPECT_EQ(truth("servo_on"), false) << cause;
        EXPECT_EQ(truth("pwm"), 0) << cause;
        load(kStart);
        EXPECT_EQ(truth("pwm"), 0) << cause;
    };
    const Gains gains{.kp = 200, .kd = 2000, .el = 500};
    servoOn(gains);
    load(kLoadPwm, {99});
    rig->must("set 1 power 0");
    rig->waitTicks(2);
    rig->must("set 1 power 1");
    expectNothingLeft("loss of power");
    servoOn(gains);
    load(kLoadPwm, {99});
    stopHere(5000);
    expectNothingLeft("excess error");
    servoOn(gains);
    load(kLoadPwm, {99});
    stop(kAmplifier | kMotorOff);
    expectNothingLeft("motor off");
}

TEST_P(PicServo, PwmMode3_TheOutputLimitIsIgnored) {
    gains({.ol = 10});
    pwm(80);
    EXPECT_EQ(truth("pwm"), 80);
}

TEST_P(PicServo, PwmMode4_CurrentLimitingIsStillPerformed) {
    rig->must("set 1 analog 0");
    gains({.cl = 101});
    pwm(80);
    rig->must("set 1 analog 200");
    rig->waitTicks(30);
    EXPECT_EQ(truth("pwm"), 50);
}

TEST_P(PicServo, PwmMode5_TheCommandPositionFollowsTheMotor) {
    stop(kAmplifier);
    pwm(60);
    for (int i = 0; i < 20; ++i) {
        rig->wait(milliseconds(10));
        EXPECT_EQ(number("command_position"), number("position"));
    }
    EXPECT_GT(number("position"), 1000);
}

TEST_P(PicServo, PwmMode6_EnteringPositionOrVelocityModeMakesNoJump) {
    for (const bool profile : {false, true}) {
        turnAway();
        gains(kGoodGains);
        stop(kAmplifier);
        const double shaft = number("shaft");
        const int here = truth("position");
        if (profile)
            velocity(0, kOne);
        else
            trapezoid(here, kOne, kOne);
        EXPECT_EQ(truth("servo_on"), true);
        rig->wait(milliseconds(100));
        EXPECT_NEAR(number("shaft"), shaft, 1);
        EXPECT_EQ(number("command_position"), here);
    }
}

TEST_P(PicServo, PwmMode7_TheCommandVelocityFollowsTheMotorSoThatVelocityModeGoesOnFromIt) {
    gains(kGoodGains);
    stop(kAmplifier);
    pwm(60);
    rig->wait(milliseconds(300));
    const double v = number("velocity");
    EXPECT_NEAR(v, 23.7, 0.1) << "see DefineStatus3";
    EXPECT_NEAR(number("command_velocity"), v, 1);
    velocity(0, kOne / 1024);
    // 11 bytes and at most a tick after the command: some 22 ticks of slowing down.
    EXPECT_NEAR(number("command_velocity"), v, 1.1);
    rig->waitTicks(1024);
    EXPECT_NEAR(number("command_velocity"), v - 1, 1.1);
    expectNoViolation();
}

TEST_P(PicServo, PwmMode8_ATrapezoidBeginsAtZeroVelocityAllTheSame) {
    gains(kGoodGains);
    stop(kAmplifier);
    pwm(60);
    rig->wait(milliseconds(300));
    trapezoid(1'000'000, 30 * kOne, kOne / 64);
    EXPECT_LT(number("command_velocity"), 40.0 / 64) << "what 40 ticks add";
}

TEST_P(PicServo, PwmMode9_AValueThatDrivesTheMotorOutlastsALossOfPower) {
    for (const char* chip : {"servo@1", "servo@4", "servo@5"}) {
        start(chip, 1);
        stop(kAmplifier);
        pwm(80);
        rig->must("set 1 power 0");
        rig->wait(milliseconds(500));
        EXPECT_EQ(truth("pwm"), 80) << chip;
        rig->must("set 1 power 1");
        const double shaft = number("shaft");
        rig->wait(milliseconds(500));
        EXPECT_EQ(truth("pwm"), 80) << chip;
        EXPECT_GT(number("shaft"), shaft + 5000) << chip << ", as in PwmMode1";
        rig->must("set 1 power 0");
        pwm(-60);
        rig->must("set 1 power 1");
        EXPECT_EQ(truth("pwm"), -60) << chip << ", started without power";
    }
}

TEST_P(PicServo, PowerMonitor1_TheStatusByteTellsTheMotorPower) {
    EXPECT_EQ(status().byte & kPowerOn, kPowerOn);
    rig->must("set 1 power 0");
    EXPECT_EQ(status().byte & kPowerOn, 0U);
}

TEST_P(PicServo, PowerMonitor2_LosingThePowerDisablesTheServo) {
    servoOn();
    velocity(kOne, kOne);
    rig->must("set 1 power 0");
    rig->waitTicks(2);
    EXPECT_EQ(truth("servo_on"), false);
    EXPECT_EQ(truth("mode"), "pwm");
    EXPECT_EQ(truth("pwm"), 0);
}

TEST_P(PicServo, PowerMonitor3_TheMotorDoesNotLurchWhenThePowerReturns) {
    servoOn();
    velocity(kOne, kOne);
    rig->must("set 1 power 0");
    rig->wait(milliseconds(500));
    const double shaft = number("shaft");
    rig->must("set 1 power 1");
    rig->wait(milliseconds(500));
    EXPECT_EQ(number("shaft"), shaft);
    EXPECT_EQ(truth("servo_on"), false);
}

TEST_P(PicServo, PowerMonitor4_PositionErrorIsSetToTellIt) {
    servoOn();
    EXPECT_EQ(status().byte & kPositionError, 0U);
    rig->must("set 1 power 0");
    EXPECT_EQ(status().byte & kPositionError, kPositionError);
    rig->must("set 1 power 1");
    EXPECT_EQ(status().byte & kPositionError, kPositionError);
}

}  // namespace
}  // namespace nmc::conformance
