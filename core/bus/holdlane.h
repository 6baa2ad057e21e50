// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/types.h"

namespace nmc::bus {

/// Motion while it is held: what the operator wants, what the module was told last, and the stop that is owed
/// once he stops wanting it. A press that has ended is over: its late evidence moves nothing. Pure.
class HoldLane {
public:
    explicit HoldLane(Duration timeout) : m_timeout(timeout) {}

    /// Nothing when that press is over.
    void hold(const HoldToMove& hold, TimePoint now);
    /// It cannot be had now: this press is over before it began.
    void refuse(const HoldToMove& hold);
    void release();
    /// True once when the evidence stopped coming.
    [[nodiscard]] bool expired(TimePoint now);
    /// Forgets everything, the owed stop too: somebody else stops the motor.
    void clear();

    [[nodiscard]] std::optional<TimePoint> deadline() const;
    [[nodiscard]] const std::optional<HoldToMove>& wanted() const { return m_wanted; }
    /// The start to send, if the module has not been told what is wanted.
    [[nodiscard]] std::optional<Step> start() const;
    /// The stop that is owed. Comes before any start.
    [[nodiscard]] std::optional<Step> stop() const;

    void onStartSent() { m_told = m_wanted; }
    /// The start was certainly not carried out.
    void onStartRefused(const std::optional<HoldToMove>& before) { m_told = before; }
    [[nodiscard]] const std::optional<HoldToMove>& told() const { return m_told; }
    void onStopEnded() { m_owed.reset(); }

private:
    void end(std::uint32_t press);

    Duration m_timeout;
    std::optional<HoldToMove> m_wanted;
    std::optional<HoldToMove> m_told;  ///< sent, whatever came of it
    std::optional<HoldToMove> m_owed;  ///< told and no longer wanted
    TimePoint m_until;
    std::optional<std::uint32_t> m_over;  ///< the last press that has ended
};

}  // namespace nmc::bus
