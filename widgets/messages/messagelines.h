// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

#include "widgets/common/message.h"

namespace nmc {

/// One entry of the history: a cause, how often, and from when to when.
struct MessageEntry {
    Message message;
    QDateTime time;    ///< of the last time it was told
    QDateTime over{};  ///< invalid: not yet
    int count = 1;
};

/// Which entries are shown; what is empty lets all pass.
struct MessageFilter {
    std::optional<Severity> severity{};
    std::optional<ModuleIndex> module{};
    QString text{};  ///< somewhere in its words
    bool onlyNotOver = false;

    [[nodiscard]] bool passes(const MessageEntry& entry) const;
};

/// "11:02:03", and the day before it where that is not today.
[[nodiscard]] QString timeText(const QDateTime& time, const QDate& today);
/// Of the log and of an exported list: when, how grave, of which module, in what words. One line.
[[nodiscard]] QString messageLine(const MessageEntry& entry);
/// That it is over.
[[nodiscard]] QString overLine(const MessageEntry& entry);
/// The oldest first.
[[nodiscard]] std::string messageText(const std::vector<MessageEntry>& newestFirst);

}  // namespace nmc
