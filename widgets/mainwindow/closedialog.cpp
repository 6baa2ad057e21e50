// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/closedialog.h"

#include <QPushButton>

#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

CloseDialog::CloseDialog(int movingMotors, const QString& stopText, QWidget* parent)
    : AskDialog({u"closeDialog"_s, tr("Motors are moving"), texts::closing(movingMotors), stopText,
                 u"stopAndCloseButton"_s, tr("St&ay"), u"stayButton"_s},
                parent) {
    findChild<QPushButton*>(u"stopAndCloseButton"_s)->setDefault(true);
}

RestartDialog::RestartDialog(int movingMotors, QWidget* parent)
    : AskDialog({u"restartDialog"_s, tr("Restart the network"), texts::beforeRestart(movingMotors),
                 tr("&Restart the network: positions and gains are lost"), u"restartButton"_s, tr("&Cancel"),
                 u"cancelRestartButton"_s},
                parent) {
    findChild<QPushButton*>(u"cancelRestartButton"_s)->setDefault(true);
}

}  // namespace nmc
