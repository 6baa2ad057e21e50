// SPDX-License-Identifier: MIT
#include "link/connection/workerevent.h"

namespace nmc {

bool isSample(const WorkerEvent& event) {
    const auto* told = std::get_if<bus::Event>(&event);
    return told != nullptr && (std::holds_alternative<bus::Sample>(*told) ||
                               std::holds_alternative<bus::ConnectProgress>(*told));
}

}  // namespace nmc
