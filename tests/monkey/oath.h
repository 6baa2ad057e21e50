// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "app/composition.h"
#include "tests/monkey/controls.h"
#include "tests/support/virtualchain.h"

namespace nmc::monkey {

using testing_support::Packet;
using testing_support::VirtualChain;

/// What must be true whatever is done to the window, and whatever happens to the chain.
///
///  asked    no motor moves, and no start is sent to one, unless the user has pressed what starts it
///  visible  the window requests nothing that the state it shows forbids, and nothing by itself
///  read     a read-only connection sends queries, and stops only if they are requested
///  stop     STOP ALL is there whenever a port is open; it acts within the press, its packets are sent before
///           any other, and every motor whose module hears is at rest kAtRestWithin later
///  focus    is not given to a control that starts a motor
///  chip     on a line that is well, nothing is sent that a real chip would not forgive
class Oath {
public:
    /// For a stop of all modules while the line is well (faults.md F-01).
    static constexpr Duration kAtRestWithin = std::chrono::milliseconds(2'500);

    Oath(VirtualChain& chain, Composition& program);

    // Called by the code that acts.
    /// An input of the user is being delivered: the window may request something.
    void userActs(bool acts) { m_acting = acts; }
    /// The input may start these motors: the selected one, the one of a row, or all.
    void mayStart(const Motors& motors);
    /// The user requests a stop of one motor, or of all.
    void stopsOne();
    void aboutToStopAll();
    void stoppedAll();
    /// Something is wrong with the line or a module, until `until`.
    void fault(TimePoint until);
    /// The input puts the focus where the user wants it: Tab, or a press on what gets it.
    void movedFocus();
    /// Called after each bit of time.
    void look();
    [[nodiscard]] const std::vector<std::string>& complaints() const { return m_complaints; }
    /// So that a test can check that there was something to see.
    [[nodiscard]] unsigned motions() const { return m_motions; }
    [[nodiscard]] unsigned stopsInMotion() const { return m_stopsInMotion; }

private:
    struct Motor {
        bool mayMove = false;
        bool moves = false;
        TimePoint lastMoved{};
        std::optional<TimePoint> stopAsked;
        std::optional<TimePoint> restDue;
    };

    void complain(const std::string& what);
    [[nodiscard]] std::optional<std::size_t> placeOf(ModuleIndex module);
    [[nodiscard]] std::optional<std::size_t> selected();
    [[nodiscard]] const LinkState& link() const { return m_program.store().link(); }
    [[nodiscard]] bool calm() const;
    void checkIntent(ModuleIndex module, const Intent& intent);
    void checkPackets();
    void checkStopPackets(const std::vector<Packet>& packets);
    void checkMotors();
    void checkWindow();

    VirtualChain& m_chain;
    Composition& m_program;
    QObject m_context;
    std::vector<Motor> m_motors;
    std::vector<std::string> m_complaints;
    bool m_acting = false;
    std::uint32_t m_press = 0;
    bool m_askedRead = false;  ///< a stop was requested in this connection
    bool m_wasDisconnected = true;
    TimePoint m_faultsUntil{};
    QHash<const QWidget*, const QWidget*> m_focus;  ///< by window: where the user has put it
    unsigned m_stops = 0;                           ///< number of stops that the window has requested
    struct Stop {
        TimePoint at{};
        unsigned before = 0;
        bool open = false;
        bool judged = false;  ///< its packets are judged
    };
    std::optional<Stop> m_stop;
    unsigned m_motions = 0;
    unsigned m_stopsInMotion = 0;
};

}  // namespace nmc::monkey
