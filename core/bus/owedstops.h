// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "bus/chain.h"
#include "bus/recovery.h"
#include "bus/task.h"

namespace nmc::bus {

/// The stops that are owed to single modules (Chain::Module::owed): sent before anything else but a stop of
/// all, again while the module moves on, blindly and for ever while it does not answer, and at once when it
/// is heard again. Only a confirmation ends one, or a start that the operator asks for after the end of a
/// hold.
class OwedStops : public Task {
public:
    OwedStops(Chain& chain, Recovery& recovery, const Line& line, std::vector<Event>& events)
        : m_chain(chain), m_recovery(recovery), m_line(line), m_events(events) {}

    /// Somebody looks for the chain: questions would be in his way, so stops go out blindly.
    void setBlind(bool blind) { m_blind = blind; }
    /// A module that answers has not been told yet.
    [[nodiscard]] bool untold() const;

    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] Next next(TimePoint now) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;
    [[nodiscard]] std::optional<TimePoint> due() const override;

private:
    [[nodiscard]] bool blindly(ModuleIndex module) const;
    [[nodiscard]] Next blindScript(TimePoint now);

    Chain& m_chain;
    Recovery& m_recovery;
    const Line& m_line;
    std::vector<Event>& m_events;
    bool m_blind = false;
};

}  // namespace nmc::bus
