// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "model/scope/customsignal.h"

namespace nmc {

/// What the scope waits for, and how it shows it.
struct TriggerSettings {
    enum class Condition : std::uint8_t {
        Rising,   ///< comes from below the level and reaches it; for a bit: becomes set
        Falling,  ///< comes from above the level and reaches it; for a bit: becomes cleared
        Above,    ///< is above the level, or the bit is set, even if it already was
        Below,
    };
    enum class Mode : std::uint8_t {
        Single,  ///< one picture
        Normal,  ///< picture after picture: the caller that shows them arms it again
    };

    ModuleIndex module;
    std::variant<ScopeSignal, ScopeBit> source = ScopeSignal::Position;
    Condition condition = Condition::Rising;
    double level = 0.0;  ///< in the unit of valueOf(), or of a derived value; unused for a bit
    Mode mode = Mode::Single;
    double preTrigger = 0.2;             ///< fraction of the window before the trigger, 0..1
    double window = 1.0;                 ///< s; limited to 1 us to 10 days
    std::vector<CustomSignal> custom{};  ///< the definition of the source, if it is one of the user's

    bool operator==(const TriggerSettings&) const = default;
};

/// Finds the moment that the scope is to show. It examines the samples as they arrive, or the values that
/// DerivedSignals computes from them, and keeps none; the picture is taken from the history. Pure.
class ScopeTrigger {
public:
    enum class State : std::uint8_t {
        Off,
        Armed,  ///< waits for the condition, and until the history covers the time before it
        Fired,  ///< waits for the rest of the picture: the module's samples, or the values derived from them
        Complete,  ///< the picture is complete
    };

    /// Switches the trigger off. A derived signal starts from nothing: its values must be fed again from the
    /// first one.
    void set(const TriggerSettings& settings);
    /// Sets the window of the next picture and switches the trigger off; it must be armed again.
    void setWindow(double seconds);
    [[nodiscard]] const TriggerSettings& settings() const { return m_settings; }
    /// The source, if it is derived.
    [[nodiscard]] std::optional<ModuleSignal> derivedSource() const;

    /// Arms the trigger from `now` on. Earlier data may be in the picture, but do not trigger.
    void arm(TimePoint now);
    void disarm();
    /// The samples so far are no longer in the history: none of them precedes a trigger.
    void forgetSamples();

    /// Feeds every sample of every module in order of arrival, in any state.
    State feed(ModuleIndex module, const ScopeSample& sample);
    /// Feeds every value of derivedSource(), after the samples from which it is computed.
    State feedDerived(const ScopeSample& value);

    [[nodiscard]] State state() const { return m_state; }
    /// Valid in Fired and Complete. An edge of a curve is where the straight line between two samples crosses
    /// the level; any other condition counts from the sample that first shows it.
    [[nodiscard]] std::optional<TimePoint> firedAt() const { return m_firedAt; }
    /// The interval to show; valid in Fired and Complete.
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
    std::optional<Value> m_last;              ///< of the watched module, if no data are missing after it
    std::size_t m_behind = 0;                 ///< samples after the picture while a derived value is missing
};

}  // namespace nmc
