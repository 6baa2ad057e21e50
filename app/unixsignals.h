// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// SIGTERM, SIGINT and SIGHUP as a Qt signal in the GUI thread. One object a process.
class UnixSignals : public QObject {
    Q_OBJECT

public:
    explicit UnixSignals(QObject* parent = nullptr);
    ~UnixSignals() override;

signals:
    void terminationAsked();
};

}  // namespace nmc
