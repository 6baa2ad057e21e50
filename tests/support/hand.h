// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "tests/support/choosefile.h"
#include "tests/support/virtualpanel.h"

namespace nmc::testing_support {

[[nodiscard]] inline QString nameOf(QWidget& widget) {
    QAccessibleInterface* face = QAccessible::queryAccessibleInterface(&widget);
    return face != nullptr ? face->text(QAccessible::Name) : QString();
}

/// A user at the window, who knows controls only by their names.
class Hand {
public:
    explicit Hand(VirtualPanel& panel) : m_panel(panel) {}

    /// The first visible widget whose name begins with `name`, in the active window before others; scrolled
    /// into view if needed.
    template <typename Widget>
    Widget* find(const QString& name) {
        Widget* found = nullptr;
        (void)m_panel.waitFor([&] {
            found = inSight<Widget>(name);
            return found != nullptr;
        });
        EXPECT_NE(found, nullptr) << name.toStdString() << " is not visible. There are:\n"
                                  << seen<Widget>().toStdString();
        if (found != nullptr)
            turnTo(*found->window());
        return found;
    }
    void click(const QString& name) {
        auto* button = find<QAbstractButton>(name);
        ASSERT_NE(button, nullptr);
        ASSERT_TRUE(m_panel.waitFor([&] { return button->isEnabled(); }))
            << name.toStdString() << ": " << button->toolTip().toStdString();
        clickOn(*button);
    }
    void type(const QString& field, const QString& text) {
        auto* edit = find<QLineEdit>(field);
        ASSERT_NE(edit, nullptr);
        ASSERT_TRUE(m_panel.waitFor([&] { return edit->isEnabled(); })) << field.toStdString();
        QTest::mouseClick(edit, Qt::LeftButton);
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Tab);
    }
    void choose(const QString& box, const QString& item) {
        auto* combo = find<QComboBox>(box);
        ASSERT_NE(combo, nullptr);
        const int row = combo->findText(item);
        ASSERT_GE(row, 0) << item.toStdString();
        combo->setFocus();
        QTest::keyClick(combo, Qt::Key_Home);
        for (int i = 0; i < row; ++i)
            QTest::keyClick(combo, Qt::Key_Down);
        EXPECT_EQ(combo->currentText(), item);
    }
    void hold(const QString& name, const std::function<bool()>& until) {
        auto* button = find<QAbstractButton>(name);
        ASSERT_NE(button, nullptr);
        ASSERT_TRUE(m_panel.waitFor([&] { return button->isEnabled(); })) << button->toolTip().toStdString();
        QTest::mousePress(button, Qt::LeftButton);
        EXPECT_TRUE(m_panel.waitFor(until));
        QTest::mouseRelease(button, Qt::LeftButton);
    }
    void fromMenu(const QString& text) {
        for (QAction* action : m_panel.window().findChildren<QAction*>())
            if (action->text().remove(u'&').startsWith(text)) {
                ASSERT_TRUE(action->isEnabled()) << text.toStdString();
                return action->trigger();
            }
        FAIL() << "no " << text.toStdString();
    }
    void chooseFile(const QString& path) {
        QFileDialog* dialog = nullptr;
        ASSERT_TRUE(m_panel.waitFor([&] {
            dialog = m_panel.window().findChild<QFileDialog*>();
            return dialog != nullptr && dialog->isVisible();
        }));
        testing_support::chooseFile(*dialog, path);
        ASSERT_TRUE(m_panel.waitFor([&] { return m_panel.window().findChild<QFileDialog*>() == nullptr; }));
    }
    /// Toggles the mark of a row in a list.
    void tick(const QString& list, const QString& row) {
        auto* view = find<QAbstractItemView>(list);
        ASSERT_NE(view, nullptr);
        const QModelIndexList rows =
            view->model()->match(view->model()->index(0, 0), Qt::DisplayRole, row, 1, Qt::MatchStartsWith);
        ASSERT_EQ(rows.size(), 1) << row.toStdString();
        view->setCurrentIndex(rows.front());
        QTest::keyClick(view, Qt::Key_Space);
    }
    void turnTo(const QString& page) {
        for (QTabBar* bar : m_panel.window().findChildren<QTabBar*>())
            for (int i = 0; i < bar->count(); ++i)
                if (bar->isVisible() && bar->tabText(i).remove(u'&') == QString(page).remove(u'&')) {
                    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
                    return;
                }
        FAIL() << "no page " << page.toStdString();
    }
    void strike(QKeyCombination keys) {
        turnTo(m_panel.window());
        QTest::keyClick(m_panel.window().windowHandle(), keys.key(), keys.keyboardModifiers());
    }
    bool reads(const QString& words) {
        return m_panel.waitFor([&] {
            for (const QLabel* label : m_panel.window().findChildren<QLabel*>())
                if (label->isVisible() && label->text().contains(words))
                    return true;
            return false;
        });
    }

    /// Activates a window, as a window manager does when a dialog has closed.
    void turnTo(QWidget& window) {
        window.activateWindow();
        EXPECT_TRUE(m_panel.waitFor([&] { return window.isActiveWindow(); }));
    }

private:
    template <typename Widget>
    Widget* inSight(const QString& name) {
        QWidgetList windows = QApplication::topLevelWidgets();
        std::partition(windows.begin(), windows.end(),
                       [](const QWidget* window) { return window->isActiveWindow(); });
        for (QWidget* window : windows)
            for (Widget* widget : window->findChildren<Widget*>())
                if (widget->isVisible() && nameOf(*widget).startsWith(name)) {
                    testing_support::turnTo(*widget);
                    if (!widget->visibleRegion().isEmpty())
                        return widget;
                }
        return nullptr;
    }
    template <typename Widget>
    QString seen() {
        QStringList names;
        for (QWidget* window : QApplication::topLevelWidgets())
            for (Widget* widget : window->findChildren<Widget*>())
                if (widget->isVisible())
                    names << nameOf(*widget);
        return names.join(u'\n');
    }

    VirtualPanel& m_panel;
};

}  // namespace nmc::testing_support
