// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/types.h"

namespace nmc::bus {

/// State of held motion: what the user wants, and what was last sent to the module. Once the motion is no
/// longer wanted, a stop is owed. A press that has ended is over: late evidence of it moves nothing. Pure.
class HoldLane {
public:
    explicit HoldLane(Duration timeout) : m_timeout(timeout) {}

    /// True if that press has ended, or a later one.
    [[nodiscard]] bool over(std::uint32_t press) const { return m_over && press <= *m_over; }
    /// Has no effect if that press is over.
    void hold(const HoldToMove& hold, TimePoint now);
    /// The motion is not possible now: this press is over before it began.
    void refuse(const HoldToMove& hold) { end(hold.press); }
    /// Ends the hold. Returns the motion that was sent, or only loaded; a stop is owed for it, because a load
    /// left waiting would run with the next start of its group.
    [[nodiscard]] std::optional<HoldToMove> release();
    /// True if the evidence has stopped coming.
    [[nodiscard]] bool expired(TimePoint now) const { return m_wanted && now >= m_until; }
    /// Ends the hold without a stop, because something else stops the motor.
    void clear();

    [[nodiscard]] std::optional<TimePoint> deadline() const;
    [[nodiscard]] const std::optional<HoldToMove>& wanted() const { return m_wanted; }
    /// Keeps the motion that was sent instead of the one that is wanted.
    void keepSent() { m_wanted = m_sent; }
    /// The command to be sent, if the module was not sent what is wanted: the start, or, for the first motion
    /// with a goal, its load, which startLoaded() must follow. A PIC-SERVO cannot change the velocity of a
    /// move to a goal (DS-V 4.4), so from then on it is a run.
    [[nodiscard]] std::optional<Order> start() const;
    [[nodiscard]] Order startLoaded() const;

    void onLoadSent() { m_loaded = true; }
    void onStartSent() { m_sent = m_wanted; }
    /// The start was certainly not carried out.
    void onStartRefused(const std::optional<HoldToMove>& before) { m_sent = before; }
    [[nodiscard]] const std::optional<HoldToMove>& sent() const { return m_sent; }

private:
    void end(std::uint32_t press);

    Duration m_timeout;
    std::optional<HoldToMove> m_wanted;
    std::optional<HoldToMove> m_sent;  ///< sent, whatever the outcome
    bool m_loaded = false;             ///< a load without a start was sent, whatever the outcome
    TimePoint m_until;
    std::optional<std::uint32_t> m_over;  ///< the last press that has ended
};

}  // namespace nmc::bus
