// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Precompiled, so that what the tests of the window need of Qt is included here only.
#include <QtTest>
#include <QtWidgets>
#include <memory>

#include "tests/support/eventually.h"
#include "tests/support/turnto.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/requests.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

inline void PrintTo(const QString& text, std::ostream* out) {
    *out << text.toStdString();
}

using namespace Qt::StringLiterals;
using testing_support::eventually;

/// A servo in the state that follows from these values.
struct Servo {
    int index = 0;
    std::uint8_t version = 4;
    bool on = true;
    bool power = true;
    bool moveDone = true;
    std::int32_t position = 0;
    bool gains = true;
    int millisecond = 0;
    bool held = false;  ///< at its position, by a Stop Here

    [[nodiscard]] ModuleState state() const;
};

[[nodiscard]] servo::SetGain someGains();
[[nodiscard]] LinkState connectedTo(std::vector<ModuleState> modules);
[[nodiscard]] QPalette darkPalette();

/// A visible, active window with its own settings, and its controls by object name.
class WindowTest : public testing::Test {
protected:
    WindowTest();
    ~WindowTest() override;

    void showServos(std::vector<Servo> servos);
    void showServo(const Servo& servo = {}) { showServos({servo}); }
    /// Shows one such module, simulated, with every dock open.
    void showInEveryDock(const ModuleIdentity& identity);

    template <typename T = QWidget>
    T* find(const QString& objectName) {
        T* widget = window->findChild<T*>(objectName);
        EXPECT_NE(widget, nullptr) << objectName.toStdString();
        if (widget != nullptr)
            testing_support::turnTo(*widget);
        return widget;
    }
    NumberField* field(const QString& objectName) { return find<NumberField>(objectName); }
    QAbstractButton* button(const QString& objectName) { return find<QAbstractButton>(objectName); }
    QString text(const QString& objectName) { return find<QLabel>(objectName)->text(); }
    /// As a user would: selects what is there and types over it.
    void type(const QString& objectName, const QString& text);
    /// Selects an entry of a box with the arrow keys.
    void pick(const QString& box, const QString& entry);
    /// The widgets that have the focus as Tab is pressed again and again, until it is where it was.
    QSet<const QWidget*> reachedByTab();
    void click(const QString& objectName) { QTest::mouseClick(button(objectName), Qt::LeftButton); }

    QTemporaryDir directory;
    QSettings settings{directory.filePath(u"settings.ini"_s), QSettings::IniFormat};
    Machine machine;
    std::unique_ptr<MainWindow> window;
};

}  // namespace nmc
