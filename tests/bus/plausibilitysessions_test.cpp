// SPDX-License-Identifier: GPL-3.0-or-later
// On a clean line, no reply is rejected, whatever the motors do. NMC_PLAUSIBILITY_SECONDS sets the length of
// each session.
#include <gtest/gtest.h>

#include "sim/random.h"
#include "tests/bus/steps.h"
#include "tests/support/campaign.h"
#include "tests/support/modules.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using servo::StopManner;
using sim::Input;
using testing_support::kStep;

/// An operator who acts at random.
class Session {
public:
    Session(std::vector<ModuleIdentity> modules, std::uint32_t baud, std::uint64_t seed)
        : m_random(seed), bus(std::move(modules), EngineConfig{baud}, withSeed(seed)) {}

    [[nodiscard]] bool begin() { return bus.connect(); }
    void run() {
        for (const TimePoint end =
                 bus.now + std::chrono::seconds(campaignSize("NMC_PLAUSIBILITY_SECONDS", 60));
             bus.now < end && !m_failed;) {
            const auto module = static_cast<std::uint8_t>(below(bus.chain.moduleCount()));
            bus.chain.identity(ModuleIndex(module)) == kStep ? actOnStepper(module) : actOnServo(module);
            bus.runFor(Duration(below(400'000'000)));
            expectNothingRejected();
        }
    }
    void expectNothingRejected() {
        const LinkStatistics& statistics = bus.engine.statistics();
        // A motor that was at rest, was not queried for a second, and was carried away by a load meanwhile
        // needs a second reply: one of its neighbour would look the same (link.md 2.4).
        const auto jumps = statistics.rejections[static_cast<std::size_t>(Rejection::PositionJump)];
        if (jumps <= 1 && statistics.errors() == jumps && bus.count<HealthChanged>() == 0)
            return;
        m_failed = true;
        for (std::size_t i = 0; i < kRejections; ++i)
            if (statistics.rejections[i] != 0)
                ADD_FAILURE() << "rule " << i << " rejected " << statistics.rejections[i];
        ADD_FAILURE() << "at " << toSeconds(bus.now.time_since_epoch()) << " s after: " << m_lately;
    }

private:
    [[nodiscard]] static sim::ChainOptions withSeed(std::uint64_t seed) {
        sim::ChainOptions options;
        options.seed = seed;
        return options;
    }
    [[nodiscard]] std::uint64_t below(std::uint64_t limit) { return m_random.below(limit); }
    [[nodiscard]] bool coin() { return below(2) == 0; }
    [[nodiscard]] std::int32_t around(std::int32_t reach) {
        return static_cast<std::int32_t>(below(2 * static_cast<std::uint64_t>(reach))) - reach;
    }
    void did(const std::string& what) {
        m_lately = (m_lately + ", " + what).substr(m_lately.size() / 200 * 40);
    }
    void ask(const std::string& what, std::vector<Order> orders) {
        did(what);
        bus.submit(std::move(orders));
    }
    void set(std::uint8_t module, Input input, std::optional<double> value) {
        did("input " + std::to_string(static_cast<int>(input)));
        bus.chain.set(ModuleIndex(module), input, value, bus.now);
    }

    void actOnServo(std::uint8_t m) {
        switch (below(20)) {
            case 0:
                return ask("gains and on", {gains(m), enable(m)});
            case 1: {
                // Too much Kp and too little Kd: it swings as hard as the motor can.
                const servo::SetGain wild{static_cast<std::uint16_t>(500 + below(3'000)),
                                          100,
                                          0,
                                          0,
                                          255,
                                          0,
                                          0x3FFF,
                                          1,
                                          std::uint8_t{0}};
                return ask("wild gains and on", {toServo(m, wild), enable(m)});
            }
            case 2:
            case 3:
            case 4:
                return ask("move", {loadMove(m, around(8'000)), start(m)});
            case 5:
            case 6: {
                servo::LoadTrajectory load;
                load.velocity = CountsPerTick(static_cast<std::uint32_t>(below(20 * 65'536)));
                load.acceleration = CountsPerTickSquared(static_cast<std::uint32_t>(1 + below(65'536)));
                load.profile = servo::ProfileMode::Velocity;
                load.reverse = coin();
                load.startNow = coin();
                return ask("velocity", {toServo(m, load), start(m)});
            }
            case 7: {
                servo::LoadTrajectory load;
                load.pwm = static_cast<std::uint8_t>(below(256));
                load.servo = false;
                load.reverse = coin();
                load.startNow = true;
                return ask("PWM", {toServo(m, load)});
            }
            case 8: {
                const std::array kManners{StopManner::AmplifierOnly, StopManner::MotorOff,
                                          StopManner::Abruptly, StopManner::Smoothly};
                const servo::StopMotor stop{below(4) != 0, kManners.at(below(4)), {}};
                return ask("stop " + std::to_string(static_cast<int>(stop.manner)), {toServo(m, stop)});
            }
            case 9:
                return ask("stop here",
                           {toServo(m, servo::StopMotor{true, StopManner::Here, Counts(around(3'000))})});
            case 10: {
                servo::SetHoming homing;
                homing.onLimit1Change = coin();
                homing.onLimit2Change = coin();
                homing.onIndexChange = coin();
                homing.onPositionError = coin();
                const auto end = below(4);
                homing.motorOff = end == 1;
                homing.stopAbruptly = end == 2;
                homing.stopSmoothly = end == 3;
                return ask("homing", {toServo(m, homing)});
            }
            case 11:
                return ask("reset position", {toServo(m, ResetPosition{})});
            case 12:
                return ask("save as home", {toServo(m, SaveAsHome{})});
            case 13:
                return ask("clear", {toServo(m, servo::ClearStickyBits{})});
            case 14:
                return set(m, Input::Power, coin() || coin() ? 1.0 : 0.0);
            case 15:
                return set(m, coin() ? Input::Limit1 : Input::Limit2, coin() ? 1.0 : 0.0);
            case 16: {
                // A mechanical stop that a servo pushes against is not removed: that would make a motor leap
                // without a command.
                if (bus.servo(m).pwm != 0)
                    return;
                const double shaft = bus.servo(m).shaftCounts;
                if (coin())
                    return set(m, Input::TravelMax,
                               coin() ? std::optional(shaft + 500 + around(400)) : std::nullopt);
                return set(m, Input::TravelMin,
                           coin() ? std::optional(shaft - 500 + around(400)) : std::nullopt);
            }
            case 17:
                return set(m, Input::Load, (m_random.unit() - 0.5) * 0.2);
            case 18:
                did("stop all");
                bus.engine.stopAll(bus.now);
                return;
            default:
                did("hold");
                bus.engine.hold({ModuleIndex(m),
                                 CountsPerTick(static_cast<std::uint32_t>(below(10 * 65'536))),
                                 CountsPerTickSquared(655),
                                 coin(),
                                 {},
                                 ++m_presses},
                                bus.now);
                return;
        }
    }

    void actOnStepper(std::uint8_t m) {
        const auto to = [m](StepperCommand command) { return Order{ModuleIndex(m), std::move(command)}; };
        switch (below(16)) {
            case 0:
            case 1: {
                const stepper::SetParameters parameters{static_cast<stepper::SpeedMode>(below(4)),
                                                        coin(),
                                                        coin(),
                                                        coin(),
                                                        static_cast<std::uint8_t>(1 + below(20)),
                                                        200,
                                                        50,
                                                        static_cast<std::uint8_t>(coin() ? 0 : 100)};
                return ask("parameters", {to(parameters),
                                          to(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})});
            }
            case 2:
            case 3:
            case 4:
            case 5:
            case 6: {
                stepper::LoadTrajectory load;
                if (coin())
                    load.position = Counts(around(20'000));
                if (coin() || coin()) {
                    load.speed = static_cast<std::uint8_t>(1 + below(250));
                    load.accelerationTime = static_cast<std::uint8_t>(1 + below(20));
                } else {
                    load.timer = stepper::TimerCount{static_cast<std::uint16_t>(1 + below(65'452)), 20};
                }
                load.reverse = coin();
                load.startNow = coin();
                return load.startNow ? ask("load and start", {to(load)})
                                     : ask("load, start", {to(load), to(StartMotion{})});
            }
            case 7:
            case 8:
                return ask(
                    "stop",
                    {to(stepper::StopMotor{coin() || coin(), static_cast<stepper::StopManner>(below(3))})});
            case 9: {
                stepper::SetHoming homing;
                homing.onLimit1Change = coin();
                homing.onHomeSwitchChange = coin();
                const auto end = below(4);
                homing.motorOff = end == 1;
                homing.stopAbruptly = end == 2;
                homing.stopSmoothly = end == 3;
                return ask("homing", {to(homing)});
            }
            case 10:
                return ask("reset position", {to(ResetPosition{})});
            case 11:
                return ask("save as home", {to(SaveAsHome{})});
            case 12:
                return set(m, Input::Power, coin() || coin() ? 1.0 : 0.0);
            case 13: {
                const std::array kInputs{Input::Limit1, Input::Limit2, Input::Estop, Input::HomeSwitch,
                                         Input::In1};
                return set(m, kInputs.at(below(kInputs.size())), coin() ? 1.0 : 0.0);
            }
            case 14:
                return set(m, Input::Analog, static_cast<double>(below(256)));
            default:
                did("stop all");
                bus.engine.stopAll(bus.now);
                return;
        }
    }

    sim::Random m_random;
    std::uint32_t m_presses = 0;
    std::string m_lately;
    bool m_failed = false;

public:
    VirtualBus bus;
};

class Sessions : public testing::TestWithParam<std::uint32_t> {};

TEST_P(Sessions, OfServosRejectNothing) {
    for (const std::uint8_t version : {std::uint8_t{4}, kPathVersion, kScVersion})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            SCOPED_TRACE("version " + std::to_string(version) + ", seed " + std::to_string(seed));
            Session session(servos(2, version), GetParam(), seed);
            ASSERT_TRUE(session.begin());
            session.run();
            EXPECT_GT(session.bus.engine.statistics().answered, 500U);
        }
}

TEST_P(Sessions, OfSteppersRejectNothing) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Session session({kStep, kStep}, GetParam(), seed);
        ASSERT_TRUE(session.begin());
        session.run();
        EXPECT_GT(session.bus.engine.statistics().answered, 500U);
    }
}

TEST_P(Sessions, OfAMixedChainRejectNothing) {
    Session session({{ModuleType::Servo, 4}, kStep, {ModuleType::Servo, 2}}, GetParam(), 11);
    ASSERT_TRUE(session.begin());
    session.run();
}

INSTANTIATE_TEST_SUITE_P(Rates, Sessions, testing::Values(19'200U, 115'200U));

}  // namespace

}  // namespace nmc::test
