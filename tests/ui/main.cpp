// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QMutex>
#include <QStringList>

#include "widgets/common/look.h"

namespace {

QMutex messagesMutex;
QStringList messages;

/// What the platform, not the program, is to be blamed for.
bool harmless(const QString& text) {
    return text.startsWith(QLatin1String("This plugin does not support")) ||
           text.contains(QLatin1String("XDG_RUNTIME_DIR"));
}

void keep(QtMsgType type, const QMessageLogContext& /*context*/, const QString& text) {
    const QMutexLocker lock(&messagesMutex);
    if (type != QtDebugMsg && type != QtInfoMsg && !harmless(text))
        messages << text;
    std::fprintf(stderr, "%s\n", qPrintable(text));
}

/// A Qt warning that a test did not announce fails it.
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

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    testing::InitGoogleTest(&argc, argv);
    qInstallMessageHandler(keep);
    QApplication application(argc, argv);
    nmc::look::setUp(application);
    testing::UnitTest::GetInstance()->listeners().Append(new WarningsFail);
    return RUN_ALL_TESTS();
}
