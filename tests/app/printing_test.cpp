// SPDX-License-Identifier: GPL-3.0-or-later
// Prints a page of the scope with the whole program; two scripts take the place of the print system. No
// modules are needed.
#include <gtest/gtest.h>

#include "tests/support/choosefile.h"
#include "tests/support/panel.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace Qt::StringLiterals;

class PrintingProgram : public testing::Test {
protected:
    PrintingProgram() {
        qputenv("PATH", directory.path().toLocal8Bit() + ":" + path);
        install("lp", "echo \"$@\" > " + place(u"asked"_s) + "; cat > " + place(u"page.pdf"_s));
        installPrinters("office\\nlab\\nplotter\\n", "system default destination: lab");
        panel.start();
    }
    ~PrintingProgram() override { qputenv("PATH", path); }

    [[nodiscard]] QByteArray place(const QString& file) { return directory.filePath(file).toLocal8Bit(); }
    /// Installs a program of this name that runs the script.
    void install(const char* program, const QByteArray& script) {
        QFile file(directory.filePath(QLatin1StringView(program)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("#!/bin/sh\n" + script + "\n");
        file.close();
        ASSERT_TRUE(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    }
    void installPrinters(const QByteArray& names, const QByteArray& standard) {
        install("lpstat", "case $1 in -e) printf '" + names + "';; -d) echo '" + standard + "';; esac");
    }
    void print() { panel.window().findChild<QAction*>(u"scopePrintAction"_s)->trigger(); }
    /// Waits until the dialog is open and has finished looking for printers.
    bool asked() {
        return panel.waitFor(
            [&] { return open() && !find<QLabel>(u"printState"_s)->text().startsWith(u"Looking"_s); });
    }
    /// Prints, as far as that.
    bool ask() {
        print();
        return asked();
    }
    bool open() {
        auto* dialog = panel.window().findChild<QDialog*>(u"printDialog"_s);
        return dialog != nullptr && dialog->isVisible();
    }
    template <typename T>
    T* find(const QString& name) {
        auto* dialog = panel.window().findChild<QDialog*>(u"printDialog"_s);
        return dialog != nullptr ? dialog->findChild<T*>(name) : nullptr;
    }
    void click(const QString& button) {
        ASSERT_TRUE(find<QPushButton>(button)->isEnabled());
        QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton);
    }
    [[nodiscard]] QStringList printers() {
        QStringList names;
        for (int i = 0; i < find<QComboBox>(u"printerBox"_s)->count(); ++i)
            names << find<QComboBox>(u"printerBox"_s)->itemText(i);
        return names;
    }
    [[nodiscard]] QString chosen() { return find<QComboBox>(u"printerBox"_s)->currentText(); }
    bool told(const char* words) {
        return panel.waitFor([&] { return panel.count(QLatin1StringView(words)) > 0; });
    }
    [[nodiscard]] QByteArray contentOf(const QString& name) {
        QFile file(directory.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    const QByteArray path = qgetenv("PATH");
    QTemporaryDir directory;
    IntentPanel panel;
};

TEST_F(PrintingProgram, TheSystemsOwnPrinterIsProposedAndGetsThePage) {
    ASSERT_TRUE(ask());
    EXPECT_EQ(printers(), (QStringList{u"office"_s, u"lab"_s, u"plotter"_s}));
    EXPECT_EQ(chosen(), u"lab"_s);
    click(u"printButton"_s);
    EXPECT_FALSE(open());
    ASSERT_TRUE(told("The page was sent to the printer."));
    EXPECT_EQ(contentOf(u"asked"_s), "-d lab -n 1 -t NMC Panel\n");
    const QByteArray content = contentOf(u"page.pdf"_s);
    EXPECT_TRUE(content.startsWith("%PDF-"));
    EXPECT_TRUE(content.trimmed().endsWith("%%EOF"));
}

TEST_F(PrintingProgram, AnotherPrinterIsChosenWithMoreCopiesAndProposedTheNextTime) {
    ASSERT_TRUE(ask());
    QTest::keyClick(find<QComboBox>(u"printerBox"_s), Qt::Key_End);
    auto* copies = find<QLineEdit>(u"copiesField"_s);
    copies->setFocus();
    copies->selectAll();
    QTest::keyClicks(copies, u"12"_s);
    QTest::keyClick(copies, Qt::Key_Return);
    ASSERT_TRUE(told("The page was sent to the printer."));
    EXPECT_EQ(contentOf(u"asked"_s), "-d plotter -n 12 -t NMC Panel\n");
    ASSERT_TRUE(ask());
    EXPECT_EQ(chosen(), u"plotter"_s);
    EXPECT_EQ(find<QLineEdit>(u"copiesField"_s)->text(), u"1"_s) << "the number of copies is not remembered";
    click(u"printCancelButton"_s);
    installPrinters("office\\nlab\\n", "system default destination: lab");
    ASSERT_TRUE(ask());
    EXPECT_EQ(chosen(), u"lab"_s) << "the other printer no longer exists";
}

TEST_F(PrintingProgram, MoreCopiesThanThereCanBePrintNothing) {
    ASSERT_TRUE(ask());
    auto* copies = find<QLineEdit>(u"copiesField"_s);
    copies->setFocus();
    copies->selectAll();
    QTest::keyClicks(copies, u"100"_s);
    EXPECT_FALSE(find<QPushButton>(u"printButton"_s)->isEnabled());
    EXPECT_TRUE(find<QPushButton>(u"printButton"_s)->toolTip().contains(u"99"_s));
    QTest::keyClick(copies, Qt::Key_Return);
    EXPECT_TRUE(open());
}

TEST_F(PrintingProgram, CancelPrintsNothing) {
    ASSERT_TRUE(ask());
    click(u"printCancelButton"_s);
    EXPECT_FALSE(open());
    ASSERT_TRUE(ask()) << "programs that were started later have answered";
    EXPECT_EQ(panel.count(u"The page"_s), 0);
    EXPECT_FALSE(QFile::exists(directory.filePath(u"asked"_s)));
}

TEST_F(PrintingProgram, AnotherPageTakesThePlaceOfTheOneThatIsAskedAbout) {
    ASSERT_TRUE(ask());
    QTest::keyClick(find<QComboBox>(u"printerBox"_s), Qt::Key_End);
    print();
    EXPECT_EQ(panel.window().findChildren<QDialog*>(u"printDialog"_s).size(), 1);
    EXPECT_EQ(chosen(), u"plotter"_s) << "the selection stays";
    click(u"printButton"_s);
    ASSERT_TRUE(told("The page was sent to the printer."));
    EXPECT_EQ(contentOf(u"asked"_s), "-d plotter -n 1 -t NMC Panel\n");
}

TEST_F(PrintingProgram, TheOnlyPrinterIsShown) {
    installPrinters("office\\n", "no system default destination");
    ASSERT_TRUE(ask());
    EXPECT_EQ(printers(), QStringList{u"office"_s});
    EXPECT_EQ(chosen(), u"office"_s);
}

TEST_F(PrintingProgram, AStepPlotIsPrintedAsWell) {
    panel.window().findChild<QAction*>(u"responseDockAction"_s)->trigger();
    ASSERT_TRUE(panel.waitFor(
        [&] { return panel.window().findChild<QAction*>(u"responsePrintAction"_s) != nullptr; }));
    panel.window().findChild<QAction*>(u"responsePrintAction"_s)->trigger();
    ASSERT_TRUE(asked());
    click(u"printButton"_s);
    ASSERT_TRUE(told("The page was sent to the printer."));
    EXPECT_TRUE(contentOf(u"page.pdf"_s).startsWith("%PDF-"));
}

TEST_F(PrintingProgram, WithoutAPrinterItSaysWhatToDoAndSavesThePage) {
    installPrinters("", "no system default destination");
    ASSERT_TRUE(ask());
    EXPECT_TRUE(
        find<QLabel>(u"printState"_s)->text().startsWith(u"No printer is set up on this computer."_s));
    // All of its lines are visible.
    const auto* state = find<QLabel>(u"printState"_s);
    EXPECT_GE(state->height(), state->heightForWidth(state->width()));
    EXPECT_FALSE(find<QPushButton>(u"printButton"_s)->isEnabled());
    click(u"printSaveButton"_s);
    auto* file = find<QFileDialog>(u"printPdfDialog"_s);
    ASSERT_NE(file, nullptr);
    chooseFile(*file, directory.filePath(u"saved.pdf"_s));
    EXPECT_TRUE(panel.waitFor([&] { return contentOf(u"saved.pdf"_s).trimmed().endsWith("%%EOF"); }));
    EXPECT_FALSE(open());
    EXPECT_FALSE(QFile::exists(directory.filePath(u"asked"_s)));
}

TEST_F(PrintingProgram, WithoutAPrintSystemItSaysTheSame) {
    qputenv("PATH", place({}));
    ASSERT_TRUE(QFile::remove(directory.filePath(u"lpstat"_s)));
    ASSERT_TRUE(ask());
    EXPECT_TRUE(
        find<QLabel>(u"printState"_s)->text().startsWith(u"No printer is set up on this computer."_s));
}

TEST_F(PrintingProgram, PrintersThatAreNeverNamedHoldNothingUp) {
    panel.connectTo(u"simulator=servo"_s);
    install("lpstat", "exec sleep 60");
    print();
    ASSERT_TRUE(panel.waitFor([&] { return open(); }));
    EXPECT_EQ(find<QLabel>(u"printState"_s)->text(), u"Looking for printers…"_s);
    EXPECT_FALSE(find<QPushButton>(u"printButton"_s)->isEnabled());
    EXPECT_TRUE(find<QPushButton>(u"printSaveButton"_s)->isEnabled());
    QSignalSpy stops(&panel.window(), &MainWindow::stopAllRequested);
    panel.pressStopAll();
    EXPECT_EQ(stops.size(), 1);
    QTest::keyClick(find<QLineEdit>(u"copiesField"_s), Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 2);
    EXPECT_FALSE(open());
    print();
    ASSERT_TRUE(panel.waitFor([&] { return open(); }));
    panel.window().close();
    EXPECT_FALSE(panel.window().isVisible());
}

/// The system's printer is known before the others are found.
TEST_F(PrintingProgram, TheSystemsOwnPrinterNeedNotWaitForTheOthers) {
    install("lpstat", "case $1 in -e) exec sleep 60;; -d) echo 'system default destination: lab';; esac");
    print();
    ASSERT_TRUE(panel.waitFor([&] { return open() && chosen() == u"lab"_s; }));
    click(u"printButton"_s);
    ASSERT_TRUE(told("The page was sent to the printer."));
    EXPECT_EQ(contentOf(u"asked"_s), "-d lab -n 1 -t NMC Panel\n");
}

TEST_F(PrintingProgram, APrintSystemThatDoesNotAnswerHoldsNothingUp) {
    install("lp", "exec sleep 60");
    ASSERT_TRUE(ask());
    click(u"printButton"_s);
    ASSERT_TRUE(ask()) << "programs that were started later have answered";
    EXPECT_EQ(panel.count(u"The page"_s), 0);
}

TEST_F(PrintingProgram, WhatThePrintSystemRefusesIsSaid) {
    install("lp", "echo 'lab is not accepting jobs' >&2; exit 1");
    ASSERT_TRUE(ask());
    click(u"printButton"_s);
    EXPECT_TRUE(told("Could not print the page."));
}

}  // namespace
}  // namespace nmc
