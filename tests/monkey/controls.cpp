// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/monkey/controls.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QShortcut>
#include <QTabBar>
#include <algorithm>
#include <utility>

#include "widgets/panels/command.h"
#include "widgets/panels/holdbutton.h"

namespace nmc::monkey {

using namespace Qt::StringLiterals;

namespace {

/// Object names of controls that set a motor in motion. A new control that is missing here is noticed,
/// because it moves a motor that the user did not ask to move.
const QStringList& starters() {
    static const QStringList names{
        u"goButton"_s, u"goHomeButton"_s, u"startButton"_s, u"runForwardButton"_s, u"runReverseButton"_s,
        u"moveByForwardButton"_s, u"moveByReverseButton"_s, u"homeButton"_s, u"pwmForwardButton"_s,
        u"pwmReverseButton"_s, u"stepperGoButton"_s, u"stepperRunForwardButton"_s,
        u"stepperRunReverseButton"_s, u"stepperStartLoadedButton"_s, u"stepperHomeButton"_s,
        u"responseButton"_s, u"startDirectionCheckButton"_s, u"stepperMoveByForwardButton"_s,
        u"stepperMoveByReverseButton"_s, u"stepperGoHomeButton"_s,
        // these may contain any of them
        u"moduleMenu"_s, u"commandList"_s};
    return names;
}
const QStringList& startersOfAll() {
    static const QStringList names{u"groupStartButton"_s,   u"homeAllButton"_s,    u"goToPointButton"_s,
                                   u"runSequenceButton"_s,  u"runFromRowButton"_s, u"stepSequenceButton"_s,
                                   u"pauseSequenceButton"_s};  // this resumes the run, too
    return names;
}
/// In the rows of all axes; the number of the axis follows the name.
const QStringList& startersOfRows() {
    static const QStringList names{u"axisHoldForwardButton"_s, u"axisHoldReverseButton"_s,
                                   u"axisStepForwardButton"_s, u"axisStepReverseButton"_s};
    return names;
}

QString nameOf(const QWidget* widget) {
    for (const QWidget* w = widget; w != nullptr; w = w->parentWidget())
        if (!w->objectName().isEmpty() && !w->objectName().startsWith("qt_"_L1))
            return w == widget
                       ? w->objectName()
                       : w->objectName() + u'/' + QLatin1StringView(widget->metaObject()->className());
    return QLatin1StringView(widget->metaObject()->className());
}

}  // namespace

QWidgetList windows() {
    QWidgetList windows = QApplication::topLevelWidgets();
    windows.removeIf([](const QWidget* window) {
        return !window->isVisible() || window->windowHandle() == nullptr ||
               window->windowType() == Qt::ToolTip;
    });
    std::sort(windows.begin(), windows.end(), [](const QWidget* a, const QWidget* b) {
        return std::pair(a->objectName(), a->windowTitle()) < std::pair(b->objectName(), b->windowTitle());
    });
    return windows;
}

namespace {

class Collector {
public:
    QList<Spot> found;

    void look(QWidget* top) {
        m_top = top;
        for (QWidget* widget : top->findChildren<QWidget*>())
            if (widget->window() == top && widget->isVisible() && widget->isEnabled())
                take(widget);
        take(top);
    }

private:
    void add(QWidget* widget, const QRect& part, const QString& detail = {}) {
        const QRect seen = part & widget->visibleRegion().boundingRect() & widget->rect();
        if (seen.width() < 2 || seen.height() < 2)
            return;
        const QPoint at = widget->mapToGlobal(seen.center());
        // Whatever lies over it would receive the press.
        const QWidget* there = QApplication::widgetAt(at);
        if (there != widget && !widget->isAncestorOf(there))
            return;
        found.append({m_top, at, detail.isEmpty() ? nameOf(widget) : nameOf(widget) + u' ' + detail});
    }

    void take(QWidget* widget) {
        if (inFileDialog(widget)) {
            takeOfFileDialog(widget);
        } else if (auto* tabs = qobject_cast<QTabBar*>(widget)) {
            for (int i = 0; i < tabs->count(); ++i)
                add(tabs, tabs->tabRect(i), tabs->tabText(i));
        } else if (auto* menus = qobject_cast<QMenuBar*>(widget)) {
            for (QAction* action : menus->actions())
                add(menus, menus->actionGeometry(action), action->text());
        } else if (auto* menu = qobject_cast<QMenu*>(widget)) {
            for (QAction* action : menu->actions())
                if (action->isEnabled() && !action->isSeparator())
                    add(menu, menu->actionGeometry(action), action->text());
        } else if (auto* view = qobject_cast<QAbstractItemView*>(widget)) {
            takeRows(view);
        } else if (qobject_cast<QAbstractButton*>(widget) != nullptr ||
                   qobject_cast<QComboBox*>(widget) != nullptr ||
                   qobject_cast<QLineEdit*>(widget) != nullptr ||
                   qobject_cast<QScrollBar*>(widget) != nullptr) {
            add(widget, widget->rect());
        } else if (widget->focusPolicy() != Qt::NoFocus && widget->children().isEmpty()) {
            add(widget, widget->rect());
        }
    }

    void takeRows(QAbstractItemView* view) {
        if (view->model() == nullptr || qobject_cast<QHeaderView*>(view) != nullptr)
            return;
        constexpr int kMax = 6;  // so that a long list does not make up most of the spots
        const int rows = view->model()->rowCount(view->rootIndex());
        for (int row = 0; row < std::min(rows, kMax); ++row) {
            const QModelIndex index = view->model()->index(row, 0, view->rootIndex());
            add(view->viewport(), view->visualRect(index), u"row %1"_s.arg(row));
        }
    }

    /// Of a file dialog, only the name and the buttons that end it are used.
    void takeOfFileDialog(QWidget* widget) {
        const bool name = widget->objectName() == u"fileNameEdit"_s;
        if (name || (qobject_cast<QAbstractButton*>(widget) != nullptr &&
                     qobject_cast<QDialogButtonBox*>(widget->parentWidget()) != nullptr))
            add(widget, widget->rect());
    }

    QWidget* m_top = nullptr;
};

bool usable(const QWidget* widget) {
    return widget->isVisible() && widget->isEnabled();
}

}  // namespace

QList<Spot> spots() {
    Collector collector;
    if (QWidget* popup = QApplication::activePopupWidget()) {
        collector.look(popup);
        return collector.found;
    }
    for (QWidget* window : windows())
        collector.look(window);
    return collector.found;
}

QList<QKeySequence> shortcuts() {
    QList<QKeySequence> keys;
    for (const QWidget* window : windows()) {
        for (const auto* button : window->findChildren<QAbstractButton*>())
            if (usable(button))
                keys << button->shortcut();
        for (const auto* action : window->findChildren<QAction*>())
            if (action->isEnabled())
                keys << action->shortcuts();
        for (const auto* shortcut : window->findChildren<QShortcut*>())
            keys << shortcut->key();
        for (const auto* menus : window->findChildren<QMenuBar*>())
            for (const QAction* action : menus->actions())
                keys << QKeySequence::mnemonic(action->text());
    }
    keys.removeIf([](const QKeySequence& key) { return key.isEmpty(); });
    return keys;
}

Motors startedBy(const QWidget* widget) {
    for (const QWidget* w = widget; w != nullptr; w = w->parentWidget()) {
        const QString name = w->objectName();
        for (const QString& row : startersOfRows())
            if (name.startsWith(row))
                return {true, false,
                        ModuleIndex(static_cast<std::uint8_t>(name.mid(row.size()).toInt() - 1))};
        if (startersOfAll().contains(name))
            return {true, true};
        if (qobject_cast<const HoldButton*>(w) != nullptr || starters().contains(name))
            return {true};
    }
    return {};
}

Motors startedBy(const QKeySequence& keys) {
    for (const QWidget* window : windows())
        for (const auto* button : window->findChildren<QAbstractButton*>())
            if (usable(button) && button->shortcut() == keys && startedBy(button).any)
                return startedBy(button);
    for (const QWidget* window : windows())
        for (const auto* command : window->findChildren<Command*>())
            if (usable(command->button()) && command->shortcut() == keys && startedBy(command->button()).any)
                return startedBy(command->button());
    return {};
}

Motors startedByEnter(const QWidget* widget) {
    static const QStringList fields{u"goalField"_s, u"stepperGoalField"_s, u"runVelocityField"_s,
                                    u"commandWords"_s};
    return widget != nullptr && fields.contains(widget->objectName()) ? Motors{true} : startedBy(widget);
}

bool inFileDialog(const QWidget* widget) {
    return widget != nullptr && qobject_cast<const QFileDialog*>(widget->window()) != nullptr;
}

}  // namespace nmc::monkey
