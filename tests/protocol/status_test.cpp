// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/status.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/modules.h"

namespace nmc {
namespace {

using testing_support::kCmc;
using testing_support::kIo;
using testing_support::kSc;
using testing_support::kServo;
using testing_support::kStep;

/// A well-formed reply with arbitrary content: a random status byte and items, then their sum.
std::vector<std::uint8_t> anyReply(const ModuleIdentity& module, StatusItems items) {
    auto reply = *rc::gen::container<std::vector<std::uint8_t>>(replyLength(module, items) - 1,
                                                                rc::gen::arbitrary<std::uint8_t>());
    reply.push_back(sum8(reply));
    return reply;
}

ModuleIdentity anyModule() {
    return *rc::gen::element(kServo, kCmc, kSc, kStep, kIo);
}

StatusItems anyItems(const ModuleIdentity& module) {
    return StatusItems(
        static_cast<std::uint8_t>(*rc::gen::inRange(0U, 0x100U) & unsigned{allItems(module).mask()}));
}

TEST(ReplyLength, IsTwoPlusTheItems) {
    // DS-V 5.2: sizes 4, 1, 2, 1, 4, 2; the minimum reply has 2 bytes (3.1).
    EXPECT_EQ(replyLength(kServo, StatusItems(0x00)), 2U);
    EXPECT_EQ(replyLength(kServo, StatusItems(0x09)),
              7U);                                           // the data sheet's example: bits 0 and 3
    EXPECT_EQ(replyLength(kServo, StatusItems(0x1F)), 14U);  // the golden reply
    EXPECT_EQ(replyLength(kServo, StatusItems(0x3F)), 16U);
    EXPECT_EQ(replyLength(kStep, StatusItems(0x3F)), 16U);
    EXPECT_EQ(replyLength(kStep, StatusItems(0x04)), 4U);
}

TEST(ReplyLength, IsNineteenForEverythingOfALaterModule) {
    // 1 + 4 + 1 + 2 + 1 + 4 + 2 + 2 + 1 + 1, and 1 + 2 + 3 + 4 + 2 + 2 + 4 + 1.
    EXPECT_EQ(replyLength(kCmc, StatusItems(0xFF)), 19U);
    EXPECT_EQ(replyLength(kSc, StatusItems(0xFF)), 19U);
    EXPECT_EQ(replyLength(kIo, StatusItems(0xFF)), 19U);
    EXPECT_EQ(replyLength(kSc, StatusItems(0x41)), 8U);   // position and its error
    EXPECT_EQ(replyLength(kIo, StatusItems(0x1F)), 11U);  // the items that centrifuge programs read
    EXPECT_EQ(kMaxReply, 19U);
}

TEST(ReplyLength, IgnoresTheUndefinedItems) {
    EXPECT_EQ(replyLength(kServo, StatusItems(0xC0)), 2U);
}

TEST(DecodeStatus, ReadsEveryServoItemFromItsPlace) {
    std::vector<std::uint8_t> reply{0x09, 0x78, 0x56, 0x34, 0x92, 0x4F, 0xFD, 0xFF,
                                    0x14, 0x01, 0x00, 0x00, 0x80, 0x00, 0x04};
    reply.push_back(sum8(reply));
    const auto report = decodeStatus(kServo, StatusItems(0x3F), reply);
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ(report->position, static_cast<std::int32_t>(0x92345678));
    EXPECT_EQ(report->analog, 0x4F);
    EXPECT_EQ(report->velocity, 3);  // the wire carries -3, the negative of the velocity
    EXPECT_EQ(report->aux, 0x14);
    EXPECT_EQ(report->home, INT32_MIN + 1);
    EXPECT_EQ(report->identity, (ModuleIdentity{ModuleType::Servo, 4}));
}

TEST(DecodeStatus, ReadsTheStepItemsFromTheirPlaces) {
    std::vector<std::uint8_t> reply{0x0D, 0xFF, 0xFF, 0xFF, 0xFF, 0x80, 0xAC, 0xFF,
                                    0x21, 3,    0,    0,    0,    0x03, 0x01};
    reply.push_back(sum8(reply));
    const auto report = decodeStatus(kStep, StatusItems(0x3F), reply);
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ(report->position, -1);
    EXPECT_EQ(report->timerCount, 65'452);
    EXPECT_FALSE(report->velocity.has_value());
    EXPECT_TRUE(stepper::InputsByte{*report->aux}.estop());
    EXPECT_TRUE(stepper::InputsByte{*report->aux}.homeSwitch());
    EXPECT_EQ(report->identity, (ModuleIdentity{ModuleType::Stepper, 1}));
    EXPECT_TRUE(report->stepperStatus().moving());
}

TEST(DecodeStatus, ReadsEveryItemOfThePicIoFromItsPlace) {
    // IO1, IO8 and IO10; A/D 1, 2, 3; counter 0x01020304; type 2, version 1; latched IO12; 0xFFFFFFFF.
    std::vector<std::uint8_t> reply{0x00, 0x81, 0x02, 1, 2,    3,    4,    3,    2,
                                    1,    2,    1,    0, 0x08, 0xFF, 0xFF, 0xFF, 0xFF};
    reply.push_back(sum8(reply));
    const auto report = decodeStatus(kIo, StatusItems(0xFF), reply);
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ(report->pins, 0x0281);
    EXPECT_EQ(report->analogs[0], 1);
    EXPECT_EQ(report->analogs[1], 2);
    EXPECT_EQ(report->analogs[2], 3);
    EXPECT_EQ(report->counter, 0x01020304U);
    EXPECT_EQ(report->identity, kIo);
    EXPECT_EQ(report->latchedPins, 0x0800);
    EXPECT_EQ(report->latchedCounter, 0xFFFFFFFFU);
    EXPECT_FALSE(report->position || report->analog || report->aux || report->home);
    EXPECT_FALSE(report->commandRefused());
}

TEST(DecodeStatus, DoesNotNegateTheVelocityOfALaterServo) {
    std::vector<std::uint8_t> reply{0x00, 0xFD, 0xFF, 0xFC};
    EXPECT_EQ(decodeStatus(kServo, StatusItems(0x04), reply)->velocity, 3);
    EXPECT_EQ(decodeStatus(kCmc, StatusItems(0x04), reply)->velocity, -3);
    EXPECT_EQ(decodeStatus(kSc, StatusItems(0x04), reply)->velocity, -3);
}

TEST(DecodeStatus, SurvivesTheOneVelocityThatHasNoNegative) {
    std::vector<std::uint8_t> reply{0x00, 0x00, 0x80, 0x80};
    EXPECT_EQ(decodeStatus(kServo, StatusItems(0x04), reply)->velocity, INT16_MAX);
}

TEST(StatusBits, AreWhereTheDataSheetsPutThem) {
    const servo::StatusByte status{0b1000'0001};
    EXPECT_TRUE(status.moveDone() && status.homeInProgress());
    EXPECT_FALSE(status.overcurrent() || status.powerOn() || status.positionError() || status.limit1() ||
                 status.limit2());
    const servo::AuxByte aux{0b0010'0100};
    EXPECT_TRUE(aux.servoOn() && aux.servoOverrun());
    EXPECT_FALSE(aux.indexComplement() || aux.positionWrap() || aux.accelDone() || aux.slewDone());
    // An SC accelerating, the index high; at constant speed; slowing down, the index low.
    EXPECT_EQ(servo::toAuxByte(0b0100'1101), servo::AuxByte{0b0100'0100});
    EXPECT_EQ(servo::toAuxByte(0b0001'0101), servo::AuxByte{0b0000'1100});
    EXPECT_EQ(servo::toAuxByte(0b0110'0110), servo::AuxByte{0b0111'1111});
    const stepper::StatusByte stepper{0b0100'1100};
    EXPECT_TRUE(stepper.trapezoidalMode() && stepper.powerOn() && stepper.amplifierEnabled());
    EXPECT_FALSE(stepper.moving() || stepper.velocityMode() || stepper.atSpeed() || stepper.homing());
}

RC_GTEST_PROP(DecodeStatus, HasExactlyTheItemsThatWereAskedFor, ()) {
    const ModuleIdentity module = anyModule();
    const StatusItems items = anyItems(module);
    const auto report = decodeStatus(module, items, anyReply(module, items));
    RC_ASSERT(report.has_value());
    RC_ASSERT(report->identity.has_value() == items.has(StatusItems::Identity));
    if (module.type == ModuleType::Io) {
        RC_ASSERT(report->pins.has_value() == items.has(StatusItems::Pins));
        RC_ASSERT(report->analogs[0].has_value() == items.has(StatusItems::Analog1));
        RC_ASSERT(report->analogs[1].has_value() == items.has(StatusItems::Analog2));
        RC_ASSERT(report->analogs[2].has_value() == items.has(StatusItems::Analog3));
        RC_ASSERT(report->counter.has_value() == items.has(StatusItems::Counter));
        RC_ASSERT(report->latchedPins.has_value() == items.has(StatusItems::LatchedPins));
        RC_ASSERT(report->latchedCounter.has_value() == items.has(StatusItems::LatchedCounter));
        return;
    }
    RC_ASSERT(report->position.has_value() == items.has(StatusItems::Position));
    RC_ASSERT(report->analog.has_value() == items.has(StatusItems::Analog));
    RC_ASSERT((report->velocity || report->timerCount) == items.has(StatusItems::Velocity));
    RC_ASSERT(report->aux.has_value() == items.has(StatusItems::Aux));
    RC_ASSERT(report->home.has_value() == items.has(StatusItems::Home));
    RC_ASSERT(report->positionError.has_value() == items.has(StatusItems::PositionError));
    RC_ASSERT(report->pathPoints.has_value() == items.has(StatusItems::PathPoints));
}

TEST(DecodeStatus, RejectsEveryOneBitCorruptionOfEveryItemSet) {
    rc::check([] {
        const ModuleIdentity module = anyModule();
        const StatusItems items = anyItems(module);
        const auto reply = anyReply(module, items);
        for (std::size_t bit = 0; bit < reply.size() * 8; ++bit) {
            auto corrupted = reply;
            corrupted[bit / 8] = static_cast<std::uint8_t>(corrupted[bit / 8] ^ (1U << bit % 8));
            RC_ASSERT(!decodeStatus(module, items, corrupted));
        }
    });
}

RC_GTEST_PROP(DecodeStatus, RejectsEveryOtherLength, ()) {
    const ModuleIdentity module = anyModule();
    const StatusItems items = anyItems(module);
    auto reply = anyReply(module, items);
    reply.resize(*rc::gen::distinctFrom(rc::gen::inRange<std::size_t>(0, 20), reply.size()));
    RC_ASSERT(!decodeStatus(module, items, reply));
}

}  // namespace
}  // namespace nmc
