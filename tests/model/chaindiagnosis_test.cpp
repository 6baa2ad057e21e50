// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/module/chaindiagnosis.h"

#include <gtest/gtest.h>

#include "model/intent/intent.h"
#include "tests/support/modules.h"

namespace nmc {
namespace {

using Finding = ChainDiagnosis::Finding;
using testing_support::kServo;
using testing_support::kStep;

constexpr ModuleIdentity kOldServo{ModuleType::Servo, 1};

Machine machineExpecting(const std::vector<ModuleIdentity>& expected) {
    Machine machine;
    for (const ModuleIdentity& identity : expected)
        machine.axes.emplace_back().expected = identity;
    return machine;
}

LinkState linkWith(const std::vector<ModuleIdentity>& found) {
    LinkState link;
    link.phase = LinkPhase::Connected;
    for (const ModuleIdentity& identity : found) {
        const auto index = static_cast<std::uint8_t>(link.modules.size());
        bus::ModuleInfo& info = link.modules.emplace_back().info;
        info.index = ModuleIndex(index);
        info.address = BusAddress(static_cast<std::uint8_t>(index + 1));
        info.identity = identity;
    }
    return link;
}

TEST(ChainDiagnosis, WhatIsExpectedAndThereIsFine) {
    const auto chain = diagnose(machineExpecting({kServo, kStep}), linkWith({kServo, kStep}));
    EXPECT_EQ(chain.finding, Finding::Fine);
    EXPECT_EQ(chain.places.size(), 2U);
    EXPECT_EQ(chain.places[1].state, ChainPlace::State::Fine);
}

TEST(ChainDiagnosis, OfAChainNobodyHasToldOfNothingIsKnown) {
    const auto chain = diagnose({}, linkWith({kServo}));
    EXPECT_EQ(chain.finding, Finding::NothingExpected);
    EXPECT_EQ(chain.places[0].state, ChainPlace::State::New);
}

TEST(ChainDiagnosis, FewerThanExpectedBreakBehindTheLastThatAnswers) {
    // Addresses are assigned from the far end: modules 1 and 2 have theirs, so the link to module 3 is
    // broken.
    const auto chain =
        diagnose(machineExpecting({kServo, kServo, kServo, kStep}), linkWith({kServo, kServo}));
    EXPECT_EQ(chain.finding, Finding::BreakBehind);
    EXPECT_EQ(chain.at, ModuleIndex(1));
    EXPECT_EQ(chain.expected, 4U);
    EXPECT_EQ(chain.found, 2U);
    EXPECT_EQ(chain.places[2].state, ChainPlace::State::Missing);
    EXPECT_EQ(chain.places[3].state, ChainPlace::State::Missing);
}

TEST(ChainDiagnosis, ACutOffFarEndIsToldFromABreak) {
    const auto chain = diagnose(machineExpecting({kOldServo, kServo, kStep}), linkWith({kServo, kStep}));
    EXPECT_EQ(chain.finding, Finding::FarEndMissing);
}

TEST(ChainDiagnosis, AnotherVersionIsOtherHardware) {
    const auto chain = diagnose(machineExpecting({kServo, kServo}), linkWith({kServo, kOldServo}));
    EXPECT_EQ(chain.finding, Finding::OtherHardware);
    EXPECT_EQ(chain.at, ModuleIndex(1));
    EXPECT_EQ(chain.places[1].state, ChainPlace::State::Different);
}

TEST(ChainDiagnosis, OneMoreIsSaid) {
    const auto chain = diagnose(machineExpecting({kServo}), linkWith({kServo, kStep}));
    EXPECT_EQ(chain.finding, Finding::MoreThanBefore);
    EXPECT_EQ(chain.at, ModuleIndex(1));
}

TEST(ChainDiagnosis, SilenceAndRestartsComeFirst) {
    LinkState link = linkWith({kServo, kServo, kServo});
    link.modules[2].silent = true;
    EXPECT_EQ(diagnose(machineExpecting({kServo}), link).finding, Finding::Unresponsive);
    link.modules[1].hasRestarted = true;
    const auto chain = diagnose(machineExpecting({kServo}), link);
    EXPECT_EQ(chain.finding, Finding::Restarted);
    EXPECT_EQ(chain.at, ModuleIndex(1));
}

TEST(ChainDiagnosis, ALostChainIsNotFineWhateverItsModulesSaidLast) {
    LinkState link = linkWith({kServo, kStep});
    link.phase = LinkPhase::Lost;
    const auto chain = diagnose(machineExpecting({kServo, kStep}), link);
    EXPECT_EQ(chain.finding, Finding::Unresponsive);
    for (const ChainPlace& place : chain.places)
        EXPECT_EQ(place.state, ChainPlace::State::Unresponsive);
}

TEST(LinkState, AModuleThatIsNotAskedAnyMoreDoesNotAnswer) {
    for (const LinkPhase phase : {LinkPhase::Connecting, LinkPhase::Lost, LinkPhase::Disconnected}) {
        LinkState link = linkWith({kServo});
        link.phase = phase;
        link.modules[0].repliesPerSecond = 5;
        EXPECT_FALSE(isLive(link, link.modules[0]));
        EXPECT_EQ(asShown(link).modules[0].activity(), Activity::Unresponsive);
        EXPECT_EQ(asShown(link).modules[0].repliesPerSecond, 0);
    }
}

/// Table and refusals said of modules that answered to the last that they do not.
TEST(LinkState, OnceSendingHasStoppedModulesAreNotAsked) {
    LinkState link = linkWith({kServo, kStep, kServo});
    link.phase = LinkPhase::Lost;
    link.quiet = true;
    link.modules[0].restarted();
    link.modules[2].silent = true;
    const auto chain = diagnose(machineExpecting({kServo, kStep, kServo}), asShown(link));
    EXPECT_EQ(chain.finding, Finding::Restarted);
    EXPECT_EQ(chain.places[0].state, ChainPlace::State::Restarted);
    EXPECT_EQ(chain.places[1].state, ChainPlace::State::NotAsked);
    EXPECT_EQ(chain.places[2].state, ChainPlace::State::Unresponsive);
    EXPECT_EQ(whyInaccessible(IntentKind::Home, asShown(link).modules[1]), Refusal::NotAsked);
    EXPECT_EQ(whyInaccessible(IntentKind::MotorOff, asShown(link).modules[1]), std::nullopt);
    EXPECT_EQ(whyInaccessible(IntentKind::Home, asShown(link).modules[2]), Refusal::Unresponsive);
}

TEST(LinkState, AChainThatIsOnlyLookedForHasNoFault) {
    LinkState link = linkWith({kServo});
    link.phase = LinkPhase::Connecting;
    link.looking = true;
    EXPECT_FALSE(isLive(link, link.modules[0])) << "its last reply is getting older";
    const ModuleState shown = asShown(link).modules[0];
    EXPECT_NE(shown.activity(), Activity::Unresponsive);
    EXPECT_EQ(whyInaccessible(IntentKind::Move, shown), Refusal::Looking);
    EXPECT_NE(whyInaccessible(IntentKind::StopMotion, shown), Refusal::Looking);
    const auto chain = diagnose(machineExpecting({kServo}), asShown(link));
    EXPECT_EQ(chain.finding, Finding::Looking);
    EXPECT_EQ(chain.places[0].state, ChainPlace::State::Fine);
}

TEST(LinkState, AValueIsOldByHowOftenItsModuleIsAsked) {
    LinkState link = linkWith({kServo});
    ModuleState& module = link.modules[0];
    module.latest.emplace();
    module.latestTime = TimePoint(std::chrono::seconds(10));
    link.now = TimePoint(std::chrono::milliseconds(10'400));
    EXPECT_TRUE(isLive(link, module));
    link.now = TimePoint(std::chrono::milliseconds(10'600));
    EXPECT_FALSE(isLive(link, module));
    // Even if few replies get through: a bad line does not make an old value a current one.
    module.repliesPerSecond = 1.0;
    EXPECT_FALSE(isLive(link, module));
    link.focused = ModuleIndex(1);  // the others are then polled once in 0.9 s
    EXPECT_TRUE(isLive(link, module));
    link.now = TimePoint(std::chrono::milliseconds(12'800));
    EXPECT_FALSE(isLive(link, module));
    link.focused = ModuleIndex(0);
    link.now = TimePoint(std::chrono::milliseconds(10'600));
    EXPECT_FALSE(isLive(link, module)) << "the focused module is polled as often as the line allows";
}

/// 32 modules at 9600 Bd, a reply of 17 bytes to a query of 5: 22 x 1.04 ms, a quarter of a millisecond for
/// the tick and 4 ms for the adapter make 0.87 s for a round.
TEST(LinkState, ALongChainOnASlowLineIsAskedMoreRarely) {
    LinkState link;
    link.phase = LinkPhase::Connected;
    link.baud = 9'600;
    for (std::uint8_t i = 0; i < 32; ++i) {
        ModuleState module;
        module.info = {ModuleIndex(i), BusAddress(static_cast<std::uint8_t>(i + 1)), kServo, {}};
        module.latest.emplace();
        module.latestTime = TimePoint(std::chrono::seconds(10));
        link.modules.push_back(module);
    }
    link.now = TimePoint(std::chrono::milliseconds(12'400));
    EXPECT_TRUE(isLive(link, link.modules[31]));
    link.now = TimePoint(std::chrono::milliseconds(13'000));
    EXPECT_FALSE(isLive(link, link.modules[31]));
}

TEST(ChainDiagnosis, NothingIsConcludedWithoutAConnection) {
    EXPECT_EQ(diagnose(machineExpecting({kServo}), {}).finding, Finding::NotConnected);
    LinkState lost;
    lost.phase = LinkPhase::Lost;
    EXPECT_EQ(diagnose(machineExpecting({kServo}), lost).finding, Finding::NobodyAnswers);
}

/// 2000 steps/s would be 2000 counts/tick, 3.9 million counts/s.
TEST(LinkState, SettingsForAnotherTypeAreNotThoseOfTheModuleThatIsThere) {
    Machine machine = machineExpecting({kServo, kStep});
    for (AxisSettings& axis : machine.axes) {
        axis.name = "Table";
        axis.unit = {UnitKind::Millimetres, 200.0, {}};
        axis.motion.velocity = 2'000;
        axis.travel = {0, 40'000, 3'000};
    }
    Machine servos = machine;
    servos.axes[1] = {};
    servos.axes[1].name = "Table";
    servos.axes[1].expected = kStep;
    LinkState link = linkWith({kOldServo, kServo});
    EXPECT_EQ(usable(machine, link.modules), servos);
    link.take(machine);
    EXPECT_FALSE(link.modules[0].otherType()) << "another version counts alike";
    EXPECT_TRUE(link.modules[0].replaced());
    EXPECT_EQ(link.modules[0].travel.fastest, 3'000);
    EXPECT_TRUE(link.modules[1].otherType());
    EXPECT_EQ(link.modules[1].unit, UnitKind::Native);
    EXPECT_EQ(link.modules[1].travel, TravelSettings{});
    EXPECT_EQ(usable(machine, linkWith({kServo, kStep}).modules), machine);
    EXPECT_EQ(usable(machine, linkWith({kServo, kUnheardModule}).modules), machine);
    EXPECT_EQ(usable(machine, {}), machine);

    link.take(servos);
    EXPECT_TRUE(link.modules[1].replaced());
    EXPECT_FALSE(link.modules[1].otherType()) << "there is no number of another chip";
    servos.program.points = {{"All", {{ModuleIndex(1), 3, false}}}};
    link.take(servos);
    EXPECT_TRUE(link.modules[1].otherType()) << "there is one in a point";
}

}  // namespace
}  // namespace nmc
