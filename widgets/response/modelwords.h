// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "model/tuning/identify.h"
#include "model/tuning/predict.h"
#include "model/tuning/suggest.h"

/// A motor model, and what follows from it, in words.
namespace nmc::texts {

/// One constant per line, with one standard deviation, in the chip's units.
[[nodiscard]] QStringList motorFound(const Identified& found);
/// Why no motor model was found, and what to do.
[[nodiscard]] QString motorNotFound(IdentifyFailure failure);
/// "Kp 310, Kd 2900, …"
[[nodiscard]] QString gainsInShort(const servo::SetGain& gains);
/// What a step would do, one result per line.
[[nodiscard]] QStringList predicted(const Prediction& prediction);

}  // namespace nmc::texts
