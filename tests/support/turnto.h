// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>

namespace nmc::testing_support {

/// Shows the tab page of the control and scrolls to it, as a user must do to see it. Has no effect on
/// actions.
inline void turnTo(QObject& control) {
    auto* widget = qobject_cast<QWidget*>(&control);
    for (QWidget* page = widget != nullptr ? widget->parentWidget() : nullptr; page != nullptr;
         page = page->parentWidget())
        if (page->parentWidget() != nullptr)
            if (auto* tabs = qobject_cast<QTabWidget*>(page->parentWidget()->parentWidget()))
                tabs->setCurrentWidget(page);
    // A widget that has just become visible gets its position only now.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    for (QWidget* around = widget; around != nullptr; around = around->parentWidget())
        if (auto* scroll = qobject_cast<QScrollArea*>(around); scroll != nullptr && around != widget)
            scroll->ensureWidgetVisible(widget);
}

/// Clicks with the mouse; on the mark of a check box, because one as wide as its row does not react
/// everywhere.
inline void clickOn(QAbstractButton& button) {
    turnTo(button);
    const bool marked = qobject_cast<QCheckBox*>(&button) != nullptr;
    const QPoint mark(button.height() / 2, button.height() / 2);
    QTest::mouseClick(&button, Qt::LeftButton, {}, marked ? mark : QPoint());
}

}  // namespace nmc::testing_support
