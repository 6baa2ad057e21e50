// SPDX-License-Identifier: MIT
#include "sim/motorplant.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace nmc::sim {

namespace {

/// Order of the state: current, speed, counts, voltage, torque. The last two are constant within a sub-step.
constexpr std::size_t kOrder = 5;
using Matrix = std::array<std::array<double, kOrder>, kOrder>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t i = 0; i < kOrder; ++i)
        for (std::size_t k = 0; k < kOrder; ++k)
            for (std::size_t j = 0; j < kOrder; ++j)
                c[i][j] += a[i][k] * b[k][j];
    return c;
}

/// exp(m): the series for m / 2^s, squared s times.
Matrix exponential(Matrix m) {
    double norm = 0;
    for (const auto& row : m)
        for (double x : row)
            norm = std::max(norm, std::abs(x));
    constexpr double kSmall = 1.0 / 32;  // below it, twelve terms exceed the precision of a double
    const int squarings = norm > kSmall ? std::ilogb(norm / kSmall) + 1 : 0;
    for (auto& row : m)
        for (double& x : row)
            x = std::ldexp(x, -squarings);

    Matrix sum{};
    for (std::size_t i = 0; i < kOrder; ++i)
        sum[i][i] = 1.0;
    Matrix term = sum;
    for (int n = 1; n <= 12; ++n) {
        term = product(term, m);
        for (auto& row : term)
            for (double& x : row)
                x /= n;
        for (std::size_t i = 0; i < kOrder; ++i)
            for (std::size_t j = 0; j < kOrder; ++j)
                sum[i][j] += term[i][j];
    }
    for (int i = 0; i < squarings; ++i)
        sum = product(sum, sum);
    return sum;
}

double signOf(double x) {
    return x < 0 ? -1.0 : 1.0;
}

/// A current below this counts as zero; it is a millionth of what the converter can resolve.
constexpr double kNoAmperes = 1e-8;

}  // namespace

void MotorPlant::setParameters(const MotorParameters& p) {
    m_parameters = p;
    m_countsPerRad = p.countsPerTurn / (2.0 * std::numbers::pi);
    m_voltsPerPwm = p.supplyVolts / (255 - p.amplifierDeadbandPwm);

    constexpr double h = kSubstepSeconds;
    Matrix driven{};
    driven[0] = {-p.resistanceOhm / p.inductanceHenry * h, -p.motorConstant / p.inductanceHenry * h, 0,
                 h / p.inductanceHenry, 0};
    driven[1] = {p.motorConstant / p.inertiaKgM2 * h, -p.viscousNmS / p.inertiaKgM2 * h, 0, 0,
                 h / p.inertiaKgM2};
    driven[2] = {0, m_countsPerRad * h, 0, 0, 0};
    const Matrix e = exponential(driven);
    const auto row = [&e](std::size_t i) { return Row{e[i][0], e[i][1], e[i][3], e[i][4]}; };
    m_amperes = row(0);
    m_speed = row(1);
    m_counts = row(2);

    m_stalledDecay = std::exp(-p.resistanceOhm / p.inductanceHenry * h);
    m_stalledGain = (1.0 - m_stalledDecay) / p.resistanceOhm;

    Matrix open{};
    open[1] = {0, driven[1][1], 0, 0, driven[1][4]};
    open[2] = driven[2];
    const Matrix coast = exponential(open);
    m_coastDecay = coast[1][1];
    m_coastGain = coast[1][4];
    m_coastTravel = coast[2][1];
    m_coastTravelGain = coast[2][4];

    constexpr double kDampingRatio = 0.02;
    const double second = p.elasticInertiaKgM2;
    const double reduced = second * p.inertiaKgM2 / (second + p.inertiaKgM2);
    const double swing = 2.0 * std::numbers::pi * p.resonanceHz;
    m_elastic.stiffness = swing * swing * reduced;
    m_elastic.damping = 2.0 * kDampingRatio * swing * reduced;
    if (second == 0.0)
        m_elastic = {};
    m_loadNm = p.loadNm;
    keepWithinTravel();
}

void MotorPlant::hold(bool held) {
    m_held = held;
    if (held)
        m_state.radPerSecond = 0.0;
}

void MotorPlant::advanceTick(double pwm, bool bridgeEnabled) {
    if (!bridgeEnabled) {
        for (int i = 0; i < kSubsteps && !atRest(); ++i) {
            twist();
            substepOpen();
            swing();
        }
        return;
    }
    const double magnitude = std::max(0.0, std::abs(pwm) - m_parameters.amplifierDeadbandPwm);
    const double volts = (pwm < 0 ? -magnitude : magnitude) * m_voltsPerPwm;
    if (magnitude == 0.0 && atRest())
        return;
    for (int i = 0; i < kSubsteps; ++i) {
        twist();
        substepClosed(volts);
        swing();
    }
}

void MotorPlant::twist() {
    if (m_parameters.elasticInertiaKgM2 == 0.0)
        return;
    const double faster = m_state.radPerSecond - m_elastic.radPerSecond;
    m_elastic.twist += 0.5 * kSubstepSeconds * faster;
    m_loadNm = m_parameters.loadNm + m_elastic.stiffness * m_elastic.twist + m_elastic.damping * faster;
}

/// Applies to the second mass the torque of the spring in this sub-step.
void MotorPlant::swing() {
    constexpr double kNoRadPerSecond = 1e-6;
    const double second = m_parameters.elasticInertiaKgM2;
    if (second == 0.0)
        return;
    m_elastic.radPerSecond += (m_loadNm - m_parameters.loadNm) / second * kSubstepSeconds;
    m_elastic.twist += 0.5 * kSubstepSeconds * (m_state.radPerSecond - m_elastic.radPerSecond);
    // Compares the energy of both, with the spring's energy expressed as the speed that it would give the
    // mass.
    const double energy = m_elastic.radPerSecond * m_elastic.radPerSecond +
                          m_elastic.stiffness / second * m_elastic.twist * m_elastic.twist;
    if (m_state.radPerSecond == 0.0 && energy < kNoRadPerSecond * kNoRadPerSecond)
        m_elastic.twist = m_elastic.radPerSecond = 0.0;
}

MotorPlant::State MotorPlant::solved(double volts, double torque) const {
    const auto next = [&](const Row& row) {
        return row.amperes * m_state.amperes + row.radPerSecond * m_state.radPerSecond + row.volts * volts +
               row.torque * torque;
    };
    return {next(m_amperes), next(m_speed), m_state.counts + next(m_counts)};
}

void MotorPlant::substepClosed(double volts) {
    const MotorParameters& p = m_parameters;
    const double before = m_state.radPerSecond;
    if (before == 0.0) {
        substepAtRest(m_state.amperes * m_stalledDecay + volts * m_stalledGain, volts);
        return;
    }
    State next = solved(volts, -m_loadNm - p.coulombNm * signOf(before));
    if (before * next.radPerSecond <= 0.0)
        reverse(before, next);
    m_state = next;
    keepWithinTravel();
}

/// The shaft is at rest: dry friction balances any torque up to its limit.
void MotorPlant::substepAtRest(double nextAmperes, double volts) {
    const MotorParameters& p = m_parameters;
    const double torque = p.motorConstant * nextAmperes - m_loadNm;
    if (!m_held && std::abs(torque) > p.coulombNm && !isStopped(torque)) {
        const State next = solved(volts, -m_loadNm - p.coulombNm * signOf(torque));
        // Averaged over the sub-step in which the shaft breaks away, friction may still have been the
        // stronger.
        if (next.radPerSecond * torque > 0.0) {
            m_state = next;
            keepWithinTravel();
            return;
        }
    }
    m_state.amperes = std::abs(nextAmperes) < kNoAmperes ? 0.0 : nextAmperes;
}

/// The speed crossed zero within the sub-step: from there on, friction acts in the other direction or holds
/// the shaft.
void MotorPlant::reverse(double speedBefore, State& next) const {
    const MotorParameters& p = m_parameters;
    const double change = speedBefore - next.radPerSecond;
    const double share = change == 0.0 ? 1.0 : speedBefore / change;
    const double rest = (1.0 - share) * kSubstepSeconds;
    const double amperes = m_state.amperes + share * (next.amperes - m_state.amperes);
    const double torque = p.motorConstant * amperes - m_loadNm;
    next.radPerSecond = std::abs(torque) <= p.coulombNm
                            ? 0.0
                            : (torque - p.coulombNm * signOf(torque)) / p.inertiaKgM2 * rest;
    next.counts = m_state.counts +
                  0.5 * m_countsPerRad * (speedBefore * share * kSubstepSeconds + next.radPerSecond * rest);
}

/// No current flows: the bridge is off, and its diodes have emptied the inductance within a sub-step.
void MotorPlant::substepOpen() {
    const MotorParameters& p = m_parameters;
    m_state.amperes = 0.0;
    const double before = m_state.radPerSecond;
    if (m_held || (before == 0.0 && std::abs(m_loadNm) <= p.coulombNm))
        return;
    const double torque = -m_loadNm - p.coulombNm * signOf(before == 0.0 ? -m_loadNm : before);
    State next{0.0, m_coastDecay * before + m_coastGain * torque,
               m_state.counts + m_coastTravel * before + m_coastTravelGain * torque};
    if (before * next.radPerSecond < 0.0)
        reverse(before, next);
    m_state = next;
    keepWithinTravel();
}

void MotorPlant::keepWithinTravel() {
    if (m_state.counts < m_parameters.travelMinCounts) {
        m_state.counts = m_parameters.travelMinCounts;
        m_state.radPerSecond = std::max(m_state.radPerSecond, 0.0);
    } else if (m_state.counts > m_parameters.travelMaxCounts) {
        m_state.counts = m_parameters.travelMaxCounts;
        m_state.radPerSecond = std::min(m_state.radPerSecond, 0.0);
    }
}

bool MotorPlant::isStopped(double torque) const {
    return torque < 0 ? m_state.counts <= m_parameters.travelMinCounts
                      : m_state.counts >= m_parameters.travelMaxCounts;
}

bool MotorPlant::index(std::int64_t encoder) const {
    return encoder % static_cast<std::int64_t>(m_parameters.countsPerTurn) == 0;
}

std::uint8_t MotorPlant::currentSense() const {
    const double reading = std::abs(m_state.amperes) * m_parameters.adCountsPerAmpere;
    return static_cast<std::uint8_t>(std::min(reading, 255.0));
}

}  // namespace nmc::sim
