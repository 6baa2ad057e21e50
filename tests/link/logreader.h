// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLoggingCategory>
#include <QMutex>
#include <string>
#include <vector>

namespace nmc::testing_support {

/// Collects what all threads of this process log, as "category: text".
class LogReader {
public:
    explicit LogReader(const QString& rules) {
        s_lines.clear();
        QLoggingCategory::setFilterRules(rules);
        m_before = qInstallMessageHandler(&LogReader::take);
    }
    ~LogReader() {
        qInstallMessageHandler(m_before);
        QLoggingCategory::setFilterRules({});
    }
    LogReader(const LogReader&) = delete;
    LogReader& operator=(const LogReader&) = delete;

    static std::vector<std::string> lines() {
        const QMutexLocker lock(&s_mutex);
        return s_lines;
    }

private:
    static void take(QtMsgType, const QMessageLogContext& context, const QString& text) {
        const QMutexLocker lock(&s_mutex);
        s_lines.push_back(std::string(context.category) + ": " + text.toStdString());
    }

    QtMessageHandler m_before;
    inline static QMutex s_mutex;
    inline static std::vector<std::string> s_lines;
};

}  // namespace nmc::testing_support
