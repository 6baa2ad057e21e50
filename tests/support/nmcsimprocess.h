// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QProcess>
#include <QStringList>

#include <string>

#include "base/time.h"

namespace nmc::testing_support {

/// Counts per tick; a servo that holds is never quite still.
inline constexpr double kAtRest = 0.01;

/// The real nmcsim in a process of its own, and its control lines.
class NmcsimProcess {
public:
    explicit NmcsimProcess(const QString& chain, const QStringList& options = {});
    ~NmcsimProcess();

    /// The terminal to open; empty when it did not start.
    [[nodiscard]] const QString& terminal() const { return m_terminal; }
    [[nodiscard]] QJsonObject control(const QString& line);
    [[nodiscard]] QJsonObject state(int module) { return control(QStringLiteral("state %1").arg(module)); }
    /// What the host did that the data sheets do not allow, as the simulator says it; empty when nothing.
    [[nodiscard]] std::string violations();
    /// Ends it; a terminal that is open is hung up.
    void quit();

private:
    QByteArray readLine();

    QProcess m_process;
    QString m_terminal;
};

/// By the simulator's own time.
void letPass(NmcsimProcess& sim, Duration time);

}  // namespace nmc::testing_support
