// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <optional>

#include "base/time.h"

namespace nmc {

/// How long a USB adapter at a port delays received bytes, where its driver reports it (FTDI: 16 ms unless
/// changed). `root`: where sysfs is mounted.
[[nodiscard]] std::optional<Duration> latencyTimerOf(const QString& port,
                                                     const QString& root = QStringLiteral("/sys"));

/// The file that holds this time in milliseconds.
[[nodiscard]] QString latencyTimerFile(const QString& port, const QString& root = QStringLiteral("/sys"));

}  // namespace nmc
