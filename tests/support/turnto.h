// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>

namespace nmc::testing_support {

/// To the tab that it stands on and as far down as it stands, as everybody must who wants to see it. Of
/// actions nothing is seen.
inline void turnTo(QObject& control) {
    auto* widget = qobject_cast<QWidget*>(&control);
    for (QWidget* page = widget != nullptr ? widget->parentWidget() : nullptr; page != nullptr;
         page = page->parentWidget())
        if (page->parentWidget() != nullptr)
            if (auto* tabs = qobject_cast<QTabWidget*>(page->parentWidget()->parentWidget()))
                tabs->setCurrentWidget(page);
    // What just came in sight has its place only then.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    for (QWidget* around = widget; around != nullptr; around = around->parentWidget())
        if (auto* scroll = qobject_cast<QScrollArea*>(around); scroll != nullptr && around != widget)
            scroll->ensureWidgetVisible(widget);
}

/// By the mouse. On the mark of a check box: one as wide as its row is not one all over.
inline void clickOn(QAbstractButton& button) {
    turnTo(button);
    const bool marked = qobject_cast<QCheckBox*>(&button) != nullptr;
    const QPoint mark(button.height() / 2, button.height() / 2);
    QTest::mouseClick(&button, Qt::LeftButton, {}, marked ? mark : QPoint());
}

}  // namespace nmc::testing_support
