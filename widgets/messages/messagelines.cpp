// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/messagelines.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

class MessageLineTexts {
    Q_DECLARE_TR_FUNCTIONS(MessageLines)
};

const QString kClock = u"HH:mm:ss"_s;

/// Columns that a spreadsheet can separate, too.
QString line(const QDateTime& time, const Message& message, const QStringList& words) {
    QStringList columns{time.toString(Qt::ISODateWithMs), texts::severity(message.severity),
                        message.module ? texts::moduleName(*message.module) : u"–"_s};
    for (const QString& word : words)
        if (!word.isEmpty())
            columns << word.simplified();
    return columns.join(u'\t');
}

}  // namespace

bool MessageFilter::passes(const MessageEntry& entry) const {
    const Message& message = entry.message;
    const QString words = message.headline + u'\n' + message.body + u'\n' + message.details;
    return (!severity || message.severity == *severity) && (!module || message.module == *module) &&
           (!onlyNotOver || !entry.over.isValid()) && words.contains(text, Qt::CaseInsensitive);
}

QString timeText(const QDateTime& time, const QDate& today) {
    const QString clock = time.time().toString(kClock);
    return time.date() == today ? clock : time.date().toString(Qt::ISODate) + u' ' + clock;
}

QString messageLine(const MessageEntry& entry) {
    const Message& message = entry.message;
    QStringList words{message.headline, message.body, message.details};
    if (entry.count > 1)
        words << MessageLineTexts::tr("%n times", nullptr, entry.count);
    if (entry.over.isValid())
        words << Common::tr("ended at %1").arg(timeText(entry.over, entry.time.date()));
    return line(entry.time, message, words);
}

QString overLine(const MessageEntry& entry) {
    return line(entry.over, entry.message, {MessageLineTexts::tr("Ended: %1").arg(entry.message.headline)});
}

std::string messageText(const std::vector<MessageEntry>& newestFirst) {
    std::string text;
    std::for_each(newestFirst.rbegin(), newestFirst.rend(),
                  [&text](const MessageEntry& entry) { text += messageLine(entry).toStdString() + '\n'; });
    return text;
}

}  // namespace nmc
