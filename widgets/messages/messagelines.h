// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

#include "widgets/common/message.h"

namespace nmc {

/// One entry of the history: a cause, how often and when last it was reported, and when it ended.
struct MessageEntry {
    Message message;
    QDateTime time;    ///< when it was last reported
    QDateTime over{};  ///< when it ended; invalid: not yet
    int count = 1;
    unsigned number = 0;  ///< of the cause, in this session

    [[nodiscard]] bool ended() const { return over.isValid(); }
};

/// Which entries are shown; empty conditions let all entries pass.
struct MessageFilter {
    std::optional<Severity> severity{};
    std::optional<ModuleIndex> module{};
    QString text{};  ///< must occur in the words of the message
    bool onlyNotOver = false;

    [[nodiscard]] bool passes(const MessageEntry& entry) const;
};

/// "11:02:03", preceded by the date if that is not today.
[[nodiscard]] QString timeText(const QDateTime& time, const QDate& today);
/// The line of the log or of an exported list: time, severity, module and words.
[[nodiscard]] QString messageLine(const MessageEntry& entry);
/// The line of the log that says that the cause has ended.
[[nodiscard]] QString overLine(const MessageEntry& entry);
/// One line for each entry, oldest first.
[[nodiscard]] std::string messageText(const std::vector<MessageEntry>& newestFirst);

}  // namespace nmc
