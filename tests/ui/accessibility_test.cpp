// SPDX-License-Identifier: GPL-3.0-or-later
// What assistive technology is told: the names of messages, and states. tests/accessibility listens to the
// real program.
#include "windowtest.h"

namespace nmc {
namespace {

class Spoken : public WindowTest {
protected:
    Spoken() { showServo(); }
    [[nodiscard]] QAccessible::State stateOf(const QString& name) {
        return QAccessible::queryAccessibleInterface(find(name))->state();
    }
    /// The name as it is read out.
    [[nodiscard]] QString nameOf(const QString& name) {
        return QAccessible::queryAccessibleInterface(find(name))->text(QAccessible::Name);
    }
};

Message fault(const QString& key, const QString& headline) {
    return {.key = key, .severity = Severity::Fault, .headline = headline, .body = u"Look at it."_s};
}

TEST_F(Spoken, TheBannerIsAnAlertNamedByItsMessage) {
    EXPECT_EQ(QAccessible::queryAccessibleInterface(find(u"banner"_s))->role(), QAccessible::AlertMessage);
    window->showMessage(fault(u"a"_s, u"The motor is hot."_s));
    EXPECT_EQ(nameOf(u"banner"_s), u"Fault: The motor is hot."_s);
    EXPECT_EQ(find(u"banner"_s)->accessibleDescription(), u"Look at it."_s);
    window->endMessage(u"a"_s);
    EXPECT_EQ(nameOf(u"banner"_s), u"Important message"_s);
}

TEST_F(Spoken, WhatAStopCameToIsTheNameOfItsLabelUntilSomethingMoves) {
    bus::StopFinished finished;
    finished.stopped = {ModuleIndex(0)};
    window->showStopResult(finished);
    EXPECT_TRUE(nameOf(u"stopResultLabel"_s).contains(u"stopped"_s));
    EXPECT_EQ(nameOf(u"stopResultLabel"_s), text(u"stopResultLabel"_s));
    window->showLink({});
    EXPECT_EQ(nameOf(u"stopResultLabel"_s), QString());
}

TEST_F(Spoken, ThePanelIsBusyWhileTheModuleIsWaitedFor) {
    showServo({.on = false, .millisecond = 1});
    EXPECT_FALSE(stateOf(u"modulePanel"_s).busy);
    click(u"enableButton"_s);
    EXPECT_TRUE(stateOf(u"modulePanel"_s).busy);
    showServo({.millisecond = 2});
    EXPECT_FALSE(stateOf(u"modulePanel"_s).busy);
}

TEST_F(Spoken, ThePanelIsBusyWhileTheChainIsLookedFor) {
    LinkState connecting;
    connecting.phase = LinkPhase::Connecting;
    window->showLink(connecting);
    EXPECT_TRUE(stateOf(u"modulePanel"_s).busy);
    window->showLink({});
    EXPECT_FALSE(stateOf(u"modulePanel"_s).busy);
}

/// A screen reader counts the children and then requests each of them: one may have gone in the meantime.
TEST_F(Spoken, AChildThatHasGoneIsNone) {
    int seen = 0;
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
        if (interface == nullptr || !widget->inherits("QScrollArea"))
            continue;
        ++seen;
        EXPECT_GE(interface->childCount(), 1) << widget->objectName().toStdString();
        EXPECT_EQ(interface->child(interface->childCount()), nullptr) << widget->objectName().toStdString();
    }
    EXPECT_GT(seen, 5);
}

TEST_F(Spoken, WhatIsDisabledIsDescribedByItsReason) {
    showServo({.on = false, .millisecond = 1});
    int seen = 0;
    for (const QString& name :
         {u"goButton"_s, u"holdForwardButton"_s, u"runForwardButton"_s, u"stopSmoothlyButton"_s,
          u"connectButton"_s, u"portBox"_s, u"tryGainsButton"_s}) {
        QWidget* control = find(name);
        if (control->isEnabled())
            continue;
        ++seen;
        EXPECT_TRUE(stateOf(name).disabled) << name.toStdString();
        const QString description =
            QAccessible::queryAccessibleInterface(control)->text(QAccessible::Description);
        EXPECT_FALSE(description.isEmpty()) << name.toStdString();
        EXPECT_EQ(description, control->toolTip()) << name.toStdString();
    }
    EXPECT_GE(seen, 5);
}

}  // namespace
}  // namespace nmc
