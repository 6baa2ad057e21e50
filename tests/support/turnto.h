// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabWidget>

namespace nmc::testing_support {

/// To the tab that it stands on, as everybody must who wants to see it. Of actions nothing is seen.
inline void turnTo(const QObject& control) {
    const auto* widget = qobject_cast<const QWidget*>(&control);
    for (QWidget* page = widget != nullptr ? widget->parentWidget() : nullptr; page != nullptr;
         page = page->parentWidget())
        if (page->parentWidget() != nullptr)
            if (auto* tabs = qobject_cast<QTabWidget*>(page->parentWidget()->parentWidget()))
                tabs->setCurrentWidget(page);
}

}  // namespace nmc::testing_support
