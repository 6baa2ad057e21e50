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

/// What the panel does once it is running.
struct Start {
    std::optional<QString>
        port;  ///< to connect to at once; for the simulator kSimulatorPort, optionally with '=' and a chain
    std::uint32_t baud = 19'200;
    bool quitAfterFirstPaint = false;  ///< for the start-up benchmark
    bool enableFaults = false;         ///< the built-in simulator accepts fault lines
    bool readOnly = false;             ///< with `port`: only queries are sent
    std::optional<QString> machine{};  ///< a machine file
    /// Other programs: whether they may connect, and move motors without the user being asked.
    enum class Programs : std::uint8_t { KeptOut, LetIn, MayMove };
    Programs programs = Programs::KeptOut;
};

/// There is nothing to start: text for standard output, or for standard error if the exit code is not 0. 2:
/// the arguments are invalid; 3: there is no such port.
struct Say {
    QString text;
    int exitCode = 0;
};

/// Reads the arguments, beginning with the program's name. Needs at most a QCoreApplication, and no display;
/// `ports` is called only if needed.
[[nodiscard]] std::variant<Start, Say> readCommandLine(const QStringList& arguments,
                                                       const std::function<QList<PortEntry>()>& ports);

}  // namespace nmc
