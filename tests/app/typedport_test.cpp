// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/support/panel.h"

namespace nmc {
namespace {

using testing_support::IntentPanel;

TEST(TypedPort, ThatIsNoneSaysWhatToDo) {
    IntentPanel panel;
    panel.start();
    QTemporaryDir directory;
    QFile file(directory.filePath(QStringLiteral("mill.json")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    panel.askFor(QStringLiteral("/dev/ttyNone"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(QStringLiteral("/dev/ttyNone not found.")); }));
    panel.askFor(QStringLiteral("simulator=servo,nothing"));
    ASSERT_TRUE(
        panel.waitFor([&] { return panel.standing(QStringLiteral("simulator=servo,nothing not found.")); }));
    panel.askFor(file.fileName());
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(QStringLiteral("is not a serial port.")); }))
        << panel.headlines().join(QLatin1Char('\n')).toStdString();
    EXPECT_TRUE(panel.press(QStringLiteral("is not a serial port."), QStringLiteral("Choose another port")));
}

}  // namespace
}  // namespace nmc
