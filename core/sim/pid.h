// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc::sim {

/// The parameters of Set Gain (DS-V 5.2).
struct Gains {
    std::uint16_t kp = 0;  ///< 0..7FFF
    std::uint16_t kd = 0;  ///< 0..7FFF
    std::uint16_t ki = 0;  ///< 0..7FFF
    std::uint16_t il = 0;  ///< integration limit, 0..7FFF; the running sum is held within IL * 256
    std::uint8_t ol = 0;   ///< output limit in PWM counts
    std::uint8_t cl = 0;   ///< current limit in A/D counts; odd: upper bound, even: lower bound, 0: none
    std::uint16_t el = 0;  ///< position error limit in counts, 0..3FFF
    std::uint8_t sr = 1;   ///< servo rate divisor
    std::uint8_t db = 0;   ///< deadband compensation in PWM counts, version 4
    std::uint8_t sm = 1;   ///< counts per step pulse, SC
};

/// The control filter of DS-V 4.3 in integer arithmetic. The data sheet prints a minus before Kd, which would
/// drive instead of damp; here it is a plus (protocol.md 2, a choice).
class PidFilter {
public:
    /// Returns the filter's output for a position error in counts: signed PWM counts times 256. Called once
    /// per servo tick.
    std::int64_t output(const Gains& gains, std::int32_t error);
    /// Clears the running sum and the previous error.
    void reset() { *this = PidFilter{}; }

private:
    std::int32_t m_previousError = 0;
    std::int32_t m_runningSum = 0;
};

}  // namespace nmc::sim
