// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

class BusWorker;

/// SIGTERM, SIGINT and SIGHUP. In the handler itself the worker is told to stop the motors and to close, so a
/// GUI thread that is blocked delays no stop; then the GUI thread hears of it as a Qt signal. A program that
/// has not ended 3 s later is ended by the kernel. One object a process.
class UnixSignals : public QObject {
    Q_OBJECT

public:
    /// `worker` must outlive the object.
    explicit UnixSignals(BusWorker& worker, QObject* parent = nullptr);
    ~UnixSignals() override;

signals:
    void terminationAsked();
};

}  // namespace nmc
