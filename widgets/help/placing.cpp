// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/placing.h"

#include <QDialog>
#include <QMainWindow>
#include <QScreen>

#include "widgets/common/look.h"

namespace nmc {

void placeBelowTop(QDialog& dialog, QSize wanted) {
    const auto* window = qobject_cast<const QMainWindow*>(dialog.parentWidget());
    if (window == nullptr)
        return;
    const int unit = look::gridUnit(&dialog);
    const QWidget* top = window->menuWidget();
    const QPoint corner = top->mapToGlobal(QPoint(unit * 2, top->height() + unit));
    const QRect room = window->screen()->availableGeometry();
    const int titleBar = unit * 4;  // not known before it is shown
    dialog.resize(wanted.boundedTo({room.right() - corner.x(), room.bottom() - corner.y() - titleBar}));
    dialog.move(corner);
}

}  // namespace nmc
