// SPDX-License-Identifier: MIT
#include "model/tuning/identify.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/time.h"

namespace nmc {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The unknowns: first those of the motor, then those of each run.
constexpr Index kPush = 0;  ///< log(K / tau): the acceleration per PWM count
constexpr Index kTau = 1;   ///< log tau
constexpr Index kFriction = 2;
constexpr Index kLoad = 3;
constexpr Index kDelay = 4;  ///< ticks of 0.512 ms
constexpr Index kDeadband = 5;
constexpr Index kPlay = 6;  ///< counts
constexpr Index kOfMotor = 7;
constexpr Index kStart = 0;  ///< ticks of 0.512 ms
constexpr Index kPlace = 1;  ///< counts; shaft position relative to the encoder reading
constexpr Index kHeld = 2;   ///< the integral's place in the range that friction leaves it, -1..1
constexpr Index kSlack = 3;  ///< fraction of the play by which the shaft is ahead, 0..1
constexpr Index kOfRun = 4;

const double kTick = toSeconds(kServoTick);

/// Counts²: variance of rounding to whole counts, doubled for the whole counts that the filter receives.
constexpr double kWholeCount = 2.0 / 12;
/// PWM counts: standard deviation of truncating to whole counts.
constexpr double kPwmSpread = 0.29;
/// Counts: standard deviation of rounding the play to whole counts.
constexpr double kPlaySpread = 0.29;
/// s²: variance of a sample's time, which is off by up to half a tick (bus::Sample).
const double kTimeSpread = kTick * kTick / 12;

/// Prior knowledge of an unknown, and its limits.
struct Bounds {
    double likely = 0.0;
    double spread = 0.0;
    double least = 0.0;
    double most = 0.0;
};

struct Reading {
    double seconds = 0.0;
    double position = 0.0;
    double spread = 0.0;  ///< counts
    double weight = 0.0;  ///< 1 / spread; smaller where a shaft at rest repeats the same reading
};

struct Record {
    const ResponseRecord* run = nullptr;
    double stood = 0.0;    ///< counts, mean position before the step
    double squares = 0.0;  ///< counts², sum of squared deviations of the encoder from `stood`
    double before = 0.0;   ///< number of readings before the step
    std::vector<Reading> readings;

    [[nodiscard]] double from() const { return run->taken.from; }
    [[nodiscard]] double goal() const { return run->taken.goal; }
    [[nodiscard]] double step() const { return goal() - from(); }
    [[nodiscard]] const servo::SetGain& gains() const { return run->taken.gains; }
};

[[nodiscard]] double speedAt(const std::vector<ResponsePoint>& points, std::size_t i) {
    const ResponsePoint& a = points[i == 0 ? 0 : i - 1];
    const ResponsePoint& b = points[std::min(i + 1, points.size() - 1)];
    return b.seconds > a.seconds ? std::abs(b.position - a.position) / (b.seconds - a.seconds) : 0.0;
}

/// Number of consecutive samples around this one with the same position.
[[nodiscard]] std::size_t repeats(const std::vector<ResponsePoint>& points, std::size_t i) {
    std::size_t first = i;
    std::size_t last = i;
    while (first > 0 && points[first - 1].position == points[i].position)
        --first;
    while (last + 1 < points.size() && points[last + 1].position == points[i].position)
        ++last;
    return last - first + 1;
}

[[nodiscard]] Record recordOf(const ResponseRecord& run) {
    Record record;
    record.run = &run;
    for (const ResponsePoint& point : run.points)
        if (point.seconds <= 0) {
            record.stood += point.position;
            ++record.before;
        }
    record.stood /= std::max(1.0, record.before);
    for (std::size_t i = 0; i < run.points.size(); ++i) {
        const ResponsePoint& point = run.points[i];
        if (point.seconds <= 0) {
            record.squares += (point.position - record.stood) * (point.position - record.stood);
            continue;
        }
        const double speed = speedAt(run.points, i);
        const double spread = std::sqrt(kWholeCount + speed * speed * kTimeSpread);
        const auto same = static_cast<double>(repeats(run.points, i));
        record.readings.push_back({point.seconds, point.position, spread,
                                   1 / std::sqrt(spread * spread + kWholeCount * (same - 1))});
    }
    if (record.before == 0 && !record.readings.empty())
        record.stood = record.readings.front().position;
    return record;
}

/// Returns the encoder's noise in counts rms, as seen while the shaft stood before the steps, and reduces the
/// weight of the readings accordingly.
[[nodiscard]] double countNoise(std::vector<Record>& records) {
    constexpr double kMost = 1.0;  // counts; more means that the shaft does not stand
    double squares = 0.0, free = 0.0;
    for (const Record& record : records) {
        squares += record.squares;
        free += std::max(0.0, record.before - 1);
    }
    const double variance = free > 0 ? std::min(kMost, squares / free) : 0.0;
    for (Record& record : records)
        for (Reading& reading : record.readings) {
            reading.weight = 1 / std::sqrt(1 / (reading.weight * reading.weight) + variance);
            reading.spread = std::sqrt(reading.spread * reading.spread + variance);
        }
    return std::sqrt(variance);
}

class Fit {
public:
    explicit Fit(const std::vector<Record>& records) : m_records(records) {
        m_bounds = {{std::log(1e4), 10.0, std::log(0.1), std::log(1e9)},
                    {std::log(0.05), 5.0, std::log(2e-4), std::log(50.0)},
                    {0.0, 100.0, 0.0, 255.0},
                    {0.0, 100.0, -255.0, 255.0},
                    {1.0, 0.6, 0.0, double{Loop::kLongestDelay}},
                    {0.0, 10.0, 0.0, 100.0},
                    {0.0, 3.0, 0.0, kMostPlay}};
        for (const Record& record : records) {
            const double sr = secondsPerTick(record.gains().sr) / kTick;
            m_bounds.push_back({(sr + 1) / 2, std::sqrt((sr * sr + 1) / 12), -1.0, sr + 2});
            m_bounds.push_back({0.0, 0.3, -0.5, 0.5});
            m_bounds.push_back({0.0, 0.6, -1.0, 1.0});
            m_bounds.push_back({0.5, 0.3, 0.0, 1.0});
        }
        for (const Record& record : records)
            m_readings += static_cast<Index>(record.readings.size());
    }

    [[nodiscard]] VectorXd likely() const {
        VectorXd x(static_cast<Index>(m_bounds.size()));
        for (Index i = 0; i < x.size(); ++i)
            x[i] = bounds(i).likely;
        return x;
    }

    /// Returns a fit of the same motors with a second mass on a spring.
    [[nodiscard]] Fit swinging(double second, double hertz) const {
        Fit other = *this;
        other.m_second = second;
        other.m_resonance = hertz;
        return other;
    }

    [[nodiscard]] MotorConstants motor(const VectorXd& x) const {
        return {std::exp(x[kPush] + x[kTau]),
                std::exp(x[kTau]),
                x[kFriction],
                x[kLoad],
                x[kDelay] * kTick,
                x[kDeadband],
                x[kPlay],
                0.0,
                m_second,
                m_resonance};
    }

    [[nodiscard]] LoopStart start(const VectorXd& x, std::size_t run) const {
        const Record& record = m_records[run];
        const servo::SetGain& gains = record.gains();
        LoopStart start{record.stood + of(x, run, kPlace), record.from(), 0.0, of(x, run, kSlack)};
        // The truncation of the filter lets friction hold a little more.
        MotorConstants motor = this->motor(x);
        motor.friction += 1;
        const double held =
            holdingRange(motor).at(of(x, run, kHeld)) - gains.kp * (start.command - start.position) / 256;
        if (gains.ki > 0)
            start.integral = std::clamp(held * 256 / gains.ki, -1.0 * gains.il, 1.0 * gains.il);
        return start;
    }

    [[nodiscard]] Loop loop(const VectorXd& x, std::size_t run) const {
        return {motor(x), m_records[run].gains(), start(x, run), m_records[run].goal(), Rounding::Mean};
    }

    [[nodiscard]] static double of(const VectorXd& x, std::size_t run, Index which) {
        return x[kOfMotor + kOfRun * static_cast<Index>(run) + which];
    }

    /// Fills in the weighted residuals: those of the readings of one run, then the amount by which the shaft
    /// could not have stood still before the step.
    void missesOf(const VectorXd& x, std::size_t run, Eigen::Ref<VectorXd> misses) const {
        Loop loop = this->loop(x, run);
        const double begin = of(x, run, kStart) * kTick;
        Index row = 0;
        for (const Reading& reading : m_records[run].readings)
            misses[row++] = (reading.position - loop.at(reading.seconds - begin).position) * reading.weight;
        const LoopStart start = this->start(x, run);
        const ControlFilter filter(m_records[run].gains(), Rounding::Mean, start.integral,
                                   start.command - start.position, x[kDeadband]);
        misses[row] = std::max(0.0, std::abs(filter.standing() + x[kLoad]) - x[kFriction]) / kPwmSpread;
    }

    [[nodiscard]] Index rowsOf(std::size_t run) const {
        return static_cast<Index>(m_records[run].readings.size()) + 1;
    }
    [[nodiscard]] Index rows() const {
        return m_readings + static_cast<Index>(m_records.size()) + static_cast<Index>(m_bounds.size());
    }

    [[nodiscard]] VectorXd misses(const VectorXd& x) const {
        VectorXd all(rows());
        Index row = 0;
        for (std::size_t run = 0; run < m_records.size(); ++run) {
            missesOf(x, run, all.segment(row, rowsOf(run)));
            row += rowsOf(run);
        }
        for (Index i = 0; i < x.size(); ++i)
            all[row + i] = (x[i] - bounds(i).likely) / bounds(i).spread;
        return all;
    }

    [[nodiscard]] MatrixXd jacobian(const VectorXd& x) const {
        MatrixXd all = MatrixXd::Zero(rows(), x.size());
        Index row = 0;
        for (std::size_t run = 0; run < m_records.size(); ++run) {
            const Index first = kOfMotor + kOfRun * static_cast<Index>(run);
            const auto column = [&](Index i) { all.block(row, i, rowsOf(run), 1) = slope(x, run, i); };
            for (Index i = 0; i < kOfMotor; ++i)
                column(i);
            for (Index i = first; i < first + kOfRun; ++i)
                column(i);
            row += rowsOf(run);
        }
        for (Index i = 0; i < x.size(); ++i)
            all(row + i, i) = 1 / bounds(i).spread;
        return all;
    }

    /// PWM counts; the largest value that an integral can carry.
    [[nodiscard]] double carried() const {
        double most = 0.0;
        for (const Record& record : m_records)
            most = std::max(most, record.gains().ki * record.gains().il / 256.0);
        return most;
    }
    /// PWM counts of load beyond what the integral can carry. That part is held by a position error, which
    /// exists before the steps. 0 where the error is negligible.
    [[nodiscard]] double beyondIntegral() const {
        constexpr double kOff = 3.0;  // counts
        double held = 0.0;
        for (const Record& record : m_records) {
            const double off = record.from() - record.stood;
            if (std::abs(off) < kOff)
                return 0.0;
            held -= record.gains().kp * off / 256;
        }
        held /= static_cast<double>(m_records.size());
        return held + std::copysign(carried(), held);
    }
    [[nodiscard]] const Bounds& bounds(Index i) const { return m_bounds[static_cast<std::size_t>(i)]; }

private:
    [[nodiscard]] VectorXd slope(const VectorXd& x, std::size_t run, Index i) const {
        const double by = i < kFriction ? 2e-3 : 2e-2;
        VectorXd high = x;
        VectorXd low = x;
        high[i] = std::min(x[i] + by, bounds(i).most);
        low[i] = std::max(x[i] - by, bounds(i).least);
        VectorXd above(rowsOf(run));
        VectorXd below(rowsOf(run));
        missesOf(high, run, above);
        missesOf(low, run, below);
        return (above - below) / (high[i] - low[i]);
    }

    const std::vector<Record>& m_records;
    std::vector<Bounds> m_bounds;
    Index m_readings = 0;
    double m_second = 0.0;  ///< as in MotorConstants
    double m_resonance = 0.0;
};

struct Solution {
    VectorXd x;
    double cost = std::numeric_limits<double>::infinity();  ///< sum of squares
};

struct Found {
    Solution best;
    std::vector<Solution> others;  ///< solutions with other loads
};

/// Levenberg-Marquardt within bounds: an unknown that is at a bound and pushes beyond it stays there for the
/// step.
[[nodiscard]] Solution descend(const Fit& fit, VectorXd x, int steps) {
    constexpr double kEnough = 1e-4;
    VectorXd misses = fit.misses(x);
    double cost = misses.squaredNorm();
    double damping = 1e-2;
    for (int step = 0; step < steps; ++step) {
        const MatrixXd jacobian = fit.jacobian(x);
        const VectorXd gradient = jacobian.transpose() * misses;
        MatrixXd square = jacobian.transpose() * jacobian;
        VectorXd downhill = -gradient;
        for (Index i = 0; i < x.size(); ++i) {
            const bool stays = (x[i] <= fit.bounds(i).least && gradient[i] > 0) ||
                               (x[i] >= fit.bounds(i).most && gradient[i] < 0);
            if (!stays)
                continue;
            square.row(i).setZero();
            square.col(i).setZero();
            square(i, i) = 1;
            downhill[i] = 0;
        }
        bool better = false;
        for (int attempt = 0; attempt < 8 && !better; ++attempt) {
            MatrixXd damped = square;
            damped.diagonal() *= 1 + damping;
            VectorXd next = x + damped.ldlt().solve(downhill);
            for (Index i = 0; i < x.size(); ++i)
                next[i] = std::clamp(next[i], fit.bounds(i).least, fit.bounds(i).most);
            const VectorXd there = fit.misses(next);
            const double costThere = there.squaredNorm();
            better = costThere < cost;
            damping = better ? damping / 5 : damping * 6;
            if (!better)
                continue;
            const bool enough = cost - costThere < kEnough * cost;
            x = next;
            misses = there;
            cost = costThere;
            if (enough)
                return {x, cost};
        }
        if (!better)
            break;
    }
    return {x, cost};
}

/// Searches a coarse grid of plausible motors with these frictions, and refines the best few.
[[nodiscard]] Found solve(const Fit& fit, std::span<const double> frictions, double play) {
    constexpr double kMinPush = 30.0, kMaxPush = 3e6, kPushStep = 1.5;
    constexpr double kMinTau = 2e-3, kMaxTau = 2.0, kTauStep = 2.2;
    constexpr std::size_t kTried = 5;
    const double load = fit.beyondIntegral();
    std::vector<Solution> starts;
    for (double tau = kMinTau; tau < kMaxTau; tau *= kTauStep)
        for (const double friction : frictions) {
            Solution best;
            for (double push = kMinPush; push < kMaxPush; push *= kPushStep) {
                VectorXd x = fit.likely();
                x[kPush] = std::log(push);
                x[kTau] = std::log(tau);
                x[kFriction] = friction;
                x[kLoad] = load;
                x[kPlay] = play;
                const double cost = fit.misses(x).squaredNorm();
                if (cost < best.cost)
                    best = {x, cost};
            }
            starts.push_back(best);
        }
    std::ranges::sort(starts, {}, &Solution::cost);
    Solution best;
    for (std::size_t i = 0; i < std::min(kTried, starts.size()); ++i) {
        const Solution found = descend(fit, starts[i].x, 12);
        if (found.cost < best.cost)
            best = found;
    }
    // Within its limit, an integral carries any load equally well; the actual load only shows if the integral
    // meets its limit, so several loads are tried.
    std::vector<Solution> others = {best};
    for (const double part : {-0.6, -0.25, 0.25, 0.6}) {
        VectorXd x = others.front().x;
        x[kLoad] = part * fit.carried();
        if (fit.carried() == 0)
            break;
        others.push_back(descend(fit, x, 8));
        if (others.back().cost < best.cost)
            best = others.back();
    }
    return {descend(fit, best.x, 60), others};
}

/// Checks that the motor moved far enough in the direction of the step.
[[nodiscard]] std::optional<IdentifyFailure> motionProblem(const Record& record) {
    const double direction = record.step() < 0 ? -1.0 : 1.0;
    const double enough = std::max(3.0, std::abs(record.step()) * 0.03);
    for (const Reading& reading : record.readings) {
        const double gone = (reading.position - record.stood) * direction;
        if (gone >= enough)
            return std::nullopt;
        if (gone <= -enough)
            return IdentifyFailure::WrongWay;
    }
    return IdentifyFailure::DoesNotMove;
}

/// True when the motor reverses again and again, and the last swings are as wide as those before them.
[[nodiscard]] bool swings(const Record& record) {
    constexpr std::size_t kHalfSwings = 8;
    constexpr double kCalming = 0.93;
    const double noticed = std::max(4.0, std::abs(record.step()) * 0.05);
    std::vector<double> turns;  // positions
    double high = record.stood;
    double low = record.stood;
    bool rising = record.step() > 0;
    for (const Reading& reading : record.readings) {
        high = std::max(high, reading.position);
        low = std::min(low, reading.position);
        if (rising && reading.position < high - noticed) {
            turns.push_back(high);
            low = reading.position;
            rising = false;
        } else if (!rising && reading.position > low + noticed) {
            turns.push_back(low);
            high = reading.position;
            rising = true;
        }
    }
    if (turns.size() < kHalfSwings)
        return false;
    const auto width = [&turns](std::size_t i) { return std::abs(turns[i] - turns[i - 1]); };
    const std::size_t last = turns.size() - 1;
    const double late = width(last) + width(last - 1);
    const double early = width(last - 4) + width(last - 5);
    return late > early * kCalming * kCalming;
}

/// True when the motor comes to rest short of its goal after moving at nearly its top speed in the interval
/// before the last. Friction and the filter would let a motor slow down gradually.
[[nodiscard]] bool stopsDead(const Record& record) {
    constexpr double kShort = 0.05;  // of the step
    constexpr double kNearly = 0.6;
    const double direction = record.step() < 0 ? -1.0 : 1.0;
    const double step = std::abs(record.step());
    const auto gone = [&](const Reading& reading) { return (reading.position - record.stood) * direction; };
    const double end = gone(record.readings.back());
    // If the shaft moves back from its farthest position, nothing was in its way.
    const auto beyond = [&](const Reading& reading) {
        return gone(reading) > end + std::max(2.0, kShort * end);
    };
    if (step - end < std::max(3.0, kShort * step) ||
        std::any_of(record.readings.begin(), record.readings.end(), beyond))
        return false;
    double fastest = 0.0;
    double last = 0.0;
    Reading before{0.0, record.stood, 0.0, 0.0};
    for (const Reading& here : record.readings) {
        if (gone(here) >= end - 1)
            break;
        last = (gone(here) - gone(before)) / (here.seconds - before.seconds);
        fastest = std::max(fastest, last);
        before = here;
    }
    return fastest > 0 && last >= kNearly * fastest;
}

[[nodiscard]] Identified identified(const Fit& fit, const std::vector<Record>& records,
                                    const Found& solution) {
    Identified found;
    const VectorXd& x = solution.best.x;
    double missed = 0.0, expected = 0.0, weighted = 0.0, next = 0.0, count = 0.0;
    for (std::size_t run = 0; run < records.size(); ++run) {
        Loop loop = fit.loop(x, run);
        const double start = Fit::of(x, run, kStart) * kTick;
        std::vector<ResponsePoint> fitted;
        for (const ResponsePoint& point : records[run].run->points)
            fitted.push_back({point.seconds, loop.at(point.seconds - start).position});
        const std::size_t before = fitted.size() - records[run].readings.size();
        double last = 0.0;
        for (std::size_t i = 0; i < records[run].readings.size(); ++i) {
            const Reading& reading = records[run].readings[i];
            const double miss = reading.position - fitted[before + i].position;
            missed += miss * miss;
            expected += reading.spread * reading.spread;
            weighted += miss * miss * reading.weight * reading.weight;
            next += miss * reading.weight * last;
            last = miss * reading.weight;
            ++count;
        }
        found.runs.push_back(std::move(fitted));
    }
    found.missed = std::sqrt(missed / count);
    found.expected = std::sqrt(expected / count);

    // Residuals that exceed the expected ones, and residuals that are correlated, carry less information.
    const double alike = std::clamp(next / std::max(weighted, 1e-9), 0.0, 0.9);
    const double inflation = std::max(1.0, weighted / count) * (1 + alike) / (1 - alike);
    const MatrixXd jacobian = fit.jacobian(x);
    const MatrixXd square = jacobian.transpose() * jacobian;
    const MatrixXd covariance = square.ldlt().solve(MatrixXd::Identity(x.size(), x.size())) * inflation;
    // A second mass of half the inertia is visible where the part of its effect that no other constant can
    // absorb is at least two standard deviations.
    const VectorXd rigid = fit.misses(x);
    const auto shows = [&](double hertz) {
        constexpr double kLittle = 0.05, kSecond = 0.5;
        const VectorXd trace = (fit.swinging(kLittle, hertz).misses(x) - rigid) / kLittle;
        const VectorXd own = trace - jacobian * square.ldlt().solve(jacobian.transpose() * trace);
        return own.norm() * kSecond > 2 * std::sqrt(inflation);
    };
    found.motor.rigidUpTo = kLowestResonance;
    constexpr double kNext = 1.12;
    while (*found.motor.rigidUpTo < kHighestResonance && shows(*found.motor.rigidUpTo))
        *found.motor.rigidUpTo *= kNext;
    // K is exp(kPush) times tau; the other constants are unknowns themselves.
    MatrixXd constants = MatrixXd::Identity(kOfMotor, kOfMotor);
    constants(kPush, kTau) = 1;
    MatrixXd spread = constants * covariance.topLeftCorner(kOfMotor, kOfMotor) * constants.transpose();
    // The model is not the motor: the lag of an inductance partly goes into tau, and a quarter of a tick more
    // or less of delay cannot be distinguished from it; PWM values and counts are whole numbers.
    const MotorConstants motor = fit.motor(x);
    constexpr double kDelaySpread = 0.25;  // ticks
    const double own = std::hypot(0.015, motor.delay / motor.timeConstant);
    VectorXd more(kOfMotor);
    more << own, own, std::hypot(kPwmSpread, own * motor.friction), kPwmSpread, kDelaySpread,
        std::hypot(kPwmSpread, own * motor.deadband), kPlaySpread;
    spread.diagonal() += more.cwiseAbs2();
    const VectorXd doubt = spread.diagonal().cwiseSqrt();
    for (Index i = 0; i < kOfMotor; ++i)
        for (Index j = 0; j < kOfMotor; ++j)
            found.motor.correlation[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
                spread(i, j) / (doubt[i] * doubt[j]);
    found.motor.gain = {motor.gain, motor.gain * doubt[kPush]};
    found.motor.timeConstant = {motor.timeConstant, motor.timeConstant * doubt[kTau]};
    found.motor.friction = {motor.friction, doubt[kFriction]};
    found.motor.load = {motor.load, doubt[kLoad]};
    found.motor.delay = {motor.delay, doubt[kDelay] * kTick};
    found.motor.deadband = {motor.deadband, doubt[kDeadband]};
    found.motor.play = {motor.play, doubt[kPlay]};
    // Other solutions that explain the steps as well have different loads, and it is unknown which one is
    // right.
    constexpr double kAsWell = 9.0;
    for (const Solution& other : solution.others)
        if (other.cost < solution.best.cost + kAsWell * inflation)
            found.motor.load.doubt = std::max(found.motor.load.doubt, std::abs(other.x[kLoad] - motor.load));
    return found;
}

}  // namespace

tl::expected<Identified, IdentifyFailure> identify(std::span<const ResponseRecord> runs) {
    std::vector<Record> records;
    for (const ResponseRecord& run : runs.first(std::min(runs.size(), kMaxRuns)))
        records.push_back(recordOf(run));
    if (records.empty())
        return tl::unexpected(IdentifyFailure::TooFewSamples);
    for (const Record& record : records)
        if (record.readings.size() < kFewestSamples)
            return tl::unexpected(IdentifyFailure::TooFewSamples);
    for (const Record& record : records)
        if (const auto problem = motionProblem(record))
            return tl::unexpected(*problem);
    if (std::any_of(records.begin(), records.end(), swings))
        return tl::unexpected(IdentifyFailure::Oscillates);

    double longest = 0.0;
    for (const Record& record : records)
        longest = std::max(longest, std::abs(record.step()));
    const auto isExplained = [longest](const Identified& found) {
        // A motor does not match the model exactly: allow half a thousandth of its travel beyond what encoder
        // and times explain.
        constexpr double kFarAbove = 1.7;
        constexpr double kOfTheStep = 5e-4;
        return found.missed <= kFarAbove * found.expected + kOfTheStep * longest;
    };
    const double noise = countNoise(records);
    constexpr std::array kFrictions = {0.1, 1.0, 6.0};
    // When friction and load together exceed what an integral can carry, there are local minima beside the
    // right one.
    constexpr std::array kMuchFriction = {3.0, 6.0, 12.0, 20.0};
    const Fit fit(records);
    constexpr double kMuchPlay = 6.0;
    Identified found = identified(fit, records, solve(fit, kFrictions, 0.0));
    const auto tryAgain = [&](std::span<const double> frictions, double play) {
        if (isExplained(found))
            return;
        Identified other = identified(fit, records, solve(fit, frictions, play));
        if (other.missed < found.missed)
            found = std::move(other);
    };
    tryAgain(kMuchFriction, 0.0);
    tryAgain(kFrictions, kMuchPlay);
    found.motor.noise = noise;
    constexpr double kClear = 0.5;
    const auto isClear = [](const Measured& measured) { return measured.doubt <= kClear * measured.value; };
    const bool good = isExplained(found) && isClear(found.motor.gain) && isClear(found.motor.timeConstant);
    if (!good && std::any_of(records.begin(), records.end(), stopsDead))
        return tl::unexpected(IdentifyFailure::Obstacle);
    if (found.motor.play.value > kMostPlay - 0.1)
        return tl::unexpected(IdentifyFailure::Play);
    // An inexact model is still useful: its residuals widen its doubts.
    constexpr double kRoughly = 4.0;
    if (!isExplained(found) && found.missed > kRoughly * found.expected)
        return tl::unexpected(IdentifyFailure::NotExplained);
    if (!isClear(found.motor.gain))
        return tl::unexpected(IdentifyFailure::GainUnclear);
    if (!isClear(found.motor.timeConstant))
        return tl::unexpected(IdentifyFailure::TimeConstantUnclear);
    return found;
}

}  // namespace nmc
