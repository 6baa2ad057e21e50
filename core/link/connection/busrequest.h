// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bus/types.h"
#include "link/connection/workerevent.h"

/// What the GUI thread asks of the bus thread and is answered one by one. Values; any thread.
namespace nmc {

struct ChangeRate {
    std::uint32_t baud = 0;
};
/// Its address back to a module that has restarted; another one to a module that answers.
struct Readdress {
    ModuleIndex module;
    std::optional<BusAddress> address{};
};
/// As bus::Engine::resetModule().
struct ResetModule {
    ModuleIndex module;
    std::optional<servo::HardReset> configuration{};
};
struct ControlLine {
    std::string text;
};

/// Each ends in exactly one event, whatever becomes of the connection: OperationFinished, GroupFinished,
/// RateChanged or RateChangeFailed, Readdressed, AddressChanged or ReaddressFailed; a simulator's control
/// line in SimulatorAnswered.
using BusRequest =
    std::variant<bus::Operation, bus::GroupOperation, ChangeRate, Readdress, ResetModule, ControlLine>;

/// The end of a request that the engine has never seen, or will not finish.
[[nodiscard]] WorkerEvent refusal(const BusRequest& request);

/// The requests that the engine has taken on and has not finished. Bus thread.
class OpenRequests {
public:
    void begin(const BusRequest& request);
    void onEvent(const bus::Event& event);
    /// The connection is over: how all that are left have ended, in their order.
    [[nodiscard]] std::vector<WorkerEvent> abandon();

private:
    std::vector<BusRequest> m_open;
};

}  // namespace nmc
