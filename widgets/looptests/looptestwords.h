// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <span>

#include "model/frequency/frequencyresponse.h"

/// Texts for the tests of a loop.
namespace nmc::texts {

/// One line for each figure, even if it was not reached; empty if there are no points.
[[nodiscard]] QStringList frequencyFigures(std::span<const FrequencyPoint> points);

}  // namespace nmc::texts
