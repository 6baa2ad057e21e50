// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/violations.h"

#include <algorithm>

#include "tests/sim/hostwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using Kind = ViolationKind;
using Kinds = std::vector<Kind>;

class Violations : public testing::Test {
protected:
    explicit Violations(const ChainOptions& options = {}) : wire("servo,servo", options) {
        wire.address(2);
        wire.gains(goodGains());
        wire.servoOn();
    }
    [[nodiscard]] bool has(Kind kind) const {
        const Kinds all = wire.violations();
        return std::find(all.begin(), all.end(), kind) != all.end();
    }
    HostWire wire;
};

TEST_F(Violations, ACommandThatCutsAReplyIsOneAndHasItsBytesAndTime) {
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now);
    wire.wait(milliseconds(5));
    wire.exchange(packet(2, 0x0E));
    ASSERT_EQ(wire.violations(), Kinds{Kind::CommandInFlight});
    const Violation& v = wire.chain.violations().entries()[0];
    EXPECT_EQ(v.module, 0) << "the module whose reply was cut";
    EXPECT_EQ(toHex(v.bytes), "AA 02 0E 10");
    EXPECT_GT(v.time, TimePoint{} + milliseconds(10));
    EXPECT_LE(v.time, wire.now);
}

TEST_F(Violations, WhoWasReadLateIsNotCalledHasty) {
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now, true);
    wire.chain.hostSends(packet(2, 0x0E), wire.now, true);
    wire.wait(milliseconds(1));
    wire.exchange(packet(2, 0x0E));
    EXPECT_EQ(wire.violations(), Kinds{}) << "it was read in time, but after commands that were not";
    wire.exchange(packet(2, 0x0E));
    wire.exchange(packet(1, 0x0E));
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now);
    wire.wait(milliseconds(5));
    wire.exchange(packet(2, 0x0E));
    EXPECT_EQ(wire.violations(), Kinds{Kind::CommandInFlight}) << "it had waited twice in between";
}

/// The simulator slept, so the host gave up waiting and repeated its command just as it was answered. It
/// takes that answer for the one to the repeated command, and sends the next while that is still being
/// answered.
TEST_F(Violations, WhoRepeatsACommandThatWasReadLateIsNotCalledHasty) {
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now, true);
    wire.wait(milliseconds(50));
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now);
    wire.wait(milliseconds(5));
    wire.chain.hostSends(packet(2, 0x0E), wire.now);
    wire.wait(milliseconds(50));
    EXPECT_EQ(wire.violations(), Kinds{});
}

TEST_F(Violations, AStopMotorMayCutAReply) {
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now);
    wire.wait(milliseconds(5));
    wire.exchange(packet(1, 0x17, {0x05}));
    EXPECT_EQ(wire.violations(), Kinds{});
}

/// A servo and a stepper, and two PIC-I/Os, of which the last is alone in group 81.
TEST_F(Violations, OnlyAStopMotorThatStopsAMotorMayCutAReply) {
    struct Early {
        unsigned address;
        unsigned command;
        Bytes data;
        bool blamed;
    };
    for (const Early& early : {
             Early{1, 0x17, {0x03}, false}, Early{1, 0x17, {0x04}, false}, Early{1, 0x17, {0x09}, false},
             Early{1, 0x57, {0x11, 0, 0, 0, 0}, false}, Early{1, 0x17, {0x01}, true},
             Early{2, 0x17, {0x04}, false}, Early{2, 0x17, {0x09}, false}, Early{2, 0x17, {0x01}, true},
             Early{2, 0x17, {0x03}, true},  // a stepper has no use for bit 1
             Early{3, 0x47, {0x1E, 0, 0, 0}, true}, Early{0xFF, 0x17, {0x05}, false},
             Early{0xFF, 0x17, {0x03}, false}, Early{0xFF, 0x17, {0x01}, true},
             Early{0x81, 0x47, {0x1E, 0, 0, 0}, true},
             Early{9, 0x17, {0x05}, false},  // to a module that has restarted, perhaps
         }) {
        HostWire all("servo,step,io,io");
        all.address(4);
        all.command(4, 0x21, {4, 0x81});
        all.chain.hostSends(packet(1, 0x13, {0x1F}), all.now);
        all.wait(milliseconds(5));
        all.exchange(packet(early.address, early.command, early.data));
        const Kinds kinds = all.violations();
        EXPECT_EQ(std::ranges::count(kinds, Kind::CommandInFlight), early.blamed ? 1 : 0)
            << toHex(packet(early.address, early.command, early.data));
    }
}

TEST_F(Violations, NullsGarbageAndAWrongSumAreNone) {
    wire.chain.hostSends(packet(1, 0x13, {0x1F}), wire.now);
    wire.wait(milliseconds(5));
    wire.exchange(Bytes(16, 0));
    wire.wait(milliseconds(5));
    Bytes wrong = packet(1, 0x0E);
    wrong.back() ^= 1;
    wire.exchange(wrong);
    wire.exchange({1, 2, 3, 0xAA, 0xAA, 0xAA, 0xAA});
    wire.exchange(Bytes(16, 0));
    EXPECT_EQ(wire.violations(), Kinds{});
}

TEST_F(Violations, ACommandBehindAnUnansweredGroupCommandWithoutAPauseIsOne) {
    wire.command(0xFF, 0x1A, {10});
    wire.chain.setHostBaud(115'200);
    ASSERT_EQ(wire.violations(), Kinds{});
    Bytes two = packet(0xFF, 0x0C);
    for (const std::uint8_t byte : packet(0xFF, 0x0E))
        two.push_back(byte);
    wire.exchange(two);
    // At 115 200 Bd a command takes 347 us, less than a tick: it may or may not overwrite the first.
    ASSERT_FALSE(wire.violations().empty());
    EXPECT_TRUE(has(Kind::CommandInFlight));
}

TEST_F(Violations, WaitingHalfAMillisecondBehindAGroupCommandIsEnough) {
    for (int i = 0; i < 100; ++i) {
        wire.chain.hostSends(packet(0xFF, 0x0C), wire.now);
        wire.wait(std::chrono::nanoseconds(4 * 520'833) + std::chrono::microseconds(510 + 3 * i));
    }
    wire.wait(milliseconds(5));
    EXPECT_EQ(wire.violations(), Kinds{});
    EXPECT_EQ(wire.chain.statistics().modules[0].executions(CommandCode::SaveAsHome), 100U);
}

class Overwriting : public Violations {
protected:
    using Violations::Violations;
    /// Sends two commands at once, up to twenty times, until this is a violation. At half the servo rate, 250
    /// kBd is not a violation; a command takes 160 us of a tick of 512.
    void sendTwo(bool late, const Bytes& second = packet(1, 0x0E)) {
        wire.gains(gainData(0, 0, 0, 0, 0, 0, 0, 2, 0), 0xFF);
        wire.command(0xFF, 0x1A, {4});
        wire.chain.setHostBaud(250'000);
        for (int i = 0; i < 20 && wire.violations().empty(); ++i) {
            Bytes two = packet(1, 0x12, {0x20});
            two.insert(two.end(), second.begin(), second.end());
            wire.chain.hostSends(two, wire.now, late);
            wire.wait(std::chrono::microseconds(2'100));
        }
    }
};

TEST_F(Overwriting, ASecondCommandBeforeTheFirstIsExecutedOverwritesIt) {
    sendTwo(false);
    EXPECT_TRUE(has(Kind::CommandOverwritten));
    EXPECT_EQ(wire.command(1, 0x0E).size(), 2U) << "Define Status was lost";
}

/// DS-V 4.1: after one tick, it may cut a reply short.
TEST_F(Overwriting, AStopThatIsTooEarlyOverwritesItToo) {
    sendTwo(false, packet(1, 0x17, {0x05}));
    EXPECT_TRUE(has(Kind::CommandOverwritten));
}

class OverwritingAtATerminal : public Overwriting {
protected:
    OverwritingAtATerminal() : Overwriting(ChainOptions{.hostHasOwnClock = true}) {}
};

TEST_F(OverwritingAtATerminal, AStopIsNotBlamedForIt) {
    sendTwo(false, packet(1, 0x17, {0x05}));
    EXPECT_EQ(wire.violations(), Kinds{});
}

TEST_F(OverwritingAtATerminal, ACommandThatMustWaitForTheAnswerIs) {
    sendTwo(false);
    EXPECT_TRUE(has(Kind::CommandOverwritten));
}

TEST_F(OverwritingAtATerminal, AStopMotorThatOnlySetsTheAmplifierIsToo) {
    sendTwo(false, packet(1, 0x17, {0x01}));
    EXPECT_TRUE(has(Kind::CommandOverwritten));
}

TEST_F(Overwriting, WhoWasReadLateIsNotBlamedForIt) {
    sendTwo(true);
    EXPECT_EQ(wire.violations(), Kinds{});
}

TEST_F(Violations, ARateThatTheChipDoesNotKeepUpWithIsOne) {
    const auto kindsAt = [](const char* chip, std::uint8_t divisor, bool slowServo = false) {
        HostWire one(chip);
        if (slowServo)
            one.gains(gainData(0, 0, 0, 0, 0, 0, 0, 2, 0), 0);
        one.command(0xFF, 0x1A, {divisor});
        return one.violations();
    };
    // DS-V 3.1, DS-S 3.1: up to 115 200 Bd, divisor 10.
    for (const char* chip :
         {"servo@1", "servo@2", "servo@3", "servo@4", "servo@5", "servo@10", "step", "io"}) {
        EXPECT_EQ(kindsAt(chip, 10), Kinds{}) << chip;
        EXPECT_EQ(kindsAt(chip, 4), Kinds{Kind::OutOfRange}) << chip;
        EXPECT_EQ(kindsAt(chip, 5), chip == std::string("servo@10") ? Kinds{} : Kinds{Kind::OutOfRange})
            << chip;
    }
    EXPECT_EQ(kindsAt("servo@4", 5, true), Kinds{}) << "DS-V 3.1: faster at lower servo rates";
}

/// DS-V 5.2: bits 2 and 3 of Stop Motor set the goal velocity to zero, here while a load waits.
TEST_F(Violations, AProfileWhoseVelocityAStopHasZeroedIsOne) {
    for (const std::uint8_t stop : {std::uint8_t{0x05}, std::uint8_t{0x09}}) {
        for (const unsigned profile : {0x10U, 0x30U}) {
            HostWire one;
            one.address(1);
            one.gains(goodGains());
            Bytes load{static_cast<std::uint8_t>(profile | 0x07)};
            for (const std::uint32_t value : {1000U, kOne, kOne})
                append(load, value, 4);
            one.command(1, 0xD4, load);
            one.command(1, 0x17, {stop});
            one.command(1, 0x05);
            one.waitTicks(50);
            EXPECT_EQ(one.truth().servo.commandPosition, 0);
            EXPECT_EQ(one.violations(), Kinds{Kind::VelocityNotLoaded});
            one.command(1, 0x17, {stop});
            one.command(1, 0xD4, load);
            one.command(1, 0x05);
            one.waitTicks(50);
            EXPECT_GT(one.truth().servo.commandPosition, 40) << "loaded again";
            EXPECT_EQ(one.violations().size(), 1U);
        }
    }
}

TEST_F(Violations, AVelocityOf0ThatWasLoadedIsNone) {
    wire.velocity(kOne, kOne);
    wire.velocity(0, kOne);
    EXPECT_EQ(wire.violations(), Kinds{});
}

/// DS-V 5.2 says it of bits 2 and 3 only, and these versions keep the velocity (docs/family.md).
TEST_F(Violations, AVelocityThatAStopHasKeptIsNone) {
    wire.velocity(kOne, kOne);
    wire.enableAmplifier();
    wire.waitTicks(200);
    wire.command(1, 0x14, {0xB0});
    for (const char* chip : {"servo@5", "servo@10"}) {
        HostWire one(chip);
        one.address(1);
        one.gains(goodGains());
        one.velocity(kOne, kOne);
        one.servoOn();
        one.command(1, 0x14, {0xB0});
        EXPECT_EQ(one.truth().servo.commandVelocity, 1.0) << chip;
        EXPECT_EQ(one.violations(), Kinds{}) << chip;
    }
    EXPECT_EQ(wire.violations(), Kinds{});
}

TEST_F(Violations, TwoLeadersOfAGroupAreReportedWhenTheyAnswerTogether) {
    wire.command(1, 0x21, {1, 0x01});
    wire.command(2, 0x21, {2, 0x01});
    wire.command(0x81, 0x0E);
    EXPECT_EQ(wire.violations(), (Kinds{Kind::ReplyCollision, Kind::ReplyCollision}));
}

TEST_F(Violations, WrongLengthsAreReported) {
    wire.command(1, 0x1E, {0});                 // No Operation with data
    wire.command(1, 0x07);                      // Stop Motor without its control byte
    wire.command(1, 0x17, {0x11});              // stop here without a position
    wire.command(1, 0x57, {0x05, 0, 0, 0, 0});  // a position without stop here
    wire.command(1, 0x24, {0x11, 1});           // a trajectory shorter than its control byte announces
    wire.command(1, 0xC6, Bytes(12, 1));        // Set Gain of 12
    EXPECT_EQ(wire.violations(), Kinds(6, Kind::WrongLength));
}

// DS-V 5.2, Stop Motor: 1 data byte, or 5 with bit 4; Reset Position of an SC: 1, or 5 with bit 1
// (docs/family.md).
TEST_F(Violations, AnythingBetweenTheTwoLengthsOfACommandIsReported) {
    const auto kindsOf = [](const char* chip, unsigned code, std::uint8_t control, std::size_t length) {
        HostWire one(chip);
        one.address(1);
        Bytes data(length);
        data[0] = control;
        one.command(1, static_cast<unsigned>(length) << 4U | code, data);
        return one.violations();
    };
    for (std::size_t length = 1; length <= 5; ++length) {
        const Kinds ofShort = length == 1 ? Kinds{} : Kinds{Kind::WrongLength};
        const Kinds ofLong = length == 5 ? Kinds{} : Kinds{Kind::WrongLength};
        for (const char* chip : {"servo@4", "servo@10"}) {
            EXPECT_EQ(kindsOf(chip, 7, 0x01, length), ofShort) << chip << ' ' << length;
            EXPECT_EQ(kindsOf(chip, 7, 0x11, length), ofLong) << chip << ' ' << length;
        }
        EXPECT_EQ(kindsOf("servo@10", 0, 0x01, length), ofShort) << length;
        EXPECT_EQ(kindsOf("servo@10", 0, 0x02, length), ofLong) << length;
    }
}

TEST_F(Violations, OutOfRangeValuesAreReported) {
    wire.gains(gainData(0x8000, 0, 0, 0, 0, 0, 0, 1, 0));
    wire.gains(gainData(0, 0, 0, 0, 0, 0, 0x4000, 1, 0));
    wire.gains(gainData(0, 0, 0, 0, 0, 0, 0, 0, 0));
    wire.command(1, 0x54, {0x02, 0, 0, 0, 0x80});
    EXPECT_EQ(wire.violations(), Kinds(4, Kind::OutOfRange));
}

TEST_F(Violations, MoreThanOneMannerOfStoppingIsReported) {
    wire.command(1, 0x17, {0x0D});
    wire.command(1, 0x19, {0x31});
    EXPECT_EQ(wire.violations(), (Kinds{Kind::StopBits, Kind::StopBits}));
    EXPECT_TRUE(wire.chain.violations().remarks().empty());
}

// DS-V 5.2: with bit 1 the bits 2 to 4 are ignored.
TEST_F(Violations, MotorOffWithAnotherMannerOfStoppingIsARemarkOnly) {
    wire.exchange({0xAA, 0x01, 0x17, 0x06, 0x1E});
    EXPECT_FALSE(wire.truth().servo.servoOn);
    EXPECT_EQ(wire.violations(), Kinds{});
    ASSERT_EQ(wire.chain.violations().remarks().size(), 1U);
    const Violation& remark = wire.chain.violations().remarks()[0];
    EXPECT_EQ(remark.kind, Kind::StopBits);
    EXPECT_EQ(toHex(remark.bytes), "AA 01 17 06 1E");
    wire.chain.clearStatistics(wire.now);
    EXPECT_TRUE(wire.chain.violations().remarks().empty());
}

TEST_F(Violations, ResetPositionDuringATrapezoidOfAnScIsNone) {
    for (const char* chip : {"servo@4", "servo@5", "servo@10"}) {
        HostWire one(chip);
        one.address(1);
        one.gains(goodGains());
        one.servoOn();
        one.trapezoid(1000, kOne, kOne);
        one.command(1, 0x00);
        EXPECT_EQ(one.violations(), chip == std::string("servo@10") ? Kinds{} : Kinds{Kind::ResetInMotion})
            << chip;
    }
}

/// A command with reserved bits in its first data byte, which the data sheet requires to be clear; `data` has
/// other bits set that go together.
struct Form {
    unsigned command;
    Bytes data;
    unsigned reserved;
};

/// Adds each bit of the first data byte, one at a time: only the reserved ones are reported.
void expectReservedBits(std::string_view chip, const std::vector<Form>& forms) {
    for (const Form& form : forms)
        for (unsigned bit = 0; bit < 8; ++bit) {
            HostWire wire{chip};
            wire.address(1);
            Bytes data = form.data;
            data[0] = static_cast<std::uint8_t>(data[0] | 1U << bit);
            wire.command(1, form.command, data);
            const Kinds all = wire.violations();
            EXPECT_EQ(std::ranges::count(all, Kind::ReservedBits), form.reserved >> bit & 1U)
                << chip << " command " << form.command << " bit " << bit;
        }
}

// DS-V 5.2. Set Homing Mode's bits 2, 4 and 5 are "don't care" on versions 1 and 2.
TEST(ReservedBits, OfAServoAreReported) {
    for (const char* chip : {"servo@1", "servo@2", "servo@3", "servo@4"})
        expectReservedBits(chip, {{0x12, {0}, 0xC0},
                                  {0x13, {0x1F}, 0xC0},
                                  {0x17, {0x01}, 0xE0},
                                  {0x18, {0x0C}, 0xF0},
                                  {0x19, {0x00}, 0x00},
                                  {0x94, {0x36, 0, 0, 1, 0, 0, 1, 0, 0}, 0x00}});
}

// DS-S 5.1. Stop Motor's bit 1 is "not used" and nothing more; those of Set Parameters are "ignored".
TEST(ReservedBits, OfAStepperAreReported) {
    expectReservedBits("step", {{0x12, {0}, 0xC0},
                                {0x13, {0x1F}, 0xC0},
                                {0x34, {0x06, 10, 10}, 0x60},
                                {0x56, {0x03, 1, 0, 0, 0}, 0x00},
                                {0x17, {0x01}, 0xF0},
                                {0x18, {0x1F}, 0xE0},
                                {0x19, {0x00}, 0xC0}});
}

TEST_F(Violations, OutputsMadeByAReservedBitAreReported) {
    wire.exchange({0xAA, 0x01, 0x18, 0x10, 0x29});
    EXPECT_EQ(wire.violations(), Kinds{Kind::ReservedBits}) << "and both limit pins are outputs";
    wire.exchange({0xAA, 0x01, 0x18, 0x0C, 0x25});
    wire.command(1, 0x0E);  // without data: bytes left over from earlier packets are not reported
    EXPECT_EQ(wire.violations().size(), 1U);
}

TEST(ViolationLog, IsBoundedAndGoesOnCounting) {
    ViolationLog log;
    for (std::size_t i = 0; i < ViolationLog::kCapacity + 5; ++i)
        log.add({TimePoint{}, 0, Kind::StopBits, {}});
    EXPECT_EQ(log.entries().size(), 10'000U);
    EXPECT_EQ(log.count(), 10'005U);
}

}  // namespace
}  // namespace nmc::sim::test
