// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabWidget>

namespace nmc::testing_support {

/// To the tab that it stands on, as everybody must who wants to see it.
inline void turnTo(const QWidget& widget) {
    for (QWidget* page = widget.parentWidget(); page != nullptr; page = page->parentWidget())
        if (page->parentWidget() != nullptr)
            if (auto* tabs = qobject_cast<QTabWidget*>(page->parentWidget()->parentWidget()))
                tabs->setCurrentWidget(page);
}

}  // namespace nmc::testing_support
