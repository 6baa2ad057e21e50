// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QStringList>
#include <optional>

#include "model/response/responsefile.h"
#include "widgets/looptests/frequencypage.h"

namespace nmc {

/// The tuning of a loop, for the records of the machine; what is unknown is left out.
struct TuningReport {
    QString machine;
    QString module;
    QString chip;  ///< type, version and address
    QString port;  ///< with its rate
    bool simulated = false;
    QDateTime made;
    std::optional<servo::SetGain> gains{};            ///< in force
    std::optional<KeptResponse> run{};                ///< the last step response, of any connection
    QStringList motor{};                              ///< what was found out about it, a line each
    std::optional<FrequencyPage::Found> frequency{};  ///< the last frequency response
};

/// Returns one page of HTML with its pictures embedded. GUI thread.
[[nodiscard]] QString reportHtml(const TuningReport& report);
/// Returns the report as a PDF of one A4 page. GUI thread.
[[nodiscard]] QByteArray reportPdf(const TuningReport& report);

}  // namespace nmc
