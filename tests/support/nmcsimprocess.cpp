// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/nmcsimprocess.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QThread>
#include <csignal>

#include <sys/prctl.h>

#include "tests/support/patience.h"

namespace nmc::testing_support {

NmcsimProcess::NmcsimProcess(const QString& chain, const QStringList& options) {
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    // nmcsim ends with a test that crashes: otherwise it would keep the test's output open, and the crash
    // would look like a test that hangs.
    m_process.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });
    m_process.start(QStringLiteral(NMCSIM_PATH), QStringList{QStringLiteral("--chain"), chain} + options);
    const QByteArray ready = readLine();
    if (ready.startsWith("ready "))
        m_terminal = QString::fromLocal8Bit(ready.mid(6));
}

NmcsimProcess::~NmcsimProcess() {
    quit();
}

QJsonObject NmcsimProcess::control(const QString& line) {
    m_process.write(line.toUtf8() + '\n');
    const QByteArray answer = readLine();
    // Otherwise, a motor of a simulator that has ended would seem to stand still.
    if (answer.isEmpty())
        qFatal("nmcsim does not answer: %s", qUtf8Printable(line));
    return QJsonDocument::fromJson(answer).object();
}

std::string NmcsimProcess::violations() {
    const QJsonArray all = control(QStringLiteral("stats"))[QStringLiteral("violations")].toArray();
    return all.isEmpty() ? std::string() : QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

void NmcsimProcess::quit() {
    if (m_process.state() == QProcess::NotRunning)
        return;
    m_process.write("quit\n");
    if (!m_process.waitForFinished(kPatienceMs))
        m_process.kill();
}

void letPass(NmcsimProcess& sim, Duration time) {
    const auto now = [&sim] {
        return sim.control(QStringLiteral("stats"))[QStringLiteral("time")].toDouble();
    };
    for (const double until = now() + toSeconds(time); now() < until;)
        QThread::msleep(1);
}

QByteArray NmcsimProcess::readLine() {
    while (!m_process.canReadLine())
        if (!m_process.waitForReadyRead(kPatienceMs))
            return {};
    return m_process.readLine().trimmed();
}

}  // namespace nmc::testing_support
