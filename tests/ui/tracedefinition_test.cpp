// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/tracedefinition.h"

#include <gtest/gtest.h>

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using Part = TraceDefinition::Part;

constexpr ModuleSignal kFirst{ModuleIndex(0), ScopeSignal::Custom1};

ScopeModule servo(double countsPerMm) {
    ScopeModule module;
    module.identity = {ModuleType::Servo, 4};
    module.scale = AxisScale::servo({UnitKind::Millimetres, countsPerMm}, {});
    return module;
}

TEST(TraceDefinition, SurvivesTheSettingsFile) {
    const TraceDefinition gantry{u"skew, 50 %; X=Y"_s,
                                 u"µm"_s,
                                 {{ModuleIndex(0), ScopeSignal::Position}, 1000},
                                 Part{{std::nullopt, ScopeSignal::Velocity}, -0.125},
                                 12.5};
    EXPECT_EQ(TraceDefinition::fromText(gantry.toText()), gantry);
    EXPECT_FALSE(gantry.toText().contains(u'=')) << "between a key and its value";
    EXPECT_FALSE(gantry.toText().contains(u';')) << "between two keys";
    const TraceDefinition smooth{u"smooth"_s, {}, {{std::nullopt, ScopeSignal::Analog}, 1}, {}, 3};
    EXPECT_EQ(TraceDefinition::fromText(smooth.toText()), smooth);
}

TEST(TraceDefinition, WhatCannotBeReadDefinesNoTrace) {
    for (const QString& text :
         {u""_s, u"a"_s, u"a,mm,0,position"_s, u"a,mm,0,position,0"_s, u"a,mm,0,position,nan"_s,
          u"a,mm,0,nonsense,1"_s, u"a,mm,0,custom1,1"_s, u"a,mm,0,33.position,1"_s, u"a,mm,-1,position,1"_s,
          u"a,mm,nan,position,1"_s, u"a,mm,1e9,position,1"_s, u",mm,0,position,1"_s,
          u"a,mm,0,position,1,custom2,1"_s, u"a,mm,0,position,1,error"_s, u"a,mm,0,position,1e99"_s})
        EXPECT_FALSE(TraceDefinition::fromText(text)) << text.toStdString();
    EXPECT_TRUE(TraceDefinition::fromText(u"a,mm,0,position,1"_s)) << "the rest of these texts is right";
}

TEST(TraceDefinition, ValuesAreTakenInTheUnitsInWhichTheirSignalsAreShown) {
    const std::vector<ScopeModule> modules{servo(100), servo(250)};
    const TraceDefinition skew{u"skew"_s,
                               u"µm"_s,
                               {{{}, ScopeSignal::Position}, 1000},
                               Part{{ModuleIndex(1), ScopeSignal::Position}, -1000}};
    const auto trace = skew.at(kFirst, modules);
    ASSERT_TRUE(trace);
    EXPECT_NEAR(trace->step, 4, 1e-9) << "a count of module 2 is 4 um, one of module 1 is 10 um";
    EXPECT_EQ(trace->signal.first.of, (ModuleSignal{ModuleIndex(0), ScopeSignal::Position}));
    EXPECT_EQ(trace->signal.second->of, (ModuleSignal{ModuleIndex(1), ScopeSignal::Position}));
    // 200 counts of module 1 are 2 mm, 450 of module 2 are 1.8 mm: 200 um apart.
    EXPECT_NEAR((trace->signal.first.scale(200) + trace->signal.second->scale(450)) * trace->step, 200, 1e-6);
}

TEST(TraceDefinition, AnOffsetIsMultipliedToo) {
    ScopeModule module = servo(1);
    module.analog = {0.5, -10, "bar"};
    const TraceDefinition doubled{u"double"_s, u"bar"_s, {{{}, ScopeSignal::Analog}, 2}};
    const auto trace = doubled.at(kFirst, {module});
    ASSERT_TRUE(trace);
    EXPECT_NEAR(trace->signal.first.scale(30) * trace->step, 10, 1e-9) << "2 x (30 x 0.5 - 10)";
}

TEST(TraceDefinition, IsNotShownWhereItsSignalsAreNot) {
    ScopeModule io;
    io.identity = {ModuleType::Io, 1};
    const TraceDefinition follows{u"follows"_s, {}, {{{}, ScopeSignal::Position}, 1}};
    const TraceDefinition third{u"third"_s, {}, {{ModuleIndex(2), ScopeSignal::Position}, 1}};
    const auto modules = withTraces({servo(1), io}, {follows, third});
    EXPECT_TRUE(modules[0].has(ScopeSignal::Custom1));
    EXPECT_TRUE(modules[0].reports(ScopeSignal::Custom1));
    EXPECT_FALSE(modules[1].has(ScopeSignal::Custom1)) << "a PIC-I/O has no position";
    EXPECT_FALSE(modules[0].has(ScopeSignal::Custom2)) << "there is no third module";
    EXPECT_FALSE(modules[0].has(ScopeSignal::Custom3));
}

}  // namespace
}  // namespace nmc
