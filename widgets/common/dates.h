// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <string>

#include "base/time.h"

namespace nmc {

/// The date and time of a moment, `now` being the present one.
[[nodiscard]] QDateTime dateOf(TimePoint at, TimePoint now);
/// As in files: ISO 8601 with the offset of the time zone; empty for an invalid date.
[[nodiscard]] QString isoDate(const QDateTime& date);
/// The date in this text, which isoDate() has made; invalid for any other text.
[[nodiscard]] QDateTime dateIn(const std::string& iso);

}  // namespace nmc
