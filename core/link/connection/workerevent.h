// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "bus/types.h"
#include "link/guardian/guardianproblem.h"
#include "link/ports/porterror.h"

/// What the bus thread tells the GUI thread. Values; any thread.
namespace nmc {

/// The port is open and discovery begins.
struct PortOpened {};
/// The connection is over: by close(), or for the reason given.
struct PortClosed {
    std::optional<PortError> error;
};

/// The built-in simulator's answer to a control line.
struct SimulatorAnswered {
    std::string line;  ///< as it was given
    std::string json;
};

/// The GUI thread did not turn its event loop for so long.
struct PanelFroze {
    Duration length{};
    bool stopped = false;  ///< motors moved, so they were stopped after Heartbeat::kStopAfter
};

/// The computer was suspended and has woken.
struct ComputerSlept {
    Duration length{};
    bool stopped = true;  ///< motors were told to stop; not by a read-only connection
};

/// The bus thread stood still while something moved, and the guardian stopped the motors.
struct GuardianStopped {};

/// Nobody stops the motors any more when this process is killed.
struct GuardianMissing {
    GuardianProblem problem = GuardianProblem::Missing;
};

using WorkerEvent = std::variant<bus::Event, PortOpened, PortClosed, SimulatorAnswered, PanelFroze,
                                 ComputerSlept, GuardianStopped, GuardianMissing>;

/// It tells how things stand, and the next one tells it better: one that is lost is not missed.
[[nodiscard]] bool isSample(const WorkerEvent& event);

}  // namespace nmc
