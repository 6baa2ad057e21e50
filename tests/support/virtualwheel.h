// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <utility>
#include <vector>

#include "widgets/gamepad/jogwheel.h"

namespace nmc::testing_support {

/// An input device without hardware, plugged in while this object exists: a pipe in the place of the kernel's
/// device. Like the kernel, it leaves out relative values that are 0.
class VirtualInput {
public:
    struct Event {
        int type, code, value;
    };

    explicit VirtualInput(const QByteArray& vendor, const QByteArray& product)
        : m_before(JogWheel::folders()) {
        const QDir folder(m_folder.path());
        folder.mkpath(QStringLiteral("sys/event3/device/id"));
        folder.mkpath(QStringLiteral("dev"));
        chmod(QFile::encodeName(m_folder.path()).constData(), 0755);  // for tests as another user
        write(QStringLiteral("vendor"), vendor);
        write(QStringLiteral("product"), product);
        mkfifo(path().constData(), 0600);
        m_pipe = ::open(path().constData(), O_RDWR | O_CLOEXEC);
        JogWheel::folders() = {m_folder.filePath(QStringLiteral("dev")),
                               m_folder.filePath(QStringLiteral("sys"))};
    }
    ~VirtualInput() {
        unplug();
        JogWheel::folders() = m_before;
    }
    VirtualInput(const VirtualInput&) = delete;
    VirtualInput& operator=(const VirtualInput&) = delete;

    [[nodiscard]] QByteArray path() const {
        return QFile::encodeName(m_folder.filePath(QStringLiteral("dev/event3")));
    }
    /// What the device reports at once; it has been taken when this returns.
    void report(const std::vector<Event>& events, int end = SYN_REPORT) {
        std::vector<input_event> written;
        const auto add = [&](const Event& event) {
            input_event one{};
            one.type = static_cast<__u16>(event.type);
            one.code = static_cast<__u16>(event.code);
            one.value = event.value;
            written.push_back(one);
        };
        for (const Event& event : events)
            if (event.type != EV_REL || event.value != 0)
                add(event);
        if (written.empty() && end == SYN_REPORT)
            return;
        add({EV_SYN, end, 0});
        const auto bytes = written.size() * sizeof(input_event);
        if (::write(m_pipe, written.data(), bytes) != static_cast<ssize_t>(bytes))
            qFatal("the pipe takes no report");
        QCoreApplication::processEvents();
    }
    void unplug() {
        QDir(m_folder.filePath(QStringLiteral("sys"))).removeRecursively();
        if (m_pipe >= 0)
            ::close(std::exchange(m_pipe, -1));
        QCoreApplication::processEvents();
    }

private:
    void write(const QString& name, const QByteArray& text) {
        QFile file(m_folder.filePath(QStringLiteral("sys/event3/device/id/") + name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text + '\n') < 0)
            qFatal("no identity");
    }

    QTemporaryDir m_folder;
    JogWheel::Folders m_before;
    int m_pipe = -1;
};

/// A ShuttleXpress. Each report has its ring and the counter of its wheel.
class VirtualWheel : public VirtualInput {
public:
    static constexpr int kButton = BTN_4, kMiddleButton = BTN_6;

    explicit VirtualWheel(int counter = 10) : VirtualInput("0b33", "0020"), m_counter(counter) {}

    void press(int button = kButton) { change({{EV_KEY, button, 1}}); }
    void release(int button = kButton) { change({{EV_KEY, button, 0}}); }
    /// -7 to 7; 0 is the centre.
    void push(int ring) {
        m_ring = ring;
        change({});
    }
    void turn(int detents) {
        for (const int way = detents < 0 ? -1 : 1; detents != 0; detents -= way) {
            m_counter = (m_counter + way) & 0xff;
            change({});
        }
    }

private:
    void change(std::vector<Event> events) {
        events.push_back({EV_REL, REL_DIAL, m_counter});
        events.push_back({EV_REL, REL_WHEEL, m_ring});
        report(events);
    }

    int m_ring = 0;
    int m_counter;
};

}  // namespace nmc::testing_support
