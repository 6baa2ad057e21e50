// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/qtwarnings.h"

#include <gtest/gtest.h>

#include <QMutex>
#include <QStringList>

namespace nmc::testing_support {

namespace {

QMutex messagesMutex;
QStringList messages;

/// True if the platform is to blame, not the program.
bool harmless(const QString& text) {
    return text.startsWith(QLatin1String("This plugin does not support")) ||
           text.contains(QLatin1String("XDG_RUNTIME_DIR"));
}

void keep(QtMsgType type, const QMessageLogContext& /*context*/, const QString& text) {
    if (harmless(text))
        return;
    const QMutexLocker lock(&messagesMutex);
    if (type != QtDebugMsg && type != QtInfoMsg)
        messages << text;
    std::fprintf(stderr, "%s\n", qPrintable(text));
}

class WarningsFail : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo& /*info*/) override {
        const QMutexLocker lock(&messagesMutex);
        messages.clear();
    }
    void OnTestEnd(const testing::TestInfo& /*info*/) override {
        const QMutexLocker lock(&messagesMutex);
        for (const QString& message : messages)
            ADD_FAILURE() << "Qt says: " << message.toStdString();
    }
};

}  // namespace

void failOnQtWarnings() {
    qInstallMessageHandler(keep);
    testing::UnitTest::GetInstance()->listeners().Append(new WarningsFail);
}

}  // namespace nmc::testing_support
