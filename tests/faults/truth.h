// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "tests/support/virtualbus.h"

namespace nmc::test {

/// What the simulated servos really did, and what the engine said about them. Modules are told apart by where
/// they are: spreadOut() before. Looks at every Sample of the bus as it comes; takes the place of bus.onTime.
class Truth {
public:
    explicit Truth(VirtualBus& bus);
    Truth(const Truth&) = delete;
    Truth& operator=(const Truth&) = delete;
    ~Truth();

    /// Moves the servos, which are on, to 0, 20 000, -20 000, 40 000 ...: none is taken for another.
    [[nodiscard]] static bool spreadOut(VirtualBus& bus);
    [[nodiscard]] static std::int32_t placeOf(std::uint8_t module);

    /// Checks the samples that have come since.
    void look();
    /// The same, and then the bus forgets its events: for millions of exchanges.
    void lookAndForget();

    [[nodiscard]] std::uint64_t samples() const { return m_samples; }
    /// Samples that do not say where their module was at their time.
    [[nodiscard]] std::uint64_t wrong() const { return m_wrong; }
    /// Samples that permit what was not so: "stands still" while it moved, "limit released" while it was
    /// closed, "power is there" while there was none, throughout their time.
    [[nodiscard]] std::uint64_t wrongPermissions() const { return m_wrongPermissions; }
    /// The first of them in words.
    [[nodiscard]] const std::string& first() const { return m_first; }
    void expectAllTrue();

private:
    struct Moment {
        TimePoint time;
        std::int32_t position = 0;
        double speed = 0;  ///< commanded or measured, the lower one
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
