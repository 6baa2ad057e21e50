// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>

#include "app/translations.h"
#include "tests/support/qtwarnings.h"
#include "widgets/common/look.h"

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    testing::InitGoogleTest(&argc, argv);
    nmc::testing_support::failOnQtWarnings();
    QApplication application(argc, argv);
    nmc::look::setUp(application);
    nmc::Translations english;
    nmc::installTranslations(english, QLocale::c());
    return RUN_ALL_TESTS();
}
