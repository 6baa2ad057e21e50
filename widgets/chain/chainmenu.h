// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "bus/types.h"
#include "model/module/linkstate.h"
#include "model/settings/machine.h"

class QAction;
class QMenu;

namespace nmc {

class ChainDialog;

/// The menu for the chain as a whole, and the dialog that it opens: doctor, groups and baud rate. All
/// requests are signals.
class ChainMenu : public QObject {
    Q_OBJECT

public:
    /// `machine` and `link` belong to the window, and outlive this object.
    ChainMenu(const Machine& machine, const LinkState& link, QWidget* window);

    void addTo(QMenu& menu);
    /// Call when the machine or the link has changed. Emits nothing.
    void refresh();
    void openDoctor();

signals:
    /// Requests another search for the chain; nothing is reset.
    void scanRequested();
    /// The receiver asks the user first.
    void restartRequested();
    /// Requests that the modules found now be expected from now on.
    void acceptRequested();
    void addressRequested(nmc::ModuleIndex module, nmc::BusAddress address);
    void groupChangeRequested(const nmc::bus::GroupChange& change);
    void groupCommandRequested(const nmc::bus::GroupCommand& command);
    void groupNamed(quint8 group, const QString& name);
    void rateRequested(quint32 baud);

private:
    QAction* newAction(const QString& objectName, const QString& text, const QKeySequence& shortcut,
                       const QString& tip);
    void open(int page);

    const Machine& m_machine;
    const LinkState& m_link;
    QWidget* m_window;
    ChainDialog* m_dialog = nullptr;  ///< null until it is opened for the first time
    QAction* m_doctor;
    QAction* m_groups;
    QAction* m_rate;
    QAction* m_scan;
    QAction* m_restart;
};

}  // namespace nmc
