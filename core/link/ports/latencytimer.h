// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <optional>

#include "base/time.h"

namespace nmc {

/// How long a USB adapter at a port holds received bytes back, where its driver tells (FTDI: 16 ms unless
/// somebody has changed it). `root`: where sysfs is mounted.
[[nodiscard]] std::optional<Duration> latencyTimerOf(const QString& port,
                                                     const QString& root = QStringLiteral("/sys"));

/// The file that holds it, in milliseconds.
[[nodiscard]] QString latencyTimerFile(const QString& port, const QString& root = QStringLiteral("/sys"));

}  // namespace nmc
