// SPDX-License-Identifier: GPL-3.0-or-later
// Commands as objects: the Module menu, the palette that finds them, their keys.
#include "tests/model/stepperfixture.h"
#include "tests/support/motionof.h"
#include "widgets/panels/command.h"
#include "windowtest.h"

namespace nmc {
namespace {

using testing_support::Stepper;

class Commands : public WindowTest {
protected:
    void strike(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(QGuiApplication::focusWindow(), key, modifiers);
    }
    QWidget* palette() { return window->findChild<QWidget*>(u"commandPalette"_s); }
    /// Opens the palette with Ctrl+K, and types the words.
    void look(const QString& words) {
        QTest::keyClick(window->windowHandle(), Qt::Key_K, Qt::ControlModifier);
        ASSERT_NE(palette(), nullptr);
        ASSERT_TRUE(QTest::qWaitForWindowActive(palette(), testing_support::kPatienceMs));
        for (const QChar c : words)
            strike(static_cast<Qt::Key>(c.toUpper().unicode()));
    }
    QString chosen() {
        const QTreeWidgetItem* item = palette()->findChild<QTreeWidget*>()->currentItem();
        return item == nullptr ? QString() : item->text(0) + u" / "_s + item->text(1);
    }
    QString says() { return palette()->findChild<QLabel*>(u"commandReason"_s)->text(); }
    QMenu* moduleMenu() {
        auto* menu = window->findChild<QMenu*>(u"moduleMenu"_s);
        menu->popup(QPoint(0, 0));
        return menu;
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
    QSignalSpy stops{window.get(), &MainWindow::stopAllRequested};
};

TEST_F(Commands, AreFoundByTheirWordsAndDoneByEnter) {
    showServo();
    look(u"run forward"_s);
    EXPECT_EQ(chosen(), u"Run forward until stopped / Module 1"_s);
    strike(Qt::Key_Return);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_NO_THROW((void)test::motionOf<servomotion::VelocityProfile>(intents.at(0).at(1).value<Intent>()));
    EXPECT_FALSE(palette()->isVisible());
}

TEST_F(Commands, OfAMenuAreFoundByWhatTheyMean) {
    look(u"bode"_s);
    EXPECT_EQ(chosen(), u"Loop tests / View"_s);
    EXPECT_TRUE(says().contains(u"Bode"_s)) << says().toStdString();
}

TEST_F(Commands, SayWhyTheyCannotBeDone) {
    showServo({.on = false});
    look(u"run forward"_s);
    EXPECT_EQ(says(), button(u"runForwardButton"_s)->toolTip());
    strike(Qt::Key_Return);
    EXPECT_EQ(intents.size(), 0);
    EXPECT_TRUE(palette()->isVisible()) << "the user reads the reason there";
}

TEST_F(Commands, OfAPageThatIsNotInSightAreAsTheModuleIsNow) {
    showServo({.gains = false});
    showServo({.millisecond = 20});  // gains have been applied, and the Details page was never shown
    look(u"sticky"_s);
    strike(Qt::Key_Return);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_TRUE(std::holds_alternative<intent::ClearStickyBits>(intents.at(0).at(1).value<Intent>()));
    EXPECT_TRUE(window->findChild<QWidget*>(u"detailsBox"_s)->isVisible())
        << "the page of the command is shown";
}

TEST_F(Commands, OfAnotherModuleAreShownAndNotDone) {
    showServos({{}, {}});
    look(u"module 2 run forward"_s);
    ASSERT_EQ(chosen(), u"Run forward until stopped / Module 2"_s);
    strike(Qt::Key_Return);
    EXPECT_EQ(window->selectedModule(), ModuleIndex(1));
    EXPECT_TRUE(eventually([this] { return QToolTip::text() == button(u"runForwardButton"_s)->toolTip(); }));
    EXPECT_FALSE(button(u"runForwardButton"_s)->hasFocus()) << "otherwise Space would run the command";
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(Commands, OfTheMenusAreFoundToo) {
    look(u"safety"_s);
    strike(Qt::Key_Return);
    EXPECT_NE(window->findChild<QWidget*>(u"safetyDialog"_s), nullptr);
}

TEST_F(Commands, EscInThePaletteStopsAndClosesIt) {
    showServo({.moveDone = false});
    look(u"go"_s);
    strike(Qt::Key_Escape);
    EXPECT_EQ(stops.size(), 1);
    EXPECT_FALSE(palette()->isVisible());
}

/// This has happened: the palette stayed over "Run forward" after STOP ALL, and took the next click.
TEST_F(Commands, APressAnywhereElseClosesThePaletteAndActs) {
    showServo();
    for (const QString& other : {u"stopAllButton"_s, u"stopAbruptlyButton"_s, u"kpField"_s}) {
        SCOPED_TRACE(other.toStdString());
        look(u"go"_s);
        ASSERT_TRUE(palette()->isVisible());
        QTest::mouseClick(palette()->findChild<QTreeWidget*>()->viewport(), Qt::LeftButton);
        EXPECT_TRUE(palette()->isVisible()) << "a click within it chooses";
        QTest::mouseClick(find(other), Qt::LeftButton);
        EXPECT_FALSE(palette()->isVisible()) << other.toStdString();
    }
    EXPECT_EQ(stops.size(), 1);
    EXPECT_EQ(intents.size(), 1);
}

TEST_F(Commands, StandInTheModuleMenuWithTheirKeys) {
    showServo();
    QMenu* menu = moduleMenu();
    QStringList texts;
    for (const QAction* action : menu->actions())
        texts << action->text().remove(u'&');
    EXPECT_TRUE(texts.contains(u"Go home"_s));
    EXPECT_TRUE(texts.contains(u"Clear sticky bits"_s)) << "although its page is not visible";
    menu->close();
}

TEST_F(Commands, OfAnOpenMenuAreAsTheModuleIsNow) {
    showServo();
    QMenu* menu = moduleMenu();
    const QAction* clear = nullptr;
    for (const QAction* action : menu->actions())
        if (action->text().remove(u'&') == u"Clear sticky bits"_s)
            clear = action;
    ASSERT_NE(clear, nullptr);
    EXPECT_TRUE(clear->isEnabled());
    ModuleState silent = Servo{}.state();
    silent.silent = true;
    window->showLink(connectedTo({silent}));
    EXPECT_FALSE(clear->isEnabled()) << "although its page is not visible";
    menu->close();
}

TEST_F(Commands, OfTheModuleMenuAreThoseOfItsChip) {
    window->showLink(connectedTo({Stepper::holding().module}));
    QMenu* menu = moduleMenu();
    QStringList names;
    for (const QAction* action : menu->actions())
        names << action->text().remove(u'&');
    EXPECT_TRUE(names.contains(u"Apply parameters"_s));
    EXPECT_FALSE(names.contains(u"Apply gains"_s));
    menu->close();
}

TEST_F(Commands, NameTheirKeysInTheToolTip) {
    showServo();
    EXPECT_EQ(button(u"goHomeButton"_s)->toolTip().count(u"Ctrl+Shift+G"_s), 0)
        << "it is not possible, and the tool tip gives the reason";
    EXPECT_TRUE(button(u"loadButton"_s)->toolTip().endsWith(u" (Ctrl+D)."_s))
        << button(u"loadButton"_s)->toolTip().toStdString();
}

TEST_F(Commands, NoKeyHasTwoMeanings) {
    for (const ModuleState& module : {Servo{}.state(), Stepper::holding().module}) {
        window->showLink(connectedTo({module}));
        QHash<QKeySequence, QString> meanings;
        const auto note = [&meanings](const QKeySequence& key, const QString& what) {
            if (key.isEmpty())
                return;
            EXPECT_FALSE(meanings.contains(key) && meanings[key] != what)
                << key.toString().toStdString() << ": " << meanings[key].toStdString() << ", "
                << what.toStdString();
            meanings[key] = what;
        };
        for (const QAction* action : window->findChildren<QAction*>())
            for (const QKeySequence& key : action->shortcuts())
                note(key, action->text().remove(u'&'));
        for (const QAbstractButton* one : window->findChildren<QAbstractButton*>())
            if (!one->shortcut().toString().startsWith(u"Alt+"_s))
                note(one->shortcut(), one->text().remove(u'&'));
        EXPECT_GT(meanings.size(), 20);
    }
}

TEST_F(Commands, EnterInRunRunsAndKeepsTheDirection) {
    showServo();
    type(u"runVelocityField"_s, u"0.4"_s);
    QTest::keyClick(field(u"runVelocityField"_s), Qt::Key_Return);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_FALSE(test::motionOf<servomotion::VelocityProfile>(intents.at(0).at(1).value<Intent>()).reverse);

    ModuleState reverse = Servo{.moveDone = false, .millisecond = 40}.state();
    reverse.motion = MotionMode::Velocity;
    reverse.goalVelocity = -0.4;
    window->showLink(connectedTo({reverse}));
    QTest::keyClick(field(u"runVelocityField"_s), Qt::Key_Return);
    ASSERT_EQ(intents.size(), 2);
    EXPECT_TRUE(test::motionOf<servomotion::VelocityProfile>(intents.at(1).at(1).value<Intent>()).reverse);
}

/// A run to a travel limit is sent as a move, of a motion that another host has started the direction is
/// unknown, and what a stop slows down is to end.
TEST_F(Commands, EnterInRunLeavesAnyOtherMotionAlone) {
    for (const MotionMode motion : {MotionMode::Trapezoidal, MotionMode::None, MotionMode::Velocity}) {
        SCOPED_TRACE(static_cast<int>(motion));
        ModuleState module = Servo{.moveDone = false}.state();
        module.motion = motion;
        window->showLink(connectedTo({module}));
        ASSERT_TRUE(button(u"runForwardButton"_s)->isEnabled());
        type(u"runVelocityField"_s, u"0.2"_s);
        QTest::keyClick(field(u"runVelocityField"_s), Qt::Key_Return);
        EXPECT_EQ(intents.size(), 0);
    }
}

/// The direction that is kept is the chip's, which on a reversed axis is not that of the buttons.
TEST_F(Commands, EnterInRunKeepsTheDirectionOfAReversedAxis) {
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, -100, {}};
    window->showMachine(machine);
    for (const double velocity : {-0.4, 0.4}) {
        intents.clear();
        ModuleState module = Servo{.moveDone = false, .millisecond = velocity < 0 ? 40 : 80}.state();
        module.motion = MotionMode::Velocity;
        module.goalVelocity = velocity;
        window->showLink(connectedTo({module}));
        QTest::keyClick(field(u"runVelocityField"_s), Qt::Key_Return);
        ASSERT_EQ(intents.size(), 1);
        EXPECT_EQ(test::motionOf<servomotion::VelocityProfile>(intents.at(0).at(1).value<Intent>()).reverse,
                  velocity < 0);
    }
}

}  // namespace
}  // namespace nmc
