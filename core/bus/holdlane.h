// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/types.h"

namespace nmc::bus {

/// Motion while it is held: what the operator wants, and what the module was told last. Once he stops wanting
/// it a stop is owed. Pure.
class HoldLane {
public:
    explicit HoldLane(Duration timeout) : m_timeout(timeout) {}

    void hold(const HoldToMove& hold, TimePoint now);
    /// What it was told and is not wanted any more: a stop is owed for it.
    [[nodiscard]] std::optional<HoldToMove> release();
    /// The evidence has stopped coming.
    [[nodiscard]] bool expired(TimePoint now) const { return m_wanted && now >= m_until; }
    /// Forgets everything: somebody else stops the motor.
    void clear();

    [[nodiscard]] std::optional<TimePoint> deadline() const;
    [[nodiscard]] const std::optional<HoldToMove>& wanted() const { return m_wanted; }
    /// The start to send, if the module has not been told what is wanted.
    [[nodiscard]] std::optional<Step> start() const;

    void onStartSent() { m_told = m_wanted; }
    /// The start was certainly not carried out.
    void onStartRefused(const std::optional<HoldToMove>& before) { m_told = before; }
    [[nodiscard]] const std::optional<HoldToMove>& told() const { return m_told; }

private:
    Duration m_timeout;
    std::optional<HoldToMove> m_wanted;
    std::optional<HoldToMove> m_told;  ///< sent, whatever came of it
    TimePoint m_until;
};

}  // namespace nmc::bus
