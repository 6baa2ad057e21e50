// SPDX-License-Identifier: GPL-3.0-or-later
// Each test of a loop with each trouble that a motor, a line or a user can cause: the test ends soon, the
// motor is then off or held, a reason is given, no model results, and all modules share the bus again. Engine
// and simulator in virtual time, checked against the state of the simulator.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "model/response/responserecord.h"
#include "model/tuning/identify.h"
#include "tests/procedures/procedurebench.h"
#include "tests/support/tunedservo.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

enum class Kind : std::uint8_t { Step, Square, Sines, Gains };
enum class Trouble : std::uint8_t {
    Jammed,     ///< the shaft is held
    Reversed,   ///< the encoder counts the wrong way
    HardStop,   ///< in the middle of the step
    LimitStop,  ///< by the chip itself, which is set up to stop there
    Unstable,   ///< the gains make the oscillation grow
    Slips,      ///< the shaft turns some degrees before the encoder does
    PowerLost,  ///< and back a second after the end of the test
    Lossy,      ///< one frame in seven is damaged
    Mute,       ///< no answer for 0.3 s
    Deaf,       ///< no command arrives for 0.3 s
    Restarted,
    StopAll,
    MotorOff,
    Cancel,
};

struct Name {
    std::string operator()(const testing::TestParamInfo<std::tuple<Kind, Trouble>>& info) const {
        constexpr std::array kKinds{"Step", "Square", "Sines", "Gains"};
        constexpr std::array kTroubles{"Jammed",    "Reversed",  "HardStop", "LimitStop", "Unstable",
                                       "Slips",     "PowerLost", "Lossy",    "Mute",      "Deaf",
                                       "Restarted", "StopAll",   "MotorOff", "Cancel"};
        return std::string(kKinds.at(static_cast<std::size_t>(std::get<0>(info.param)))) + "_" +
               kTroubles.at(static_cast<std::size_t>(std::get<1>(info.param)));
    }
};

class BadBench : public testing::TestWithParam<std::tuple<Kind, Trouble>> {
protected:
    static constexpr servo::SetGain kGood{200, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}};
    static constexpr servo::SetGain kOther{250, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}};
    /// Without damping, the delay of a tick makes it oscillate; the output limit leaves time to notice.
    static constexpr servo::SetGain kUnstable{5'000, 0, 0, 0, 60, 0, 16'000, 1, std::uint8_t{0}};

    [[nodiscard]] static Kind kind() { return std::get<0>(GetParam()); }
    [[nodiscard]] static Trouble trouble() { return std::get<1>(GetParam()); }
    [[nodiscard]] static sim::ChainOptions options() {
        sim::ChainOptions options;
        if (trouble() == Trouble::Slips)
            options.motor.playCounts = 30;
        return options;
    }
    /// A module that restarts on a faster chain ends all polls (faults.md F-16).
    [[nodiscard]] static std::uint32_t baud() { return trouble() == Trouble::Restarted ? 19'200 : 115'200; }
    [[nodiscard]] Intent wanted() const {
        switch (kind()) {
            case Kind::Step:
                return intent::StepResponse{100, ResponseMethod::StopHere, 2.0};
            case Kind::Square:
                return intent::SquareWave{100, 0.4, 6, 200};
            case Kind::Sines:
                return intent::FrequencyResponse{20, 2.0, 6.0};
            case Kind::Gains:
                return intent::TryGains{trouble() == Trouble::Unstable ? kUnstable : kOther, 4.0};
        }
        return intent::CancelProcedure{};
    }
    [[nodiscard]] servo::SetGain gains() const {
        return trouble() == Trouble::Unstable && kind() != Kind::Gains ? kUnstable : kGood;
    }
    /// Makes the servo hold at 0, with the troubles that exist from the beginning.
    void hold() {
        ASSERT_TRUE(bench.connect() && bench.perform(intent::AskAnew{}) &&
                    bench.perform(intent::ApplyGains{gains()}) && bench.perform(intent::Enable{}) &&
                    bench.perform(intent::StopHere{}));
        if (trouble() == Trouble::Jammed)
            bench.fault(sim::FaultKind::Stall);
        if (trouble() == Trouble::Reversed)
            bench.fault(sim::FaultKind::Reverse);
        if (trouble() == Trouble::HardStop)
            bench.set(sim::Input::TravelMax, 10.0);
        if (trouble() == Trouble::LimitStop) {
            bench.putSwitch(sim::Input::Limit2, 10.0, false);
            ASSERT_TRUE(bench.perform(intent::ArmLimitStop{false, true, HomingRecipe::Stop::Abruptly}));
        }
    }
    void fault(sim::FaultKind fault, double probability, std::optional<Duration> lasts) {
        sim::FaultSpec spec;
        spec.kind = fault;
        spec.probability = probability;
        spec.lasts = lasts;
        EXPECT_TRUE(bench.bus.chain.inject(spec, bench.bus.now).has_value());
    }
    /// Causes the trouble while the test is running.
    void strike() {
        switch (trouble()) {
            case Trouble::PowerLost:
                return bench.set(sim::Input::Power, 0.0);
            case Trouble::Lossy:
                return fault(sim::FaultKind::Flip, 0.15, {});
            case Trouble::Mute:
                return fault(sim::FaultKind::MuteRx, 1.0, 300ms);
            case Trouble::Deaf:
                return fault(sim::FaultKind::MuteTx, 1.0, 300ms);
            case Trouble::Restarted:
                return bench.bus.chain.powerCycle(ModuleIndex(0), bench.bus.now);
            case Trouble::StopAll:
                return bench.stopAll();
            case Trouble::MotorOff:
                return bench.switchOff();
            case Trouble::Cancel:
                return bench.procedure->cancel();
            case Trouble::Unstable:  // something touches the shaft
                bench.set(sim::Input::Load, 0.05);
                bench.bus.runFor(4ms);
                return bench.set(sim::Input::Load, 0.0);
            case Trouble::Jammed:
            case Trouble::Reversed:
            case Trouble::HardStop:
            case Trouble::LimitStop:
            case Trouble::Slips:
                return;  // these exist from the beginning
        }
    }
    /// Number of statuses from each module while `passes` lets the virtual time pass.
    template <typename Passes>
    [[nodiscard]] std::array<std::size_t, 3> statuses(Passes passes) {
        const auto count = [this] {
            std::array<std::size_t, 3> of{};
            for (std::uint8_t i = 0; i < 3; ++i)
                of[i] = bench.bus.samplesOf(i);
            return of;
        };
        const auto before = count();
        passes();
        auto all = count();
        for (std::size_t i = 0; i < 3; ++i)
            all[i] -= before[i];
        return all;
    }
    /// Runs the test until its trouble is due.
    void underWay() {
        const ProcedureStage stage = kind() == Kind::Gains ? ProcedureStage::Trying : ProcedureStage::Moving;
        if (!bench.runTo(stage, 5.0))
            return;
        const auto all = statuses([this] {
            const bool atOnce = trouble() == Trouble::Mute || trouble() == Trouble::Deaf;
            for (int i = 0; i < (atOnce ? 1 : 40) && bench.turn(); ++i) {
            }
        });
        if (!bench.procedure->report().over() && bench.procedure->report().stage == stage) {
            EXPECT_GE(all[0], 5 * (all[1] + all[2])) << "the module under test has most of the bus";
        }
    }
    void keepEdge() {
        const auto& edge = bench.procedure->report().step;
        if (edge && (edges.empty() || edges.back() != *edge))
            edges.push_back(*edge);
    }
    [[nodiscard]] ResponseRecord recordOf(const ResponseTaken& taken) const {
        std::vector<ScopeSample> samples;
        for (const auto& sample : bench.bus.all<bus::Sample>())
            if (sample.module == ModuleIndex(0) && sample.report.position) {
                samples.emplace_back();
                samples.back().time = sample.time;
                samples.back().position = *sample.report.position;
            }
        return takeRun(ModuleIndex(0), samples, taken, kFirstBand);
    }

    void expectReason(const ProcedureReport& report) const;
    void expectOffOrHeld();
    void expectNoModel(const ProcedureReport& report) const;
    void expectNoModel(const ResponseTaken& taken) const;
    void expectGainsFromBefore();
    void expectTheBusIsEverybodys();

    ProcedureBench bench{servos(3, servoVersion()), options(), baud()};
    std::vector<ResponseTaken> edges;
};

/// Checks the reason that is shown to the user.
void BadBench::expectReason(const ProcedureReport& report) const {
    ASSERT_TRUE(report.over());
    const auto failed = [&](std::initializer_list<ProcedureFailure> any) {
        EXPECT_EQ(report.stage, ProcedureStage::Failed);
        ASSERT_TRUE(report.failure);
        EXPECT_EQ(std::count(any.begin(), any.end(), *report.failure), 1)
            << "failure " << static_cast<int>(*report.failure);
    };
    // If the shaft does not move at all, or not far, the step shows it, and identify() says so; trying gains
    // requires no motion.
    const bool moves = kind() != Kind::Gains;
    using enum ProcedureFailure;
    switch (trouble()) {
        case Trouble::Jammed:
        case Trouble::HardStop:
            if (kind() == Kind::Sines)
                return failed({NotFollowing});
            EXPECT_EQ(report.stage, ProcedureStage::Done);
            return;
        case Trouble::Reversed:
            if (moves)
                return failed({TravelLimit, Unstable, WentOff});
            EXPECT_EQ(report.stage, ProcedureStage::Done);
            return;
        case Trouble::LimitStop:
            if (moves)
                return failed({StoppedShort});
            EXPECT_EQ(report.stage, ProcedureStage::Done);
            return;
        case Trouble::Unstable:
            return moves ? failed({TravelLimit, Unstable, WentOff}) : failed({Swings, Saturates});
        case Trouble::Slips:
            return report.stage == ProcedureStage::Done ? void() : failed({NotStill, NotFollowing, Swings});
        case Trouble::PowerLost:
            return failed({WentOff});
        case Trouble::Mute:
        case Trouble::Deaf:
            // A gap in a record shows in its figures; a sine with a gap is repeated.
            if (report.stage == ProcedureStage::Done)
                return;
            [[fallthrough]];
        case Trouble::Lossy:
        case Trouble::Restarted:
            return failed({LinkSuspect, Refused, ModuleUnresponsive});
        case Trouble::StopAll:
        case Trouble::MotorOff:
        case Trouble::Cancel:
            EXPECT_EQ(report.stage, ProcedureStage::Cancelled);
            return;
    }
}

void BadBench::expectOffOrHeld() {
    // In counts: friction and the integral term may move it by a few, and within its play no motion is seen.
    const double held = 8.0 + static_cast<double>(options().motor.playCounts);
    const auto at = bench.truth();
    double farthest = 0.0;
    bool moved = false;
    bool wentOn = false;
    const TimePoint end = bench.bus.now + 2s;
    while (bench.bus.now < end) {
        bench.bus.runFor(1ms);
        const auto now = bench.truth();
        farthest = std::max(farthest, std::abs(now.shaftCounts - at.shaftCounts));
        moved = moved || (now.servoOn && now.commandPosition != at.commandPosition);
        wentOn = wentOn || (now.servoOn && !at.servoOn);
    }
    EXPECT_FALSE(wentOn) << "nothing switches it on again";
    EXPECT_FALSE(moved) << "its command position no longer changes";
    EXPECT_LE(at.servoOn ? farthest : 0.0, held);
    EXPECT_EQ(at.servoOn ? 0 : bench.truth().pwm, 0);
}

/// Checks what the program keeps of a test: whole steps (LoopTestController::followSteps()), forward
/// edges (SquareWavePage).
void BadBench::expectNoModel(const ProcedureReport& report) const {
    const bool whole = report.stage == ProcedureStage::Done || report.failure == ProcedureFailure::NotStill;
    if (kind() == Kind::Step && report.step && whole)
        expectNoModel(*report.step);
    if (kind() == Kind::Square)
        for (const ResponseTaken& edge : edges)
            if (edge.goal > edge.from && edge != edges.back())
                expectNoModel(edge);
}

/// What was recorded before the trouble began, or next to a silence of the line, may describe the motor, and
/// so may an edge, or a step of a CMC or SC, that begins with the play taken up. The model must then be that
/// of the simulated motor.
void BadBench::expectNoModel(const ResponseTaken& taken) const {
    const auto found = identify(std::array{recordOf(taken)});
    const bool later = hasPathBuffer(bench.modules.front().info.identity);
    const bool maybe =
        trouble() > Trouble::Slips || (trouble() == Trouble::Slips && (kind() == Kind::Square || later));
    if (!found)
        return;
    EXPECT_TRUE(maybe) << "a model: K " << found->motor.gain.value << " tau "
                       << found->motor.timeConstant.value;
    const MotorConstants truth = testing_support::physics(sim::MotorParameters{});
    const auto expectRight = [](const Measured& value, double truly) {
        EXPECT_NEAR(value.value, truly, std::max(0.1 * truly, 2 * value.doubt));
    };
    expectRight(found->motor.gain, truth.gain);
    expectRight(found->motor.timeConstant, truth.timeConstant);
}

void BadBench::expectGainsFromBefore() {
    if (kind() != Kind::Gains || trouble() == Trouble::Restarted)
        return;  // a restarted module has no gains and is off
    const sim::Gains now = bench.truth().gains;
    EXPECT_EQ(now.kp, kGood.kp);
    EXPECT_EQ(now.kd, kGood.kd);
    EXPECT_EQ(now.ol, kGood.ol);
    EXPECT_EQ(now.el, kGood.el);
}

void BadBench::expectTheBusIsEverybodys() {
    bench.bus.runFor(5s);  // until silent modules are queried again
    const auto all = statuses([this] { bench.bus.runFor(1s); });
    EXPECT_GT(all[1], 10U);
    EXPECT_NEAR(static_cast<double>(all[1]), static_cast<double>(all[2]), 3.0);
    if (trouble() != Trouble::Restarted) {
        EXPECT_NEAR(static_cast<double>(all[0]), static_cast<double>(all[1]), 3.0);
    }
}

TEST_P(BadBench, EndsOffOrHeldWithAReasonAndNoModel) {
    ASSERT_NO_FATAL_FAILURE(hold());
    ASSERT_NO_FATAL_FAILURE(bench.begin(wanted()));
    bench.onTurn = [this](Procedure&) { keepEdge(); };
    ASSERT_NO_FATAL_FAILURE(underWay());
    if (!bench.procedure->report().over()) {
        strike();
        ASSERT_NO_FATAL_FAILURE(std::ignore = bench.goOn(20.0));
    }
    if (trouble() == Trouble::Lossy)
        bench.bus.chain.clearFaults(bench.bus.now);
    const ProcedureReport report = bench.procedure->report();
    expectReason(report);
    expectNoModel(report);
    bench.bus.runFor(1s);
    if (trouble() == Trouble::PowerLost)
        bench.set(sim::Input::Power, 1.0);
    expectOffOrHeld();
    expectGainsFromBefore();
    expectTheBusIsEverybodys();
    bench.bus.expectNoViolations();
}
INSTANTIATE_TEST_SUITE_P(All, BadBench,
                         testing::Combine(testing::Values(Kind::Step, Kind::Square, Kind::Sines, Kind::Gains),
                                          testing::Values(Trouble::Jammed, Trouble::Reversed,
                                                          Trouble::HardStop, Trouble::LimitStop,
                                                          Trouble::Unstable, Trouble::Slips,
                                                          Trouble::PowerLost, Trouble::Lossy, Trouble::Mute,
                                                          Trouble::Deaf, Trouble::Restarted, Trouble::StopAll,
                                                          Trouble::MotorOff, Trouble::Cancel)),
                         Name());

}  // namespace
}  // namespace nmc::test
