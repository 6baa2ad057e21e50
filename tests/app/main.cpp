// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>

#include "app/translations.h"
#include "widgets/common/look.h"

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    // What moves here is no reason for the developer's computer to delay its sleep.
    qputenv("DBUS_SYSTEM_BUS_ADDRESS", "unix:path=/nowhere");
    qputenv("QT_HASH_SEED", "0");
    testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    nmc::look::setUp(application);
    nmc::Translations english;
    nmc::installTranslations(english, QLocale::c());
    // Here a window that closes is one test's end, not the program's.
    QApplication::setQuitOnLastWindowClosed(false);
    return RUN_ALL_TESTS();
}
