// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/types.h"

namespace nmc {

/// The home position of an axis, as far as this connection knows it; counts (steps) in terms of the chip's
/// present counter.
///
/// The chip's home register is something else (DS-V 5.2, DS-S 5.1): it contains whatever was captured or
/// saved last, for example the vicinity of an index or the position of a limit stop, and 0 after a restart.
/// Reset Position sets the counter to 0 but leaves the register, which then denotes a different position.
/// Home is therefore what a search has found, or what the user has saved or declared. It is adjusted when the
/// counter is set while the motor stands still, and becomes unknown after anything that may have set the
/// counter unseen.
class HomeFact {
public:
    enum class Source : std::uint8_t {
        Search,
        Saved,
        Declared,    ///< the user confirmed that the position is right: home is where the counter is 0
        Remembered,  ///< from the last known position of the axis before its module restarted; not checked
    };
    struct Place {
        std::int32_t counts = 0;
        TimePoint since;  ///< when it was found, saved or declared
        Source source = Source::Search;
        [[nodiscard]] bool verified() const { return source != Source::Remembered; }
        bool operator==(const Place&) const = default;
    };

    /// Empty if unknown.
    [[nodiscard]] const std::optional<Place>& place() const { return m_place; }

    /// Home was saved, and its position has not been read back yet.
    [[nodiscard]] bool awaited() const { return m_saved.has_value(); }

    /// Sets home to the position that a search has read from the chip, twice.
    void found(std::int32_t counts, TimePoint time);
    /// Sets home to counter 0, because the user confirms the counter.
    void declare(TimePoint time);
    /// The position of home if what was remembered of the axis still holds (model/module/positionmemory.h).
    /// It has no effect until the user accepts it. Like a place, it is adjusted when the counter is set.
    [[nodiscard]] const std::optional<std::int32_t>& offered() const { return m_offered; }
    void offer(std::int32_t counts);
    /// The user has accepted the offer.
    void takeOffer(TimePoint time);
    void dropOffer() { m_offered.reset(); }
    void forget();
    void apply(const bus::CommandExecuted& executed);
    void apply(const bus::Sample& sample);

private:
    /// The counter moved by this many counts; empty if unknown.
    void counterMoved(TimePoint time, std::optional<std::int32_t> by);
    [[nodiscard]] std::optional<std::int32_t> shift(const ModuleCommand& command) const;

    struct Reading {
        TimePoint time;
        std::int32_t position = 0;
        bool still = false;  ///< at the same position as in the previous reading
    };

    std::optional<Place> m_place;
    std::optional<std::int32_t> m_offered;
    /// Time at which Save as Home was carried out; the position is taken from the home register, once two
    /// readings agree.
    std::optional<TimePoint> m_saved;
    std::optional<std::int32_t> m_reading;
    std::optional<std::int32_t> m_register;  ///< as last reported
    std::optional<Reading> m_latest;
};

}  // namespace nmc
