// SPDX-License-Identifier: GPL-3.0-or-later
// The last position of an axis is offered to a module that has forgotten it. Expected values are calculated
// by hand.
#include "model/machinefile/positionfile.h"

#include <gtest/gtest.h>

#include "servofixture.h"
#include "tests/support/modules.h"

namespace nmc {
namespace {

using namespace testing_support;

constexpr std::int64_t kMonday = 1'700'000'000;

/// A servo at a port, followed from one session to the next.
struct Axis {
    PositionMemory memory;
    LinkState link;
    double time = 1.0;

    Axis() { link.phase = LinkPhase::Connected; }
    ModuleState& module() { return link.modules.front(); }
    void find(bool attached) {
        link.modules = {servoModule()};
        memory.found({link.modules.front().info}, attached);
    }
    void says(std::int32_t position, int status = kMoveDone | kPower) {
        module().apply(sampleOf(time += 0.05, static_cast<std::uint8_t>(status), kServoOn, position));
    }
    /// Passes each offer on to the home of its module, as the program does.
    std::vector<PositionMemory::Offer> look(std::int64_t now = kMonday) {
        auto offers = memory.look(link, now);
        for (const PositionMemory::Offer& offer : offers)
            module().home.offer(offer.home);
        return offers;
    }
    /// Home was found at 300 and the axis is 700 before it, unless other values are given.
    void wasLeft(std::int32_t counter = -400, std::int32_t home = 300) {
        find(false);
        says(counter);
        (void)look();
        module().home.found(home, atSeconds(time));
        says(counter);
        (void)look();
    }
    /// Begins another session at the same port.
    void another() {
        const RememberedChain kept = readRemembered(writeRemembered({"press", memory.remembered()}));
        memory = {};
        memory.begin(kept.positions);
    }
    /// Begins another session, in which the module has restarted and reports 0.
    void restarted() {
        another();
        find(false);
        says(0);
    }
};

TEST(PositionMemory, KnowsNothingOfAnAxisWithoutAHome) {
    Axis axis;
    axis.find(false);
    axis.says(500);
    EXPECT_TRUE(axis.look().empty());
    EXPECT_TRUE(axis.memory.remembered().empty());
}

TEST(PositionMemory, AModuleThatRestartedHasItsHomeOnTheOtherSideOfZero) {
    Axis axis;
    axis.wasLeft();  // 700 before home
    axis.another();
    axis.find(false);
    EXPECT_TRUE(axis.look().empty()) << "it has not reported its status yet";
    axis.says(0);
    const auto offers = axis.look(kMonday + 60);
    ASSERT_EQ(offers.size(), 1U);
    EXPECT_EQ(offers[0].module, kFirst);
    EXPECT_EQ(offers[0].home, 700) << "0 is 700 before home";
    EXPECT_EQ(offers[0].remembered.fromHome, -700);
    EXPECT_EQ(offers[0].remembered.seen, kMonday);
    EXPECT_EQ(offers[0].remembered.source, HomeFact::Source::Search);
    EXPECT_FALSE(axis.module().home.place()) << "not applied by itself";
    EXPECT_TRUE(axis.look().empty()) << "it is offered only once";
}

/// This has happened: a servo reports the end of its motion 3 counts before its goal, and that was remembered
/// for good.
TEST(PositionMemory, AServoIsRememberedWhereItHasSettled) {
    Axis axis;
    axis.wasLeft();
    axis.says(1'000, kPower);
    (void)axis.look();
    axis.says(1'997);
    (void)axis.look(kMonday + 10);
    axis.says(2'000);
    (void)axis.look(kMonday + 10);
    EXPECT_EQ(axis.memory.remembered().at(kFirst).counter, 1'997);
    (void)axis.look(kMonday + 12);
    EXPECT_EQ(axis.memory.remembered().at(kFirst).counter, 2'000);
    EXPECT_EQ(axis.memory.remembered().at(kFirst).fromHome, 1'700) << "home is at 300";
    EXPECT_EQ(axis.memory.remembered().at(kFirst).seen, kMonday + 12);
    axis.says(2'001);
    (void)axis.look(kMonday + 20);
    EXPECT_EQ(axis.memory.remembered().at(kFirst).counter, 2'000) << "it hunts";
}

TEST(PositionMemory, WhatIsTakenIsNotVerifiedUntilItIsFoundAgain) {
    Axis axis;
    axis.wasLeft();
    axis.restarted();
    (void)axis.look();
    axis.module().home.takeOffer(atSeconds(axis.time));
    ASSERT_TRUE(axis.module().home.place());
    EXPECT_EQ(axis.module().home.place()->counts, 700);
    EXPECT_FALSE(axis.module().home.place()->verified());
    EXPECT_FALSE(axis.module().home.offered());
    axis.module().home.found(690, atSeconds(axis.time));
    EXPECT_TRUE(axis.module().home.place()->verified());
}

TEST(PositionMemory, AnOfferThatNobodyTakesGoesAlongWithTheMotor) {
    Axis axis;
    axis.wasLeft();
    axis.restarted();
    (void)axis.look();
    axis.says(250);
    (void)axis.look(kMonday + 100);
    axis.restarted();
    const auto offers = axis.look();
    ASSERT_EQ(offers.size(), 1U);
    EXPECT_EQ(offers[0].home, 450) << "it was 450 before home";
    EXPECT_EQ(offers[0].remembered.seen, kMonday + 100);
}

TEST(PositionMemory, OneThatMovedWhenItWasSeenLastIsNotOffered) {
    Axis axis;
    axis.wasLeft();
    axis.module().apply(executedAt(axis.time += 0.05, velocityMode(65'536, 100)));
    axis.says(-300, kPower);
    (void)axis.look();
    ASSERT_TRUE(axis.memory.remembered().at(kFirst).moving);
    axis.restarted();
    EXPECT_TRUE(axis.look().empty());
    axis.says(0);
    (void)axis.look();
    EXPECT_TRUE(axis.memory.remembered().empty()) << "it is not offered later either";
}

TEST(PositionMemory, AnotherModuleAtThatPlaceGetsNothing) {
    Axis axis;
    axis.wasLeft();
    axis.another();
    axis.link.modules = {servoModule(1)};
    axis.memory.found({axis.module().info}, false);
    axis.says(0);
    EXPECT_TRUE(axis.look().empty());
}

TEST(PositionMemory, ACounterThatGoesOnHasToStandWhereItStood) {
    for (const std::int32_t counter : {-400, -402, -500}) {
        Axis axis;
        axis.wasLeft();
        axis.another();
        axis.find(true);
        axis.says(counter);
        const auto offers = axis.look();
        EXPECT_EQ(offers.size(), counter == -500 ? 0U : 1U) << counter;
        for (const PositionMemory::Offer& offer : offers)
            EXPECT_EQ(offer.home, 300) << "home is where it was, since the chip has kept its count";
    }
}

TEST(PositionMemory, ZeroHereTakesTheOfferAlong) {
    Axis axis;
    axis.wasLeft();
    axis.restarted();
    (void)axis.look();
    axis.says(100);
    axis.says(100);
    axis.module().apply(executedAt(axis.time += 0.005, ResetPosition{}));
    EXPECT_EQ(axis.module().home.offered(), 600);
}

TEST(PositionMemory, AJumpOfTheCounterWithdrawsIt) {
    Axis axis;
    axis.wasLeft();
    axis.restarted();
    (void)axis.look();
    bus::Sample jump = sampleOf(axis.time += 0.05, kMoveDone | kPower, kServoOn, 5'000);
    jump.jumped = true;
    axis.module().apply(jump);
    EXPECT_FALSE(axis.module().home.offered());
    (void)axis.look();
    EXPECT_TRUE(axis.memory.remembered().empty());
}

TEST(PositionMemory, OneThatRestartsInTheMiddleOfASessionIsOfferedWhereItWas) {
    Axis axis;
    axis.wasLeft();
    axis.module().restarted();
    axis.module().silent = true;
    (void)axis.look();
    axis.link.modules = {servoModule()};
    axis.memory.restarted(kFirst);
    axis.says(0);
    const auto offers = axis.look();
    ASSERT_EQ(offers.size(), 1U);
    EXPECT_EQ(offers[0].home, 700);
}

TEST(PositionMemory, AFileThatIsNoneOfOursIsNothing) {
    Axis axis;
    axis.wasLeft();
    const RememberedChain chain{"press", axis.memory.remembered()};
    const RememberedChain nothing;
    const std::string whole = writeRemembered(chain);
    EXPECT_EQ(readRemembered(whole), chain);
    for (const char* text :
         {"", "[]", "{\"machine\": \"\", \"positions\": 3}", "{\"machine\": \"\", \"positions\": [3]}",
          "{\"machine\": 3, \"positions\": []}", "{\"positions\": []}",
          "{\"machine\": \"\", \"positions\": [{\"module\": 1}]}", "\xff\xfe"})
        EXPECT_EQ(readRemembered(text), nothing) << text;
    for (std::size_t length = 0; length + 2 < whole.size(); ++length)
        EXPECT_EQ(readRemembered(std::string_view(whole).substr(0, length)), nothing) << length;
    std::string far = whole;
    far.replace(far.find("-700"), 4, "9999999999");
    EXPECT_EQ(readRemembered(far), nothing);
}

TEST(PositionMemory, ReadsAFileThatAnEarlierVersionHasWritten) {
    const RememberedChain chain = readRemembered(
        "{\n \"machine\": \"press\",\n \"positions\": [\n  {\n   \"counter\": -700,\n   \"from_home\": 300,\n"
        "   \"home_saved\": 1,\n   \"module\": 2,\n   \"moving\": 0,\n   \"seen\": 1764000000000,\n"
        "   \"type\": 0,\n   \"version\": 4\n  }\n ]\n}\n");
    EXPECT_EQ(chain.machine, "press");
    ASSERT_TRUE(chain.positions.contains(ModuleIndex(1)));
    const RememberedPosition& last = chain.positions.at(ModuleIndex(1));
    EXPECT_EQ(last.identity, (ModuleIdentity{ModuleType::Servo, 4}));
    EXPECT_EQ(last.fromHome, 300);
    EXPECT_EQ(last.counter, -700);
    EXPECT_EQ(last.source, HomeFact::Source::Saved);
    EXPECT_EQ(last.seen, 1'764'000'000'000);
    EXPECT_FALSE(last.moving);
}

TEST(PositionMemory, ThereIsNoEndOfTheCountThatItFallsOver) {
    Axis axis;
    axis.wasLeft(kLastCount, -kLastCount);
    axis.restarted();
    const auto offers = axis.look();
    ASSERT_EQ(offers.size(), 1U);
    EXPECT_EQ(offers[0].home, 2) << "-2 from home, across the wrap";
}

}  // namespace
}  // namespace nmc
