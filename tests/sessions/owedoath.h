// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "bus/types.h"
#include "tests/sessions/wire.h"

namespace nmc::test {

class Rig;

/// What must be true of the stops that the engine owes (issue 13, "What must be true afterwards", 3): a motor
/// whose hold has ended, whose motion strays, or whose group has started only in part is at rest kSoon after
/// its module hears, unless it is started again; and its stop is not reported as confirmed before.
class OwedStopOath {
public:
    /// A silent module is queried at least once a second (faults.md F-10); beyond that, and the time it takes
    /// to slow down, there is no excuse.
    static constexpr Duration kSoon = std::chrono::milliseconds(1'500);

    explicit OwedStopOath(Rig& rig) : m_rig(&rig) {}

    /// The button of a held motion is up, or nothing reports any longer that it is down; by `due` the engine
    /// has to know. `wireFrom`: size of the wire log when it went down.
    void onHoldEnded(const bus::HoldToMove& hold, std::size_t wireFrom, TimePoint due);
    void onEvent(const bus::Event& event);
    void onSent(const WireItem& item);
    void onTime();
    /// Something else takes over: a stop of all modules, another program, a power cycle.
    void forget() { m_debts.clear(); }

private:
    struct Debt {
        std::size_t index;
        std::uint8_t place;
        std::uint8_t address;
        TimePoint heardSince;
    };

    void owe(ModuleIndex module, TimePoint due);
    void checkConfirmed(const bus::OwedStopConfirmed& event);

    Rig* m_rig;
    std::vector<Debt> m_debts;
    TimePoint m_nextLook{};
};

}  // namespace nmc::test
