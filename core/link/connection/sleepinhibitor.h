// SPDX-License-Identifier: MIT
#pragma once

#include <QDBusConnection>
#include <QDBusUnixFileDescriptor>
#include <QObject>
#include <QString>

class QDBusPendingCallWatcher;

namespace nmc {

class BusStore;

/// Has the computer wait with its sleep until the motors stand, by a lock of logind
/// (org.freedesktop.login1.Manager.Inhibit). It is taken while anything moves, and it is of the kind "delay":
/// a lid that is shut goes past a "block", and a computer that stays awake in a bag helps nobody, but nothing
/// goes past the delay before its time is up, 5 s usually, and that is enough to stop. Without logind or
/// D-Bus, and on a read-only connection, all of this does nothing. GUI thread.
class SleepInhibitor : public QObject {
    Q_OBJECT

public:
    /// `busAddress`: of the bus that logind is on; empty: the system's. Nothing is asked of it before
    /// something moves.
    explicit SleepInhibitor(QString busAddress = {}, QObject* parent = nullptr);
    ~SleepInhibitor() override;

    /// Is told by it what moves, and that a stop has run its course.
    void follow(const BusStore& store);

    void setMoving(bool moving);
    /// A stop of all motors has run its course: no more can be done before the computer sleeps.
    void stopFinished();

signals:
    /// The computer is about to sleep, and motors move: stop them.
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
    bool m_sleeping = false;  ///< the computer is, or is about to
    bool m_asked = false;     ///< for the lock, and not answered yet
    QDBusUnixFileDescriptor m_lock;
};

}  // namespace nmc
