// SPDX-License-Identifier: GPL-3.0-or-later
#include "inlanguage.h"
#include "widgets/common/printdialog.h"
#include "widgets/machine/machinemenu.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Controls : public WindowTest {
protected:
    /// Shows a servo with the docks of simulator, packet monitor and step response, which have their own
    /// controls.
    void showSimulatedServo() {
        find(u"responseDock"_s)->show();
        find(u"responseDock"_s)->raise();
        find(u"monitorDock"_s)->show();
        find(u"monitorDock"_s)->raise();
        LinkState link = connectedTo({Servo{}.state()});
        link.simulated = true;
        window->showLink(link);
    }
    /// The controls that a user can operate, without the parts of which Qt builds its widgets.
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
    window->showMessage(texts::portProblem({PortProblem::InUse, "/dev/ttyUSB0", {}, {}, {}}));
    ASSERT_GT(controls().size(), 30);
    for (const QWidget* widget : controls()) {
        EXPECT_FALSE(widget->objectName().isEmpty()) << widget->metaObject()->className();
        EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
    }
}

/// The words on a control, without underlines and drawn arrows; empty if there are none.
QString shownWords(QString text) {
    static const QRegularExpression edges(u"^[^\\p{L}\\p{N}%]+|[^\\p{L}\\p{N}%)]+$"_s,
                                          QRegularExpression::UseUnicodePropertiesOption);
    return text.remove(QRegularExpression(u"&(?=.)"_s)).remove(edges);
}

class SpokenNames : public Controls {};

TEST_F(SpokenNames, BeginWithTheWordsThatTheControlShows) {
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Stepper, ModuleType::Io}) {
        showInEveryDock({type, 1});
        window->findChild<QAction*>(u"groupsAction"_s)->trigger();
        for (const QWidget* widget : controls()) {
            const QString name = widget->accessibleName();
            EXPECT_NE(name, widget->toolTip()) << widget->objectName().toStdString();
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            const QString shown = button != nullptr ? shownWords(button->text()) : QString();
            EXPECT_TRUE(shownWords(name).startsWith(shown, Qt::CaseInsensitive))
                << widget->objectName().toStdString() << " shows \"" << shown.toStdString()
                << "\" and is called \"" << name.toStdString() << '"';
        }
    }
}

/// In a grid, the label that names a field is the first item of its row; a label after a field is its unit.
bool begins(const QLayout& layout, int item) {
    const auto* grid = qobject_cast<const QGridLayout*>(&layout);
    int line = 0;
    int column = 0;
    int lines = 0;
    int columns = 0;
    if (grid != nullptr)
        grid->getItemPosition(item, &line, &column, &lines, &columns);
    return column == 0;
}

/// The labels of a layout, each with the item that follows it in reading order.
QList<std::pair<QLabel*, QWidget*>> labelledBy(const QLayout& layout) {
    QList<std::pair<QLabel*, QWidget*>> pairs;
    for (int i = 0; i + 1 < layout.count(); ++i)
        // A label with an object name shows a value.
        if (auto* label = qobject_cast<QLabel*>(layout.itemAt(i)->widget());
            label != nullptr && label->objectName().isEmpty() && begins(layout, i))
            pairs.append({label, layout.itemAt(i + 1)->widget()});
    return pairs;
}

TEST_F(SpokenNames, EachLabelBeforeAFieldIsItsBuddy) {
    int seen = 0;
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Stepper, ModuleType::Io}) {
        showInEveryDock({type, 1});
        for (const QLayout* layout : window->findChildren<QLayout*>())
            for (const auto& [label, field] : labelledBy(*layout)) {
                const bool fills = qobject_cast<QLineEdit*>(field) != nullptr ||
                                   qobject_cast<QComboBox*>(field) != nullptr ||
                                   qobject_cast<QSlider*>(field) != nullptr;
                if (!fills)
                    continue;
                ++seen;
                EXPECT_NE(label->buddy(), nullptr)
                    << label->text().toStdString() << ", before " << field->objectName().toStdString();
            }
    }
    EXPECT_GT(seen, 20);
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
    EXPECT_GT(seen.size(), 20);
}

TEST_F(Controls, EachIsReachedByTab) {
    showSimulatedServo();
    const QSet<const QWidget*> reached = reachedByTab();
    for (const QWidget* control : controls()) {
        if (!control->isVisible() || !control->isEnabled() || control->inherits("QDockWidgetTitleButton"))
            continue;
        // Among exclusive choices, Tab reaches only the selected one.
        const auto* choice = qobject_cast<const QAbstractButton*>(control);
        if (choice != nullptr && choice->autoExclusive() && !choice->isChecked())
            continue;
        EXPECT_TRUE(reached.contains(control)) << control->objectName().toStdString();
    }
}

/// Only one panel of a module is visible at a time, and only one of its tabs; hidden ones do not react to
/// mnemonics.
struct Panel {
    ModuleType type;
    const char* panel;
    const char* pages;
};
constexpr std::array kPanels{Panel{ModuleType::Servo, "servoPanel", "servoPages"},
                             Panel{ModuleType::Stepper, "stepperPanel", "stepperPages"}};

class Mnemonics : public testing::WithParamInterface<std::string>, public InLanguage, public Controls {
protected:
    Mnemonics() : InLanguage(GetParam()) { showSimulatedServo(); }
    void show(const Panel& shown) {
        panel = shown;
        ModuleState module = Servo{}.state();
        module.info.identity = {panel.type, 1};
        window->showLink(connectedTo({module}));
    }
    /// False if it belongs to another panel or another tab than the ones that are shown.
    [[nodiscard]] bool listens(const QWidget* widget, const QWidget* tab) const {
        const QWidget* child = widget;
        const QWidget* above = widget->parentWidget();
        for (; above != nullptr; child = above, above = above->parentWidget()) {
            if (above->objectName() == u"modulePanel"_s)
                return child->objectName() == QLatin1String(panel.panel);
            if (above->objectName() == u"qt_tabwidget_stackedwidget"_s &&
                above->parentWidget()->objectName() == QLatin1String(panel.pages) && child != tab)
                return false;
        }
        return true;
    }
    void expectNoneTwice(const QWidget* tab) {
        QHash<QString, QString> owners;
        const auto check = [&owners](const QString& text, const QString& owner) {
            const QKeySequence mnemonic = QKeySequence::mnemonic(text);
            if (mnemonic.isEmpty())
                return;
            const QString key = mnemonic.toString();
            EXPECT_FALSE(owners.contains(key)) << key.toStdString() << ": " << owner.toStdString() << " and "
                                               << owners.value(key).toStdString();
            owners.insert(key, owner);
        };
        // A menu within a menu reacts only there.
        for (const QMenu* menu :
             find(u"menuBar"_s)->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly))
            check(menu->title(), menu->title());
        for (const QAbstractButton* control : window->findChildren<QAbstractButton*>())
            if (control->window() == window.get() && listens(control, tab))
                check(control->text(), control->objectName());
        for (const QLabel* label : window->findChildren<QLabel*>())
            if (label->window() == window.get() && label->buddy() != nullptr && listens(label, tab))
                check(label->text(), label->buddy()->objectName());
        EXPECT_GT(owners.size(), 15) << owners.keys().join(u' ').toStdString();
    }
    Panel panel = kPanels.front();
};

TEST_P(Mnemonics, DoNotCollide) {
    for (const Panel& each : kPanels) {
        show(each);
        auto* tabs = find<QTabWidget>(QLatin1String(panel.pages));
        for (int i = 0; i < tabs->count(); ++i) {
            SCOPED_TRACE(tabs->tabText(i).toStdString());
            expectNoneTwice(tabs->widget(i));
        }
    }
}

TEST_P(Mnemonics, DoNotCollideWithinAMenu) {
    window->machineMenu().showFile({{}, {}, false, {u"/tmp/mill.json"_s}});
    int seen = 0;
    for (const QMenu* menu : window->findChildren<QMenu*>()) {
        QHash<QString, QString> owners;
        for (const QAction* action : menu->actions()) {
            const QString key = QKeySequence::mnemonic(action->text()).toString();
            if (key.isEmpty())
                continue;
            ++seen;
            EXPECT_FALSE(owners.contains(key))
                << menu->objectName().toStdString() << ", " << key.toStdString() << ": "
                << action->text().toStdString() << " and " << owners.value(key).toStdString();
            owners.insert(key, action->text());
        }
    }
    EXPECT_GT(seen, 20);
}

/// Each dialog is a window with its own mnemonics.
TEST_P(Mnemonics, DoNotCollideWithinADialog) {
    for (const QString& action : {u"chainDoctorAction"_s, u"operatorAction"_s, u"scopeSignalsAction"_s,
                                  u"manualAction"_s, u"reportProblemAction"_s, u"restartNetworkAction"_s})
        window->findChild<QAction*>(action)->trigger();
    window->machineMenu().showDifferences(u"mill.json"_s, {});
    (new PrintDialog({}, window->requests(), window.get()))->show();
    int seen = 0;
    for (const QDialog* dialog : window->findChildren<QDialog*>()) {
        QHash<QString, QString> owners;
        for (const QAbstractButton* control : dialog->findChildren<QAbstractButton*>()) {
            const QString key = QKeySequence::mnemonic(control->text()).toString();
            if (key.isEmpty() || control->window() != dialog || !control->isVisible())
                continue;
            ++seen;
            EXPECT_FALSE(owners.contains(key))
                << dialog->objectName().toStdString() << ", " << key.toStdString() << ": "
                << control->objectName().toStdString() << " and " << owners.value(key).toStdString();
            owners.insert(key, control->objectName());
        }
    }
    EXPECT_GT(seen, 3);
}

INSTANTIATE_TEST_SUITE_P(Languages, Mnemonics, testing::ValuesIn(allLanguages()),
                         [](const auto& language) { return language.param; });

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

/// The name of an axis may look like markup; a tool tip is a label, too.
TEST_F(Controls, ShowNoTextAsMarkup) {
    int seen = 0;
    for (const ModuleType type : {ModuleType::Servo, ModuleType::Stepper, ModuleType::Io}) {
        showInEveryDock({type, 1});
        window->findChild<QAction*>(u"groupsAction"_s)->trigger();
        window->findChild<QAction*>(u"safetyAction"_s)->trigger();
        for (QLabel* label : window->findChildren<QLabel*>()) {
            label->ensurePolished();  // as it is before it is shown
            EXPECT_EQ(label->textFormat(), Qt::PlainText)
                << label->objectName().toStdString() << ": " << label->text().toStdString();
            ++seen;
        }
    }
    EXPECT_GT(seen, 100);
    QToolTip::showText({}, u"<b>X</b>"_s);
    int tips = 0;
    for (const QWidget* widget : QApplication::topLevelWidgets())
        if (const auto* tip = qobject_cast<const QLabel*>(widget); tip && tip->inherits("QTipLabel")) {
            EXPECT_EQ(tip->textFormat(), Qt::PlainText);
            ++tips;
        }
    EXPECT_GE(tips, 1);
    QToolTip::hideText();
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
