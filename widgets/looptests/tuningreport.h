// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QStringList>
#include <optional>
#include <vector>

#include "model/frequency/frequencypoint.h"
#include "model/response/responsefile.h"

namespace nmc {

/// How a loop is tuned, for the file of the machine: what is not known is left out.
struct TuningReport {
    QString machine;
    QString module;
    QString chip;  ///< type, version and address
    QString port;  ///< with its rate
    bool simulated = false;
    QDateTime made;
    std::optional<servo::SetGain> gains{};      ///< in force
    std::optional<KeptResponse> run{};          ///< the last step response
    QStringList motor{};                        ///< what was found of it, a line each
    std::vector<FrequencyPoint> frequencies{};  ///< the last frequency response
};

/// One page with its pictures inside it. GUI thread.
[[nodiscard]] QString reportHtml(const TuningReport& report);
/// The same on one page of A4. GUI thread.
[[nodiscard]] QByteArray reportPdf(const TuningReport& report);

}  // namespace nmc
