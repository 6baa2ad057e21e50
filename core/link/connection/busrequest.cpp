// SPDX-License-Identifier: MIT
#include "link/connection/busrequest.h"

#include <algorithm>

#include "base/overloaded.h"
#include "bus/commandlane.h"

namespace nmc {

namespace {

/// True when an event ends this request, which the engine has taken on.
struct Ends {
    const BusRequest& request;

    bool operator()(const bus::OperationFinished& end) const {
        const auto* operation = std::get_if<bus::Operation>(&request);
        return operation != nullptr && operation->id == end.id;
    }
    bool operator()(const bus::GroupFinished& end) const {
        const auto* operation = std::get_if<bus::GroupOperation>(&request);
        return operation != nullptr && operation->id == end.id;
    }
    bool operator()(const AnyOf<bus::RateChanged, bus::RateChangeFailed> auto&) const {
        return std::holds_alternative<ChangeRate>(request);
    }
    bool operator()(const AnyOf<bus::Readdressed, bus::AddressChanged, bus::ReaddressFailed> auto&) const {
        return std::holds_alternative<Readdress>(request) || std::holds_alternative<ResetModule>(request);
    }
    bool operator()(
        const AnyOf<bus::ChainFound, bus::ConnectFailed, bus::StopFinished, bus::ModuleUnresponsive,
                    bus::CommandRefused, bus::LinkLost, bus::HoldExpired, bus::HealthChanged,
                    bus::ModuleRestarted, bus::MotionSuspect, bus::StoppedBeforeLimit, bus::OwedStopConfirmed,
                    bus::EchoNoticed, bus::ForeignTraffic, bus::ForeignMotion> auto&) const {
        return false;
    }
    bool operator()(const In<bus::StateEvent> auto&) const { return false; }
};

}  // namespace

WorkerEvent refusal(const BusRequest& request, bus::Outcome outcome) {
    return std::visit(
        Overloaded{
            [outcome](const bus::Operation& operation) -> WorkerEvent {
                return bus::Event(bus::rejected(operation, outcome));
            },
            [outcome](const bus::GroupOperation& operation) -> WorkerEvent {
                return bus::Event(bus::GroupFinished{operation.id, outcome, operation.what, {}, false});
            },
            [](const ChangeRate& change) -> WorkerEvent {
                bus::RateChangeFailed failed;
                failed.wanted = change.baud;
                return bus::Event(failed);
            },
            [](const AnyOf<Readdress, ResetModule> auto& readdress) -> WorkerEvent {
                return bus::Event(
                    bus::ReaddressFailed{readdress.module, bus::ReaddressFailed::Reason::NotNow});
            },
            [](const ControlLine& line) -> WorkerEvent {
                return SimulatorAnswered{line.text, R"({"error":"the simulator does not listen"})"};
            },
        },
        request);
}

void OpenRequests::begin(const BusRequest& request) {
    m_open.push_back(request);
}

void OpenRequests::onEvent(const bus::Event& event) {
    const auto ended = std::ranges::find_if(
        m_open, [&event](const BusRequest& request) { return std::visit(Ends{request}, event); });
    if (ended != m_open.end())
        m_open.erase(ended);
}

std::vector<WorkerEvent> OpenRequests::abandon() {
    std::vector<WorkerEvent> ends;
    for (const BusRequest& request : m_open)
        ends.push_back(refusal(request, bus::Outcome::Cancelled));
    m_open.clear();
    return ends;
}

}  // namespace nmc
