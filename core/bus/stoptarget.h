// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/belief.h"
#include "bus/exchange.h"
#include "bus/types.h"

namespace nmc::bus {

/// How a motor is to come to rest.
enum class StopManner : std::uint8_t {
    Abruptly,
    Smoothly,
    Off,  ///< a motor that runs the wrong way would run on with its servo on
};

/// What a module has to be told to come to rest; nothing when it is off, because on a PIC-SERVO the stop
/// would switch the servo on and on a PIC-STEP energise the motor (link.md 2.6). What is on keeps holding,
/// but for StopManner::Off; a PWM output without servo is switched off.
[[nodiscard]] std::optional<ModuleCommand> stopFor(const Belief& belief,
                                                   StopManner manner = StopManner::Abruptly);

/// Items that tell whether it stands still; `second`: the same in a reply of another length.
[[nodiscard]] StatusItems standstillItems(ModuleType type, bool second);

/// One module on its way to a confirmed stop: told until it answers, then looked at until two looks in a row,
/// of different length, show it at rest. Told again when it moves on or falls silent. A stop of all has one
/// of these for each module, and so has a stop that is owed. Pure.
class StopTarget {
public:
    /// A motor that has been told to stop abruptly needs some time; then it is told again. One that slows
    /// down by itself needs more.
    static constexpr Duration kPatience = std::chrono::milliseconds(60);
    static constexpr Duration kSmoothPatience = std::chrono::milliseconds(1000);

    explicit StopTarget(const Belief& belief, StopManner manner = StopManner::Abruptly);

    [[nodiscard]] ModuleIndex module() const { return m_module; }
    [[nodiscard]] StopManner manner() const { return m_manner; }
    /// What it has to be told, if it is on by now: somebody may have switched it off meanwhile. One of which
    /// nothing is known, and that does not say, is told to switch off: that ends whatever it does, and never
    /// switches anything on.
    [[nodiscard]] std::optional<ModuleCommand> stop(const Belief& belief) const;
    [[nodiscard]] bool needsStop() const { return m_needsStop; }
    /// Nobody knows yet whether it has to be told.
    [[nodiscard]] bool unknown() const { return m_unknown; }
    /// It was seen at rest, twice.
    [[nodiscard]] bool stopped() const { return m_confirmed >= 2; }
    /// It was seen at rest, once.
    [[nodiscard]] bool almostStopped() const { return m_confirmed == 1; }
    /// It has answered since it was told or asked for the first time.
    [[nodiscard]] bool heard() const { return m_heard; }
    /// Questions in a row without an answer.
    [[nodiscard]] unsigned silences() const { return m_silences; }

    /// What to ask it next: its stop, or else Read Status with items().
    struct Question {
        std::optional<ModuleCommand> stop;
        StatusItems items;
    };
    [[nodiscard]] Question next(const Belief& belief);
    /// What came of it; `belief` has the answer already.
    void onReply(const ReplyEnd& end, const Belief& belief, TimePoint now);

    /// Its stop went out without waiting for an answer: it is looked at before it is told again, since an
    /// abrupt stop may have tripped the servo, which a second one would switch on. `certain`: it is, when it
    /// was carried out.
    struct Blind {
        ModuleCommand stop;
        TimePoint latched;
    };
    void onBlindSent(std::optional<Blind> certain);
    /// The stop that was sent blind, where it is certain when that was latched; once.
    [[nodiscard]] std::optional<Blind> takeBlind();

private:
    void onLook(const StatusReport& report, const Belief& belief, TimePoint now);

    ModuleIndex m_module;
    ModuleType m_type;
    StopManner m_manner;
    bool m_needsStop;         ///< it is told before it is looked at
    bool m_unknown;           ///< no status of it was ever believed
    bool m_asksStop = false;  ///< the question under way
    bool m_second = false;    ///< layouts take turns
    unsigned m_inVain = 0;    ///< stops in a row that were not answered
    bool m_heard = false;     ///< once true, stays so
    unsigned m_silences = 0;
    unsigned m_confirmed = 0;
    std::optional<std::int32_t> m_position;
    std::optional<Blind> m_blind;
    std::optional<TimePoint> m_lastStop;  ///< that was answered
};

}  // namespace nmc::bus
