// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>

#include "app/translations.h"
#include "widgets/common/look.h"

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    // Motion in tests must not delay the sleep of the developer's computer.
    qputenv("DBUS_SYSTEM_BUS_ADDRESS", "unix:path=/nowhere");
    qputenv("QT_HASH_SEED", "0");
    testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    nmc::look::setUp(application);
    nmc::Translations english;
    nmc::installTranslations(english, QLocale::c());
    // A window that closes ends a test here, not the program.
    QApplication::setQuitOnLastWindowClosed(false);
    return RUN_ALL_TESTS();
}
