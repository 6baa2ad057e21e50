// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSet>
#include <QSlider>

#include "windowtest.h"

namespace nmc {
namespace {

class Controls : public WindowTest {
protected:
    /// With the simulator's dock and the packet monitor's, which have controls of their own.
    void showSimulatedServo() {
        find(u"monitorDock"_s)->show();
        find(u"monitorDock"_s)->raise();
        LinkState link = connectedTo({Servo{}.state()});
        link.simulated = true;
        window->showLink(link);
    }
    /// What a user can operate; not the parts that Qt builds its widgets of.
    QList<QWidget*> controls() {
        QList<QWidget*> found;
        for (QWidget* widget : window->findChildren<QWidget*>()) {
            const bool operates = qobject_cast<QAbstractButton*>(widget) != nullptr ||
                                  qobject_cast<QLineEdit*>(widget) != nullptr ||
                                  qobject_cast<QComboBox*>(widget) != nullptr ||
                                  qobject_cast<QSlider*>(widget) != nullptr ||
                                  qobject_cast<QPlainTextEdit*>(widget) != nullptr ||
                                  qobject_cast<QAbstractItemView*>(widget) != nullptr;
            bool ours = !widget->objectName().startsWith(u"qt_"_s);
            for (const QWidget* p = widget->parentWidget(); p != nullptr; p = p->parentWidget())
                ours = ours && !p->inherits("QComboBoxPrivateContainer") && !p->inherits("QComboBox") &&
                       !p->inherits("QTabBar") && !p->inherits("QMenuBar") && !p->inherits("QTableView");
            if (operates && ours)
                found << widget;
        }
        return found;
    }
};

TEST_F(Controls, EachHasAnObjectNameAndAnAccessibleName) {
    showSimulatedServo();
    window->showMessage(texts::portProblem({PortProblem::InUse, u"/dev/ttyUSB0"_s, {}, {}, {}, 0}));
    ASSERT_GT(controls().size(), 30);
    for (const QWidget* widget : controls()) {
        EXPECT_FALSE(widget->objectName().isEmpty()) << widget->metaObject()->className();
        EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
    }
}

TEST_F(Controls, ObjectNamesAreUnique) {
    showSimulatedServo();
    QSet<QString> seen;
    for (const QWidget* widget : controls()) {
        if (widget->objectName().startsWith(u"listAction_"_s))
            continue;
        EXPECT_FALSE(seen.contains(widget->objectName())) << widget->objectName().toStdString();
        seen.insert(widget->objectName());
    }
}

TEST_F(Controls, EachIsReachedByTab) {
    showSimulatedServo();
    QSet<const QWidget*> reached;
    QWidget* widget = window.get();
    do {
        widget = widget->nextInFocusChain();
        reached.insert(widget);
    } while (widget != window.get());
    for (const QWidget* control : controls()) {
        if (!control->isVisible() || control->inherits("QDockWidgetTitleButton"))
            continue;
        EXPECT_TRUE(reached.contains(control)) << control->objectName().toStdString();
        EXPECT_NE(control->focusPolicy() & Qt::TabFocus, 0) << control->objectName().toStdString();
    }
}

TEST_F(Controls, MnemonicsDoNotCollide) {
    showSimulatedServo();
    QHash<QString, QString> owners;
    const auto check = [&owners](const QString& text, const QString& owner) {
        const QKeySequence mnemonic = QKeySequence::mnemonic(text);
        if (mnemonic.isEmpty())
            return;
        const QString key = mnemonic.toString();
        EXPECT_FALSE(owners.contains(key))
            << key.toStdString() << ": " << owner.toStdString() << " and " << owners.value(key).toStdString();
        owners.insert(key, owner);
    };
    // A menu within a menu is only listened to there.
    for (const QMenu* menu : find(u"menuBar"_s)->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly))
        check(menu->title(), menu->title());
    for (const QAbstractButton* control : window->findChildren<QAbstractButton*>())
        check(control->text(), control->objectName());
    for (const QLabel* label : window->findChildren<QLabel*>())
        if (label->buddy() != nullptr)
            check(label->text(), label->buddy()->objectName());
}

TEST_F(Controls, EachDockHasAMenuEntry) {
    for (const QString& dock : {u"chainDock"_s, u"scopeDock"_s, u"messagesDock"_s}) {
        QAction* toggle = window->findChild<QAction*>(dock + u"Action"_s);
        ASSERT_NE(toggle, nullptr) << dock.toStdString();
        toggle->trigger();
        EXPECT_FALSE(find(dock)->isVisible());
        toggle->trigger();
        EXPECT_TRUE(find(dock)->isVisible());
    }
}

TEST_F(Controls, TheMonitorsDockIsClosedAtFirstAndHasAMenuEntry) {
    QAction* toggle = window->findChild<QAction*>(u"monitorDockAction"_s);
    ASSERT_NE(toggle, nullptr);
    EXPECT_FALSE(find(u"monitorDock"_s)->isVisible());
    toggle->trigger();
    EXPECT_TRUE(find(u"monitorDock"_s)->isVisible());
    window->findChild<QAction*>(u"resetLayoutAction"_s)->trigger();
    EXPECT_FALSE(find(u"monitorDock"_s)->isVisible());
    EXPECT_TRUE(find(u"messagesDock"_s)->isVisible());
}

TEST_F(Controls, HelpSaysToFitAHardwareStop) {
    window->findChild<QAction*>(u"safetyAction"_s)->trigger();
    auto* box = find(u"safetyDialog"_s);
    ASSERT_NE(box, nullptr);
    EXPECT_FALSE(box->isModal());
    bool said = false;
    for (const QLabel* label : box->findChildren<QLabel*>())
        said = said || label->text().contains(u"no link watchdog"_s);
    EXPECT_TRUE(said);
}

}  // namespace
}  // namespace nmc
