// SPDX-License-Identifier: GPL-3.0-or-later
// The metrics of a step response taken from bus samples, compared with the simulator's state at every tick:
// random gains, loads and steps, through procedure, engine and line. NMC_STEP_SETS sets their number.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>

#include "model/procedure/stepsrun.h"
#include "model/response/responserecord.h"
#include "tests/procedures/procedurebench.h"
#include "tests/support/campaign.h"
#include "tests/support/servotick.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using testing_support::kTick;

constexpr double kBandPercent = 2;
constexpr double kRecord = 0.4;

/// One set to try.
struct Trial {
    servo::SetGain gains;
    intent::StepResponse wanted;
    double inertia = 0.0;
    double friction = 0.0;
};

/// What the motor did, at every tick after the one at which the command was latched.
struct Truth {
    std::vector<std::int32_t> positions;
    bool off = false;

    /// Determined independently: the motor went beyond twice the step, or a quarter of it the wrong way.
    [[nodiscard]] bool wentTooFar(double from, double step) const {
        return std::any_of(positions.begin(), positions.end(), [&](std::int32_t position) {
            const double way = (position - from) / step;
            return way > 2 || way < -0.25;
        });
    }
    /// Determined independently: between 1 s and 2 s, long after the record but before a hold was tried in
    /// vain, the motor swings by more than a third of the step from end to end.
    [[nodiscard]] bool swingsFar(double step) const {
        const auto from = std::min(static_cast<std::size_t>(1.0 / kTick), positions.size());
        const auto to = std::min(static_cast<std::size_t>(2.0 / kTick), positions.size());
        if (from == to)
            return false;
        const auto at = [this](std::size_t tick) { return positions.begin() + static_cast<long>(tick); };
        const auto [low, high] = std::minmax_element(at(from), at(to));
        return *high - *low > std::abs(step) / 3;
    }
};

/// Calculated independently, from whole ticks and without any interpolation.
struct TrueMetrics {
    std::optional<double> rise;
    double overshoot = 0.0;
    std::optional<double> settling;
    double steadyError = 0.0;
};

[[nodiscard]] TrueMetrics measured(const Truth& truth, const ResponseRecord& run) {
    const double step = run.taken.goal - run.taken.from;
    TrueMetrics m;
    std::optional<std::size_t> low, high, lastOutside;
    double sum = 0;
    const auto ticks = std::min(truth.positions.size(), static_cast<std::size_t>(kRecord / kTick));
    const std::size_t tail = ticks * 4 / 5;
    for (std::size_t i = 0; i < ticks; ++i) {
        const double method = (truth.positions[i] - run.taken.from) / step;
        if (!low && method >= 0.1)
            low = i;
        if (!high && method >= 0.9)
            high = i;
        m.overshoot = std::max(m.overshoot, 100 * (method - 1));
        if (std::abs(truth.positions[i] - run.taken.goal) > run.band())
            lastOutside = i;
        if (i >= tail)
            sum += truth.positions[i];
    }
    if (low && high)
        m.rise = static_cast<double>(*high - *low) * kTick;
    if (!lastOutside || *lastOutside < tail)
        m.settling = lastOutside ? static_cast<double>(*lastOutside + 1) * kTick : 0.0;
    m.steadyError = run.taken.goal - sum / static_cast<double>(ticks - tail);
    return m;
}

/// One chain for one trial.
class ResponseBench : public ProcedureBench {
public:
    explicit ResponseBench(std::uint64_t seed) : ProcedureBench(servos(1), phase(seed)) {
        bus.onTime = [this] { look(); };
    }

    /// Empty if there is no step, for instance because the motor cannot even hold still with these gains.
    [[nodiscard]] std::optional<ProcedureReport> tryOut(const Trial& trial) {
        const servo::SetGain calm{100, 3'000, 0, 0, 255, 0, 8'000, 1, std::uint8_t{0}};
        const bool on = connect() && perform(intent::AskAnew{}) && perform(intent::ApplyGains{calm}) &&
                        perform(intent::Enable{}) && perform(intent::StopHere{});
        EXPECT_TRUE(on);
        set(sim::Input::Inertia, trial.inertia);
        set(sim::Input::Friction, trial.friction);
        if (!perform(intent::ApplyGains{trial.gains}) || !plan(trial.wanted, module()))
            return std::nullopt;
        m_before = truthNow();
        m_watching = true;
        bus.engine.focus(ModuleIndex(0), bus.now);
        begin(trial.wanted);
        const ProcedureReport report = goOn(10);
        return report.step || truth.off ? std::optional(report) : std::nullopt;
    }
    [[nodiscard]] ResponseRecord run(const ResponseTaken& taken) const {
        std::vector<ScopeSample> samples;
        for (const auto& sample : bus.all<bus::Sample>()) {
            if (!sample.report.position)
                continue;
            ScopeSample kept;
            kept.time = sample.time;
            kept.position = *sample.report.position;
            samples.push_back(kept);
        }
        return takeRun(ModuleIndex(0), samples, taken, kBandPercent);
    }

    /// The position that the servo held before the step.
    [[nodiscard]] double from() const { return m_before.commandPosition; }

    Truth truth;

private:
    [[nodiscard]] static sim::ChainOptions phase(std::uint64_t seed) {
        sim::ChainOptions options;
        options.seed = seed;
        return options;
    }
    [[nodiscard]] sim::ServoSnapshot truthNow() { return bus.servo(0); }
    /// Called at least every half millisecond, so no tick is missed.
    void look() {
        if (!m_watching)
            return;
        const sim::ModuleSnapshot now = bus.chain.snapshot(ModuleIndex(0), bus.now);
        if (now.tick == m_tick)
            return;
        m_tick = now.tick;
        m_latched = m_latched || (now.servo.servoOn && now.servo.commandPosition != m_before.commandPosition);
        if (m_latched)
            truth.positions.push_back(now.servo.position);
        truth.off = truth.off || !now.servo.servoOn;
    }

    sim::ServoSnapshot m_before;
    std::uint64_t m_tick = 0;
    bool m_watching = false;
    bool m_latched = false;
};

class Trials {
public:
    explicit Trials(unsigned seed) : m_random(seed) {}

    [[nodiscard]] Trial next() {
        Trial trial;
        const auto step = static_cast<std::int32_t>(spread(20, 500));
        const bool integral = uniform(0, 1) < 0.5;
        trial.gains.kp = static_cast<std::uint16_t>(spread(20, 4'000));
        trial.gains.kd = static_cast<std::uint16_t>(spread(30, 8'000));
        trial.gains.ki = integral ? static_cast<std::uint16_t>(spread(1, 100)) : std::uint16_t{0};
        trial.gains.il = static_cast<std::uint16_t>(uniform(0, 1'000));
        trial.gains.ol = static_cast<std::uint8_t>(uniform(60, 255));
        trial.gains.el = static_cast<std::uint16_t>(1.1 * step + 5 + spread(1, 2'000));
        trial.gains.sr = uniform(0, 1) < 0.8 ? std::uint8_t{1} : static_cast<std::uint8_t>(uniform(2, 4));
        trial.gains.db = std::uint8_t{0};
        trial.wanted.counts = uniform(0, 1) < 0.5 ? -step : step;
        trial.wanted.method = uniform(0, 1) < 0.5 ? ResponseMethod::Profile : ResponseMethod::StopHere;
        trial.wanted.record = kRecord;
        trial.inertia = 1.7e-5 * spread(1, 4);
        trial.friction = uniform(0, 0.006);
        return trial;
    }

private:
    [[nodiscard]] double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }
    /// Uniform in the logarithm.
    [[nodiscard]] double spread(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    std::mt19937 m_random;
};

[[nodiscard]] std::string toText(const Trial& t) {
    std::ostringstream text;
    text << "Kp " << t.gains.kp << " Kd " << t.gains.kd << " Ki " << t.gains.ki << " IL " << t.gains.il
         << " OL " << int{t.gains.ol} << " EL " << t.gains.el << " SR " << int{t.gains.sr} << " step "
         << t.wanted.counts << " inertia " << t.inertia << " friction " << t.friction;
    return text.str();
}

/// Counts how many of the metrics that can be compared are right.
struct Share {
    const char* name;
    int of = 0;
    int within = 0;
    int inDoubt = 0;

    bool add(const Measured& measured, double truth, double tolerance) {
        const double off = std::abs(measured.value - truth);
        ++of;
        within += off <= tolerance ? 1 : 0;
        inDoubt += off <= measured.doubt ? 1 : 0;
        return off <= tolerance;
    }
    /// If there is no measured value, there must be no true one either.
    bool add(const Figure& measured, const std::optional<double>& truth, double tolerance) {
        return measured && truth ? add(*measured, *truth, tolerance)
                                 : measured.has_value() == truth.has_value();
    }
    void expectMost() const {
        std::printf("%s: %d of %d within the figure, %d within the doubt\n", name, within, of, inDoubt);
        EXPECT_GE(within, 0.95 * of) << name;
        EXPECT_GE(inDoubt, 0.95 * of) << name;
        EXPECT_GT(of, 0);
    }
};

class Tally {
public:
    void add(const Trial& trial, const ProcedureReport& report, const ResponseBench& bench) {
        ++m_sets;
        const auto failure = report.failure;
        if (failure == ProcedureFailure::WentOff) {
            EXPECT_TRUE(bench.truth.off);
            ++m_trips;
            ++m_right;
        } else if (failure == ProcedureFailure::TravelLimit || failure == ProcedureFailure::Unstable) {
            // There is no report of a step that was not recorded to its end.
            EXPECT_TRUE(bench.truth.wentTooFar(bench.from(), trial.wanted.counts) ||
                        bench.truth.swingsFar(trial.wanted.counts));
            ++m_tooFar;
            ++m_right;
        } else {
            EXPECT_FALSE(bench.truth.off) << "every trip is recognised";
            EXPECT_TRUE(report.stage == ProcedureStage::Done || failure == ProcedureFailure::NotStill);
            compare(bench.run(*report.step), bench.truth);
        }
    }
    void expectMost() const {
        std::printf("%d tripped, %d went too far, %d never rose, %d never settled; samples every %.3f ms\n",
                    m_trips, m_tooFar, m_compared - m_rise.of, m_compared - m_settling.of,
                    1e3 * m_intervals / m_compared);
        for (const Share& share : {m_rise, m_overshoot, m_settling, m_error})
            share.expectMost();
        std::printf("all right in %d of %d sets\n", m_right, m_sets);
        EXPECT_GE(m_right, 0.95 * m_sets);
        EXPECT_GT(m_trips, 0);
        EXPECT_LT(m_settling.of, m_compared) << "some never settle";
    }

private:
    void compare(const ResponseRecord& run, const Truth& truth) {
        const TrueMetrics is = measured(truth, run);
        const double interval = run.metrics.interval;
        const bool rise = m_rise.add(run.metrics.rise, is.rise, interval);
        const bool settling = m_settling.add(run.metrics.settling, is.settling, interval);
        const bool overshoot = m_overshoot.add(run.metrics.overshoot.value(), is.overshoot, 2.0);
        m_error.add(run.metrics.steadyError.value(), is.steadyError, 1.0);
        m_right += rise && settling && overshoot ? 1 : 0;
        m_intervals += interval;
        ++m_compared;
    }

    Share m_rise{"rise time"}, m_overshoot{"overshoot"}, m_settling{"settling time"}, m_error{"steady error"};
    int m_sets = 0, m_right = 0, m_trips = 0, m_tooFar = 0, m_compared = 0;
    double m_intervals = 0;
};

/// Sets that cannot be tried at all do not count.
TEST(ResponseTruth, MetricsFromTheWireAreThoseOfTheMotor) {
    const auto sets = static_cast<int>(campaignSize("NMC_STEP_SETS", 200));
    const unsigned seed = 20'240'601;
    std::printf("seed %u, %d sets\n", seed, sets);
    Trials trials(seed);
    Tally tally;
    for (int tried = 0, done = 0; done < sets; ++tried) {
        const Trial trial = trials.next();
        SCOPED_TRACE(testing::Message() << "set " << tried << ": " << toText(trial));
        ResponseBench bench(static_cast<std::uint64_t>(tried) + 1);
        if (const auto report = bench.tryOut(trial)) {
            tally.add(trial, *report, bench);
            ++done;
        }
    }
    tally.expectMost();
}

}  // namespace
}  // namespace nmc::test
