// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <optional>
#include <variant>

#include "link/ports/linktypes.h"

namespace nmc {

/// What the panel is asked to do once it is up.
struct Start {
    std::optional<QString>
        port;  ///< connect at once; for the simulator kSimulatorPort, or that, '=' and a chain
    std::uint32_t baud = 19'200;
    bool quitAfterFirstPaint = false;  ///< for the start-up benchmark
    bool enableFaults = false;         ///< the built-in simulator takes fault lines
    bool readOnly = false;             ///< with `port`: nothing is sent but questions
    std::optional<QString> machine{};  ///< a machine file
};

/// Nothing to start: text for standard output, or for standard error when the exit code is not 0.
/// 2: the arguments are wrong in themselves; 3: there is no such port.
struct Say {
    QString text;
    int exitCode = 0;
};

/// Reads the arguments, the program's name first. Needs a QCoreApplication at most, and no display; `ports`
/// is asked only when the answer matters.
[[nodiscard]] std::variant<Start, Say> readCommandLine(const QStringList& arguments,
                                                       const std::function<QList<PortEntry>()>& ports);

}  // namespace nmc
