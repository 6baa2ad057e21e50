// SPDX-License-Identifier: MIT
#pragma once

#include <QDBusConnection>
#include <QDBusUnixFileDescriptor>
#include <QObject>
#include <QString>

class QDBusPendingCallWatcher;

namespace nmc {

class BusStore;

/// Delays the computer's sleep until the motors have stopped, by means of a logind lock
/// (org.freedesktop.login1.Manager.Inhibit). The lock is taken while anything moves, and its kind is "delay":
/// closing the lid overrides a "block", and a computer that stays awake in a bag is no use, but nothing
/// overrides a delay before its time is up, usually 5 s, which is enough to stop. Without logind or D-Bus,
/// and on a read-only connection, this class does nothing. GUI thread.
class SleepInhibitor : public QObject {
    Q_OBJECT

public:
    /// `busAddress`: the bus that logind is on; empty: the system bus. It is not contacted before something
    /// moves.
    explicit SleepInhibitor(QString busAddress = {}, QObject* parent = nullptr);
    ~SleepInhibitor() override;

    /// Follows the store, which reports what moves and when a stop has finished.
    void follow(const BusStore& store);

    void setMoving(bool moving);
    /// A stop of all motors has finished: nothing more can be done before the computer sleeps.
    void stopFinished();

signals:
    /// The computer is about to sleep while motors move: stop them.
    void stopWanted();

private slots:
    void prepareForSleep(bool sleeps);

private:
    [[nodiscard]] bool connectToBus();
    void take();
    void taken(QDBusPendingCallWatcher* call);

    QString m_address;
    QDBusConnection m_bus{QString()};
    bool m_connected = false;
    bool m_moving = false;
    bool m_sleeping = false;  ///< the computer sleeps, or is about to
    bool m_asked = false;     ///< the lock has been requested and not yet granted
    QDBusUnixFileDescriptor m_lock;
};

}  // namespace nmc
