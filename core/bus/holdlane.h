// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/types.h"

namespace nmc::bus {

/// Motion while it is held: what the operator wants, and what the module was told last. Once he stops wanting
/// it a stop is owed. A press that has ended is over: its late evidence moves nothing. Pure.
class HoldLane {
public:
    explicit HoldLane(Duration timeout) : m_timeout(timeout) {}

    /// That press has ended, or one after it.
    [[nodiscard]] bool over(std::uint32_t press) const { return m_over && press <= *m_over; }
    /// Nothing when that press is over.
    void hold(const HoldToMove& hold, TimePoint now);
    /// It cannot be had now: this press is over before it began.
    void refuse(const HoldToMove& hold) { end(hold.press); }
    /// What it was told and is not wanted any more: a stop is owed for it.
    [[nodiscard]] std::optional<HoldToMove> release();
    /// The evidence has stopped coming.
    [[nodiscard]] bool expired(TimePoint now) const { return m_wanted && now >= m_until; }
    /// Forgets everything: somebody else stops the motor.
    void clear();

    [[nodiscard]] std::optional<TimePoint> deadline() const;
    [[nodiscard]] const std::optional<HoldToMove>& wanted() const { return m_wanted; }
    /// What has to be sent, if the module has not been told what is wanted: the start; with a goal the load
    /// for it, which startLoaded() has to follow.
    [[nodiscard]] std::optional<Order> start() const;
    [[nodiscard]] Order startLoaded() const;

    void onStartSent() { m_sent = m_wanted; }
    /// The start was certainly not carried out.
    void onStartRefused(const std::optional<HoldToMove>& before) { m_sent = before; }
    [[nodiscard]] const std::optional<HoldToMove>& sent() const { return m_sent; }

private:
    void end(std::uint32_t press);

    Duration m_timeout;
    std::optional<HoldToMove> m_wanted;
    std::optional<HoldToMove> m_sent;  ///< sent, whatever came of it
    TimePoint m_until;
    std::optional<std::uint32_t> m_over;  ///< the last press that has ended
};

}  // namespace nmc::bus
