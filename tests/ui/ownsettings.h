// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "model/machinefile/machinefile.h"
#include "tests/model/stepperfixture.h"
#include "windowtest.h"

namespace nmc {

using testing_support::Stepper;

/// Two modules of each chip.
class OwnSettings : public WindowTest {
protected:
    OwnSettings() {
        machine.axes.resize(4);
        for (int i = 0; i < 2; ++i)
            modules.push_back(Servo{.index = i}.state());
        for (std::uint8_t i = 2; i < 4; ++i) {
            modules.push_back(Stepper::holding().module);
            modules.back().info.index = ModuleIndex(i);
            modules.back().info.address = BusAddress(static_cast<std::uint8_t>(i + 1));
        }
        window->showLink(connectedTo(modules));
        list = find<QAbstractItemView>(u"chainList"_s);
    }

    void clickModule(int module) {
        const QRect row = list->visualRect(list->model()->index(module, 0));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, row.center());
        ASSERT_EQ(selected(), module);
    }
    [[nodiscard]] int selected() const { return list->currentIndex().row(); }
    [[nodiscard]] bool servo() const { return selected() < 2; }

    /// Opens a page by a click on its tab.
    void openPage(const QString& page) {
        auto* tabs = find<QTabBar>(servo() ? u"servoPagesBar"_s : u"stepperPagesBar"_s);
        int tab = 0;
        while (tab < tabs->count() && tabs->tabText(tab) != page)
            ++tab;
        ASSERT_LT(tab, tabs->count()) << page.toStdString();
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(tab).center());
    }
    /// Scrolls to where the control is, as a user would.
    template <typename T = QWidget>
    T* reach(const QString& name) {
        T* widget = find<T>(name);
        for (auto* area : window->findChildren<QScrollArea*>())
            if (area->widget()->isAncestorOf(widget))
                area->ensureWidgetVisible(widget);
        EXPECT_TRUE(widget->isVisible()) << name.toStdString();
        return widget;
    }
    /// Types over the contents, key by key; `typed` is called after each key.
    void typeOver(
        const QString& name, const QString& text, const std::function<void()>& typed = [] {}) {
        auto* target = reach<QLineEdit>(name);
        QTest::mouseClick(target, Qt::LeftButton);
        QTest::keyClick(target, Qt::Key_A, Qt::ControlModifier);
        for (const QChar c : text) {
            QTest::keyClick(target, c.toLatin1());
            typed();
        }
    }
    void choose(const QString& box, const QString& entry) {
        auto* combo = reach<QComboBox>(box);
        combo->setFocus(Qt::TabFocusReason);
        QTest::keyClick(combo, Qt::Key_Home);
        for (int i = 0; i < combo->count() && combo->currentText() != entry; ++i)
            QTest::keyClick(combo, Qt::Key_Down);
        ASSERT_EQ(combo->currentText(), entry);
    }
    /// Returns false if a user cannot press it.
    bool press(const QString& name) {
        auto* target = reach<QAbstractButton>(name);
        if (!target->isEnabled())
            return false;
        QTest::mouseClick(target, Qt::LeftButton, {}, QPoint(8, target->height() / 2));
        return true;
    }

    std::vector<ModuleState> modules;
    QAbstractItemView* list = nullptr;
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

}  // namespace nmc
