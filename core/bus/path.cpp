// SPDX-License-Identifier: MIT
#include "bus/path.h"

namespace nmc::bus {

std::optional<PathControl> pathControlOf(const ServoCommand& command) {
    if (const auto* sc = std::get_if<servo::ScIoControl>(&command))
        return PathControl{sc->fastPath, sc->stepAndDirection};
    if (const auto* cmc = std::get_if<servo::IoControl>(&command))
        return PathControl{cmc->fastPath, false};
    return std::nullopt;
}

}  // namespace nmc::bus
