// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bus/types.h"
#include "model/settings/machine.h"

namespace nmc {

/// The work offset that positions of an axis are counted from where a user reads and types them.
struct WorkZero {
    WorkOffset offset;
    std::optional<double> counts;  ///< in terms of the chip's present counter; empty: not known any more
    bool operator==(const WorkZero&) const = default;
};

/// A position as the user reads it, in counts (steps) from the work zero, or by the chip's counter if there
/// is none. Empty: it is not known how far the work zero is.
[[nodiscard]] inline std::optional<double> countedFrom(const std::optional<WorkZero>& zero, double counts) {
    if (!zero)
        return counts;
    return zero->counts ? std::optional(counts - *zero->counts) : std::nullopt;
}

/// The home position of an axis, as far as this connection knows it; counts (steps) in terms of the chip's
/// present counter.
///
/// The chip's home register is something else (DS-V 5.2, DS-S 5.1): it contains whatever was captured or
/// saved last, for example the vicinity of an index or the position of a limit stop, and 0 after a restart.
/// Reset Position sets the counter to 0 but leaves the register, which then denotes a different position.
/// Home is therefore what a search has found, or what the user has saved or declared. It is adjusted when the
/// counter is set while the motor stands still, and becomes unknown after anything that may have set the
/// counter unseen.
///
/// A work offset in use counts from home and moves with it, or, if home is unknown, from counter 0. It is not
/// known any more once home is lost or determined again, or the counter is set while home is unknown: then it
/// has to be chosen again, because the same offset may now be another place.
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
    [[nodiscard]] std::optional<std::int32_t> counts() const {
        return m_place ? std::optional(m_place->counts) : std::nullopt;
    }

    /// What positions by the chip's counter count from. As long as it is equal, they are the same places.
    struct Origin {
        std::optional<std::int32_t> home;
        unsigned lost = 0;  ///< home unknown: how often what they counted from was lost in this connection
        bool operator==(const Origin&) const = default;
    };
    [[nodiscard]] Origin origin() const { return m_place ? Origin{counts()} : Origin{{}, m_lost}; }

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
    /// The module counts from 0 again.
    void restarted();

    /// Empty: no work offset is in use.
    [[nodiscard]] std::optional<WorkZero> workZero() const;
    /// The work offset with which `position` reads `called` counts (steps); empty: outside the counter's
    /// range.
    [[nodiscard]] std::optional<WorkOffset> workOffset(const std::string& name, std::int32_t position,
                                                       double called) const;
    /// Uses an offset that was chosen while home was there, or none; has no effect if home is not there any
    /// more.
    void useWork(const std::optional<WorkOffset>& offset, const std::optional<std::int32_t>& home);
    /// The offsets of the machine are these now: one that has been changed or deleted is not known any more.
    void keepWork(const std::vector<WorkOffset>& offsets);

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

    struct Work {
        WorkOffset offset;
        bool known = true;
    };
    /// Positions from before, and the work offset, are other places now.
    void loseOrigin() {
        ++m_lost;
        if (m_work)
            m_work->known = false;
    }

    std::optional<Place> m_place;
    std::optional<Work> m_work;
    unsigned m_lost = 0;
    std::optional<std::int32_t> m_offered;
    /// Time at which Save as Home was carried out; the position is taken from the home register, once two
    /// readings agree.
    std::optional<TimePoint> m_saved;
    std::optional<std::int32_t> m_reading;
    std::optional<std::int32_t> m_register;  ///< as last reported
    std::optional<Reading> m_latest;
};

}  // namespace nmc
