// SPDX-License-Identifier: MIT
#include "model/frequency/frequencyresponse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/angle.h"
#include "base/time.h"
#include "model/frequency/othergains.h"

namespace nmc {

namespace {

using Complex = std::complex<double>;

struct SineReading {
    double seconds = 0.0;
    double value = 0.0;
};

struct SineFit {
    Complex phasor;
    double doubt = 0.0;
    double missed = 0.0;  ///< rms
};

/// Fits a cos + b sin + c + d t. The phasor is a - ib; its doubt is one standard deviation, assuming that
/// `samples` of the readings are independent.
[[nodiscard]] SineFit fitSine(const std::vector<SineReading>& readings, double hertz, std::size_t samples) {
    const auto rows = static_cast<Eigen::Index>(readings.size());
    Eigen::MatrixXd basis(rows, 4);
    Eigen::VectorXd values(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const SineReading& reading = readings[static_cast<std::size_t>(i)];
        const double angle = 2 * std::numbers::pi * hertz * reading.seconds;
        basis.row(i) << std::cos(angle), std::sin(angle), 1.0, reading.seconds;
        values[i] = reading.value;
    }
    const Eigen::LDLT<Eigen::Matrix4d> normal(basis.transpose() * basis);
    const Eigen::Vector4d found = normal.solve(basis.transpose() * values);
    const double free = std::max(1.0, static_cast<double>(samples) - 4);
    const double missed = (values - basis * found).squaredNorm();
    const Eigen::Matrix4d covariance = normal.solve(Eigen::Matrix4d::Identity()) * missed / free;
    return {{found[0], -found[1]},
            std::sqrt(std::max(covariance(0, 0), covariance(1, 1))),
            std::sqrt(missed / static_cast<double>(rows))};
}

/// Between two readings.
constexpr double kReadingTime = secondsPerTick(1);

/// The command, once per tick.
[[nodiscard]] std::vector<SineReading> commandsOf(const bus::SineRecord& record, double since) {
    std::vector<SineReading> readings;
    const auto seconds = [&](std::size_t i) {
        return toSeconds(record.commands[i].time - record.commands.front().time);
    };
    for (std::size_t i = 0; i + 1 < record.commands.size(); ++i)
        for (double t = seconds(i); t < seconds(i + 1); t += kReadingTime)
            if (t + kReadingTime >= since)
                readings.push_back({t + kReadingTime, static_cast<double>(record.commands[i].counts)});
    return readings;
}

/// The position once per tick as well, interpolated linearly between samples. Without interpolation, the
/// samples would always fall on the same places of the command's steps, which would shift the phase of the
/// motor by their position. Gaps of more than half a period are left out.
[[nodiscard]] std::vector<SineReading> positionsOf(const std::vector<SineReading>& samples, double since) {
    std::vector<SineReading> readings;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const SineReading& from = samples[i];
        const SineReading& to = samples[i + 1];
        if (to.seconds - from.seconds > since / 2)
            continue;
        const double slope = (to.value - from.value) / (to.seconds - from.seconds);
        for (double t = from.seconds; t < to.seconds; t += kReadingTime)
            if (t >= since)
                readings.push_back({t, from.value + slope * (t - from.seconds)});
    }
    return readings;
}

/// The samples in order of time, without duplicate times.
[[nodiscard]] std::vector<SineReading> samplesOf(const bus::SineRecord& record) {
    std::vector<SineReading> samples;
    for (const auto* points : {&record.answers, &record.polls})
        for (const bus::SinePoint& point : *points)
            samples.push_back(
                {toSeconds(point.time - record.commands.front().time), static_cast<double>(point.counts)});
    std::ranges::sort(samples, {}, &SineReading::seconds);
    const auto sameTime = [](const SineReading& a, const SineReading& b) { return a.seconds == b.seconds; };
    samples.erase(std::unique(samples.begin(), samples.end(), sameTime), samples.end());
    return samples;
}

/// Interpolates linearly between two values, at `part` of the way.
[[nodiscard]] double between(double from, double to, double part) {
    return from + part * (to - from);
}

}  // namespace

std::optional<FrequencyPoint> measureFrequency(const bus::SineRecord& record, double hertz) {
    const double since = 1 / hertz;
    if (record.commands.empty())
        return std::nullopt;
    const std::vector<SineReading> samples = samplesOf(record);
    if (samples.size() < kFewestPoints)
        return std::nullopt;
    for (std::size_t i = 1; i < samples.size(); ++i)
        if (samples[i].seconds - samples[i - 1].seconds > std::max(kSilence, since / 2))
            return std::nullopt;
    const std::vector<SineReading> commands = commandsOf(record, since);
    const std::vector<SineReading> positions = positionsOf(samples, since);
    if (positions.size() < kFewestPoints || commands.size() < kFewestPoints)
        return std::nullopt;
    const SineFit command = fitSine(commands, hertz, samples.size());
    const SineFit position = fitSine(positions, hertz, samples.size());
    const double size = std::abs(command.phasor);
    if (size <= 0)
        return std::nullopt;
    const double unlike = position.missed * position.missed - command.missed * command.missed;
    return FrequencyPoint{hertz, position.phasor / command.phasor, position.doubt / size,
                          std::sqrt(std::max(0.0, unlike))};
}

double doubtOfWholePwm(const FrequencyPoint& point, const servo::SetGain& gains, double amplitude) {
    const double lost = 2 / std::numbers::pi / (std::abs(filterAt(gains, point.hertz)) / 256 * amplitude);
    return std::abs(point.closed) * (lost < 1 ? std::min(1.0, lost / (1 - lost)) : 1.0) / 2;
}

double commandsPerSecond(std::span<const bus::SinePoint> commands) {
    if (commands.size() < 2)
        return 0.0;
    const double seconds = toSeconds(commands.back().time - commands.front().time);
    return seconds > 0 ? static_cast<double>(commands.size() - 1) / seconds : 0.0;
}

double decibels(Complex value) {
    return std::max(kFaintest, 20 * std::log10(std::abs(value)));
}

FrequencySpread spreadOf(const FrequencyPoint& point) {
    const double size = std::abs(point.closed);
    const double wide = 2 * point.doubt;
    FrequencySpread spread{kFaintest, decibels(size + wide), 180.0};
    if (wide < size) {
        spread.lowest = decibels(size - wide);
        spread.degrees = std::asin(wide / size) * kDegrees;
    }
    return spread;
}

std::vector<double> phases(std::span<const Complex> values) {
    constexpr double kMiddlePhase = -90;  // a loop lags, by up to 270 degrees
    std::vector<double> phases;
    for (const Complex& value : values) {
        const double own = std::arg(value) * kDegrees;
        const double before = phases.empty() ? kMiddlePhase : phases.back();
        phases.push_back(before + std::remainder(own - before, 360.0));
    }
    return phases;
}

FrequencyFigures figuresOf(std::span<const FrequencyPoint> points) {
    FrequencyFigures figures;
    std::vector<Complex> open;
    for (const FrequencyPoint& point : points)
        open.push_back(point.open());
    const std::vector<double> turned = phases(open);
    // The fraction of the interval at which a value falls below a level, on a straight line between two
    // points.
    const auto falls = [](double before, double after, double level) -> std::optional<double> {
        if (before < level || after >= level)
            return std::nullopt;
        return (before - level) / (before - after);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double closed = decibels(points[i].closed);
        figures.resonance = i == 0 ? closed : std::max(figures.resonance, closed);
        if (i == 0)
            continue;
        const auto hertz = [&](double part) {
            return std::exp(between(std::log(points[i - 1].hertz), std::log(points[i].hertz), part));
        };
        const double decibelsBefore = decibels(open[i - 1]);
        const double decibelsAfter = decibels(open[i]);
        constexpr double kHalfPower = -3.0103;
        if (const auto part = falls(decibels(points[i - 1].closed), closed, kHalfPower);
            part && !figures.bandwidth)
            figures.bandwidth = hertz(*part);
        if (const auto part = falls(decibelsBefore, decibelsAfter, 0.0); part && !figures.crossover) {
            figures.crossover = hertz(*part);
            figures.phaseMargin = std::remainder(180 + between(turned[i - 1], turned[i], *part), 360.0);
        }
        // The phase above the nearest odd number of half turns: the negative real axis.
        const double marginBefore = std::remainder(180 + turned[i - 1], 360.0);
        const double marginAfter = marginBefore + turned[i] - turned[i - 1];
        if (const auto part = falls(marginBefore, marginAfter, 0.0))
            figures.gainMargin =
                std::min(figures.gainMargin.value_or(std::numeric_limits<double>::infinity()),
                         std::pow(10, -between(decibelsBefore, decibelsAfter, *part) / 20));
        // Where the phase comes back while |L| is above 1, the curve does not go around -1.
        if (marginBefore < 0 && marginAfter >= 0 && decibelsAfter > 0)
            figures.gainMargin.reset();
    }
    return figures;
}

bool isUnstable(const FrequencyFigures& figures) {
    return figures.phaseMargin.value_or(1.0) <= 0.0 || figures.gainMargin.value_or(2.0) <= 1.0;
}

}  // namespace nmc
