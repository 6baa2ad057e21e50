// SPDX-License-Identifier: MIT
#pragma once

#include "base/overloaded.h"
#include "model/sequence/sequencerun.h"

namespace nmc {

/// Visitor for std::visit that informs a run of the bus events that concern it. The ends of the run's own
/// operations and procedures are reported to it by the caller that carried them out.
struct SequenceNews {
    SequenceRun& run;

    void operator()(const bus::ModuleUnresponsive& silence) const {
        if (silence.silent)
            run.onLinkSuspect();
    }
    void operator()(const bus::HealthChanged& changed) const {
        if (changed.health != bus::LinkHealth::Good)
            run.onLinkSuspect();
    }
    void operator()(const AnyOf<bus::ModuleRestarted, bus::LinkLost> auto&) const { run.onLinkSuspect(); }
    void operator()(const AnyOf<bus::MotionSuspect, bus::StoppedBeforeLimit, bus::ForeignMotion,
                                bus::HoldExpired> auto& news) const {
        run.onTakenOver(news.module);
    }
    /// The motors that were set in motion from here have been sent a stop.
    void operator()(const AnyOf<bus::ForeignTraffic, bus::StopFinished> auto&) const { run.onStopOfAll(); }
    void operator()(const bus::GroupFinished& finished) const {
        // Only a start of the group moves a motor on: after anything else, it would go to its goal unwatched.
        const auto* command = std::get_if<bus::GroupCommand>(&finished.what);
        const bool moved = command != nullptr && command->action == bus::GroupCommand::Action::StartMotion;
        for (const bus::GroupMember& member : finished.members)
            if (member.outcome != bus::MemberOutcome::Withheld)  // nothing was sent to anybody
                run.onTakenOver(member.module, moved);
    }
    void operator()(const AnyOf<bus::ChainFound, bus::ConnectFailed> auto&) const { run.onClosed(); }
    void operator()(const AnyOf<bus::OperationFinished, bus::CommandRefused, bus::RateChanged,
                                bus::RateChangeFailed, bus::OwedStopConfirmed, bus::Readdressed,
                                bus::AddressChanged, bus::ReaddressFailed, bus::EchoNoticed> auto&) const {}
    void operator()(const In<bus::StateEvent> auto&) const {}
};

}  // namespace nmc
