// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopesetup.h"

#include <gtest/gtest.h>

#include "widgets/scope/scopewords.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;

TEST(ScopeSetup, SurvivesTheSettingsFile) {
    ScopeSetup setup = ScopeSetup::usual();
    setup.set(2, {ModuleIndex(4), ScopeSignal::Velocity}, true);
    setup.set(2, {std::nullopt, ScopeSignal::Analog}, true);
    setup.set(3, {ModuleIndex(0), ScopeSignal::Acceleration}, true);
    setup.set(3, {std::nullopt, ScopeSignal::Pwm}, true);
    setup.heights = {2, 0.5, 1.25, 1};
    setup.readings = false;
    setup.lane = true;
    setup.seconds = 30;
    setup.set(3, {ModuleIndex(2), ScopeSignal::CountRate}, true);
    setup.bits[ModuleType::Servo] = {{ScopeBit::Byte::Aux, 2}, {ScopeBit::Byte::Status, 7}};
    setup.bits[ModuleType::Io] = {{ScopeBit::Byte::Status, 0}, {ScopeBit::Byte::Aux, 3}};
    setup.custom[1] = {u"twice; = ,"_s, u"mm"_s, {{ModuleIndex(1), ScopeSignal::Position}, 2}};
    setup.set(1, {std::nullopt, ScopeSignal::Custom2}, true);
    EXPECT_EQ(ScopeSetup::fromText(setup.toText()), setup);
}

TEST(ScopeSetup, WhatCannotBeReadIsLeftOut) {
    const ScopeSetup setup = ScopeSetup::fromText(
        u"strip=position,nonsense,33.error,0.error,error;seconds=-3;lane=maybe;bits;strip=;strip=2.velocity,2.velocity;strip=x;strip=position;servobits=1,99,-1,x;heights=-1,x,2"_s);
    ASSERT_EQ(setup.strips[0].size(), 2U);
    EXPECT_EQ(setup.strips[0][1], (SignalRef{std::nullopt, ScopeSignal::Error}));
    EXPECT_TRUE(setup.strips[1].empty());
    EXPECT_EQ(setup.strips[2], (std::vector<SignalRef>{{ModuleIndex(1), ScopeSignal::Velocity}}));
    EXPECT_EQ(setup.heights, (std::array<double, ScopeSetup::kStrips>{1.5, 1, 2, 1.2}));
    EXPECT_EQ(setup.seconds, 10);
    EXPECT_FALSE(setup.lane);
    EXPECT_EQ(setup.bitsOf(ModuleType::Servo), (std::vector<ScopeBit>{{ScopeBit::Byte::Status, 1}}));
}

TEST(ScopeSetup, NothingAtAllIsTheUsual) {
    EXPECT_EQ(ScopeSetup::fromText({}), ScopeSetup::usual());
    EXPECT_EQ(ScopeSetup::fromText(u"\x01\x02;;;===,,,"_s), ScopeSetup::usual());
}

TEST(ScopeSetup, ModulesThatAreShownWhicheverIsSelectedAreKnown) {
    ScopeSetup setup = ScopeSetup::usual();
    EXPECT_TRUE(setup.fixedModules().empty());
    setup.set(0, {ModuleIndex(3), ScopeSignal::Position}, true);
    setup.set(1, {ModuleIndex(3), ScopeSignal::Error}, true);
    EXPECT_EQ(setup.fixedModules(), std::vector{ModuleIndex(3)});
    setup.custom[0] = {u"sum"_s,
                       {},
                       {{ModuleIndex(3), ScopeSignal::Position}},
                       TraceDefinition::Part{{ModuleIndex(5), ScopeSignal::Position}}};
    EXPECT_EQ(setup.fixedModules(), std::vector{ModuleIndex(3)}) << "a trace that is not shown";
    setup.set(2, {std::nullopt, ScopeSignal::Custom1}, true);
    EXPECT_EQ(setup.fixedModules(), (std::vector{ModuleIndex(3), ModuleIndex(5)}));
    setup.set(2, {std::nullopt, ScopeSignal::Custom1}, false);
    setup.custom[0].reset();
    setup.set(0, {ModuleIndex(3), ScopeSignal::Position}, false);
    setup.set(1, {ModuleIndex(3), ScopeSignal::Error}, false);
    EXPECT_EQ(setup, ScopeSetup::usual());
}

TEST(ScopeSetup, EveryNamedBitOfEachChipCanBeChosen) {
    EXPECT_EQ(laneBits({ModuleType::Servo, 4}).size(), 14U);    // DS-V 5.3: 8 and 6
    EXPECT_EQ(laneBits({ModuleType::Stepper, 1}).size(), 14U);  // DS-S 5.2: 8 and 6
    EXPECT_EQ(laneBits({ModuleType::Io, 1}).size(), 12U);       // docs/family.md: its pins
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Stepper, ModuleType::Io})
        for (const ScopeBit& bit : usualLaneBits(type))
            EXPECT_FALSE(texts::bitName(bit, ModuleIdentity{type, 1}).isEmpty());
    // CMC and SC (docs/family.md): path mode in addition.
    for (const std::uint8_t version : {kPathVersion, kScVersion}) {
        const ModuleIdentity module{ModuleType::Servo, version};
        EXPECT_EQ(laneBits(module).size(), 15U);
        EXPECT_EQ(texts::bitName({ScopeBit::Byte::Aux, 6}, module), u"path_mode"_s);
        EXPECT_EQ(texts::bitName({ScopeBit::Byte::Aux, 3}, module), u"accel_done"_s);
    }
}

TEST(ScopeModule, APicIoIsReadByTheNamesAndScalesOfItsMachine) {
    ScopeModule module;
    module.identity = {ModuleType::Io, 1};
    PinSettings::in(module.pins.pins, 8).name = "Door";
    PinSettings::in(module.pins.analog, 1) = {"Pressure", {0.5, -10, "bar"}};
    EXPECT_EQ(texts::signalName(ScopeSignal::Analog, module), u"A/D 1"_s);
    EXPECT_EQ(texts::signalName(ScopeSignal::Analog2, module), u"Pressure"_s);
    EXPECT_EQ(texts::signalUnit(ScopeSignal::Analog2, module), u"bar"_s);
    EXPECT_EQ(module.scaleOf(ScopeSignal::Analog2)(40), 10) << "40 x 0.5 bar - 10 bar";
    EXPECT_EQ(module.scaleOf(ScopeSignal::Counter)(40), 40);
    EXPECT_EQ(texts::bitName({ScopeBit::Byte::Aux, 0}, module), u"Door"_s);
    EXPECT_EQ(texts::bitName({ScopeBit::Byte::Aux, 1}, module), u"IO10"_s);
}

TEST(ScopeModule, TheErrorOfACmcOrAnScIsReported) {
    ScopeModule module;
    for (const std::uint8_t version : {kPathVersion, kScVersion}) {
        module.identity = {ModuleType::Servo, version};
        EXPECT_EQ(texts::signalName(ScopeSignal::Error, module), u"error, reported"_s);
    }
    module.identity = {ModuleType::Servo, 4};
    EXPECT_EQ(texts::signalName(ScopeSignal::Error, module), u"error, calculated"_s);
}

TEST(ScopeModule, ReportsWhatItsChipHas) {
    ScopeModule module;
    module.identity = {ModuleType::Io, 1};
    EXPECT_TRUE(module.reports(ScopeSignal::Analog));
    EXPECT_TRUE(module.reports(ScopeSignal::CountRate));
    EXPECT_FALSE(module.reports(ScopeSignal::Position));
    EXPECT_FALSE(module.has(ScopeSignal::Error));
    module.identity = {ModuleType::Servo, 4};
    EXPECT_FALSE(module.reports(ScopeSignal::Analog2));
    EXPECT_FALSE(module.has(ScopeSignal::Counter));
    EXPECT_TRUE(module.reports(ScopeSignal::Analog));
}

}  // namespace
}  // namespace nmc
