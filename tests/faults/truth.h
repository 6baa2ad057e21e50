// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "tests/support/virtualbus.h"

namespace nmc::test {

/// What the simulated servos really did, compared with what the engine reports about them. Modules are told
/// apart by their positions: call spreadOut() before. Checks every Sample of the bus as it arrives; replaces
/// bus.onTime.
class Truth {
public:
    explicit Truth(VirtualBus& bus);
    Truth(const Truth&) = delete;
    Truth& operator=(const Truth&) = delete;
    ~Truth();

    /// Moves the servos, which are on, to 0, 20 000, -20 000, 40 000 ..., so that none is taken for another.
    [[nodiscard]] static bool spreadOut(VirtualBus& bus);
    [[nodiscard]] static std::int32_t placeOf(std::uint8_t module);

    /// Checks the samples that have arrived since the last look.
    void look();
    /// Does what look() does, and then makes the bus forget its events: for millions of exchanges.
    void lookAndForget();

    [[nodiscard]] std::uint64_t samples() const { return m_samples; }
    /// Number of samples that do not show where their module was at their time.
    [[nodiscard]] std::uint64_t wrong() const { return m_wrong; }
    /// Number of samples that permit what was not so: "stands still" while it moved, "limit released" while
    /// it was closed, "power is there" while there was none, throughout their time.
    [[nodiscard]] std::uint64_t wrongPermissions() const { return m_wrongPermissions; }
    /// The first wrong sample or permission, in words.
    [[nodiscard]] const std::string& first() const { return m_first; }
    void expectAllTrue();

private:
    struct Moment {
        TimePoint time;
        std::int32_t position = 0;
        double speed = 0;  ///< commanded or measured, whichever is lower
        bool limit1 = false;
        bool power = true;
    };
    struct Around;

    void remember();
    [[nodiscard]] Around around(std::uint8_t module, TimePoint time) const;
    void check(const bus::Sample& sample);
    void complain(std::uint64_t& counter, const bus::Sample& sample, const std::string& what);

    VirtualBus& m_bus;
    std::vector<std::deque<Moment>> m_history;
    std::size_t m_seen = 0;
    std::uint64_t m_samples = 0;
    std::uint64_t m_wrong = 0;
    std::uint64_t m_wrongPermissions = 0;
    std::string m_first;
};

}  // namespace nmc::test
