// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "model/scope/signalmaker.h"

namespace nmc {

/// What the scope waits for, and what it shows of it.
struct TriggerSettings {
    enum class Condition : std::uint8_t {
        Rising,   ///< comes from below the level and reaches it; of a bit: is set
        Falling,  ///< comes from above the level and reaches it; of a bit: is cleared
        Above,    ///< the level, or it is set, from before or not
        Below,
    };
    enum class Mode : std::uint8_t {
        Single,  ///< one picture
        Normal,  ///< the next one when rearm() says so
    };

    ModuleIndex module;
    std::variant<ScopeSignal, ScopeBit> source = ScopeSignal::Position;
    Condition condition = Condition::Rising;
    double level = 0.0;  ///< in the unit of valueOf(), or as it is made; not of a bit
    Mode mode = Mode::Single;
    double preTrigger = 0.2;  ///< share of the window before the trigger, 0..1
    double window = 1.0;      ///< s; taken as 1 us to 10 days

    bool operator==(const TriggerSettings&) const = default;
};

/// Finds the moment that the scope is to show. It looks at the samples as they come and keeps none; the
/// picture is taken from the history. Pure.
class ScopeTrigger {
public:
    enum class State : std::uint8_t {
        Off,
        Armed,     ///< waits for the condition, and until there are samples for all that comes before it
        Fired,     ///< waits for the rest of the picture: the module's samples, or what is made of them
        Complete,  ///< the picture is there
    };

    /// Switches it off. Of a derived signal nothing is known then: its module's samples begin anew.
    void set(const TriggerSettings& settings);
    /// Of the next picture, for which it is to be armed again: switches it off.
    void setWindow(double seconds);
    [[nodiscard]] const TriggerSettings& settings() const { return m_settings; }

    /// From now on. What was before may be in the picture, but does not trigger.
    void arm(TimePoint now);
    /// For the next picture, when this one has been looked at; only in Mode::Normal and State::Complete.
    void rearm(TimePoint now);
    void disarm();
    /// The samples so far are not in the history any more: none of them comes before a trigger.
    void forgetSamples();

    /// Every sample of every module, in the order of arrival, in any state; `gains` are those of their
    /// history.
    State feed(ModuleIndex module, const ScopeSample& sample, const std::vector<GainsChange>& gains = {});

    [[nodiscard]] State state() const { return m_state; }
    /// Of Fired and Complete. An edge of a line is where the straight line between two samples crosses the
    /// level, everything else where a sample shows it first.
    [[nodiscard]] std::optional<TimePoint> firedAt() const { return m_firedAt; }
    /// Of Fired and Complete: what to show.
    struct Picture {
        TimePoint from;
        TimePoint to;
        bool operator==(const Picture&) const = default;
    };
    [[nodiscard]] std::optional<Picture> picture() const;

private:
    struct Value {
        TimePoint time;
        double value = 0.0;
    };
    void startAnew();
    void look(const ScopeSample& value);
    [[nodiscard]] std::optional<Value> watched(const ScopeSample& sample) const;
    [[nodiscard]] std::optional<TimePoint> conditionMet(const Value& now) const;
    [[nodiscard]] std::optional<TimePoint> crossing(const Value& now) const;
    [[nodiscard]] bool reachesTheEnd(const ScopeSample& sample);
    [[nodiscard]] double level() const;
    [[nodiscard]] Duration before() const;
    [[nodiscard]] Duration window() const;

    TriggerSettings m_settings;
    State m_state = State::Off;
    TimePoint m_armedAt;
    std::optional<TimePoint> m_firedAt;
    std::optional<TimePoint> m_samplesSince;  ///< of any module
    std::optional<Value> m_last;              ///< of the watched module, if nothing is missing behind it
    std::optional<SignalMaker> m_maker;       ///< of a derived signal
    std::size_t m_behind = 0;                 ///< samples behind the picture while a made value is missing
};

}  // namespace nmc
