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

/// The menu of the chain as a whole, and the window it opens: doctor, groups, rate. Everything is asked for
/// by signals.
class ChainMenu : public QObject {
    Q_OBJECT

public:
    /// `machine` and `link` are the window's own, and outlive this.
    ChainMenu(const Machine& machine, const LinkState& link, QWidget* window);

    void addTo(QMenu& menu);
    /// They have changed. Emits nothing.
    void refresh();
    void openDoctor();

signals:
    /// Looks for the chain again; nothing is reset.
    void scanRequested();
    /// To be asked about first.
    void restartRequested();
    /// What is there now is what is expected from now on.
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
    ChainDialog* m_dialog = nullptr;  ///< from its first opening on
    QAction* m_doctor;
    QAction* m_groups;
    QAction* m_rate;
    QAction* m_scan;
    QAction* m_restart;
};

}  // namespace nmc
