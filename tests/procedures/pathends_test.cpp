// SPDX-License-Identifier: GPL-3.0-or-later
// Paths on a line that loses packets, and paths that end early: a loss is noticed, and nothing is added
// twice; after any stop, nothing of a path is sent, and no motor moves.
#include <functional>
#include <string>

#include "tests/procedures/pathbench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using servo::PathRate;

/// Loses the frame with this number, counted from 1, or the reply to it, once.
class Loss {
public:
    Loss(PathBench& bench, std::size_t frame, bool command) {
        auto seen = std::make_shared<std::size_t>(0);
        if (command)
            bench.bus.onCommand = [=](std::vector<std::uint8_t>& packet) {
                if (PathBench::isFrame(packet) && ++*seen == frame)
                    packet.clear();
            };
        else
            bench.bus.losesReply = [=](ByteSpan packet) {
                return PathBench::isFrame(packet) && ++*seen == frame;
            };
    }
};

struct Lost {
    std::size_t frame;
    bool command;
};
class PathThatLosesAFrame : public testing::TestWithParam<Lost> {};

/// 300 points: 18 frames fill the buffer, and the last of the 25 that follow has six points.
TEST_P(PathThatLosesAFrame, GoesOnAndIsOnEachPoint) {
    PathBench bench(scs());
    ASSERT_TRUE(bench.hold());
    const Loss loss(bench, GetParam().frame, GetParam().command);
    const PathTable table = bench.swings(PathRate::Hz60, 300);
    const ProcedureReport report = bench.runPath(table);
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(bench.wasOnEachPoint(table, 0));
    EXPECT_EQ(bench.frames(), 43U + (GetParam().command ? 1U : 0U))
        << "a frame is sent again only if it was lost";
    bench.bus.expectNoViolations();
}
INSTANTIATE_TEST_SUITE_P(All, PathThatLosesAFrame,
                         testing::Values(Lost{1, true}, Lost{1, false}, Lost{18, true}, Lost{18, false},
                                         Lost{19, true}, Lost{19, false}, Lost{30, true}, Lost{30, false},
                                         Lost{43, true}, Lost{43, false}));

/// Another doubt about the link discards the exchange in progress, whose end is not reported.
TEST(PathThatIsInterrupted, GoesOnAndIsOnEachPoint) {
    for (const std::size_t frame : {5U, 18U, 19U, 30U, 43U}) {
        PathBench bench(scs());
        ASSERT_TRUE(bench.hold());
        bool doubted = false;
        bench.onSlice = [&, note = bench.onSlice] {
            note();
            if (bench.frames() == frame && !std::exchange(doubted, true))
                bench.bus.engine.distrust(bench.bus.now);
        };
        const PathTable table = bench.swings(PathRate::Hz60, 300);
        EXPECT_EQ(bench.runPath(table).stage, ProcedureStage::Done) << frame;
        EXPECT_TRUE(doubted);
        EXPECT_TRUE(bench.wasOnEachPoint(table, 0)) << frame;
        bench.bus.expectNoViolations();
    }
}

class PathEnds : public testing::Test {
protected:
    void begin(std::size_t axes = 3, std::size_t points = 2'000) {
        ASSERT_TRUE(bench.hold());
        ASSERT_TRUE(bench.group());
        PathTable table = bench.swings(PathRate::Hz60, points);
        table.columns.resize(axes);
        bench.follow(table);
        ASSERT_TRUE(bench.runToPoint(300));
    }
    /// Expects that all motors stand still, and that no path frame was sent after this entry of bus.sent.
    void expectAllStand(std::size_t since) {
        bench.settle();
        bench.bus.runFor(1s);  // smooth stops have ended
        for (std::uint8_t i = 0; i < bench.modules.size(); ++i) {
            EXPECT_TRUE(bench.stands(i)) << int{i};
            if (bench.bus.servo(i).servoOn) {
                EXPECT_EQ(bench.bus.servo(i).later->pathPoints, 0U) << int{i};
            }
            EXPECT_FALSE(bench.bus.servo(i).later->pathMode) << int{i};
        }
        EXPECT_EQ(bench.frames(since), 0U) << "nothing of a path is sent after a stop";
        bench.bus.expectNoViolations();
    }
    [[nodiscard]] std::optional<bus::PathEnd> how() const {
        const auto last = bench.bus.last<bus::PathProgress>();
        return last ? last->end : std::nullopt;
    }
    /// Index of the first stop from this entry of bus.sent on.
    [[nodiscard]] std::size_t firstStop(std::size_t from) const {
        for (std::size_t i = from; i < bench.bus.sent.size(); ++i)
            if (const auto& b = bench.bus.sent[i].bytes;
                b.size() > 4 && b[0] == 0xAA && (b[2] & 0x0FU) == 0x07)
                return i;
        ADD_FAILURE() << "no stop was sent";
        return bench.bus.sent.size();
    }
    PathBench bench{scs(3)};
};

struct PathStop {
    std::string name;
    std::function<void(PathBench&)> stop;
};
class PathIsEnded : public PathEnds, public testing::WithParamInterface<PathStop> {};

void ask(PathBench& bench, std::uint8_t module, const Intent& intent) {
    const auto steps = plan(intent, bench.modules.at(module));
    ASSERT_TRUE(steps);
    bench.bus.submit(*steps);
}

TEST_P(PathIsEnded, ForAllItsAxes) {
    begin();
    const std::size_t before = bench.bus.sent.size();
    GetParam().stop(bench);
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Cancelled);
    EXPECT_EQ(how(), bus::PathEnd::Stopped);
    expectAllStand(firstStop(before));
}
INSTANTIATE_TEST_SUITE_P(
    ByAnyStop, PathIsEnded,
    testing::Values(
        PathStop{"CancelOfTheProcedure", [](PathBench& bench) { bench.procedure->cancel(); }},
        PathStop{"SmoothStop", [](PathBench& bench) { ask(bench, 0, intent::StopSmoothly{}); }},
        PathStop{"AbruptStop", [](PathBench& bench) { ask(bench, 0, intent::StopAbruptly{}); }},
        PathStop{"MotorOff", [](PathBench& bench) { ask(bench, 0, intent::MotorOff{}); }},
        PathStop{"StopOfAnotherAxis", [](PathBench& bench) { ask(bench, 2, intent::StopSmoothly{}); }},
        PathStop{"StopHere", [](PathBench& bench) { ask(bench, 1, intent::StopHere{}); }},
        PathStop{"StopOfAll", [](PathBench& bench) { bench.bus.engine.stopAll(bench.bus.now); }},
        PathStop{"StopOfItsGroup",
                 [](PathBench& bench) {
                     bench.bus.engine.submit(
                         bus::GroupOperation{
                             bus::OperationId(2'000),
                             bus::GroupCommand{PathBench::kGroup, bus::GroupCommand::Action::StopSmoothly}},
                         bench.bus.now);
                 }}),
    [](const auto& named) { return named.param.name; });

/// 300 of 2000 points are done, so the motor moves, and a smooth stop slows down at the loaded acceleration.
TEST_F(PathEnds, SmoothlyWhereAnAccelerationIsLoaded) {
    begin();
    const std::size_t before = bench.bus.sent.size();
    bench.procedure->cancel();
    bench.goOn();
    EXPECT_EQ(bench.bus.sent[firstStop(before)].bytes[3], 0x09) << "it is smooth and keeps the amplifier on";
}

/// The other axes are being stopped smoothly, because the path has ended.
TEST_F(PathEnds, AbruptlyWhereTheOperatorThenStopsItsGroupSo) {
    begin();
    const std::size_t before = bench.bus.sent.size();
    ask(bench, 0, intent::StopSmoothly{});
    const bus::GroupCommand abruptly{PathBench::kGroup, bus::GroupCommand::Action::StopAbruptly};
    bench.bus.engine.submit(bus::GroupOperation{bus::OperationId(2'000), abruptly}, bench.bus.now);
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
    EXPECT_EQ(bench.bus.sends("AA 81 17 05 9D", before), 1U);
    expectAllStand(firstStop(before));
}

TEST_F(PathEnds, WhenTheLineFallsSilent) {
    begin();
    bench.bus.losesReply = [](ByteSpan) { return true; };
    bench.bus.onCommand = [](std::vector<std::uint8_t>& packet) { packet.clear(); };
    const std::size_t silent = bench.bus.sent.size();
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::LinkSuspect);
    EXPECT_EQ(how(), bus::PathEnd::NoAnswer);
    bench.bus.runFor(5s);
    bench.bus.losesReply = {};
    bench.bus.onCommand = {};
    bench.bus.runFor(10s);
    expectAllStand(firstStop(silent));
}

TEST_F(PathEnds, WhenAModuleRestarts) {
    begin();
    bench.bus.chain.powerCycle(ModuleIndex(1), bench.bus.now);
    const std::size_t before = bench.bus.sent.size();
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(how(), bus::PathEnd::NoAnswer);
    bench.bus.runFor(5s);
    expectAllStand(firstStop(before));
}

TEST_F(PathEnds, WhenAMotorIsHeldAndItsServoTrips) {
    begin();
    const std::size_t before = bench.bus.sent.size();
    sim::FaultSpec stall;
    stall.kind = sim::FaultKind::Stall;
    stall.modules = {2};
    ASSERT_TRUE(bench.bus.chain.inject(stall, bench.bus.now).has_value());
    servo::SetGain narrow{200, 2'000, 20, 200, 255, 0, 200, 1, std::uint8_t{0}};
    bench.bus.submit({{ModuleIndex(2), ServoCommand(narrow)}});
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::StoppedShort);
    EXPECT_FALSE(bench.bus.servo(2).servoOn);
    expectAllStand(firstStop(before));
    // Points that arrived after its trip do not remain in the buffer.
    ASSERT_TRUE(bench.ask(2, intent::Enable{}));
    EXPECT_EQ(bench.bus.servo(2).later->pathPoints, 0U);
    EXPECT_TRUE(bench.stands(2));
}

/// Two points are changed on their way although the checksum matches.
TEST_F(PathEnds, WhenItLeadsSomewhereElse) {
    begin();
    bool struck = false;
    bench.bus.onCommand = [&](std::vector<std::uint8_t>& packet) {
        if (struck || !PathBench::isFrame(packet))
            return;
        struck = true;
        packet[4] ^= 0x08U;  // 256 counts more or fewer: bit 11 of the first point and of the second
        packet[6] ^= 0x08U;
        if (((packet[4] ^ packet[6]) & 0x08U) == 0)  // so that the checksum still matches
            packet.back() =
                static_cast<std::uint8_t>(packet.back() + ((packet[4] & 0x08U) != 0 ? 16U : 240U));
    };
    const std::size_t before = bench.bus.sent.size();
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::OffPath);
    expectAllStand(firstStop(before));
}

class PathStarts : public PathEnds {
protected:
    void lay() {
        ASSERT_TRUE(bench.hold());
        ASSERT_TRUE(bench.group());
        bench.follow(bench.swings(PathRate::Hz60, 300));
    }
};

TEST_F(PathStarts, NoneWhenTheStartIsLost) {
    lay();
    bench.bus.onCommand = [](std::vector<std::uint8_t>& packet) {
        if (packet.size() == 4 && packet[2] == 0x0D)
            packet.clear();
    };
    ASSERT_TRUE(bench.turn());
    const std::size_t laying = bench.bus.sent.size();
    EXPECT_EQ(bench.goOn().failure, ProcedureFailure::NotStarted);
    for (const auto& seen : bench.ticks)
        EXPECT_TRUE(seen.empty()) << "none was ever in path mode";
    expectAllStand(firstStop(laying));
}

TEST_F(PathStarts, AllOrNone) {
    lay();
    sim::FaultSpec deaf;
    deaf.kind = sim::FaultKind::Ignore;
    deaf.modules = {1};
    deaf.command = CommandCode::AddPathPoints;
    bench.bus.onCommand = [&](std::vector<std::uint8_t>& packet) {
        if (packet.size() == 4 && packet[2] == 0x0D) {
            EXPECT_TRUE(bench.bus.chain.inject(deaf, bench.bus.now).has_value());
        }
    };
    std::size_t started = 0;
    bench.onSlice = [&, note = bench.onSlice] {
        note();
        if (started == 0 && !bench.ticks[0].empty())
            started = bench.bus.sent.size();
    };
    EXPECT_EQ(bench.goOn().failure, ProcedureFailure::NotStarted);
    EXPECT_FALSE(bench.ticks[0].empty()) << "the others had begun";
    EXPECT_TRUE(bench.ticks[1].empty());
    expectAllStand(started);
}

TEST(PathOfOne, WhoseAnswerToTheStartIsLostGoesOn) {
    PathBench bench(scs());
    ASSERT_TRUE(bench.hold());
    bench.bus.losesReply = [](ByteSpan packet) { return packet.size() == 4 && packet[2] == 0x0D; };
    const PathTable table = bench.swings(PathRate::Hz60, 300);
    EXPECT_EQ(bench.runPath(table).stage, ProcedureStage::Done);
    EXPECT_TRUE(bench.wasOnEachPoint(table, 0));
}

/// planPath() refuses it: nearly nine frames a second with their replies for each of five axes are more than
/// 9600 Bd carry.
TEST(PathOnASlowBus, TellsOfItsUnderRunBeforehand) {
    PathBench bench(scs(5), 9'600);
    ASSERT_TRUE(bench.hold());
    ASSERT_TRUE(bench.group());
    const PathTable table = bench.swings(PathRate::Hz60, 1'000);
    const auto refused = bench.planned(table);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, PathObstacle::Kind::BusTooSlow);
    auto wanted = planPath(table, bench.modules, {115'200, Duration{}});
    ASSERT_TRUE(wanted);
    bench.begin(*wanted);
    std::optional<TimePoint> told;
    bench.onTurn = [&](Procedure& procedure) {
        const auto& path = procedure.report().path;
        if (path && path->runsDry && !told)
            told = bench.bus.now;
    };
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::UnderRun);
    ASSERT_TRUE(told);
    EXPECT_EQ(report.path->end, bus::PathEnd::UnderRun);
    EXPECT_GT(toSeconds(bench.bus.now - *told), 0.3);
    for (std::uint8_t i = 0; i < 5; ++i)
        EXPECT_TRUE(bench.stands(i));
}

}  // namespace
}  // namespace nmc::test
