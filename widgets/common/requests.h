// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "bus/types.h"
#include "model/intent/intent.h"
#include "model/settings/machine.h"
#include "widgets/common/filedialog.h"

namespace nmc {

/// What the user requests of the program, wherever in the window: pages and dialogs emit it here, and nothing
/// between them and the program passes it on. One for each window. GUI thread.
class Requests : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

signals:
    // ---- of a module ----

    void intent(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// On press and every 100 ms while held; each press has a number of its own.
    void hold(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    /// The user has changed the settings of an axis; this sends nothing.
    void axisEdited(nmc::ModuleIndex module, const nmc::AxisSettings& settings);

    // ---- of the chain ----

    /// Another search for the chain; nothing is reset.
    void scan();
    /// The window asks the user first.
    void restart();
    /// The modules found now are expected from now on.
    void acceptChain();
    void address(nmc::ModuleIndex module, nmc::BusAddress address);
    void groupChange(const nmc::bus::GroupChange& change);
    void groupCommand(const nmc::bus::GroupCommand& command);
    /// The user has named the group; nothing is sent.
    void groupNamed(quint8 group, const QString& name);
    void rate(quint32 baud);

    // ---- of the program ----

    /// A file is to be saved: packets, messages, step responses, what the scope shows, and the like. The user
    /// has agreed to replace the file if it exists.
    void save(const QString& path, const nmc::FileContent& content);
    /// One page; the receiver asks for a printer.
    void print(const QByteArray& pdf);
};

}  // namespace nmc
