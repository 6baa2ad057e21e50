// SPDX-License-Identifier: GPL-3.0-or-later
// Profiled moves as they are measured from bus samples, compared with the simulator's state at every tick:
// random gains, loads, paces and windows, through procedure, engine, line and calculated error.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "model/intent/looptestplan.h"
#include "model/procedure/stepsrun.h"
#include "model/response/responserecord.h"
#include "model/scope/scopefeed.h"
#include "tests/procedures/procedurebench.h"
#include "tests/support/servotick.h"

namespace nmc::test {
namespace {

using testing_support::kTick;

/// One tick of the module.
struct MoveTick {
    double command = 0.0;
    double error = 0.0;
    std::int32_t position = 0;
};

class MoveBench : public ProcedureBench {
public:
    explicit MoveBench(std::uint64_t seed) : ProcedureBench(servos(1), phase(seed)) {
        bus.onTime = [this] { look(); };
    }
    [[nodiscard]] bool hold(const servo::SetGain& gains, double inertia, double friction) {
        if (!connect() || !perform(intent::AskAnew{}) || !perform(intent::ApplyGains{gains}) ||
            !perform(intent::Enable{}) || !perform(intent::StopHere{}))
            return false;
        set(sim::Input::Inertia, inertia);
        set(sim::Input::Friction, friction);
        settle();
        return true;
    }
    /// The ticks of one move, from the first one in which the command position differs from its start.
    [[nodiscard]] std::vector<MoveTick> ticksOf(const ResponseTaken& taken) const {
        const auto begins = [&](const MoveTick& tick) { return tick.command != taken.from; };
        const auto from = m_first.at(taken.round - 1);
        const auto first = std::find_if(m_ticks.begin() + static_cast<long>(from), m_ticks.end(), begins);
        return {first, m_ticks.end()};
    }
    [[nodiscard]] ResponseRecord recordOf(const ResponseTaken& taken, const SettleWindow& window) {
        ScopeFeed feed;
        std::vector<ScopeSample> samples;
        for (const bus::Event& event : bus.events) {
            if (const auto* executed = std::get_if<bus::CommandExecuted>(&event))
                feed.apply(*executed);
            else if (const auto* sample = std::get_if<bus::Sample>(&event))
                if (const auto kept = feed.take(*sample))
                    samples.push_back(*kept);
        }
        ResponseRecord record = takeRun(ModuleIndex(0), samples, taken, kFirstBand);
        judge(record, kFirstBand, window);
        return record;
    }
    /// Collects the moves; each is reported once it has been recorded.
    void watch() {
        m_watching = true;
        onTurn = [this](Procedure& running) {
            // The move has been sent since the previous turn.
            if (m_first.size() < running.report().round)
                m_first.push_back(m_turn);
            m_turn = m_ticks.size();
            const auto& step = running.report().step;
            if (step && (moves.empty() || moves.back() != *step))
                moves.push_back(*step);
        };
    }
    std::vector<ResponseTaken> moves;

private:
    [[nodiscard]] static sim::ChainOptions phase(std::uint64_t seed) {
        sim::ChainOptions options;
        options.seed = seed;
        return options;
    }
    /// Called at least every half millisecond, so no tick is missed.
    void look() {
        const sim::ModuleSnapshot now = bus.chain.snapshot(ModuleIndex(0), bus.now);
        if (!m_watching || now.tick == m_tick)
            return;
        m_tick = now.tick;
        m_ticks.push_back(
            {now.servo.commandPosition, now.servo.commandPosition - now.servo.position, now.servo.position});
    }

    std::vector<MoveTick> m_ticks;
    std::vector<std::size_t> m_first;  ///< for each move, a tick before it
    std::size_t m_turn = 0;
    std::uint64_t m_tick = 0;
    bool m_watching = false;
};

/// Calculated from whole ticks, without interpolation.
struct TrueMove {
    double moveTime = 0.0;
    std::optional<double> settling;
    double peak = 0.0;
    double rms = 0.0;
};

[[nodiscard]] TrueMove truthOf(const std::vector<MoveTick>& ticks, const ResponseTaken& taken,
                               const SettleWindow& window) {
    TrueMove truth;
    std::size_t end = 0;
    double squares = 0.0;
    for (; end < ticks.size() && ticks[end].command != taken.goal; ++end)
        squares += ticks[end].error * ticks[end].error;
    // The command position was still at its start one tick of the servo before the first of these.
    truth.moveTime = static_cast<double>(end + taken.gains.sr) * kTick;
    truth.rms = std::sqrt(squares / static_cast<double>(end));
    const auto recorded = std::min(ticks.size(), static_cast<std::size_t>(taken.record / kTick));
    std::optional<std::size_t> since;
    for (std::size_t i = 0; i < recorded; ++i) {
        truth.peak = std::max(truth.peak, std::abs(ticks[i].error));
        if (std::abs(ticks[i].position - taken.goal) > window.counts) {
            since.reset();
            continue;
        }
        since = since.value_or(i);
        const std::size_t from = std::max(*since, end);
        if (!truth.settling && i >= from && static_cast<double>(i - from) * kTick >= window.dwell)
            truth.settling = static_cast<double>(from - end) * kTick;
    }
    return truth;
}

struct MoveTally {
    int moves = 0;
    int settled = 0;
    int unsettled = 0;
    int timesRight = 0;
    std::vector<double> late{};  ///< s, of the settling times that are not 0, from the true one
    int rmsRight = 0;
    int rmsInDoubt = 0;
    int peakInDoubt = 0;
};

/// At any `sr`, the motor moves and is damped about as at the highest servo rate.
void tryOut(std::mt19937& random, MoveTally& tally, std::uint8_t sr) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto spread = [&](double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    };
    MoveBench bench(random());
    servo::SetGain gains{static_cast<std::uint16_t>(spread(100, 800)),
                         static_cast<std::uint16_t>(spread(1'000, 8'000) / sr),
                         static_cast<std::uint16_t>(uniform(0, 60)),
                         static_cast<std::uint16_t>(uniform(0, 200)),
                         255,
                         0,
                         16'000,
                         sr,
                         std::uint8_t{0}};
    const double friction = uniform(0, 0.004);
    const double inertia = 1.7e-5 * spread(1, 4);
    ASSERT_TRUE(bench.hold(gains, inertia, friction));
    intent::StepSeries wanted;
    const auto counts = static_cast<std::int32_t>(spread(300, 20'000));
    wanted.each.method = ResponseMethod::Move;
    wanted.each.record = 0.5;
    const double velocity = spread(2, 25) * sr;  // counts per tick
    wanted.each.pace = {
        CountsPerTick(static_cast<std::uint32_t>(velocity * 65'536)),
        CountsPerTickSquared(static_cast<std::uint32_t>(velocity / spread(50, 400) * sr * 65'536))};
    wanted.counts = {counts, -counts};
    if (whyNot(wanted, bench.module()))
        return;
    const SettleWindow window{std::floor(spread(1, 40)), uniform(0.01, 0.2)};
    bench.watch();
    const ProcedureReport report = bench.run(wanted, 60);
    if (report.failure == ProcedureFailure::NotStill)  // these gains do not hold the motor still
        return;
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    if (bench.moves.empty() || bench.moves.back() != *report.step)
        bench.moves.push_back(*report.step);
    ASSERT_EQ(bench.moves.size(), 2U);
    for (const ResponseTaken& taken : bench.moves) {
        const ResponseRecord record = bench.recordOf(taken, window);
        const TrueMove truth = truthOf(bench.ticksOf(taken), taken, window);
        SCOPED_TRACE(testing::Message()
                     << "Kp " << gains.kp << " Kd " << gains.kd << " Ki " << gains.ki << " SR " << int{sr}
                     << " from " << taken.from << " to " << taken.goal << " velocity " << velocity
                     << " window " << window.counts << " for " << window.dwell);
        ASSERT_TRUE(record.move);
        ++tally.moves;
        const auto& settling = record.move->settling;
        (truth.settling ? tally.settled : tally.unsettled) += 1;
        tally.timesRight +=
            std::abs(record.move->moveTime - truth.moveTime) <= sr * kTick &&
                    settling.has_value() == truth.settling.has_value() &&
                    (!settling || std::abs(settling->value - *truth.settling) <= settling->doubt)
                ? 1
                : 0;
        if (settling && truth.settling && *truth.settling > 0)
            tally.late.push_back(settling->value - *truth.settling);
        ASSERT_TRUE(record.move->rms && record.move->peak);
        const double off = std::abs(record.move->rms->value - truth.rms);
        tally.rmsInDoubt += off <= record.move->rms->doubt ? 1 : 0;
        tally.peakInDoubt +=
            std::abs(record.move->peak->value - truth.peak) <= record.move->peak->doubt ? 1 : 0;
        tally.rmsRight += off <= 0.02 * truth.rms ? 1 : 0;
    }
}

class MoveTruth : public testing::TestWithParam<std::uint8_t> {};

TEST_P(MoveTruth, TimesAndErrorsFromTheWireAreThoseOfTheMotor) {
    const std::uint8_t sr = GetParam();
    std::mt19937 random(20'261'128);
    MoveTally tally;
    while (tally.moves < (sr == 1 ? 160 : 80) && !HasFatalFailure())
        tryOut(random, tally, sr);
    ASSERT_FALSE(tally.late.empty());
    const auto middle = tally.late.begin() + static_cast<long>(tally.late.size() / 2);
    std::nth_element(tally.late.begin(), middle, tally.late.end());
    std::printf(
        "SR %d: %d moves, %d settled; times within their doubt in %d, median settling time late by %.2f ms; "
        "RMS error within 2 %% in %d, within its doubt in %d; peak in %d\n",
        sr, tally.moves, tally.settled, tally.timesRight, *middle * 1e3, tally.rmsRight, tally.rmsInDoubt,
        tally.peakInDoubt);
    EXPECT_GT(tally.unsettled, 0);
    EXPECT_LT(std::abs(*middle), sr * kTick / 2);
    for (const int right : {tally.timesRight, tally.rmsInDoubt, tally.peakInDoubt})
        EXPECT_GE(right, 0.95 * tally.moves);
    // At other servo rates the tick in which the chip takes a step is not known.
    if (sr == 1) {
        EXPECT_GE(tally.rmsRight, 0.95 * tally.moves);
    }
}

INSTANTIATE_TEST_SUITE_P(All, MoveTruth, testing::Values(std::uint8_t{1}, std::uint8_t{2}, std::uint8_t{4}),
                         [](const auto& sr) { return "AtSr" + std::to_string(sr.param); });

}  // namespace
}  // namespace nmc::test
