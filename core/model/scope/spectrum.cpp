// SPDX-License-Identifier: MIT
#include "model/scope/spectrum.h"

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace nmc {

namespace {

using Complex = std::complex<double>;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kPointsPerLine = 4;      ///< points per 1/stretch, so that none of them misses a line
constexpr double kSlowestLine = 2;        ///< periods per stretch; what is slower may be drift
constexpr double kFalseAlarms = 0.01;     ///< per spectrum of noise
constexpr std::size_t kMeshPerPoint = 8;  ///< mesh points per frequency: the sums are off by less than 1 %

/// A value about its mean, with its share in the window.
struct Weighted {
    double seconds = 0;
    double weight = 0;
    double value = 0;
};

/// The sums over all samples, with e = exp(-i w t).
struct Sums {
    Complex weights;  ///< of weight e
    Complex doubled;  ///< of weight e^2
    Complex values;   ///< of weight value e
};

/// Amplitude of the sine that, with an offset, fits best by weighted least squares. The weights add up to 1,
/// and the weighted mean of the values is 0 (Zechmeister and Kürster 2009, equations 5 to 15).
double amplitudeOf(const Sums& sums) {
    const double c = sums.weights.real();
    const double s = -sums.weights.imag();
    const double cc = (1 + sums.doubled.real()) / 2 - c * c;
    const double ss = (1 - sums.doubled.real()) / 2 - s * s;
    const double cs = -sums.doubled.imag() / 2 - c * s;
    const double yc = sums.values.real();
    const double ys = -sums.values.imag();
    const double d = cc * ss - cs * cs;
    return d > 0 ? std::hypot(yc * ss - ys * cs, ys * cc - yc * cs) / d : 0.0;
}

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The interval between samples between which nothing is missing; 0 if there are none.
double usualInterval(const std::vector<SignalPoint>& points) {
    std::vector<double> intervals;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].joined)
            intervals.push_back(points[i].seconds - points[i - 1].seconds);
    return intervals.empty() ? 0.0 : medianOf(std::move(intervals));
}

/// A sample weighs as much as the time that it stands for, so that an uneven rate is no noise, but not more
/// than a few usual intervals, so that the ends of a gap do not outweigh the rest.
std::vector<Weighted> weighted(const std::vector<SignalPoint>& points, double usual) {
    constexpr double kMostIntervals = 3;
    const double first = points.front().seconds;
    const double stretch = points.back().seconds - first;
    const auto line = lineThrough(points);
    std::vector<Weighted> samples;
    samples.reserve(points.size());
    double weights = 0, mean = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double before = points[i > 0 ? i - 1 : i].seconds;
        const double after = points[std::min(i + 1, points.size() - 1)].seconds;
        const double at = points[i].seconds - first;
        const double weight =
            (1 - std::cos(kTurn * at / stretch)) * std::min((after - before) / 2, kMostIntervals * usual);
        samples.push_back({at, weight, points[i].value - line->at(points[i].seconds)});
        weights += weight;
        mean += weight * samples.back().value;
    }
    mean /= weights;
    for (Weighted& sample : samples) {
        sample.weight /= weights;
        sample.value -= mean;
    }
    return samples;
}

double amplitudeAt(const std::vector<Weighted>& samples, double hertz) {
    Sums sums;
    for (const Weighted& sample : samples) {
        const Complex turned = std::polar(1.0, -kTurn * hertz * sample.seconds);
        sums.weights += sample.weight * turned;
        sums.doubled += sample.weight * turned * turned;
        sums.values += sample.weight * sample.value * turned;
    }
    return amplitudeOf(sums);
}

/// The sums of value e at all multiples of 1/period, by a fast Fourier transform of values that are spread
/// to the four nearest points of a mesh (Press and Rybicki 1989).
class Mesh {
public:
    Mesh(std::size_t size, double period) : m_values(size), m_perSecond(static_cast<double>(size) / period) {}

    void add(double seconds, double value) {
        const double place = seconds * m_perSecond;
        const double t = place - std::floor(place);
        const auto base = static_cast<std::size_t>(place) + m_values.size();
        const std::array shares{-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2,
                                -(t + 1) * t * (t - 2) / 2, (t + 1) * t * (t - 1) / 6};
        for (std::size_t i = 0; i < shares.size(); ++i)
            m_values[(base + i - 1) % m_values.size()] += value * shares[i];
    }
    [[nodiscard]] std::vector<Complex> sums() const {
        std::vector<Complex> sums;
        Eigen::FFT<double> transform;
        transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
        transform.fwd(sums, m_values);
        return sums;
    }

private:
    std::vector<double> m_values;
    double m_perSecond;
};

/// Amplitudes at the multiples `from` to `to` of 1/period.
std::vector<double> amplitudes(const std::vector<Weighted>& samples, double period, std::size_t from,
                               std::size_t to) {
    const std::size_t size = std::bit_ceil(kMeshPerPoint * to);
    Mesh weights(size, period);
    Mesh values(size, period);
    for (const Weighted& sample : samples) {
        weights.add(sample.seconds, sample.weight);
        values.add(sample.seconds, sample.weight * sample.value);
    }
    const std::vector<Complex> w = weights.sums();
    const std::vector<Complex> y = values.sums();
    std::vector<double> found;
    for (std::size_t k = from; k <= to; ++k)
        found.push_back(amplitudeOf({w[k], w[2 * k], y[k]}));
    return found;
}

/// The amplitude that one of a hundred spectra of noise alone exceeds. The amplitudes of noise have a
/// Rayleigh distribution, whose median is 1.177 times its scale. What rounding leaves of a straight line is
/// no signal either.
double thresholdOf(const std::vector<double>& amplitudes, const std::vector<SignalPoint>& points) {
    constexpr double kNothing = 1e-12;
    double largest = 0;
    for (const SignalPoint& point : points)
        largest = std::max(largest, std::abs(point.value));
    const double scale = medianOf(amplitudes) / std::sqrt(2 * std::numbers::ln2);
    const auto count = static_cast<double>(amplitudes.size());
    return std::max(scale * std::sqrt(2 * std::log(count / kFalseAlarms)), kNothing * largest);
}

/// The frequency between `low` and `high` with the highest amplitude (golden section).
double highest(const std::vector<Weighted>& samples, double low, double high) {
    constexpr double kShare = 1 / std::numbers::phi;
    constexpr int kSteps = 16;  // to a two-thousandth of the interval
    double a = high - kShare * (high - low);
    double b = low + kShare * (high - low);
    double atA = amplitudeAt(samples, a);
    double atB = amplitudeAt(samples, b);
    for (int i = 0; i < kSteps; ++i) {
        if (atA > atB) {
            high = b;
            b = a;
            atB = atA;
            a = high - kShare * (high - low);
            atA = amplitudeAt(samples, a);
        } else {
            low = a;
            a = b;
            atA = atB;
            b = low + kShare * (high - low);
            atB = amplitudeAt(samples, b);
        }
    }
    return (low + high) / 2;
}

}  // namespace

/// Up to this many intervals, the mesh is no larger than for a full record with a few samples missing.
bool hasLongGap(const std::vector<SignalPoint>& points) {
    constexpr double kMostIntervals = 2 * kMostSpectrumSamples;
    const double usual = usualInterval(points);
    return usual > 0 && points.back().seconds - points.front().seconds > kMostIntervals * usual;
}

std::optional<Spectrum> spectrumOf(const std::vector<SignalPoint>& points, unsigned derivative) {
    if (points.size() < kFewestSpectrumSamples || points.size() > kMostSpectrumSamples)
        return std::nullopt;
    const double stretch = points.back().seconds - points.front().seconds;
    const double usual = usualInterval(points);
    if (usual <= 0 || hasLongGap(points))
        return std::nullopt;
    const double period = kPointsPerLine * stretch;
    const auto from = static_cast<std::size_t>(kSlowestLine * kPointsPerLine);
    const auto limit = static_cast<std::size_t>(0.5 / usual * period);
    if (limit < 2 * from + 2)
        return std::nullopt;
    const std::size_t to = limit - from;
    Spectrum spectrum;
    const std::vector<Weighted> samples = weighted(points, usual);
    const std::vector<double> found = amplitudes(samples, period, from, to);
    const auto factor = [&](double hertz) { return std::pow(kTurn * hertz, derivative); };
    const double threshold = thresholdOf(found, points);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double hertz = static_cast<double>(from + i) / period;
        spectrum.points.push_back({hertz, found[i] * factor(hertz)});
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i + 1 < found.size(); ++i)
        if (found[i] > threshold && found[i] > found[i - 1] && found[i] >= found[i + 1] &&
            (best == 0 || spectrum.points[i].amplitude > spectrum.points[best].amplitude))
            best = i;
    if (best != 0) {
        const double hertz =
            highest(samples, spectrum.points[best - 1].hertz, spectrum.points[best + 1].hertz);
        spectrum.peak = {hertz, amplitudeAt(samples, hertz) * factor(hertz)};
    }
    return spectrum;
}

}  // namespace nmc
