// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryFile>

#include "tests/support/qtwarnings.h"
#include "widgets/common/look.h"

int main(int argc, char** argv) {
    // The default screen of the offscreen platform is too small for the window.
    QTemporaryFile screen;
    if (!screen.open())
        return 1;
    screen.write(R"({"screens": [{"name": "big", "x": 0, "y": 0, "width": 1920, "height": 1200,
                                  "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}]})");
    screen.close();
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + screen.fileName().toUtf8());
    // Another event dispatcher would not report that it is about to wait.
    qputenv("QT_NO_GLIB", "1");
    qputenv("QT_HASH_SEED", "0");
    // What moves here must not delay the sleep of the developer's computer.
    qputenv("DBUS_SYSTEM_BUS_ADDRESS", "unix:path=/nowhere");
    testing::InitGoogleTest(&argc, argv);
    nmc::testing_support::failOnQtWarnings();
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    nmc::look::setUp(application);
    return RUN_ALL_TESTS();
}
