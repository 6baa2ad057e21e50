// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

class BusWorker;

/// Handles SIGTERM, SIGINT and SIGHUP. The handler itself makes the worker stop the motors and close, so that
/// a blocked GUI thread does not delay the stop; the GUI thread is then notified by a Qt signal. The kernel
/// ends a program that has not ended 2 s after the longest time that closing takes. One object per process.
class UnixSignals : public QObject {
    Q_OBJECT

public:
    /// `worker` must outlive the object; null: there are no motors to stop.
    explicit UnixSignals(BusWorker* worker);
    ~UnixSignals() override;

signals:
    void terminationAsked();
};

}  // namespace nmc
