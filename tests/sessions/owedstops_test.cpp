// SPDX-License-Identifier: GPL-3.0-or-later
// Issue 13, "What must be true afterwards", 3: an owed stop is never dropped. A hold ends, a motion strays,
// or only half a group starts: the module hears neither its first stop nor anything else for a time, and
// stops when it hears again, however long that took.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/bus/groups.h"
#include "tests/sessions/operator.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing::IsEmpty;

constexpr Duration kSoon = OwedStopOath::kSoon;

enum class Deaf : std::uint8_t { Module, WholeBus };

struct SilenceCase {
    StopCause cause;
    Deaf deaf;
    Duration silence;
    std::uint32_t baud;
    std::size_t modules;

    friend void PrintTo(const SilenceCase& c, std::ostream* stream) {
        static constexpr std::array kCauses{"HoldReleased", "HoldExpired", "MotionSuspect",
                                            "GroupHalfStarted"};
        *stream << (c.cause == StopCause::TravelLimit ? "TravelLimit"
                                                      : kCauses.at(static_cast<std::size_t>(c.cause)))
                << (c.deaf == Deaf::Module ? "OneOf" : "AllOf") << c.modules << "For" << c.silence / 1ms
                << "At" << c.baud;
    }
};

[[nodiscard]] std::vector<SilenceCase> silenceCases() {
    std::vector<SilenceCase> all;
    for (const StopCause cause : {StopCause::HoldReleased, StopCause::HoldExpired, StopCause::MotionSuspect,
                                  StopCause::GroupHalfStarted, StopCause::TravelLimit})
        for (const Deaf deaf : {Deaf::Module, Deaf::WholeBus})
            for (const Duration silence : {Duration(300ms), Duration(2s), Duration(20s)})
                for (const std::uint32_t baud : {19'200U, 115'200U})
                    all.push_back({cause, deaf, silence, baud, 2});
    for (const Duration silence : {Duration(300ms), Duration(2s), Duration(20s)})
        all.push_back({StopCause::HoldReleased, Deaf::WholeBus, silence, 115'200, 1});
    return all;
}

[[nodiscard]] World servosAt(std::uint32_t baud, std::size_t modules) {
    World world;
    world.chain = servos(modules);
    world.baud = baud;
    return world;
}

/// A connected chain whose servos are on; the first module is the one to be stopped.
class OwedStop {
public:
    OwedStop(std::uint32_t baud, std::size_t modules) : rig(servosAt(baud, modules)) {}

    /// From its first stop on, neither the module nor, with Deaf::WholeBus, any other hears or is heard; the
    /// stop itself is lost.
    void deafFromItsStopOn(Deaf deaf, Duration silence) {
        rig.onPacket = [this, deaf, silence](std::vector<std::uint8_t>& bytes) {
            for (const WireItem& item : itemsOf(bytes, rig.bus.now, 0))
                if (!deafSince && item.isStop() && (item.address() == 1 || item.address() >= kGroup))
                    deafSince = rig.bus.now;
            if (!deafSince || deafUntil)
                return;
            deafUntil = *deafSince + silence;
            const auto place = deaf == Deaf::Module ? std::optional<std::uint8_t>(0) : std::nullopt;
            rig.fault("mute tx", silence, true, place);
            rig.fault("mute rx", silence, false, place);
        };
    }
    /// Brings about the reason to stop, and waits for the stop. Returns false if it does not come.
    [[nodiscard]] bool cause(StopCause cause) {
        switch (cause) {
            case StopCause::HoldReleased:
            case StopCause::HoldExpired:
                rig.hold(holdOn(0, rig.world.chain[0], 60), 600ms, cause == StopCause::HoldExpired);
                break;
            case StopCause::MotionSuspect:
                runsAway();
                break;
            case StopCause::GroupHalfStarted:
                startHalf();
                break;
            case StopCause::TravelLimit:
                runsOut();
                break;
            case StopCause::LinkGivenUp:
            case StopCause::StopAll:
            case StopCause::ForeignTraffic:
            case StopCause::GroupStop:
            case StopCause::PathEnded:
            case StopCause::ConnectionEnded:
                return false;
        }
        return rig.runUntil([&] { return deafSince.has_value(); }, 5s);
    }
    [[nodiscard]] std::vector<OwedStopConfirmed> confirmed() const {
        std::vector<OwedStopConfirmed> found;
        for (const auto& event : rig.bus.all<OwedStopConfirmed>())
            if (event.module == ModuleIndex(0))
                found.push_back(event);
        return found;
    }

    Rig rig;
    std::optional<TimePoint> deafSince;
    std::optional<TimePoint> deafUntil;

private:
    /// Its encoder is reversed while it runs: the position goes the other way, and the motor drives on, with
    /// an error limit and an output limit that leave time for this to be seen.
    void runsAway() {
        rig.submit({toServo(0, servo::SetGain{200, 2000, 20, 200, 60, 0, 0x3FFF, 1, std::uint8_t{0}})});
        rig.submit(runOn(0, rig.world.chain[0], 60));
        rig.run(500ms);
        rig.bus.fault("module 1 reverse for=250ms");
    }
    /// Sets a travel limit that the motor has already passed.
    void runsOut() {
        rig.submit(runOn(0, rig.world.chain[0], 60));
        rig.run(500ms);
        rig.bus.engine.setTravelLimits({{std::nullopt, 0}});
    }
    /// The second module does not hear the start.
    void startHalf() {
        for (const std::uint8_t i : {std::uint8_t{0}, std::uint8_t{1}})
            rig.submit(GroupChange{ModuleIndex(i), {kGroup, false}});
        for (const std::uint8_t i : {std::uint8_t{0}, std::uint8_t{1}})
            rig.submit({loadFar(i, rig.world.chain[i], 256)});
        rig.run(500ms);
        rig.bus.fault("module 2 ignore=start_motion");
        rig.submit(GroupCommand{kGroup, GroupCommand::Action::StartMotion});
    }
};

class OwedStopAfterSilence : public testing::TestWithParam<SilenceCase> {};

TEST_P(OwedStopAfterSilence, ReachesTheModuleAsSoonAsItHears) {
    const SilenceCase& c = GetParam();
    OwedStop owed(c.baud, c.modules);
    Rig& rig = owed.rig;
    ASSERT_TRUE(setRunning(rig, 0));
    owed.deafFromItsStopOn(c.deaf, c.silence);
    ASSERT_TRUE(owed.cause(c.cause)) << "the cause must lead to a stop";
    ASSERT_FALSE(rig.atRest(0));
    ASSERT_TRUE(rig.runUntil([&] { return rig.bus.now >= *owed.deafUntil; }, c.silence + 1s));
    ASSERT_FALSE(rig.atRest(0)) << "it runs on until it hears";
    EXPECT_THAT(owed.confirmed(), IsEmpty()) << "the stop cannot have arrived yet";
    EXPECT_TRUE(rig.runUntil([&] { return rig.atRest(0); }, kSoon)) << "it must stop once it hears";
    // An owed stop ends only with a confirmation, which comes once.
    EXPECT_TRUE(rig.runUntil([&] { return !owed.confirmed().empty(); }, kSoon));
    rig.run(3s);
    ASSERT_EQ(owed.confirmed().size(), 1U);
    EXPECT_EQ(owed.confirmed().front().cause, c.cause);
    EXPECT_TRUE(rig.atRest(0));
    EXPECT_THAT(rig.complaints, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Causes, OwedStopAfterSilence, testing::ValuesIn(silenceCases()),
                         testing::PrintToStringParamName());

/// An owed stop is repeated while the link is open: the motor hears it even on a line from which nothing
/// comes back.
TEST(OwedStopOnALineThatIsNotHeard, ReachesTheModule) {
    for (const std::uint32_t baud : {19'200U, 115'200U}) {
        SCOPED_TRACE(baud);
        OwedStop owed(baud, 2);
        Rig& rig = owed.rig;
        ASSERT_TRUE(setRunning(rig, 0));
        owed.deafFromItsStopOn(Deaf::WholeBus, 7s);
        ASSERT_TRUE(owed.cause(StopCause::HoldReleased));
        rig.fault("mute rx", 60s, false);
        rig.run(7s);
        EXPECT_TRUE(rig.runUntil([&] { return rig.atRest(0); }, kSoon));
        rig.run(2s);
        EXPECT_THAT(owed.confirmed(), IsEmpty()) << "no answer can have shown it";
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

/// A stop remains owed when a search or a check of the link begins.
class OwedStopAcross : public testing::TestWithParam<std::uint32_t> {};

TEST_P(OwedStopAcross, ASearchThatFindsTheChain) {
    OwedStop owed(GetParam(), 2);
    Rig& rig = owed.rig;
    ASSERT_TRUE(setRunning(rig, 0));
    owed.deafFromItsStopOn(Deaf::Module, 400ms);
    ASSERT_TRUE(owed.cause(StopCause::HoldReleased));
    rig.run(100ms);
    rig.connect();
    ASSERT_TRUE(rig.runUntil([&] { return rig.bus.now >= *owed.deafUntil; }, 1s));
    EXPECT_TRUE(rig.runUntil([&] { return rig.atRest(0); }, kSoon)) << "it must stop once it hears";
    rig.runToRest();
    EXPECT_EQ(owed.confirmed().size(), 1U) << "a blind stop by the search is followed by a look at the motor";
    rig.expectEnds();
    EXPECT_THAT(rig.complaints, IsEmpty());
}

TEST_P(OwedStopAcross, ASearchThatFindsNobody) {
    OwedStop owed(GetParam(), 2);
    Rig& rig = owed.rig;
    ASSERT_TRUE(setRunning(rig, 0));
    owed.deafFromItsStopOn(Deaf::WholeBus, 15s);
    ASSERT_TRUE(owed.cause(StopCause::HoldReleased));
    rig.run(1s);
    rig.connect();
    ASSERT_TRUE(rig.runUntil([&] { return !rig.searching(); }, 14s));
    ASSERT_EQ(rig.bus.count<ConnectFailed>(), 1U);
    ASSERT_TRUE(rig.runUntil([&] { return rig.bus.now >= *owed.deafUntil; }, 15s));
    EXPECT_TRUE(rig.runUntil([&] { return rig.atRest(0); }, kSoon)) << "it must stop once it hears";
    EXPECT_THAT(rig.complaints, IsEmpty());
}

TEST_P(OwedStopAcross, AChangeOfDistrust) {
    OwedStop owed(GetParam(), 2);
    Rig& rig = owed.rig;
    ASSERT_TRUE(setRunning(rig, 0));
    owed.deafFromItsStopOn(Deaf::Module, 400ms);
    ASSERT_TRUE(owed.cause(StopCause::HoldExpired));
    rig.run(100ms);
    rig.distrust();
    ASSERT_TRUE(rig.runUntil([&] { return rig.bus.now >= *owed.deafUntil; }, 1s));
    EXPECT_TRUE(rig.runUntil([&] { return rig.atRest(0); }, kSoon)) << "it must stop once it hears";
    rig.run(kSoon);
    EXPECT_EQ(owed.confirmed().size(), 1U);
    EXPECT_THAT(rig.complaints, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Rates, OwedStopAcross, testing::Values(19'200U, 115'200U));

/// The result of a stop of all modules is reported by StopFinished; what was owed before is part of it.
TEST(OwedStopUnderAStopOfAll, IsNotConfirmedBesideIt) {
    OwedStop owed(115'200, 2);
    Rig& rig = owed.rig;
    ASSERT_TRUE(setRunning(rig, 0));
    owed.deafFromItsStopOn(Deaf::Module, 300ms);
    ASSERT_TRUE(owed.cause(StopCause::HoldReleased));
    rig.run(350ms);
    rig.stopAll();
    rig.runToRest();
    EXPECT_TRUE(rig.atRest(0));
    EXPECT_EQ(rig.stopsFinished(), 1U);
    EXPECT_LE(owed.confirmed().size(), 1U);
    EXPECT_THAT(rig.complaints, IsEmpty());
}

/// Nothing is owed to a motor that the operator has started again.
TEST(OwedStopOfAMotorThatIsHeldAgain, IsOwedNoMore) {
    OwedStop owed(115'200, 2);
    Rig& rig = owed.rig;
    ASSERT_TRUE(setRunning(rig, 0));
    owed.deafFromItsStopOn(Deaf::Module, 300ms);
    ASSERT_TRUE(owed.cause(StopCause::HoldReleased));
    rig.hold(holdOn(0, rig.world.chain[0], 60), 4s, false);
    rig.run(3s);
    EXPECT_FALSE(rig.atRest(0)) << "the button is down";
    rig.run(2s);
    EXPECT_TRUE(rig.atRest(0));
}

}  // namespace

}  // namespace nmc::test
