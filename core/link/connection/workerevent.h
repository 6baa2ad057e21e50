// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "bus/types.h"
#include "link/guardian/guardianproblem.h"
#include "link/ports/porterror.h"
#include "link/terminal/linelent.h"

/// Events from the bus thread to the GUI thread. Plain values; any thread.
namespace nmc {

/// The port is open and discovery begins.
struct PortOpened {
    Duration latency{};  ///< delay of replies that is allowed for
};
/// The connection has ended, either through close() or for the given reason.
struct PortClosed {
    std::optional<PortError> error;
    std::vector<bus::UnconfirmedStop> unconfirmed{};  ///< for the next connection to this port
};

/// The built-in simulator's answer to a control line.
struct SimulatorAnswered {
    std::string line;  ///< the line as given
    std::string json;
};

/// The GUI thread did not run its event loop for this time.
struct PanelFroze {
    Duration length{};
    bool stopped = false;  ///< motors moved, so they were stopped after Heartbeat::kStopAfter
};

/// The computer was suspended and has woken up.
struct ComputerSlept {
    Duration length{};
    bool stopped = true;  ///< the stop was sent to the motors; not on a read-only connection
};

/// The bus thread stood still while something moved, and the guardian stopped the motors.
struct GuardianStopped {};

/// From now on, nothing stops the motors when this process is killed.
struct GuardianMissing {
    GuardianProblem problem = GuardianProblem::Missing;
};

using WorkerEvent = std::variant<bus::Event, PortOpened, PortClosed, SimulatorAnswered, PanelFroze,
                                 ComputerSlept, GuardianStopped, GuardianMissing, LineLent, LendingProblem>;

/// True for events that report a current state and are superseded by the next one, so that losing one does no
/// harm.
[[nodiscard]] inline bool isSample(const WorkerEvent& event) {
    const auto* busEvent = std::get_if<bus::Event>(&event);
    return busEvent != nullptr && (std::holds_alternative<bus::Sample>(*busEvent) ||
                                   std::holds_alternative<bus::ConnectProgress>(*busEvent));
}

}  // namespace nmc
