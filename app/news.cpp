// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/news.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/common/apitexts.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

using Until = News::Until;

[[nodiscard]] bool isGroupStop(const bus::GroupFinished& finished) {
    const auto* command = std::get_if<bus::GroupCommand>(&finished.what);
    return command != nullptr && isStop(command->action);
}

/// False if another host left the module running: its gains or parameters are then unknown.
[[nodiscard]] bool isKnownAgain(const ModuleState& module) {
    return module.isServo() ? module.gains.has_value()
                            : !module.isStepper() || module.stepper.parameters.has_value();
}

struct Reporter {
    const LinkState& link;
    QString port = QString::fromStdString(link.port);

    using All = std::vector<News>;

    All operator()(const bus::ChainFound& found) const {
        const bool knownAgain = std::ranges::all_of(link.modules, isKnownAgain);
        All all{{texts::connected(found, port, knownAgain), Until::Cause, bus::StopCause::ConnectionEnded,
                 found.commandedToStop}};
        if (found.replyGap > Duration{})
            all.push_back(
                {texts::repliesInPieces(port, static_cast<int>(std::lround(1e3 * toSeconds(found.replyGap)))),
                 Until::ConnectionEnds});
        // If the module that restarted is known, its own message reports it.
        if (found.unaddressed && found.absent.empty())
            all.push_back({texts::unaddressed(), Until::ConnectionEnds});
        return all;
    }
    All operator()(const bus::ConnectFailed& failed) const { return {{texts::connectFailed(failed, port)}}; }
    All operator()(const bus::OperationFinished& finished) const {
        if (finished.outcome == bus::Outcome::Done)
            return {};
        return {{texts::operationFailed(finished), Until::ModuleObeys}};
    }
    All operator()(const bus::CommandRefused& refused) const {
        return {{texts::refused(refused), Until::ModuleObeys}};
    }
    All operator()(const bus::LinkLost&) const {
        return {{texts::withRecord(texts::linkLost(port, movingModules(link)))}};
    }
    All operator()(const bus::EchoNoticed&) const {
        return {{texts::echoNoticed(port), Until::ConnectionEnds}};
    }
    All operator()(const bus::HoldExpired& expired) const {
        News news{texts::withRecord(texts::holdExpired(expired)), Until::ModuleObeys};
        if (expired.started) {
            news.stop = bus::StopCause::HoldExpired;
            news.stopped = {expired.module};
        }
        return {news};
    }
    All operator()(const bus::HealthChanged& changed) const {
        if (changed.health == bus::LinkHealth::Good)
            return {};
        News news{texts::withRecord(texts::badLink(changed))};
        if (changed.health == bus::LinkHealth::Lost && changed.module) {
            news.stop = bus::StopCause::LinkGivenUp;
            news.stopped = {*changed.module};
        }
        return {news};
    }
    All operator()(const bus::Readdressed& readdressed) const { return {{texts::readdressed(readdressed)}}; }
    All operator()(const bus::AddressChanged& changed) const { return {{texts::addressChanged(changed)}}; }
    All operator()(const bus::ReaddressFailed& failed) const {
        return {{texts::notReaddressed(failed), Until::ConnectionEnds}};
    }
    All operator()(const bus::MotionSuspect& suspect) const {
        return {{texts::withRecord(texts::motionSuspect(suspect)),
                 Until::ModuleObeys,
                 bus::StopCause::MotionSuspect,
                 {suspect.module}}};
    }
    All operator()(const bus::StoppedBeforeLimit& stopped) const {
        return {{texts::stoppedBeforeLimit(stopped.module),
                 Until::ModuleObeys,
                 bus::StopCause::TravelLimit,
                 {stopped.module}}};
    }
    All operator()(const bus::ForeignTraffic& traffic) const {
        return {{texts::withRecord(texts::foreignTraffic(traffic)), Until::ConnectionEnds,
                 bus::StopCause::ForeignTraffic, traffic.commandedToStop}};
    }
    All operator()(const bus::ForeignMotion& motion) const {
        return {{texts::withRecord(texts::foreignMotion(motion)), Until::ConnectionEnds}};
    }
    All operator()(const bus::GroupFinished& finished) const {
        std::vector<ModuleIndex> members;
        for (const bus::GroupMember& member : finished.members)
            members.push_back(member.module);
        if (finished.outcome != bus::Outcome::Done) {
            Message message = texts::groupFailed(finished, link.modules);
            if (!finished.stopped)
                return {{std::move(message), Until::ConnectionEnds}};
            return {{texts::withRecord(std::move(message)), Until::ConnectionEnds,
                     bus::StopCause::GroupHalfStarted, members}};
        }
        if (!isGroupStop(finished))
            return {};
        return {{texts::groupCommandedToStop(finished), Until::Cause, bus::StopCause::GroupStop, members}};
    }
    All operator()(const bus::RateChanged& changed) const { return {{texts::rateChanged(changed)}}; }
    All operator()(const bus::RateChangeFailed& failed) const {
        return {{texts::rateNotChanged(failed), Until::ConnectionEnds}};
    }
    All operator()(const PortClosed& closed) const {
        if (!closed.error)
            return {{texts::disconnected(port)}};
        PortError error = *closed.error;
        error.port = link.port;
        return {{texts::portProblem(error)}};
    }
    All operator()(const PanelFroze& froze) const {
        const auto moves = [this](const ModuleState& module) {
            return isLive(link, module) && module.stillMoves();
        };
        if (!froze.stopped && std::ranges::none_of(link.modules, moves))
            return {};
        return {{texts::panelFroze(toSeconds(froze.length), froze.stopped)}};
    }
    All operator()(const ComputerSlept& slept) const {
        return {{texts::machineSlept(toSeconds(slept.length), slept.stopped)}};
    }
    All operator()(const GuardianStopped&) const { return {{texts::withRecord(texts::guardianStopped())}}; }
    All operator()(const GuardianMissing& missing) const {
        return {{texts::guardianMissing(missing.problem)}};
    }
    All operator()(const LineLent& lent) const { return {{texts::lineLent(lent)}}; }
    All operator()(const LendingProblem& problem) const { return {{texts::notLent(problem)}}; }
    /// The window has a place of its own for these.
    All operator()(const AnyOf<bus::StopFinished, bus::OwedStopConfirmed, SimulatorAnswered> auto&) const {
        return {};
    }
    /// The module's state shows these.
    All operator()(const AnyOf<bus::ModuleUnresponsive, bus::ModuleRestarted> auto&) const { return {}; }
};

}  // namespace

std::vector<News> newsOf(const StoreEvent& event, const LinkState& link) {
    return std::visit(Reporter{link}, event);
}

bool endsHold(const StoreEvent& event) {
    const auto* health = std::get_if<bus::HealthChanged>(&event);
    const auto* group = std::get_if<bus::GroupFinished>(&event);
    return std::holds_alternative<bus::HoldExpired>(event) ||
           std::holds_alternative<bus::StopFinished>(event) ||
           std::holds_alternative<bus::MotionSuspect>(event) ||
           std::holds_alternative<bus::ForeignTraffic>(event) ||
           std::holds_alternative<bus::LinkLost>(event) ||
           (health != nullptr && health->health == bus::LinkHealth::Lost) ||
           (group != nullptr && (group->stopped || isGroupStop(*group)));
}

}  // namespace nmc
