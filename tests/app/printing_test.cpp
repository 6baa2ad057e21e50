// SPDX-License-Identifier: GPL-3.0-or-later
// A page from the scope to the system's printer, with the whole program; the print system is a script.
#include <gtest/gtest.h>

#include <QAction>
#include <QFile>

#include "panel.h"

namespace nmc {
namespace {

using namespace testing_support;

class PrintingProgram : public testing::Test {
protected:
    PrintingProgram() {
        qputenv("PATH", directory.path().toLocal8Bit() + ":" + path);
        panel.start();
        panel.connectTo(QStringLiteral("simulator=servo"));
        EXPECT_TRUE(panel.waitFor([&] { return panel.module().activity() != Activity::Unknown; }));
    }
    ~PrintingProgram() override { qputenv("PATH", path); }

    /// A program of this name that does what the script says.
    void install(const QByteArray& script) {
        QFile file(directory.filePath(QStringLiteral("lp")));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("#!/bin/sh\n" + script + "\n");
        file.close();
        ASSERT_TRUE(file.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
    }
    void print() { panel.window().findChild<QAction*>(QStringLiteral("scopePrintAction"))->trigger(); }
    bool told(const char* words) {
        return panel.waitFor([&] { return panel.count(QLatin1String(words)) > 0; });
    }

    const QByteArray path = qgetenv("PATH");
    QTemporaryDir directory;
    IntentPanel panel;
};

TEST_F(PrintingProgram, ThePrinterGetsThePage) {
    const QString page = directory.filePath(QStringLiteral("page.pdf"));
    install("cat > " + page.toLocal8Bit());
    print();
    ASSERT_TRUE(told("The page was sent to the printer."));
    QFile file(page);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray content = file.readAll();
    EXPECT_TRUE(content.startsWith("%PDF-"));
    EXPECT_TRUE(content.trimmed().endsWith("%%EOF"));
}

TEST_F(PrintingProgram, AStepPlotIsPrintedAsWell) {
    const QString page = directory.filePath(QStringLiteral("page.pdf"));
    install("cat > " + page.toLocal8Bit());
    panel.window().findChild<QAction*>(QStringLiteral("responseDockAction"))->trigger();
    ASSERT_TRUE(panel.waitFor([&] {
        return panel.window().findChild<QAction*>(QStringLiteral("responsePrintAction")) != nullptr;
    }));
    panel.window().findChild<QAction*>(QStringLiteral("responsePrintAction"))->trigger();
    ASSERT_TRUE(told("The page was sent to the printer."));
    QFile file(page);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().startsWith("%PDF-"));
}

TEST_F(PrintingProgram, APrintSystemThatDoesNotAnswerHoldsNothingUp) {
    install("exec sleep 60");
    print();
    EXPECT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.count(QLatin1String("The page")), 0);
}

TEST_F(PrintingProgram, WhatThePrintSystemRefusesIsSaid) {
    install("echo 'no default destination' >&2; exit 1");
    print();
    EXPECT_TRUE(told("Could not print the page."));
}

}  // namespace
}  // namespace nmc
