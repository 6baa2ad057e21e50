// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/types.h"

namespace nmc {

/// Where home of an axis is, as far as this connection knows; counts (steps), as the chip counts now.
///
/// The chip's home register is another thing (DS-V 5.2, DS-S 5.1): it holds what was captured or saved last,
/// the neighbourhood of an index or the place of a limit stop say, and 0 after a restart; and Reset Position
/// sets the counter to 0 and leaves the register, which then means another place. So home is what a search
/// has found, or the user has saved or declared. It goes along when the counter is set while the motor
/// stands, and is not known any more after all that may have set the counter unseen.
class HomeFact {
public:
    enum class Source : std::uint8_t {
        Search,
        Saved,
        Declared,    ///< somebody has said that the position is right: home is where the counter is 0
        Remembered,  ///< from where the axis was seen last, before its module restarted; nobody has checked
                     ///< it
    };
    struct Place {
        std::int32_t counts = 0;
        TimePoint since;  ///< when it was found, saved or declared
        Source source = Source::Search;
        [[nodiscard]] bool verified() const { return source != Source::Remembered; }
        bool operator==(const Place&) const = default;
    };

    /// Nothing: not known.
    [[nodiscard]] const std::optional<Place>& place() const { return m_place; }

    /// A search has read it from the chip, twice.
    void found(std::int32_t counts, TimePoint time);
    /// The counter is right, says the user.
    void declare(TimePoint time);
    /// Where home is if what was remembered of the axis is still true (model/module/positionmemory.h);
    /// nothing as long as nobody has taken it. It goes along with the counter as a place does.
    [[nodiscard]] const std::optional<std::int32_t>& offered() const { return m_offered; }
    void offer(std::int32_t counts);
    /// The user has taken it.
    void takeOffer(TimePoint time);
    void dropOffer() { m_offered.reset(); }
    void forget();
    void apply(const bus::CommandExecuted& executed);
    void apply(const bus::Sample& sample);

private:
    /// By so much, counts; empty: nobody knows.
    void counterMoved(TimePoint time, std::optional<std::int32_t> by);
    [[nodiscard]] std::optional<std::int32_t> shift(const ModuleCommand& command) const;

    struct Reading {
        TimePoint time;
        std::int32_t position = 0;
        bool still = false;  ///< where it was at the reading before
    };

    std::optional<Place> m_place;
    std::optional<std::int32_t> m_offered;
    /// Save as home was carried out then; where that was, the register tells, in two readings that agree.
    std::optional<TimePoint> m_saved;
    std::optional<std::int32_t> m_reading;
    std::optional<std::int32_t> m_register;  ///< as told last
    std::optional<Reading> m_latest;
};

}  // namespace nmc
