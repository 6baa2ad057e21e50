// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

#include "model/recording/recording.h"
#include "widgets/scope/scopemodule.h"

namespace nmc {

/// Where samples come from, and when: for captions and files.
struct ScopeOrigin {
    QString port;
    bool simulated = false;
    QDateTime zero{};  ///< when the history's zero was; invalid: not known
};

/// Something to be looked at in the scope that is over: a recording from a file, or what happened around a
/// fault.
struct ScopeRecord {
    QString title;  ///< "mill.csv", "Module 1 switched itself off, 14:02:11"
    History history;
    std::vector<ScopeModule> modules;
    bool simulated = false;
    std::optional<ModuleIndex> module{};  ///< the one that it is about
    std::optional<TimePoint> event{};     ///< when it happened
    std::optional<ScopeOrigin> origin{};  ///< nothing: this session
};

/// ISO 8601 with the offset of the zone; empty for an invalid one.
[[nodiscard]] QString isoDate(const QDateTime& date);

/// What stands above the samples of these modules in a file that counts its times from `zero`, which was at
/// `date`.
[[nodiscard]] RecordingHeader recordingHeader(const std::vector<ScopeModule>& modules, const QString& port,
                                              bool simulated, TimePoint zero, const QDateTime& date);
/// How to read what was in a file.
[[nodiscard]] ScopeRecord recordOf(const QString& title, const RecordingHeader& header, History history);

}  // namespace nmc
