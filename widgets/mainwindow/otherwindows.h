// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QObject>
#include <QPointer>

class QWidget;

namespace nmc {

/// The program's windows other than the main one, including Qt's own. None of them blocks the main window,
/// because STOP ALL would then be out of reach. A window that is to be modal, such as the file dialog's
/// "Replace it?", blocks only the window to which it belongs, unless that is the main one.
class OtherWindows : public QObject {
    Q_OBJECT

public:
    explicit OtherWindows(QWidget* mainWindow);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// Another window, or a popup, is about to be shown.
    void opened();

private:
    void unblock(QWidget& window);

    QWidget* m_mainWindow;
    QHash<QObject*, QPointer<QWidget>> m_blocked;  ///< by the window that blocks it
};

}  // namespace nmc
