// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <optional>

#include "model/intent/intent.h"
#include "model/module/linkstate.h"
#include "model/settings/machine.h"

class QAction;
class QMenu;

namespace nmc {

class ChainDialog;
class CopyDialog;
class LendDialog;
class Requests;

/// The menu for the chain as a whole, and the dialog that it opens: doctor, groups and baud rate.
class ChainMenu : public QObject {
    Q_OBJECT

public:
    /// `machine` and `link` belong to the window, and outlive this object.
    ChainMenu(const Machine& machine, const LinkState& link, Requests& requests, QWidget* window);

    void addTo(QMenu& menu);
    /// Call when the machine or the link has changed. Emits nothing.
    void refresh();
    /// The module that is shown, whose settings are copied unless the user chooses another.
    void showSelected(ModuleIndex module) { m_selected = module; }
    void showPrograms(bool on);
    void openDoctor();

private:
    void open(int page);
    void openLending();
    void openCopy();
    [[nodiscard]] std::optional<Refusal> whyNoCopy() const;

    Requests& m_requests;
    const Machine& m_machine;
    const LinkState& m_link;
    QWidget* m_window;
    ChainDialog* m_dialog = nullptr;     ///< null until it is opened for the first time
    LendDialog* m_lendDialog = nullptr;  ///< null until it is opened for the first time
    QPointer<CopyDialog> m_copyDialog;
    std::optional<ModuleIndex> m_selected;
    QAction* m_doctor;
    QAction* m_groups;
    QAction* m_rate;
    QAction* m_copy;
    QAction* m_scan;
    QAction* m_restart;
    QAction* m_programs;
    QAction* m_lend;
};

}  // namespace nmc
