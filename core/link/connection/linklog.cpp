// SPDX-License-Identifier: MIT
#include "link/connection/linklog.h"

#include <chrono>
#include <vector>

#include "base/enumname.h"
#include "base/overloaded.h"
#include "bus/commandlane.h"
#include "protocol/describe.h"

namespace nmc {

Q_LOGGING_CATEGORY(linkLog, "nmc.link", QtWarningMsg)
Q_LOGGING_CATEGORY(portLog, "nmc.link.port", QtWarningMsg)
Q_LOGGING_CATEGORY(requestLog, "nmc.link.requests", QtWarningMsg)

namespace {

std::string ms(Duration duration) {
    return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(duration).count()) + " ms";
}

std::string name(ModuleIndex module) {
    return "module " + std::to_string(module.value() + 1);
}

std::string name(const std::optional<ModuleIndex>& module) {
    return module ? name(*module) : "the bus";
}

std::string list(const std::vector<ModuleIndex>& modules) {
    std::string text;
    for (const ModuleIndex module : modules)
        text += (text.empty() ? "" : " ") + std::to_string(module.value() + 1);
    return text.empty() ? "none" : text;
}

std::string word(bus::Outcome outcome) {
    return std::string(enumName<bus::Outcome::QueueFull>(outcome));
}

template <typename Enum>
std::string number(Enum value) {
    return std::to_string(static_cast<int>(value));
}

struct EventLine {
    std::string operator()(const AnyOf<bus::Sample, bus::CommandExecuted> auto&) const { return {}; }
    std::string operator()(const bus::ConnectProgress& progress) const {
        return "connecting: stage " + number(progress.stage) + ", modules " +
               std::to_string(progress.modules);
    }
    std::string operator()(const bus::ChainFound& chain) const {
        return "chain found: modules " + std::to_string(chain.modules.size()) + ", " +
               std::to_string(chain.baud) + " Bd" + (chain.attached ? ", left as it is" : "") +
               (chain.unaddressed ? ", one without an address" : "") + (chain.readOnly ? ", read-only" : "");
    }
    std::string operator()(const bus::ConnectFailed& failed) const {
        return "connecting failed: reason " + number(failed.reason) + ", modules " + list(failed.modules) +
               ", " + std::to_string(failed.baud) + " Bd";
    }
    std::string operator()(const bus::PathProgress& path) const {
        if (path.end)
            return "path of " + name(path.module) + " ended: " + number(*path.end) + ", points " +
                   std::to_string(path.done) + " of " + std::to_string(path.points());
        return path.runsDry ? "path of " + name(path.module) + " runs dry" : std::string();
    }
    std::string operator()(const bus::OperationFinished& finished) const {
        return "operation " + std::to_string(finished.id.value()) + ": " + word(finished.outcome);
    }
    std::string operator()(const bus::GroupFinished& finished) const {
        return "group operation " + std::to_string(finished.id.value()) + ": " + word(finished.outcome) +
               (finished.stopped ? ", stopped" : "");
    }
    std::string operator()(const bus::StopFinished& finished) const {
        return "stop finished: stopped " + list(finished.stopped) + ", not reached " +
               list(finished.unreached) + ", not confirmed " + list(finished.unconfirmed) +
               ", no stop known for " + list(finished.noStopKnown) + ", " + ms(finished.took);
    }
    std::string operator()(const bus::OwedStopConfirmed& confirmed) const {
        return name(confirmed.module) + " stands: the stop owed for cause " + number(confirmed.cause);
    }
    std::string operator()(const bus::ModuleUnresponsive& silence) const {
        return name(silence.module) + (silence.silent ? " is silent" : " answers again");
    }
    std::string operator()(const bus::CommandRefused& refused) const {
        return name(refused.module) + " refused, attempt " + std::to_string(refused.attempt);
    }
    std::string operator()(const bus::ForeignTraffic& traffic) const {
        return "another host sends, commanded to stop " + list(traffic.commandedToStop);
    }
    std::string operator()(const bus::ForeignMotion& motion) const {
        return name(motion.module) + " moves by command of another host, position " +
               std::to_string(motion.position);
    }
    std::string operator()(const bus::EchoNoticed&) const { return "the adapter echoes"; }
    std::string operator()(const bus::LinkLost&) const { return "every module is silent"; }
    std::string operator()(const bus::HoldExpired& expired) const {
        return name(expired.module) + ": hold ended, " +
               std::string(enumName<bus::HoldExpired::Reason::GoalChanged>(expired.reason));
    }
    std::string operator()(const bus::HealthChanged& changed) const {
        return "health of " + name(changed.module) + ": " +
               std::string(enumName<bus::LinkHealth::Lost>(changed.health)) + ", wrong " +
               std::to_string(changed.wrong) + " of " + std::to_string(changed.of);
    }
    std::string operator()(const bus::ModuleRestarted& restarted) const {
        return name(restarted.module) + " has restarted" + (restarted.quiet ? ", the bus is quiet" : "");
    }
    std::string operator()(const bus::Readdressed& readdressed) const {
        return name(readdressed.module.index) + " has its address again";
    }
    std::string operator()(const bus::AddressChanged& changed) const {
        return name(changed.module) + " has address " + std::to_string(changed.address.value());
    }
    std::string operator()(const bus::ReaddressFailed& failed) const {
        return name(failed.module) + " was not given its address, reason " + number(failed.reason);
    }
    std::string operator()(const bus::MotionSuspect& suspect) const {
        return name(suspect.module) + ": motion suspect, reason " + number(suspect.reason) + ", position " +
               std::to_string(suspect.position);
    }
    std::string operator()(const bus::StoppedBeforeLimit& stopped) const {
        return name(stopped.module) + ": stopped before its travel limit";
    }
    std::string operator()(const bus::ModulesSeen& seen) const {
        return "the program's chain: modules " + std::to_string(seen.modules.size()) + ", " +
               std::to_string(seen.baud) + " Bd";
    }
    std::string operator()(const bus::CommandUnanswered& command) const {
        return name(command.module) + ": not known whether it has carried out the program's command " +
               number(payloadOf(command.command).code);
    }
    std::string operator()(const bus::GroupChanged& changed) const {
        return name(changed.module) +
               (changed.place ? ": group " + std::to_string(changed.place->group) : ": group unknown");
    }
    std::string operator()(const bus::RateChanged& changed) const {
        return "rate changed: " + std::to_string(changed.baud) + " Bd";
    }
    std::string operator()(const bus::RateChangeFailed& failed) const {
        return "rate not changed: reason " + number(failed.reason) + ", wanted " +
               std::to_string(failed.wanted) + " Bd, modules " + list(failed.modules) + ", lost " +
               list(failed.lost);
    }
    std::string operator()(const bus::Event& event) const { return std::visit(*this, event); }
    std::string operator()(const PortOpened&) const { return "port open"; }
    std::string operator()(const PortClosed& closed) const {
        return closed.error
                   ? "port closed: problem " + number(closed.error->problem) + ", " + closed.error->detail
                   : "port closed";
    }
    std::string operator()(const SimulatorAnswered& answer) const {
        return "simulator: " + answer.line + " -> " + answer.json;
    }
    std::string operator()(const PanelFroze& froze) const {
        return "panel froze for " + ms(froze.length) +
               (froze.stopped ? ", motors were commanded to stop" : "");
    }
    std::string operator()(const ComputerSlept& slept) const {
        return "machine slept for " + ms(slept.length);
    }
    std::string operator()(const GuardianStopped&) const {
        return "the loop stood still, and the guardian stopped the motors";
    }
    std::string operator()(const GuardianMissing& missing) const {
        return "no guardian: problem " + number(missing.problem);
    }
    std::string operator()(const LineLent& lent) const {
        return "line lent at " + lent.path + ": state " + number(lent.state);
    }
    std::string operator()(const LendingProblem& problem) const {
        return "line not lent at " + problem.path + ": problem " + number(problem.kind) + ", " +
               problem.reason;
    }
};

struct RequestLine {
    std::string operator()(const bus::Operation& operation) const {
        std::string text = "operation " + std::to_string(operation.id.value());
        for (const bus::Order& step : operation.orders) {
            const auto words = [](const auto& command) { return describeCommand(command); };
            text += "; " + name(step.module) + ' ' + std::visit(words, step.command);
        }
        return text;
    }
    std::string operator()(const bus::GroupOperation& operation) const {
        const std::string text = "group operation " + std::to_string(operation.id.value()) + ": ";
        if (const auto* change = std::get_if<bus::GroupChange>(&operation.what))
            return text + name(change->module) + " to group " + std::to_string(change->place.group) +
                   (change->place.leader ? " as leader" : "");
        const auto& command = std::get<bus::GroupCommand>(operation.what);
        return text + "group " + std::to_string(command.group) + ", action " + number(command.action);
    }
    std::string operator()(const ChangeRate& change) const {
        return "change the rate to " + std::to_string(change.baud);
    }
    std::string operator()(const Readdress& readdress) const {
        return "give " + name(readdress.module) + " address " +
               (readdress.address ? std::to_string(readdress.address->value()) : "as before");
    }
    std::string operator()(const ResetModule& reset) const { return "reset " + name(reset.module); }
    std::string operator()(const ControlLine& line) const { return "simulator: " + line.text; }
};

}  // namespace

std::string logLine(const WorkerEvent& event) {
    return std::visit(EventLine{}, event);
}

std::string logLine(const BusRequest& request) {
    return std::visit(RequestLine{}, request);
}

}  // namespace nmc
