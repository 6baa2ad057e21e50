// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <span>

#include "model/response/frequencyresponse.h"

/// Tests of the loop in words.
namespace nmc::texts {

/// One line for each that could be told; empty for no points.
[[nodiscard]] QStringList frequencyFigures(std::span<const FrequencyPoint> points);

}  // namespace nmc::texts
