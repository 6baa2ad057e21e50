// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "bus/belief.h"
#include "bus/exchange.h"
#include "bus/types.h"
#include "module/stopmanner.h"

namespace nmc::bus {

/// The command that brings a module to rest; empty if it is off, because the stop would switch on the servo
/// of a PIC-SERVO, and energise the motor of a PIC-STEP (link.md 2.6). A module that is on continues to hold,
/// except with StopManner::Off; a PWM output without servo is switched off.
[[nodiscard]] std::optional<ModuleCommand> stopFor(const Belief& belief,
                                                   StopManner manner = StopManner::Abruptly);

/// One module on its way to a confirmed stop: the stop is sent until it is answered; the module is then
/// queried until two consecutive replies of different length show it at rest. The stop is repeated if the
/// module continues to move or falls silent. A stop of all modules has one of these for each module, and so
/// has an owed stop. Pure.
class StopTarget {
public:
    /// Time after which an abrupt stop is repeated, because the motor needs some time to stop. A motor that
    /// decelerates by itself needs more.
    static constexpr Duration kPatience = std::chrono::milliseconds(60);
    static constexpr Duration kSmoothPatience = std::chrono::milliseconds(1000);

    explicit StopTarget(const Belief& belief, StopManner manner = StopManner::Abruptly);

    [[nodiscard]] ModuleIndex module() const { return m_module; }
    [[nodiscard]] StopManner manner() const { return m_manner; }
    /// The stop that must be sent, if the module is on by now; it may have been switched off in the meantime.
    /// A module in an unknown state that does not report it is sent motor off, which ends whatever it does
    /// and never switches anything on.
    [[nodiscard]] std::optional<ModuleCommand> stop(const Belief& belief) const;
    [[nodiscard]] bool needsStop() const { return m_needsStop; }
    /// It is still unknown whether a stop must be sent.
    [[nodiscard]] bool unknown() const { return m_unknown; }
    /// The module was seen at rest, twice.
    [[nodiscard]] bool stopped() const { return m_confirmed >= 2; }
    /// No stop has to be sent, but the last query did not show the module at rest.
    [[nodiscard]] bool slowsDown() const { return !m_needsStop && m_confirmed == 0; }
    /// The module has answered since the first stop or query.
    [[nodiscard]] bool heard() const { return m_heard; }
    /// Number of consecutive unanswered queries.
    [[nodiscard]] unsigned silences() const { return m_silences; }

    /// The next request: a stop, or otherwise Read Status with `items`.
    struct Question {
        std::optional<ModuleCommand> stop;
        StatusItems items;
    };
    [[nodiscard]] Question next(const Belief& belief);
    /// The result of the request; `belief` already includes the answer.
    void onReply(const ReplyEnd& end, const Belief& belief, TimePoint now);

    /// The stop was sent without waiting for an answer: the module is queried before the stop is repeated,
    /// because an abrupt stop may have tripped the servo, and a second one would switch it on. `certain`: the
    /// stop and its latch time, if they are certain.
    struct Blind {
        ModuleCommand stop;
        TimePoint latched;
    };
    void onBlindSent(std::optional<Blind> certain);
    /// The stop that was sent blindly, if its latch time is certain; returned once.
    [[nodiscard]] std::optional<Blind> takeBlind() { return std::exchange(m_blind, std::nullopt); }

private:
    void onLook(const StatusReport& report, const Belief& belief, TimePoint now);

    ModuleIndex m_module;
    ModuleType m_type;
    StopManner m_manner;
    bool m_needsStop;         ///< the stop is sent before the module is queried
    bool m_unknown;           ///< none of its statuses was ever believed
    bool m_asked = false;     ///< a request is in progress
    bool m_asksStop = false;  ///< that request is a stop
    bool m_second = false;    ///< layouts alternate
    unsigned m_inVain = 0;    ///< consecutive unanswered stops
    bool m_heard = false;     ///< never cleared
    unsigned m_silences = 0;
    unsigned m_confirmed = 0;
    std::optional<std::int32_t> m_position;
    std::optional<Blind> m_blind;
    std::optional<TimePoint> m_lastStop;  ///< the last one answered
};

}  // namespace nmc::bus
