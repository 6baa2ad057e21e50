// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/belief.h"
#include "bus/exchange.h"
#include "bus/pollschedule.h"
#include "bus/standstill.h"
#include "bus/types.h"

namespace nmc::bus {

/// How a module is stopped by "stop all": what is on stops abruptly and keeps holding; a PWM output without
/// servo is switched off; nothing is sent to what is off, because on a PIC-SERVO the stop would switch the
/// servo on and on a PIC-STEP energise the motor (link.md 2.6).
[[nodiscard]] std::optional<ModuleCommand> stopFor(const Belief& belief);

/// Items that tell whether it stands still; `second`: the same in a reply of another length.
[[nodiscard]] StatusItems standstillItems(ModuleType type, bool second);

/// One stop of all motors: every stop that is needed first, those that move before the others, then two looks
/// at each module. A stop is repeated when the module still moves or did not answer. Pure; the engine sends.
class StopRun {
public:
    /// For the whole run.
    static constexpr Duration kLimit = std::chrono::seconds(2);
    /// A motor that has been told to stop needs some time; then it is told again.
    static constexpr Duration kPatience = std::chrono::milliseconds(60);
    /// A module that answered until now is given up after this long and kSilences time-outs in a row.
    static constexpr Duration kSilentFor = std::chrono::milliseconds(500);
    static constexpr unsigned kSilences = 3;
    /// Two positions of a servo that stands still differ by no more (counts).
    static constexpr std::int64_t kStandstill = kStillCounts;

    StopRun(const std::vector<Belief>& beliefs, const PollSchedule& schedule, TimePoint now);
    /// Asked for again: look at everything anew; the time limit stays.
    void restart(const std::vector<Belief>& beliefs, const PollSchedule& schedule);

    /// Stops to send without waiting for answers, because an answer is under way or the link is in doubt.
    [[nodiscard]] std::vector<Step> blindStops() const;
    /// They went out: look before stopping again, since an abrupt stop may have tripped the servo, which a
    /// second one would switch on. `latched`: when it was carried out, as far as that is certain.
    void onBlindSent(ModuleIndex module, std::optional<TimePoint> latched);

    struct Ask {
        ModuleIndex module;
        std::optional<ModuleCommand> stop;  ///< else Read Status with these items
        StatusItems items;
    };
    /// Nothing when the run is over.
    [[nodiscard]] std::optional<Ask> next(TimePoint now);
    /// What came of the last Ask; `belief` has the answer already.
    void onReply(const ReplyEnd& end, const Belief& belief, TimePoint now);
    /// When a stop that was sent blind was latched, once its module was heard of again.
    [[nodiscard]] std::optional<TimePoint> takeBlind(ModuleIndex module);
    [[nodiscard]] std::optional<ModuleCommand> stopOf(ModuleIndex module) const;

    [[nodiscard]] StopFinished finished(TimePoint now) const;

private:
    enum class State : std::uint8_t { Open, Stopped, Unreached };
    struct Target {
        ModuleIndex module;
        std::optional<ModuleCommand> stop;
        bool wasSilent = false;
        bool moving = false;
        bool stopOwed = false;
        ModuleType type = ModuleType::Servo;
        unsigned asks = 0;
        bool second = false;  ///< layouts take turns
        unsigned silences = 0;
        unsigned confirmed = 0;
        std::optional<std::int32_t> position;
        std::optional<TimePoint> blind;
        TimePoint lastStop;
        State state = State::Open;
    };

    void plan(const std::vector<Belief>& beliefs, const PollSchedule& schedule);
    [[nodiscard]] const Target& target(ModuleIndex module) const;
    [[nodiscard]] Target& target(ModuleIndex module);
    void onSilence(Target& target, TimePoint now) const;
    void onLook(Target& target, const StatusReport& report, const Belief& belief, TimePoint now) const;

    TimePoint m_began;
    std::vector<Target> m_targets;
    Ask m_asked{};
};

}  // namespace nmc::bus
