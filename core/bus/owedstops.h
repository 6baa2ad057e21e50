// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "bus/chain.h"
#include "bus/recovery.h"
#include "bus/task.h"

namespace nmc::bus {

/// The stops owed to single modules (Chain::Module::owed): sent before anything except a stop of all modules,
/// repeated while the module continues to move, blindly and indefinitely while it does not answer, and at
/// once when it is heard again. Only a confirmation ends one, or a start that the user requests after the end
/// of a hold.
class OwedStops : public Task {
public:
    OwedStops(Chain& chain, Recovery& recovery, const Line& line, std::vector<Event>& events)
        : m_chain(chain), m_recovery(recovery), m_line(line), m_events(events) {}

    /// While the chain is being searched for, queries would interfere, so stops are sent blindly.
    void setBlind(bool blind) { m_blind = blind; }
    /// These modules are owed their stops in the same tick: one packet to their group is sent first, if it is
    /// the same for all. After that, each is sent its stop and queried by itself.
    void sendTogether(std::vector<ModuleIndex> modules) { m_together = std::move(modules); }
    /// A module that answers has not been sent its stop yet.
    [[nodiscard]] bool anyUnsent() const;

    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] Next next(TimePoint now) override;
    void onAnswer(const Ask& ask, const ReplyEnd& end) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;
    [[nodiscard]] std::optional<TimePoint> due() const override;

private:
    [[nodiscard]] bool blindly(ModuleIndex module) const;
    [[nodiscard]] Next blindScript(TimePoint now);
    [[nodiscard]] Line::Script groupScript(TimePoint now);

    Chain& m_chain;
    Recovery& m_recovery;
    const Line& m_line;
    std::vector<Event>& m_events;
    std::vector<ModuleIndex> m_together;
    bool m_blind = false;  ///< during a search: stops are sent, queries are not
};

}  // namespace nmc::bus
