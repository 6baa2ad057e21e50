// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QObject>
#include <QPointer>

class QWidget;

namespace nmc {

/// The program's windows beside the main one, Qt's own included: none of them blocks it, or STOP ALL would be
/// out of reach. One that wants to be modal, such as the file dialog's "Replace it?", blocks only the window
/// that it belongs to, unless that is the main one.
class OtherWindows : public QObject {
    Q_OBJECT

public:
    explicit OtherWindows(QWidget* mainWindow);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// One is about to be seen; a popup is one, too.
    void opened();

private:
    void unblock(QWidget& window);

    QWidget* m_mainWindow;
    QHash<QObject*, QPointer<QWidget>> m_blocked;  ///< by the window that it waits for
};

}  // namespace nmc
