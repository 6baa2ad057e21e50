// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <cstdint>

namespace nmc {

/// Why the socket cannot be opened.
struct ApiServerProblem {
    enum class Kind : std::uint8_t {
        InUse,       ///< another panel answers there
        NotPrivate,  ///< the folder, or what lies at the path, belongs to or is open to others, or is a link
        System,      ///< `reason` is the system's own
    };
    Kind kind;
    QString path;
    QString reason{};
};

}  // namespace nmc
