// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>

class QSocketNotifier;
struct input_event;

namespace nmc {

/// A jog wheel used as a pendant: a ShuttleXpress or ShuttlePRO, whose wheel moves by steps and whose ring
/// moves at a speed, or a 3-axis mouse, whose cap does so when it is pushed to the right or left. One of its
/// buttons stops all: the middle one of the five in an arc, or the right one of a mouse. Each other button
/// enables. The first device that is plugged in is used. Read on the GUI thread, from the kernel's input
/// device, and only while switched on.
class JogWheel : public QObject {
    Q_OBJECT

public:
    /// Where the kernel shows input devices. Tests make their own.
    struct Folders {
        QString devices;  ///< event0...
        QString classes;  ///< event0/device/id/vendor...
    };
    [[nodiscard]] static Folders& folders();

    explicit JogWheel(QObject* parent);
    ~JogWheel() override;

    void setOn(bool on);
    /// Something else has ended the motion: a ring or cap that is out must go back before it moves again.
    void interrupt();
    [[nodiscard]] bool isThere() const { return m_notifier != nullptr; }
    /// There is one, but this user may not read it.
    [[nodiscard]] bool isForbidden() const { return m_forbidden; }

signals:
    /// isThere() or isForbidden() has changed.
    void changed();
    /// The ring or the cap has left its centre while a button enabled, or is elsewhere now: -1 to 1, never 0.
    /// If it was already out when the button was pressed, it must go back first.
    void pushed(double share);
    /// The wheel was turned by that many detents while a button enabled.
    void turned(int detents);
    /// After pushed() or turned(): nothing enables any more, the ring or the cap is back, or the device is
    /// gone or switched off.
    void released();
    void stopPressed();

private:
    enum class Kind { Shuttle, Cap };
    struct Hands {
        int enabling = 0;  ///< number of buttons held that enable
        bool stops = false;
        double share = 0.0;  ///< of the ring or the cap
    };
    [[nodiscard]] static std::optional<Kind> kindOf(const QString& device);
    void find();
    void open(const QString& device, Kind kind);
    void read();
    void take(const input_event& event);
    /// At the end of what the device reports at once.
    void follow();
    void release();
    void lose();

    Kind m_kind = Kind::Shuttle;
    int m_file = -1;
    std::unique_ptr<QSocketNotifier> m_notifier;
    QTimer m_search;
    QTimer m_quiet;  ///< a cap that reports no push any more is back at its centre
    bool m_on = false;
    bool m_forbidden = false;
    Hands m_hands;
    bool m_wasCentred = false;     ///< since a button enables
    bool m_moves = false;          ///< pushed() or turned() was emitted, and released() not yet
    bool m_pushes = false;         ///< the last of them was pushed()
    std::optional<int> m_counter;  ///< of the wheel, 0 to 255; empty until it is first reported
    // In the present report. The kernel leaves out what is 0.
    int m_pushReported = 0, m_counterReported = 0;
    bool m_capReports = false;
};

}  // namespace nmc
