// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

#include "model/recording/recording.h"
#include "widgets/scope/scopemodule.h"

namespace nmc {

/// Where and when samples were taken, for captions and files.
struct ScopeOrigin {
    QString port;
    bool simulated = false;
    QDateTime zero{};  ///< date and time of the history's zero; invalid if unknown
};

/// Past samples to examine in the scope: a recording from a file, or the samples around a fault.
struct ScopeRecord {
    QString title;  ///< "mill.csv", "Module 1 switched itself off, 14:02:11"
    History history;
    std::vector<ScopeModule> modules;
    std::optional<ModuleIndex> module{};  ///< the module that it is about
    std::optional<TimePoint> event{};     ///< time of the event that it is about
    ScopeOrigin origin{};
};

/// The header of a file with samples of these modules, whose times count from `zero`, which was at `date`.
[[nodiscard]] RecordingHeader recordingHeader(const std::vector<ScopeModule>& modules, const QString& port,
                                              bool simulated, TimePoint zero, const QDateTime& date);
/// Makes a record of what was read from a file.
[[nodiscard]] ScopeRecord recordOf(const QString& title, const RecordingHeader& header, History history);

}  // namespace nmc
