// SPDX-License-Identifier: GPL-3.0-or-later
// Issue 13, "What must be true afterwards", 1 and 2: a stop always acts, in any phase; and it has three
// outcomes, never two. Each of these sentences has a test for each phase; the oath (stopoath.h) is checked
// throughout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/sessions/operator.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;

/// What has become of the connection to a known chain.
enum class Phase : std::uint8_t {
    Connected,
    LookingAgain,   ///< "Scan again" is under way
    FoundNobody,    ///< the search has found nothing, since the line was dead just then
    LinkLost,       ///< nothing has answered for some seconds; now the modules would
    SecondConnect,  ///< a connect follows the stop at once
};

struct PhaseCase {
    Phase phase;
    std::uint32_t baud;

    friend void PrintTo(const PhaseCase& c, std::ostream* stream) {
        static constexpr std::array kPhases{"Connected", "LookingAgain", "FoundNobody", "LinkLost",
                                            "SecondConnect"};
        *stream << kPhases.at(static_cast<std::size_t>(c.phase)) << c.baud;
    }
};

/// Two servos in velocity mode and a stepper.
[[nodiscard]] World threeAt(std::uint32_t baud) {
    World world;
    world.chain = {{ModuleType::Servo, 4}, {ModuleType::Servo, 1}, {ModuleType::Stepper, 1}};
    world.baud = baud;
    return world;
}

[[nodiscard]] std::vector<int> numbers(const std::vector<ModuleIndex>& modules) {
    std::vector<int> n;
    for (const ModuleIndex m : modules)
        n.push_back(m.value());
    return n;
}

class StopInPhase : public testing::TestWithParam<PhaseCase> {
protected:
    /// Sets the motors in motion and enters the phase; the stop comes next. `bytes` cross the wire before it,
    /// of the search if there is one.
    void enter(Rig& rig, std::uint64_t bytes) {
        ASSERT_TRUE(setRunning(rig, 3));
        switch (GetParam().phase) {
            case Phase::Connected:
            case Phase::SecondConnect:
                return rig.runBytes(bytes, 1s);
            case Phase::LookingAgain:
                rig.connect();
                return rig.runBytes(bytes, 1s);
            case Phase::FoundNobody:
                silence(rig);
                rig.connect();
                ASSERT_TRUE(rig.runUntil([&] { return !rig.searching(); }, StopOath::kSearchBound));
                break;
            case Phase::LinkLost:
                silence(rig);
                ASSERT_TRUE(rig.runUntil([&] { return rig.lost; }, 10s));
                rig.run(300ms);
                break;
        }
        rig.clearFaults();
    }
    static void silence(Rig& rig) {
        rig.fault("mute tx", kForLong, true);
        rig.fault("mute rx", kForLong, false);
    }
    /// Requests the stop, and runs to its end.
    void stop(Rig& rig) {
        rig.stopAll();
        if (GetParam().phase == Phase::SecondConnect)
            rig.connect();
        EXPECT_TRUE(rig.runUntil([&] { return !rig.stopping(); }, StopOath::kStopBound));
    }
    /// The first bytes of a search, and some in the middle of it.
    static constexpr std::array<std::uint64_t, 6> kMoments{0, 1, 17, 40, 150, 500};
};

/// As long as the port is open, stops are sent to the last known chain at its last known rate (nulls, then
/// stops that need no answer), and then its modules are queried.
TEST_P(StopInPhase, TellsTheChainThatWasKnownLastAndThenAsksIt) {
    for (const std::uint64_t bytes : kMoments) {
        SCOPED_TRACE(bytes);
        Rig rig(threeAt(GetParam().baud));
        ASSERT_NO_FATAL_FAILURE(enter(rig, bytes));
        const std::size_t from = rig.wire.size();
        rig.stopAll();
        rig.run(StopOath::kStopBound);
        std::size_t told = from;
        for (std::uint8_t place = 0; place < 3; ++place) {
            std::size_t i = from;
            while (i < rig.wire.size() && !rig.wire[i].isStopFor(place))
                ++i;
            ASSERT_LT(i, rig.wire.size()) << "no stop for module " << int{place};
            EXPECT_EQ(rig.wire[i].baud, GetParam().baud);
            told = std::max(told, i);
        }
        for (std::uint8_t address = 1; address <= 3; ++address) {
            const auto asks = [&](const WireItem& item) {
                return (item.code() == CommandCode::ReadStatus || item.code() == CommandCode::Nop ||
                        item.code() == CommandCode::DefineStatus) &&
                       item.address() == address;
            };
            EXPECT_TRUE(
                std::any_of(rig.wire.begin() + static_cast<std::ptrdiff_t>(told), rig.wire.end(), asks))
                << "module " << int{address} << " is queried after its stop";
        }
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

/// The old chain is kept until the new one is found, and is confirmed when its modules answer.
TEST_P(StopInPhase, StopsEveryModuleThatHearsAndSaysSo) {
    for (const std::uint64_t bytes : kMoments) {
        SCOPED_TRACE(bytes);
        Rig rig(threeAt(GetParam().baud));
        ASSERT_NO_FATAL_FAILURE(enter(rig, bytes));
        stop(rig);
        ASSERT_EQ(rig.stopsFinished(), 1U);
        EXPECT_THAT(numbers(rig.bus.last<StopFinished>()->stopped), ElementsAre(0, 1, 2));
        rig.runToRest();
        for (std::uint8_t place = 0; place < 3; ++place)
            EXPECT_TRUE(rig.atRest(place)) << int{place};
        EXPECT_EQ(rig.stopsFinished(), 1U);
        rig.expectEnds();
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

/// A module that does not answer is reported as not reached: it hears, and its motor stops, but nothing shows
/// it.
TEST_P(StopInPhase, CallsAModuleThatDoesNotAnswerUnreached) {
    Rig rig(threeAt(GetParam().baud));
    ASSERT_NO_FATAL_FAILURE(enter(rig, 40));
    rig.fault("silent", kForLong, false, 1);
    stop(rig);
    ASSERT_EQ(rig.stopsFinished(), 1U);
    const StopFinished finished = *rig.bus.last<StopFinished>();
    EXPECT_THAT(numbers(finished.stopped), ElementsAre(0, 2));
    EXPECT_THAT(numbers(finished.unreached), ElementsAre(1));
    EXPECT_THAT(finished.unconfirmed, IsEmpty());
    EXPECT_TRUE(rig.atRest(1));
    EXPECT_THAT(rig.complaints, IsEmpty());
}

/// A module that is not seen at rest is reported as not confirmed: it answers that it is still moving.
TEST_P(StopInPhase, CallsAModuleThatMovesOnUnconfirmed) {
    Rig rig(threeAt(GetParam().baud));
    ASSERT_NO_FATAL_FAILURE(enter(rig, 40));
    rig.fault("ignore=stop_motor", kForLong, true, 0);
    stop(rig);
    ASSERT_EQ(rig.stopsFinished(), 1U);
    const StopFinished finished = *rig.bus.last<StopFinished>();
    EXPECT_THAT(numbers(finished.stopped), ElementsAre(1, 2));
    EXPECT_THAT(numbers(finished.unconfirmed), ElementsAre(0));
    EXPECT_THAT(finished.unreached, IsEmpty());
    EXPECT_FALSE(rig.atRest(0));
    EXPECT_THAT(rig.complaints, IsEmpty());
}

/// A shaft that a load drives after its motor was switched off is not a motor at rest.
TEST_P(StopInPhase, CallsAShaftThatALoadDrivesUnconfirmed) {
    Rig rig(threeAt(GetParam().baud));
    ASSERT_NO_FATAL_FAILURE(enter(rig, 40));
    // The power of its driver fails, so the servo switches off and stays off (DS-V 4.5).
    rig.bus.chain.set(ModuleIndex(0), sim::Input::Power, 0.0, rig.bus.now);
    rig.load(0, 0.02);
    rig.run(200ms);
    ASSERT_FALSE(rig.atRest(0));
    stop(rig);
    ASSERT_EQ(rig.stopsFinished(), 1U);
    EXPECT_THAT(numbers(rig.bus.last<StopFinished>()->stopped), ElementsAre(1, 2));
    EXPECT_THAT(numbers(rig.bus.last<StopFinished>()->unconfirmed), ElementsAre(0));
    EXPECT_THAT(rig.complaints, IsEmpty());
}

/// Commands may still arrive (faults.md F-19), but no module can be confirmed.
TEST_P(StopInPhase, ConfirmsNobodyWhenNothingIsHeard) {
    Rig rig(threeAt(GetParam().baud));
    ASSERT_NO_FATAL_FAILURE(enter(rig, 40));
    rig.fault("mute rx", kForLong, false);
    stop(rig);
    ASSERT_EQ(rig.stopsFinished(), 1U);
    EXPECT_THAT(rig.bus.last<StopFinished>()->stopped, IsEmpty());
    EXPECT_THAT(numbers(rig.bus.last<StopFinished>()->unreached), ElementsAre(0, 1, 2));
    for (std::uint8_t place = 0; place < 3; ++place)
        EXPECT_TRUE(rig.atRest(place)) << int{place};
    EXPECT_THAT(rig.complaints, IsEmpty());
}

TEST_P(StopInPhase, EndsOnceWhenItIsAskedForTwice) {
    for (const std::uint64_t between : {0U, 20U, 60U}) {
        SCOPED_TRACE(between);
        Rig rig(threeAt(GetParam().baud));
        ASSERT_NO_FATAL_FAILURE(enter(rig, 40));
        rig.stopAll();
        rig.runBytes(between, 100ms);
        const bool first = !rig.stopping();
        rig.stopAll();
        rig.runToRest();
        EXPECT_EQ(rig.stopsFinished(), first ? 2U : 1U);
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Phases, StopInPhase,
    testing::Values(PhaseCase{Phase::Connected, 19'200}, PhaseCase{Phase::Connected, 115'200},
                    PhaseCase{Phase::LookingAgain, 19'200}, PhaseCase{Phase::LookingAgain, 115'200},
                    PhaseCase{Phase::FoundNobody, 19'200}, PhaseCase{Phase::FoundNobody, 115'200},
                    PhaseCase{Phase::LinkLost, 19'200}, PhaseCase{Phase::LinkLost, 115'200},
                    PhaseCase{Phase::SecondConnect, 19'200}, PhaseCase{Phase::SecondConnect, 115'200}),
    testing::PrintToStringParamName());

// ---- Where no chain has been known yet ----

class StopBeforeAChainIsKnown : public testing::TestWithParam<std::uint32_t> {
protected:
    /// Leaves the chain running, as another program may have done.
    void leaveBehind(Rig& rig) {
        ASSERT_TRUE(setRunning(rig, 3));
        rig.replaceEngine(GetParam());
    }
};

/// This is also the case of closing the panel while it connects.
TEST_P(StopBeforeAChainIsKnown, WaitsForTheSearchAndThenActs) {
    for (const std::uint64_t bytes : {0U, 1U, 17U, 40U, 150U, 500U}) {
        SCOPED_TRACE(bytes);
        Rig rig(threeAt(GetParam()));
        ASSERT_NO_FATAL_FAILURE(leaveBehind(rig));
        rig.connect();
        rig.runBytes(bytes, 1s);
        const bool known = rig.known.has_value();
        rig.stopAll();
        ASSERT_TRUE(rig.runUntil([&] { return !rig.stopping(); },
                                 known ? Duration(StopOath::kStopBound) : StopOath::kSearchBound));
        EXPECT_THAT(numbers(rig.bus.last<StopFinished>()->stopped), ElementsAre(0, 1, 2));
        rig.runToRest();
        EXPECT_EQ(rig.stopsFinished(), 1U);
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

/// Modules that were only seen do not count as stopped when an attach fails late: the second module answers
/// the search, but never reports its identity.
TEST_P(StopBeforeAChainIsKnown, CallsNobodyStoppedWhenTheSearchFailsLate) {
    for (const std::uint64_t bytes : {0U, 40U, 150U, 400U}) {
        SCOPED_TRACE(bytes);
        Rig rig(threeAt(GetParam()));
        ASSERT_NO_FATAL_FAILURE(leaveBehind(rig));
        rig.bus.fault("module 2 silent on=read_status");
        rig.faultsUntil = rig.bus.now + kForLong;
        rig.connect();
        rig.runBytes(bytes, 1s);
        rig.stopAll();
        ASSERT_TRUE(
            rig.runUntil([&] { return !rig.stopping() && !rig.searching(); }, StopOath::kSearchBound));
        ASSERT_EQ(rig.bus.count<ConnectFailed>(), 1U);
        EXPECT_THAT(rig.bus.last<StopFinished>()->stopped, IsEmpty());
        rig.runToRest();
        EXPECT_EQ(rig.stopsFinished(), 1U);
        EXPECT_THAT(rig.complaints, IsEmpty());
    }
}

/// A stop always acts: it can be sent to a module that has reported its identity at that rate.
TEST_P(StopBeforeAChainIsKnown, StopsWhoeverHasSaidWhatItIsWhenTheSearchFailsLate) {
    Rig rig(threeAt(GetParam()));
    ASSERT_NO_FATAL_FAILURE(leaveBehind(rig));
    rig.bus.fault("module 2 silent on=read_status");
    rig.faultsUntil = rig.bus.now + kForLong;
    rig.connect();
    rig.runBytes(40, 1s);
    rig.stopAll();
    ASSERT_TRUE(rig.runUntil([&] { return !rig.stopping() && !rig.searching(); }, StopOath::kSearchBound));
    rig.run(StopOath::kStopBound);
    EXPECT_TRUE(rig.atRest(0));
}

TEST_P(StopBeforeAChainIsKnown, EndsWithASearchThatFindsNobody) {
    Rig rig(threeAt(GetParam()));
    rig.fault("mute rx", kForLong, false);
    rig.connect();
    rig.runBytes(40, 1s);
    rig.stopAll();
    rig.runToRest();
    ASSERT_EQ(rig.stopsFinished(), 1U);
    EXPECT_THAT(rig.bus.last<StopFinished>()->stopped, IsEmpty());
    EXPECT_THAT(rig.complaints, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Rates, StopBeforeAChainIsKnown, testing::Values(19'200U, 57'600U, 115'200U));

// ---- While the chain itself is being changed ----

/// Some modules have been reset, and some have not.
TEST(StopWhileTheNetworkRestarts, StopsWhoeverStillRuns) {
    for (const std::uint32_t baud : {19'200U, 57'600U, 115'200U})
        for (const std::uint64_t bytes : {0U, 1U, 19U, 200U, 520U, 700U, 1'200U, 2'000U, 2'300U}) {
            SCOPED_TRACE(testing::Message() << baud << " Bd, " << bytes << " bytes");
            Rig rig(threeAt(baud));
            ASSERT_TRUE(setRunning(rig, 3));
            rig.restart();
            rig.runBytes(bytes, 2s);
            rig.stopAll();
            rig.runToRest();
            for (std::uint8_t place = 0; place < 3; ++place)
                EXPECT_TRUE(rig.atRest(place)) << int{place};
            EXPECT_EQ(rig.stopsFinished(), 1U);
            rig.expectEnds();
            EXPECT_THAT(rig.complaints, IsEmpty());
        }
}

/// Each module is at one of two rates.
TEST(StopWhileTheRateChanges, StopsWhoeverIsAtEither) {
    for (const std::uint32_t to : {19'200U, 115'200U})
        for (std::uint64_t bytes = 0; bytes < 160; bytes += 3) {
            SCOPED_TRACE(testing::Message() << to << " Bd, " << bytes << " bytes");
            Rig rig(threeAt(57'600));
            ASSERT_TRUE(setRunning(rig, 0));
            rig.changeRate(to);
            rig.runBytes(bytes, 1s);
            rig.stopAll();
            rig.runToRest();
            ASSERT_EQ(rig.stopsFinished(), 1U);
            EXPECT_THAT(numbers(rig.bus.last<StopFinished>()->stopped), ElementsAre(0, 1, 2));
            rig.expectEnds();
            EXPECT_THAT(rig.complaints, IsEmpty());
        }
}

}  // namespace

}  // namespace nmc::test
