// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/lazydock.h"

#include <QAction>

#include "widgets/common/look.h"

namespace nmc {

LazyDock::LazyDock(const QString& objectName, const QString& title, const QKeySequence& key, QWidget* parent)
    : QDockWidget(title, parent) {
    look::name(this, objectName, title);
    toggleViewAction()->setShortcut(key);
    connect(toggleViewAction(), &QAction::triggered, this, [this](bool shown) {
        // A dock behind another's tab counted as shown, so this has hidden it.
        if (shown || !m_wasSeen)
            open();
    });
    // Not showEvent: a dock behind another's tab is shown, but not seen.
    connect(this, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        m_seen = seen;
        if (seen) {
            build();
            emit opened();
        }
    });
    connect(
        this, &QDockWidget::visibilityChanged, this, [this](bool seen) { m_wasSeen = seen; },
        Qt::QueuedConnection);
}

void LazyDock::open() {
    show();
    raise();
    emit roomWanted();
}

}  // namespace nmc
