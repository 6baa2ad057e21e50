// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bus/types.h"
#include "link/connection/workerevent.h"

/// Requests from the GUI thread to the bus thread that are answered individually. Plain values; any thread.
namespace nmc {

struct ChangeRate {
    std::uint32_t baud = 0;
};
/// Gives a restarted module its address back, or a responding module another address.
struct Readdress {
    ModuleIndex module;
    std::optional<BusAddress> address{};
};
/// See bus::Engine::resetModule().
struct ResetModule {
    ModuleIndex module;
    std::optional<servo::HardReset> configuration{};
};
struct ControlLine {
    std::string text;
};

/// Every request ends in exactly one event, whatever happens to the connection: OperationFinished,
/// GroupFinished, RateChanged or RateChangeFailed, Readdressed, AddressChanged or ReaddressFailed; a
/// simulator's control line ends in SimulatorAnswered.
using BusRequest =
    std::variant<bus::Operation, bus::GroupOperation, ChangeRate, Readdress, ResetModule, ControlLine>;

/// The final event of a request that the engine has never received, or will not finish.
[[nodiscard]] WorkerEvent refusal(const BusRequest& request, bus::Outcome outcome);

/// The requests that the engine has taken on and not yet finished. Bus thread.
class OpenRequests {
public:
    void begin(const BusRequest& request);
    void onEvent(const bus::Event& event);
    /// Called when the connection ends: returns the final events of all remaining requests, in order.
    [[nodiscard]] std::vector<WorkerEvent> abandon();

private:
    std::vector<BusRequest> m_open;
};

}  // namespace nmc
