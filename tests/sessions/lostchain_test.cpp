// SPDX-License-Identifier: GPL-3.0-or-later
// Issue 13, "Mend first", e: a chain that has lost its power and has it again is not shown as live, and is
// found by the next search.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/sessions/operator.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing::IsEmpty;

struct ChainCase {
    std::size_t modules;
    std::uint32_t baud;
    bool deaf;

    friend void PrintTo(const ChainCase& c, std::ostream* stream) {
        *stream << c.modules << "At" << c.baud << (c.deaf ? "Deaf" : "");
    }
};

[[nodiscard]] std::vector<ChainCase> chainCases() {
    std::vector<ChainCase> all;
    for (const std::size_t modules : {1U, 2U, 3U, 8U})
        for (const std::uint32_t baud : {19'200U, 57'600U, 115'200U})
            for (const bool deaf : {false, true})
                all.push_back({modules, baud, deaf});
    return all;
}

class LostChain : public testing::TestWithParam<ChainCase> {
protected:
    static World world() {
        World world;
        world.chain = servos(GetParam().modules);
        world.baud = GetParam().baud;
        world.deafWhenAddressInputRises = GetParam().deaf;
        return world;
    }
    /// True if all of the chain has been reported as gone, by whatever events.
    [[nodiscard]] static bool struckOut(const Rig& rig) {
        std::set<std::uint8_t> gone;
        for (const Event& event : rig.bus.events) {
            if (std::holds_alternative<LinkLost>(event))
                return true;
            if (const auto* silence = std::get_if<ModuleUnresponsive>(&event)) {
                if (silence->silent)
                    gone.insert(silence->module.value());
                else
                    gone.erase(silence->module.value());
            }
            if (const auto* restarted = std::get_if<ModuleRestarted>(&event))
                gone.insert(restarted->module.value());
        }
        return gone.size() == rig.size();
    }
};

/// Modules that do not answer are reported as gone within three seconds.
TEST_P(LostChain, IsStruckOutWithinThreeSeconds) {
    for (const Duration after : {Duration(0ms), Duration(3ms), Duration(37ms), Duration(1s)}) {
        SCOPED_TRACE(after / 1ms);
        Rig rig(world());
        ASSERT_TRUE(setRunning(rig, 1));
        rig.run(after);
        for (std::uint8_t place = 0; place < rig.size(); ++place)
            rig.powerCycle(place);
        EXPECT_TRUE(rig.runUntil([&] { return struckOut(rig); }, 3s)) << "all of it is reported as gone";
        rig.run(100ms);
        const std::size_t samples = rig.bus.count<Sample>();
        rig.run(10s);
        EXPECT_EQ(rig.bus.count<Sample>(), samples) << "modules without an address give no samples";
        EXPECT_TRUE(struckOut(rig));
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

/// Scanning once found nothing although module 1 listened at address 0.
TEST_P(LostChain, IsFoundWhenItIsLookedFor) {
    for (const Duration after : {Duration(200ms), Duration(3s), Duration(30s)}) {
        SCOPED_TRACE(after / 1ms);
        Rig rig(world());
        ASSERT_TRUE(setRunning(rig, 1));
        for (std::uint8_t place = 0; place < rig.size(); ++place)
            rig.powerCycle(place);
        rig.run(after);
        EXPECT_TRUE(connectAndWait(rig));
        ASSERT_TRUE(rig.known.has_value());
        EXPECT_EQ(rig.known->modules.size(), rig.size());
        EXPECT_EQ(rig.known->baud, GetParam().baud);
        EXPECT_FALSE(rig.bus.last<ChainFound>()->attached);
        rig.run(1s);
        for (std::uint8_t i = 0; i < rig.size(); ++i) {
            EXPECT_TRUE(rig.bus.lastSample(i).has_value());
            EXPECT_FALSE(rig.isOn(i)) << "N2: nothing is switched on again";
        }
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

/// The modules are not reported as stopped when none has answered.
TEST_P(LostChain, IsNotCalledStopped) {
    for (const Duration after : {Duration(0ms), Duration(20ms), Duration(500ms), Duration(4s)}) {
        SCOPED_TRACE(after / 1ms);
        Rig rig(world());
        ASSERT_TRUE(setRunning(rig, 1));
        for (std::uint8_t place = 0; place < rig.size(); ++place)
            rig.powerCycle(place);
        rig.run(after);
        rig.stopAll();
        ASSERT_TRUE(rig.runUntil([&] { return !rig.stopping(); }, StopOath::kStopBound));
        EXPECT_THAT(rig.bus.last<StopFinished>()->stopped, IsEmpty());
        rig.runToRest();
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

INSTANTIATE_TEST_SUITE_P(Chains, LostChain, testing::ValuesIn(chainCases()),
                         testing::PrintToStringParamName());

}  // namespace

}  // namespace nmc::test
