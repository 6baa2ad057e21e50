// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/status.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace nmc {
namespace {

/// A well-formed reply of any content: status byte and items at random, then their sum.
std::vector<std::uint8_t> anyReply(ModuleType type, StatusItems items) {
    auto reply = *rc::gen::container<std::vector<std::uint8_t>>(replyLength(type, items) - 1,
                                                                rc::gen::arbitrary<std::uint8_t>());
    reply.push_back(sum8(reply));
    return reply;
}

ModuleType anyType() {
    return *rc::gen::element(ModuleType::Servo, ModuleType::Step);
}

StatusItems anyItems() {
    return StatusItems(static_cast<std::uint8_t>(*rc::gen::inRange(0, 0x40)));
}

TEST(ReplyLength, IsTwoPlusTheItems) {
    // DS-V 5.2: sizes 4, 1, 2, 1, 4, 2; the minimum reply has 2 bytes (3.1).
    EXPECT_EQ(replyLength(ModuleType::Servo, StatusItems(0x00)), 2U);
    EXPECT_EQ(replyLength(ModuleType::Servo, StatusItems(0x09)),
              7U);  // the data sheet's example: bits 0 and 3
    EXPECT_EQ(replyLength(ModuleType::Servo, StatusItems(0x1F)), 14U);  // the golden reply
    EXPECT_EQ(replyLength(ModuleType::Servo, StatusItems(0x3F)), 16U);
    EXPECT_EQ(replyLength(ModuleType::Step, StatusItems(0x3F)), 16U);
    EXPECT_EQ(replyLength(ModuleType::Step, StatusItems(0x04)), 4U);
}

TEST(ReplyLength, IgnoresTheUndefinedItems) {
    EXPECT_EQ(replyLength(ModuleType::Servo, StatusItems(0xC0)), 2U);
}

TEST(DecodeStatus, ReadsEveryServoItemFromItsPlace) {
    std::vector<std::uint8_t> reply{0x09, 0x78, 0x56, 0x34, 0x92, 0x4F, 0xFD, 0xFF,
                                    0x14, 0x01, 0x00, 0x00, 0x80, 0x00, 0x04};
    reply.push_back(sum8(reply));
    const auto report = decodeStatus(ModuleType::Servo, StatusItems(0x3F), reply);
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
    const auto report = decodeStatus(ModuleType::Step, StatusItems(0x3F), reply);
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ(report->position, -1);
    EXPECT_EQ(report->timerCount, 65'452);
    EXPECT_FALSE(report->velocity.has_value());
    EXPECT_TRUE(step::InputsByte{*report->aux}.estop());
    EXPECT_TRUE(step::InputsByte{*report->aux}.homeSwitch());
    EXPECT_EQ(report->identity, (ModuleIdentity{ModuleType::Step, 1}));
    EXPECT_TRUE(report->stepStatus().moving());
}

TEST(DecodeStatus, SurvivesTheOneVelocityThatHasNoNegative) {
    std::vector<std::uint8_t> reply{0x00, 0x00, 0x80, 0x80};
    EXPECT_EQ(decodeStatus(ModuleType::Servo, StatusItems(0x04), reply)->velocity, INT16_MAX);
}

TEST(StatusBits, AreWhereTheDataSheetsPutThem) {
    const servo::StatusByte status{0b1000'0001};
    EXPECT_TRUE(status.moveDone() && status.homeInProgress());
    EXPECT_FALSE(status.checksumError() || status.overcurrent() || status.powerOn() ||
                 status.positionError() || status.limit1() || status.limit2());
    const servo::AuxByte aux{0b0010'0100};
    EXPECT_TRUE(aux.servoOn() && aux.servoOverrun());
    EXPECT_FALSE(aux.indexComplement() || aux.positionWrap() || aux.accelDone() || aux.slewDone());
    const step::StatusByte stepper{0b0100'1100};
    EXPECT_TRUE(stepper.trapezoidalMode() && stepper.powerOn() && stepper.amplifierEnabled());
    EXPECT_FALSE(stepper.moving() || stepper.velocityMode() || stepper.atSpeed() || stepper.homing());
}

RC_GTEST_PROP(DecodeStatus, HasExactlyTheItemsThatWereAskedFor, ()) {
    const ModuleType type = anyType();
    const StatusItems items = anyItems();
    const auto report = decodeStatus(type, items, anyReply(type, items));
    RC_ASSERT(report.has_value());
    RC_ASSERT(report->position.has_value() == items.has(StatusItems::Position));
    RC_ASSERT(report->analog.has_value() == items.has(StatusItems::Analog));
    RC_ASSERT((report->velocity || report->timerCount) == items.has(StatusItems::Velocity));
    RC_ASSERT(report->aux.has_value() == items.has(StatusItems::Aux));
    RC_ASSERT(report->home.has_value() == items.has(StatusItems::Home));
    RC_ASSERT(report->identity.has_value() == items.has(StatusItems::Identity));
}

TEST(DecodeStatus, RejectsEveryOneBitCorruptionOfEveryItemSet) {
    rc::check([] {
        const ModuleType type = anyType();
        const StatusItems items = anyItems();
        const auto reply = anyReply(type, items);
        for (std::size_t bit = 0; bit < reply.size() * 8; ++bit) {
            auto corrupted = reply;
            corrupted[bit / 8] = static_cast<std::uint8_t>(corrupted[bit / 8] ^ (1U << bit % 8));
            RC_ASSERT(decodeStatus(type, items, corrupted).error() == StatusError::Checksum);
        }
    });
}

RC_GTEST_PROP(DecodeStatus, RejectsEveryOtherLength, ()) {
    const ModuleType type = anyType();
    const StatusItems items = anyItems();
    auto reply = anyReply(type, items);
    reply.resize(*rc::gen::distinctFrom(rc::gen::inRange<std::size_t>(0, 20), reply.size()));
    RC_ASSERT(decodeStatus(type, items, reply).error() == StatusError::Length);
}

}  // namespace
}  // namespace nmc
