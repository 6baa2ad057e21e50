// SPDX-License-Identifier: GPL-3.0-or-later
// Travel limits, judged by the shaft itself: engine, chip and motor in virtual time.
//
// The bound is derived as follows. The command position never passes a limit, since every motion towards one
// is a move that ends there (DS-V 4.4: trapezoids end at their goal; a stop on the way slows down sooner). A
// servo that is off by more than EL switches itself off, so while it is on, the shaft passes a limit by less
// than EL. The shaft of a stepper is where its counter is, so a move ends at the limit to the step; but a
// smooth stop that arrives while it slows down begins its ramp again, up to one acceleration time late
// (DS-S 4.2): at 160 x 25 steps/s and 4 x 0.25 ms, that is 4 steps.
#include <random>

#include "model/intent/travel.h"
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

constexpr std::uint16_t kErrorLimit = 300;
constexpr double kStepsOfALateRamp = 4;

/// What the tests of both chips need of an axis: a shaft, its travel limits, and how far it has been beyond
/// them.
class TravelBench : public ProcedureBench {
public:
    explicit TravelBench(ModuleType type)
        : ProcedureBench({{type, static_cast<std::uint8_t>(type == ModuleType::Servo ? 4 : 1)}}),
          m_servo(type == ModuleType::Servo) {
        const auto before = bus.onTime;
        bus.onTime = [this, before] {
            before();
            look();
        };
    }

    [[nodiscard]] bool prepare(std::int32_t lowest, std::int32_t highest) {
        if (!connect())
            return false;
        bus.runFor(200ms);
        take();
        const bool on = m_servo ? perform(intent::ApplyGains{
                                      {200, 2'000, 20, 200, 255, 0, kErrorLimit, 1, std::uint8_t{0}}}) &&
                                      perform(intent::Enable{})
                                : perform(stepperintent::SetParameters{
                                      {stepper::SpeedMode::X1, false, false, false, 4, 200, 50, 0}}) &&
                                      perform(intent::Enable{});
        module().home.declare(module().latestTime);
        module().travel.lowest = m_lowest = lowest;
        module().travel.highest = m_highest = highest;
        return on;
    }
    [[nodiscard]] double shaft() {
        const auto snapshot = bus.chain.snapshot(ModuleIndex(0), bus.now);
        return m_servo ? snapshot.servo.shaftCounts : static_cast<double>(snapshot.stepper->shaft);
    }
    void look() {
        if (m_lowest)
            beyond = std::max({beyond, *m_lowest - shaft(), shaft() - m_highest});
    }
    /// Jogs like a held button, whose request is checked against the limits on its way to the bus. Returns
    /// false if no motion was possible.
    bool jog(bool reverse, double velocity, Duration time) {
        ++m_press;
        return goOnJogging(reverse, velocity, time);
    }
    bool goOnJogging(bool reverse, double velocity, Duration time) {
        bus::HoldToMove hold;
        hold.module = ModuleIndex(0);
        hold.reverse = reverse;
        hold.press = m_press;
        if (m_servo) {
            hold.velocity = CountsPerTick(static_cast<std::uint32_t>(velocity * 65'536));
            hold.acceleration = CountsPerTickSquared(655);  // 0.01
        } else
            hold.pace = bus::StepperPace{static_cast<std::uint8_t>(velocity * 40), 4};
        bool any = false;
        for (const TimePoint end = bus.now + time; bus.now < end; bus.runFor(100ms)) {
            take();
            const auto within = withinTravel(hold, module());
            if (!within)
                break;
            any = true;
            bus.engine.hold(*within, bus.now);
        }
        return any;
    }
    [[nodiscard]] Intent run(bool reverse, double velocity) const {
        if (m_servo)
            return intent::Move{
                servomotion::VelocityProfile{CountsPerTick(static_cast<std::uint32_t>(velocity * 65'536)),
                                             CountsPerTickSquared(655), reverse}};
        return intent::Move{
            steppermotion::VelocityProfile{static_cast<std::uint8_t>(velocity * 40), 4, reverse}};
    }
    [[nodiscard]] Intent goTo(std::int32_t position, double velocity) const {
        if (m_servo)
            return intent::Move{servomotion::Trapezoid{
                Counts(position), CountsPerTick(static_cast<std::uint32_t>(velocity * 65'536)),
                CountsPerTickSquared(655)}};
        return intent::Move{
            steppermotion::Trapezoid{position, false, static_cast<std::uint8_t>(velocity * 40), 4}};
    }
    /// Sends what the limits allow; returns false if the intent is refused.
    bool ask(const Intent& intent) {
        take();
        auto steps = plan(intent, module());
        if (!steps)
            return false;
        bus.submit(std::move(*steps));
        return true;
    }
    /// Lets time pass without any call to the engine: the chain is left alone.
    void loseHost(Duration time) {
        for (const TimePoint end = bus.now + time; bus.now < end;) {
            bus.now += 5ms;
            bus.chain.advanceTo(bus.now);
            look();
        }
    }

    double beyond = -1e9;  ///< greatest distance beyond a limit

private:
    bool m_servo;
    std::optional<std::int32_t> m_lowest;
    std::int32_t m_highest = 0;
    std::uint32_t m_press = 0;
};

class TravelOf : public testing::TestWithParam<ModuleType> {
protected:
    [[nodiscard]] bool servo() const { return GetParam() == ModuleType::Servo; }
    [[nodiscard]] double bound() const { return servo() ? kErrorLimit : 0; }
    TravelBench bench{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Chips, TravelOf, testing::Values(ModuleType::Servo, ModuleType::Stepper),
                         [](const auto& type) {
                             return type.param == ModuleType::Servo ? "Servo" : "Stepper";
                         });

TEST_P(TravelOf, ARunEndsExactlyAtTheLimitAndHoldsThere) {
    ASSERT_TRUE(bench.prepare(-500, 1'500));
    ASSERT_TRUE(bench.ask(bench.run(false, 1.0)));
    bench.bus.runFor(10s);
    bench.take();
    EXPECT_NEAR(bench.shaft(), 1'500, servo() ? 3 : 0);
    EXPECT_LE(bench.beyond, servo() ? 10 : 0);
    EXPECT_FALSE(bench.module().moving());
    EXPECT_EQ(travelPlace(bench.module()), TravelPlace::AtHighest);
    EXPECT_FALSE(bench.ask(bench.run(false, 1.0)));
    ASSERT_TRUE(bench.ask(bench.run(true, 1.0)));
    bench.bus.runFor(10s);
    EXPECT_NEAR(bench.shaft(), -500, servo() ? 3 : 0);
    bench.bus.expectNoViolations();
}

TEST_P(TravelOf, AJogEndsExactlyAtTheLimitHoweverLongItIsHeld) {
    ASSERT_TRUE(bench.prepare(-500, 1'000));
    EXPECT_TRUE(bench.jog(false, 1.0, 8s));
    bench.bus.engine.release(bench.bus.now);
    bench.bus.runFor(1s);
    EXPECT_NEAR(bench.shaft(), 1'000, servo() ? 3 : 0);
    EXPECT_LE(bench.beyond, servo() ? 10 : 0);
    EXPECT_FALSE(bench.jog(false, 1.0, 1s)) << "there is no travel left";
    EXPECT_TRUE(bench.jog(true, 1.0, 500ms));
    bench.bus.engine.release(bench.bus.now);
    bench.bus.runFor(1s);
    EXPECT_LT(bench.shaft(), 950);
    EXPECT_EQ(bench.bus.count<bus::HoldExpired>(), 0U);
    bench.bus.expectNoViolations();
}

TEST_P(TravelOf, AJogStopsSoonWhenItIsReleased) {
    ASSERT_TRUE(bench.prepare(-20'000, 20'000));
    EXPECT_TRUE(bench.jog(false, 1.0, 1s));
    bench.bus.engine.release(bench.bus.now);
    bench.bus.runFor(1s);
    const double place = bench.shaft();
    EXPECT_GT(place, 300);
    EXPECT_LT(place, 3'000);
    bench.bus.runFor(2s);
    EXPECT_NEAR(bench.shaft(), place, 2);
    bench.bus.expectNoViolations();
}

TEST_P(TravelOf, ABeginningJogStopsWhatMovesAndThenGoesItsWay) {
    ASSERT_TRUE(bench.prepare(-20'000, 20'000));
    ASSERT_TRUE(bench.ask(bench.run(false, 1.0)));
    bench.bus.runFor(1s);
    const double there = bench.shaft();
    EXPECT_GT(there, 300);
    EXPECT_TRUE(bench.jog(true, 1.0, 3s));
    EXPECT_LT(bench.shaft(), there);
    bench.bus.engine.release(bench.bus.now);
    bench.bus.runFor(1s);
    bench.take();
    EXPECT_FALSE(bench.module().moving());
    bench.bus.expectNoViolations();
}

TEST_P(TravelOf, AJogWhoseGoalChangesIsOver) {
    ASSERT_TRUE(bench.prepare(-20'000, 20'000));
    EXPECT_TRUE(bench.jog(false, 1.0, 1s));
    bench.module().travel.highest.reset();  // the same happens when home is no longer known
    bench.goOnJogging(false, 1.0, 1s);
    bench.bus.runFor(1s);
    bench.take();
    ASSERT_EQ(bench.bus.count<bus::HoldExpired>(), 1U);
    EXPECT_EQ(bench.bus.last<bus::HoldExpired>()->reason, bus::HoldExpired::Reason::GoalChanged);
    EXPECT_FALSE(bench.module().moving());
    bench.bus.expectNoViolations();
}

TEST_P(TravelOf, WithTheHostDeadTheChipEndsItWithinTheLimits) {
    std::mt19937 random(servo() ? 1 : 2);
    const auto between = [&](int low, int high) {
        return std::uniform_int_distribution<>(low, high)(random);
    };
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(i);
        TravelBench alone(GetParam());
        ASSERT_TRUE(alone.prepare(-between(300, 3'000), between(300, 3'000)));
        const bool reverse = between(0, 1) == 1;
        const double velocity = between(4, 40) / 10.0;
        const Duration until = std::chrono::milliseconds(between(1, 1'500));
        if (between(0, 1) == 1) {
            ASSERT_TRUE(alone.ask(alone.run(reverse, velocity)));
            alone.bus.runFor(until);
        } else {
            ASSERT_TRUE(alone.jog(reverse, velocity, until));
        }
        alone.loseHost(20s);
        EXPECT_LE(alone.beyond, bound());
        EXPECT_FALSE(alone.shaft() < -3'003 || alone.shaft() > 3'003);
    }
}

class TravelSequences : public testing::TestWithParam<std::tuple<ModuleType, unsigned>> {
protected:
    [[nodiscard]] bool chance(double p) { return std::bernoulli_distribution(p)(m_random); }
    [[nodiscard]] int between(int low, int high) {
        return std::uniform_int_distribution<>(low, high)(m_random);
    }
    /// Loses or changes bytes to the host, and changes at most one bit of a command: with two, the checksum
    /// may still match, which no host can notice.
    void invalidate(VirtualBus& bus) {
        bus.onHostByte = [this](std::uint8_t& byte) {
            if (chance(0.002))
                byte = static_cast<std::uint8_t>(byte ^ (1U << between(0, 7)));
            return chance(0.002) ? 0U : 1U;
        };
        bus.onCommand = [this](std::vector<std::uint8_t>& command) {
            if (chance(0.01) && !command.empty())
                command[static_cast<std::size_t>(between(0, static_cast<int>(command.size()) - 1))] ^=
                    static_cast<std::uint8_t>(1U << between(0, 7));
        };
    }
    void act(TravelBench& bench) {
        const double velocity = between(4, 40) / 10.0;
        const Duration time = std::chrono::milliseconds(between(10, 900));
        switch (between(0, 6)) {
            case 0:
            case 1:
                bench.jog(chance(0.5), velocity, time);
                bench.bus.engine.release(bench.bus.now);
                break;
            case 2:
                bench.jog(chance(0.5), velocity, time);  // the hold is neither renewed nor released
                break;
            case 3:
                bench.ask(bench.run(chance(0.5), velocity));
                break;
            case 4:
                bench.ask(bench.goTo(between(-3'000, 3'000), velocity));
                break;
            case 5:
                bench.ask(chance(0.5) ? Intent(intent::StopSmoothly{}) : Intent(intent::StopAbruptly{}));
                break;
            default:
                bench.bus.engine.stopAll(bench.bus.now);
                break;
        }
        bench.bus.runFor(std::chrono::milliseconds(between(0, 1'500)));
        bench.take();
    }
    std::mt19937 m_random;
};

INSTANTIATE_TEST_SUITE_P(Seeds, TravelSequences,
                         testing::Combine(testing::Values(ModuleType::Servo, ModuleType::Stepper),
                                          testing::Range(0U, 5U)));

// 2 chips x 5 seeds x 50 sequences of ten actions.
TEST_P(TravelSequences, TheShaftNeverPassesALimitByMoreThanTheBound) {
    const auto [type, first] = GetParam();
    int moved = 0;
    int inDoubt = 0;
    for (unsigned i = 0; i < 50; ++i) {
        const unsigned seed = first * 1'000 + i;
        SCOPED_TRACE("seed " + std::to_string(seed));
        m_random.seed(seed);
        TravelBench bench(type);
        ASSERT_TRUE(bench.prepare(-between(100, 2'000), between(100, 2'000)));
        if (chance(0.5))
            invalidate(bench.bus);
        for (int n = 0; n < 10; ++n) {
            const double before = bench.shaft();
            act(bench);
            moved += std::abs(bench.shaft() - before) > 20 ? 1 : 0;
            // Noise has shown a position to which no motion leads: home is no longer known.
            if (travelForce(bench.module()) != TravelForce::InForce) {
                ++inDoubt;
                break;
            }
        }
        EXPECT_LE(bench.beyond, type == ModuleType::Servo ? kErrorLimit : kStepsOfALateRamp);
    }
    EXPECT_GT(moved, 100) << "without motions the bound proves nothing";
    EXPECT_LT(inDoubt, 25);
}

// ---- homing ----

class TravelHoming : public testing::Test {
protected:
    [[nodiscard]] static HomingRecipe recipe() {
        HomingRecipe recipe = slowRecipe();
        recipe.onLimit1 = true;
        return recipe;
    }
    ServoBench bench;
};

TEST_F(TravelHoming, ASearchEndsWhereHomeAndLimitsAreBehindIt) {
    ASSERT_TRUE(bench.enable());
    bench.module().home.declare(bench.module().latestTime);
    bench.module().travel.lowest = -200;
    // There is no switch. 0.5 counts/tick are 977 counts/s: 489 in half a second, and another 13 to slow down
    // at 0.01.
    const ProcedureReport report = bench.run(intent::Home{recipe()});
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::SoftLimit);
    EXPECT_NEAR(bench.truth().position, -200 - 489 - 13 - 4 - 13, 60);
    EXPECT_EQ(bench.truth().commandVelocity, 0);
}

TEST_F(TravelHoming, HomeIsFoundWhereItWasThoughItLiesOutside) {
    bench.putSwitch(sim::Input::Limit1, -600, true);
    ASSERT_TRUE(bench.enable());
    EXPECT_EQ(bench.run(intent::Home{recipe()}).stage, ProcedureStage::Done);
    bench.module().home.found(0, bench.module().latestTime);
    bench.module().travel.lowest = 500;
    ASSERT_TRUE(bench.moveTo(1'000));
    EXPECT_EQ(bench.run(intent::Home{recipe()}).stage, ProcedureStage::Done);
}

TEST_F(TravelHoming, InDoubtTheSearchGoesByItsOwnLimitAlone) {
    bench.putSwitch(sim::Input::Limit1, -3'000, true);
    ASSERT_TRUE(bench.enable());
    bench.module().travel.lowest = -200;
    EXPECT_EQ(bench.run(intent::Home{recipe()}).stage, ProcedureStage::Done);
}

// ---- steps, and the play of a gear ----

class Steps : public testing::Test {
protected:
    /// Goals of the moves that were loaded, from the wire: AA 01 n4 control position...
    [[nodiscard]] std::vector<std::int32_t> goals() const {
        std::vector<std::int32_t> all;
        for (const auto& sent : bench.bus.sent)
            if (sent.bytes.size() == 17 && sent.bytes[2] == 0xD4)
                all.push_back(static_cast<std::int32_t>(sent.bytes[4] | std::uint32_t{sent.bytes[5]} << 8U |
                                                        std::uint32_t{sent.bytes[6]} << 16U |
                                                        std::uint32_t{sent.bytes[7]} << 24U));
        return all;
    }
    [[nodiscard]] static intent::MoveBy by(std::int32_t counts, unsigned rounds) {
        return {{counts, rounds}, ServoPace{CountsPerTick(2 << 16), CountsPerTickSquared(1'311)}};
    }
    ServoBench bench;
};

TEST_F(Steps, EndWhereTheNextOneWouldLeaveTheLimits) {
    ASSERT_TRUE(bench.enable());
    bench.begin(by(250, 4));
    bench.module().home.declare(bench.module().latestTime);
    bench.module().travel.highest = 600;  // entered while the steps are being made
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::SoftLimit);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{250, 500}));
}

/// At 3906 counts/s, 0.3 s are 1172 counts, and slowing down by 0.02 counts/tick^2 takes 100.
TEST_F(Steps, EndOnTheWayWhereALimitIsSetNearer) {
    ASSERT_TRUE(bench.enable());
    bench.module().home.declare(bench.module().latestTime);
    bench.begin(by(20'000, 1));
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.settle();
    bench.module().travel.highest = 25'000;
    ASSERT_TRUE(bench.turn());
    EXPECT_FALSE(bench.procedure->ends()) << "its goal is still within";
    bench.module().travel.highest = 5'000;
    EXPECT_EQ(bench.goOn().failure, ProcedureFailure::SoftLimit);
    EXPECT_LT(bench.truth().position, 2'000);
    EXPECT_EQ(bench.truth().commandVelocity, 0);
    bench.bus.expectNoViolations();
}

TEST_F(Steps, TakeUpTheBacklashWhereTheyComeFromTheWrongSide) {
    ASSERT_TRUE(bench.enable());
    bench.module().backlash.distance = 40;
    EXPECT_EQ(bench.run(by(-100, 2)).stage, ProcedureStage::Done);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{-140, -100, -240, -200}));
    EXPECT_EQ(bench.stages.count(ProcedureStage::TakingUpBacklash), 1U);
    EXPECT_EQ(bench.run(by(10, 2)).stage, ProcedureStage::Done);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{-140, -100, -240, -200, -190, -180}))
        << "it rests at a goal, so the play is taken up";
    bench.bus.expectNoViolations();
}

TEST_F(Steps, TurnRoundAtTheLimitItself) {
    ASSERT_TRUE(bench.enable());
    bench.module().backlash.distance = 40;
    bench.module().home.declare(bench.module().latestTime);
    bench.module().travel.lowest = -240;
    EXPECT_EQ(bench.run(by(-100, 2)).stage, ProcedureStage::Done);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{-140, -100, -240, -200}));
    const ServoPace pace{CountsPerTick(2 << 16), CountsPerTickSquared(1'311)};
    bench.module().travel.lowest = -260;
    EXPECT_EQ(bench.run(intent::Move{moveTo(-220, pace)}).stage, ProcedureStage::Done);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{-140, -100, -240, -200, -260, -220}));
    bench.bus.expectNoViolations();
}

TEST_F(Steps, AMoveTurnsRoundToo) {
    ASSERT_TRUE(bench.enable());
    bench.module().backlash = {40, true};
    const ServoPace pace{CountsPerTick(2 << 16), CountsPerTickSquared(1'311)};
    const ProcedureReport report = bench.run(intent::Move{moveTo(500, pace)});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.kind, ProcedureKind::Approach);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{540, 500}));
    EXPECT_NEAR(bench.truth().position, 500, 3);
    EXPECT_EQ(procedureFor(intent::Move{moveTo(100, pace)}, bench.module()), nullptr)
        << "from the right side it moves straight there";
    bench.module().latest->position = 499;
    EXPECT_EQ(procedureFor(intent::Move{moveTo(500, pace)}, bench.module()), nullptr)
        << "it holds 500, and friction keeps it away";
    bench.bus.expectNoViolations();
}

/// A turn 20 counts beyond the end of the counter would be at its other end in 32 bits.
TEST_F(Steps, DoNotTurnRoundBeyondTheEndOfTheCounter) {
    ASSERT_TRUE(bench.enable());
    bench.module().backlash = {40, true};
    const ServoPace pace{CountsPerTick(2 << 16), CountsPerTickSquared(1'311)};
    EXPECT_EQ(bench.run(intent::Move{moveTo(0x7FFFFFFF - 20, pace)}).failure, ProcedureFailure::TravelLimit);
    EXPECT_TRUE(goals().empty());
}

TEST_F(Steps, AStopHereHasTakenUpNothing) {
    ASSERT_TRUE(bench.enable());
    bench.module().backlash.distance = 40;
    ASSERT_EQ(bench.run(by(-100, 1)).stage, ProcedureStage::Done);
    ASSERT_TRUE(bench.perform(intent::StopHere{}));
    const std::int32_t from = bench.module().goal().value_or(0);
    EXPECT_EQ(bench.run(by(10, 1)).stage, ProcedureStage::Done);
    EXPECT_EQ(goals(), (std::vector<std::int32_t>{-140, -100, from + 10 - 40, from + 10}));
}

/// A PIC-STEP that is on and has its parameters.
class StepperMoves : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bench.connect());
        bench.settle();
        ASSERT_TRUE(bench.perform(
            stepperintent::SetParameters{{stepper::SpeedMode::X1, false, false, false, 4, 200, 50, 0}}));
        ASSERT_TRUE(bench.perform(intent::Enable{}));
        bench.bus.onTime = [this] { lowest = std::min(lowest, bench.stepperTruth().position); };
    }
    [[nodiscard]] static intent::Move to(std::int32_t position) {
        return {steppermotion::Trapezoid{position, false, 40, 4}};
    }
    ProcedureBench bench{{{ModuleType::Stepper, 1}}};
    std::int32_t lowest = 0;
};

TEST_F(StepperMoves, TakeUpTheBacklashToo) {
    bench.module().backlash.distance = 40;
    const ProcedureReport report = bench.run(to(-500));
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.kind, ProcedureKind::Approach);
    EXPECT_EQ(lowest, -540);
    EXPECT_EQ(bench.stepperTruth().position, -500);
    EXPECT_EQ(procedureFor(to(-490), bench.module()), nullptr) << "the play is taken up on that side";
    ASSERT_TRUE(procedureFor(to(-510), bench.module()));
    bench.module().travel.lowest = -540;
    bench.module().home.declare(bench.module().latestTime);
    EXPECT_EQ(plan(to(-510), bench.module()).error(), Refusal::BeyondTravel) << "it would turn round at -550";
    bench.bus.expectNoViolations();
}

TEST_F(StepperMoves, ALimitSwitchBeyondTheGoalEndsThem) {
    bench.module().backlash.distance = 400;
    bench.begin(to(-100));
    ASSERT_TRUE(bench.runTo(ProcedureStage::TakingUpBacklash));
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(bench.turn());
    bench.set(sim::Input::Limit2, 1);
    EXPECT_EQ(bench.goOn().failure, ProcedureFailure::StoppedShort);
    EXPECT_EQ(bench.stepperTruth().stepRate, 0);
}

}  // namespace
}  // namespace nmc::test
