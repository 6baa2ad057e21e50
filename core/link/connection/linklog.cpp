// SPDX-License-Identifier: MIT
#include "link/connection/linklog.h"

#include <chrono>
#include <concepts>
#include <string_view>
#include <type_traits>
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

/// A line under construction. An enum appears as its number, except for the three that have names here.
struct Line {
    std::string text{};

    void put(std::string_view words) { text += words; }
    void put(std::integral auto number) { text += std::to_string(number); }
    void put(auto value) requires std::is_enum_v<decltype(value)> { put(static_cast<int>(value)); }
    void put(bus::Outcome outcome) { put(enumName<bus::Outcome::QueueFull>(outcome)); }
    void put(bus::LinkHealth health) { put(enumName<bus::LinkHealth::Lost>(health)); }
    void put(bus::HoldExpired::Reason reason) {
        put(enumName<bus::HoldExpired::Reason::GoalChanged>(reason));
    }
    void put(Duration duration) {
        put(std::chrono::duration_cast<std::chrono::milliseconds>(duration).count());
        put(" ms");
    }
    void put(ModuleIndex module) { text += "module " + std::to_string(module.value() + 1); }
    void put(const std::optional<ModuleIndex>& module) { module ? put(*module) : put("the bus"); }
    void put(const std::vector<ModuleIndex>& modules) {
        for (const ModuleIndex& module : modules)
            text += (&module == &modules.front() ? "" : " ") + std::to_string(module.value() + 1);
        put(modules.empty() ? "none" : "");
    }
};

/// The line of these parts, in this order.
std::string say(const auto&... parts) {
    Line line;
    (line.put(parts), ...);
    return line.text;
}

constexpr Overloaded kBusLine{
    [](const AnyOf<bus::Sample, bus::CommandExecuted> auto&) { return std::string(); },
    [](const bus::ConnectProgress& e) { return say("connecting: stage ", e.stage, ", modules ", e.modules); },
    [](const bus::ChainFound& e) {
        return say("chain found: modules ", e.modules.size(), ", ", e.baud, " Bd",
                   e.attached ? ", left as it is" : "", e.unaddressed ? ", one without an address" : "",
                   e.readOnly ? ", read-only" : "");
    },
    [](const bus::ConnectFailed& e) {
        return say("connecting failed: reason ", e.reason, ", modules ", e.modules, ", ", e.baud, " Bd");
    },
    [](const bus::PathProgress& e) {
        if (e.end)
            return say("path of ", e.module, " ended: ", *e.end, ", points ", e.done, " of ", e.points());
        return e.runsDry ? say("path of ", e.module, " runs dry") : std::string();
    },
    [](const bus::OperationFinished& e) { return say("operation ", e.id.value(), ": ", e.outcome); },
    [](const bus::GroupFinished& e) {
        return say("group operation ", e.id.value(), ": ", e.outcome, e.stopped ? ", stopped" : "");
    },
    [](const bus::StopFinished& e) {
        return say("stop finished: stopped ", e.stopped, ", not reached ", e.unreached, ", not confirmed ",
                   e.unconfirmed, ", no stop known for ", e.noStopKnown, ", ", e.took);
    },
    [](const bus::OwedStopConfirmed& e) {
        return say(e.module, " stands: the stop owed for cause ", e.cause);
    },
    [](const bus::ModuleUnresponsive& e) {
        return say(e.module, e.silent ? " is silent" : " answers again");
    },
    [](const bus::CommandRefused& e) { return say(e.module, " refused, attempt ", e.attempt); },
    [](const bus::ForeignTraffic& e) {
        return say("another host sends, commanded to stop ", e.commandedToStop);
    },
    [](const bus::ForeignMotion& e) {
        return say(e.module, " moves by command of another host, position ", e.position);
    },
    [](const bus::EchoNoticed&) { return say("the adapter echoes"); },
    [](const bus::LinkLost&) { return say("every module is silent"); },
    [](const bus::HoldExpired& e) { return say(e.module, ": hold ended, ", e.reason); },
    [](const bus::HealthChanged& e) {
        return say("health of ", e.module, ": ", e.health, ", wrong ", e.wrong, " of ", e.of);
    },
    [](const bus::ModuleRestarted& e) {
        return say(e.module, " has restarted", e.quiet ? ", the bus is quiet" : "");
    },
    [](const bus::Readdressed& e) { return say(e.module.index, " has its address again"); },
    [](const bus::AddressChanged& e) { return say(e.module, " has address ", e.address.value()); },
    [](const bus::ReaddressFailed& e) {
        return say(e.module, " was not given its address, reason ", e.reason);
    },
    [](const bus::MotionSuspect& e) {
        return say(e.module, ": motion suspect, reason ", e.reason, ", position ", e.position);
    },
    [](const bus::StoppedBeforeLimit& e) { return say(e.module, ": stopped before its travel limit"); },
    [](const bus::ModulesSeen& e) {
        return say("the program's chain: modules ", e.modules.size(), ", ", e.baud, " Bd");
    },
    [](const bus::CommandUnanswered& e) {
        return say(e.module, ": not known whether it has carried out the program's command ",
                   payloadOf(e.command).code);
    },
    [](const bus::GroupChanged& e) {
        return e.place ? say(e.module, ": group ", e.place->group) : say(e.module, ": group unknown");
    },
    [](const bus::RateChanged& e) { return say("rate changed: ", e.baud, " Bd"); },
    [](const bus::RateChangeFailed& e) {
        return say("rate not changed: reason ", e.reason, ", wanted ", e.wanted, " Bd, modules ", e.modules,
                   ", lost ", e.lost);
    },
};

constexpr Overloaded kEventLine{
    [](const bus::Event& event) { return std::visit(kBusLine, event); },
    [](const PortOpened&) { return say("port open"); },
    [](const PortClosed& e) {
        return e.error ? say("port closed: problem ", e.error->problem, ", ", e.error->detail)
                       : say("port closed");
    },
    [](const SimulatorAnswered& e) { return say("simulator: ", e.line, " -> ", e.json); },
    [](const PanelFroze& e) {
        return say("panel froze for ", e.length, e.stopped ? ", motors were commanded to stop" : "");
    },
    [](const ComputerSlept& e) { return say("machine slept for ", e.length); },
    [](const GuardianStopped&) { return say("the loop stood still, and the guardian stopped the motors"); },
    [](const GuardianMissing& e) { return say("no guardian: problem ", e.problem); },
    [](const LineLent& e) { return say("line lent at ", e.path, ": state ", e.state); },
    [](const LendingProblem& e) {
        return say("line not lent at ", e.path, ": problem ", e.kind, ", ", e.reason);
    },
};

constexpr Overloaded kRequestLine{
    [](const bus::Operation& operation) {
        std::string text = say("operation ", operation.id.value());
        for (const bus::Order& step : operation.orders) {
            const auto words = [](const auto& command) { return describeCommand(command); };
            text += say("; ", step.module, " ", std::visit(words, step.command));
        }
        return text;
    },
    [](const bus::GroupOperation& operation) {
        const std::string text = say("group operation ", operation.id.value(), ": ");
        if (const auto* change = std::get_if<bus::GroupChange>(&operation.what))
            return say(text, change->module, " to group ", change->place.group,
                       change->place.leader ? " as leader" : "");
        const auto& command = std::get<bus::GroupCommand>(operation.what);
        return say(text, "group ", command.group, ", action ", command.action);
    },
    [](const ChangeRate& change) { return say("change the rate to ", change.baud); },
    [](const Readdress& readdress) {
        return say("give ", readdress.module, " address ",
                   readdress.address ? say(readdress.address->value()) : "as before");
    },
    [](const ResetModule& reset) { return say("reset ", reset.module); },
    [](const ControlLine& line) { return say("simulator: ", line.text); },
};

}  // namespace

std::string logLine(const WorkerEvent& event) {
    return std::visit(kEventLine, event);
}

std::string logLine(const BusRequest& request) {
    return std::visit(kRequestLine, request);
}

}  // namespace nmc
