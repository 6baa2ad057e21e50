// SPDX-License-Identifier: MIT
#include "link/connection/sleepinhibitor.h"

#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>

#include "link/connection/busstore.h"
#include "link/connection/linklog.h"

namespace nmc {

namespace {

const QString kService = QStringLiteral("org.freedesktop.login1");
const QString kPath = QStringLiteral("/org/freedesktop/login1");
const QString kManager = QStringLiteral("org.freedesktop.login1.Manager");

}  // namespace

SleepInhibitor::SleepInhibitor(QString busAddress, QObject* parent)
    : QObject(parent), m_address(std::move(busAddress)) {}

SleepInhibitor::~SleepInhibitor() {
    if (m_connected && !m_address.isEmpty())
        QDBusConnection::disconnectFromBus(m_bus.name());
}

void SleepInhibitor::follow(const BusStore& store) {
    // On a read-only connection, the motors are not ours to stop.
    connect(&store, &BusStore::linkChanged, this,
            [this, &store] { setMoving(!store.link().readOnly && store.movingMotors() > 0); });
    connect(&store, &BusStore::happened, this, [this](const StoreEvent& event) {
        if (std::holds_alternative<bus::StopFinished>(event))
            stopFinished();
    });
}

void SleepInhibitor::setMoving(bool moving) {
    if (moving == m_moving)
        return;
    m_moving = moving;
    if (moving)
        take();
    else if (!m_sleeping)  // otherwise a stop is in progress, which releases the lock when it has finished
        m_lock = {};
}

void SleepInhibitor::stopFinished() {
    if (m_sleeping)
        m_lock = {};
}

bool SleepInhibitor::connectToBus() {
    if (m_connected)
        return true;
    m_bus = m_address.isEmpty() ? QDBusConnection::systemBus()
                                : QDBusConnection::connectToBus(m_address, QStringLiteral("nmc-sleep"));
    m_connected = m_bus.isConnected();
    if (m_connected)
        m_bus.connect(kService, kPath, kManager, QStringLiteral("PrepareForSleep"), this,
                      SLOT(prepareForSleep(bool)));
    else
        qCDebug(linkLog).noquote() << "no D-Bus:" << m_bus.lastError().message();
    return m_connected;
}

void SleepInhibitor::take() {
    if (m_sleeping || m_asked || m_lock.isValid() || !connectToBus())
        return;
    QDBusMessage inhibit =
        QDBusMessage::createMethodCall(kService, kPath, kManager, QStringLiteral("Inhibit"));
    inhibit << QStringLiteral("sleep") << QStringLiteral("NMC Panel") << QStringLiteral("Motors are moving.")
            << QStringLiteral("delay");
    m_asked = true;
    auto* call = new QDBusPendingCallWatcher(m_bus.asyncCall(inhibit), this);
    connect(call, &QDBusPendingCallWatcher::finished, this, &SleepInhibitor::taken);
}

void SleepInhibitor::taken(QDBusPendingCallWatcher* call) {
    call->deleteLater();
    m_asked = false;
    const QDBusPendingReply<QDBusUnixFileDescriptor> reply = *call;
    if (reply.isError())
        qCDebug(linkLog).noquote() << "sleep is not delayed:" << reply.error().message();
    else if (m_moving)
        m_lock = reply.value();
}

void SleepInhibitor::prepareForSleep(bool sleeps) {
    m_sleeping = sleeps;
    if (sleeps && m_moving)
        emit stopWanted();
    else if (m_moving)
        take();
    else
        m_lock = {};
}

}  // namespace nmc
