// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QProcess>
#include <QStringList>

#include <string>

#include "base/time.h"

namespace nmc::testing_support {

/// In counts per tick; a servo that holds is never quite still.
inline constexpr double kAtRest = 0.01;

/// The real nmcsim in its own process, with its control lines.
class NmcsimProcess {
public:
    explicit NmcsimProcess(const QString& chain, const QStringList& options = {});
    ~NmcsimProcess();

    /// The terminal to open; empty if it did not start.
    [[nodiscard]] const QString& terminal() const { return m_terminal; }
    [[nodiscard]] QJsonObject control(const QString& line);
    [[nodiscard]] QJsonObject state(int module) { return control(QStringLiteral("state %1").arg(module)); }
    /// What the host did that the data sheets do not allow, as reported by the simulator; empty if nothing.
    [[nodiscard]] std::string violations();
    /// Ends the process, which hangs up an open terminal.
    void quit();

private:
    QByteArray readLine();

    QProcess m_process;
    QString m_terminal;
};

/// Waits until this much of the simulator's own time has passed.
void letPass(NmcsimProcess& sim, Duration time);

}  // namespace nmc::testing_support
