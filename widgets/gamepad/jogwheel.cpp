// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gamepad/jogwheel.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QSocketNotifier>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kSearchInterval = 1'000;  // ms
constexpr int kQuiet = 150;             // ms; a cap that is pushed reports at least every 20 ms
constexpr double kRingEnd = 7;
constexpr double kCapEnd = 350;
constexpr int kCapSlack = 35;  ///< so that a trembling hand does not start the motor
constexpr int kShuttleStop = BTN_0 + 6;
constexpr int kCapStop = BTN_1;

[[nodiscard]] double shareOf(int push, double end, int slack) {
    return std::abs(push) > slack ? std::clamp(push / end, -1.0, 1.0) : 0.0;
}

}  // namespace

JogWheel::Folders& JogWheel::folders() {
    static Folders folders{u"/dev/input"_s, u"/sys/class/input"_s};
    return folders;
}

JogWheel::JogWheel(QObject* parent) : QObject(parent) {
    m_search.setInterval(kSearchInterval);
    connect(&m_search, &QTimer::timeout, this, &JogWheel::find);
    m_quiet.setInterval(kQuiet);
    m_quiet.setSingleShot(true);
    connect(&m_quiet, &QTimer::timeout, this, [this] {
        m_hands.share = 0;
        follow();
    });
}

JogWheel::~JogWheel() {
    setOn(false);
}

void JogWheel::setOn(bool on) {
    if (on == m_on)
        return;
    m_on = on;
    if (on)
        return find();
    m_search.stop();
    lose();
    m_forbidden = false;
}

std::optional<JogWheel::Kind> JogWheel::kindOf(const QString& device) {
    const auto number = [&](const QString& name) {
        QFile file(u"%1/%2/device/id/%3"_s.arg(folders().classes, device, name));
        return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().toInt(nullptr, 16) : 0;
    };
    constexpr int kContour = 0x0b33, kLogitech = 0x046d, k3dConnexion = 0x256f;
    constexpr std::array kShuttles{0x0010, 0x0020, 0x0030};  // PRO, Xpress, PRO v2; Contour makes mice, too
    const int vendor = number(u"vendor"_s);
    const int product = number(u"product"_s);
    if (vendor == kContour && std::ranges::find(kShuttles, product) != kShuttles.end())
        return Kind::Shuttle;
    if (vendor == k3dConnexion || (vendor == kLogitech && product >= 0xc621 && product <= 0xc62b))
        return Kind::Cap;
    return std::nullopt;
}

void JogWheel::find() {
    const bool wasForbidden = std::exchange(m_forbidden, false);
    for (const QString& device : QDir(folders().classes).entryList({u"event*"_s}, QDir::Dirs | QDir::System))
        if (const auto kind = kindOf(device); kind && !isThere())
            open(device, *kind);
    if (isThere())
        m_search.stop();
    else
        m_search.start();
    if (isThere() || m_forbidden != wasForbidden)
        emit changed();
}

void JogWheel::open(const QString& device, Kind kind) {
    const QByteArray path = QFile::encodeName(folders().devices + u'/' + device);
    m_file = ::open(path.constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    m_forbidden = m_file < 0 && errno == EACCES;
    if (m_file < 0)
        return;
    // While it moves motors, it neither scrolls nor clicks elsewhere.
    ::ioctl(m_file, EVIOCGRAB, 1);
    m_kind = kind;
    m_hands = {};
    m_counter.reset();
    m_notifier = std::make_unique<QSocketNotifier>(m_file, QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &JogWheel::read);
}

void JogWheel::read() {
    std::array<input_event, 64> events{};
    const ssize_t bytes = ::read(m_file, events.data(), sizeof(events));
    if (bytes < 0 && (errno == EAGAIN || errno == EINTR))
        return;
    if (bytes <= 0) {
        lose();
        m_search.start();
        emit changed();
        return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(bytes) / sizeof(input_event) && isThere(); ++i)
        take(events.at(i));
}

void JogWheel::take(const input_event& event) {
    if (event.type == EV_KEY && event.value != 2) {  // 2: auto-repeat
        const bool pressed = event.value != 0;
        if (event.code != (m_kind == Kind::Shuttle ? kShuttleStop : kCapStop))
            m_hands.enabling = std::max(0, m_hands.enabling + (pressed ? 1 : -1));
        else if (m_hands.stops = pressed; pressed)
            emit stopPressed();
    } else if (m_kind == Kind::Shuttle && event.type == EV_REL && event.code == REL_DIAL) {
        m_counterReported = event.value;
    } else if (m_kind == Kind::Shuttle && event.type == EV_REL && event.code == REL_WHEEL) {
        m_pushReported = event.value;
    } else if (m_kind == Kind::Cap && event.type == EV_REL && event.code <= REL_Z) {
        m_capReports = true;
        m_pushReported = event.code == REL_X ? event.value : m_pushReported;
    } else if (m_kind == Kind::Cap && event.type == EV_ABS && event.code == ABS_X) {
        m_hands.share = shareOf(event.value, kCapEnd, kCapSlack);
    } else if (event.type == EV_SYN && event.code == SYN_DROPPED) {
        // Unknown what is held now.
        m_hands = {};
        m_counter.reset();
        release();
    } else if (event.type == EV_SYN && event.code == SYN_REPORT) {
        follow();
    }
}

void JogWheel::follow() {
    int detents = 0;
    const int push = std::exchange(m_pushReported, 0);
    if (m_kind == Kind::Shuttle) {
        m_hands.share = shareOf(push, kRingEnd, 0);
        const int counter = std::exchange(m_counterReported, 0);
        detents = m_counter ? static_cast<std::int8_t>(counter - *m_counter) : 0;
        m_counter = counter;
    } else if (std::exchange(m_capReports, false)) {
        m_hands.share = shareOf(push, kCapEnd, kCapSlack);
        m_quiet.start();
    }
    const bool enables = m_hands.enabling > 0 && !m_hands.stops;
    m_wasCentred = enables && (m_wasCentred || m_hands.share == 0);
    if (!enables || (m_pushes && m_hands.share == 0))
        release();
    if (!m_wasCentred)
        return;
    if (m_hands.share != 0) {
        m_moves = m_pushes = true;
        emit pushed(m_hands.share);
    } else if (detents != 0) {
        m_moves = true;
        emit turned(detents);
    }
}

void JogWheel::interrupt() {
    m_wasCentred = m_wasCentred && m_hands.share == 0;
    m_moves = m_pushes = false;
}

void JogWheel::release() {
    m_pushes = false;
    if (std::exchange(m_moves, false))
        emit released();
}

void JogWheel::lose() {
    m_quiet.stop();
    m_notifier.reset();
    if (m_file >= 0)
        ::close(std::exchange(m_file, -1));
    m_hands = {};
    release();
}

}  // namespace nmc
