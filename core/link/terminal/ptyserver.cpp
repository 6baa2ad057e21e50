// SPDX-License-Identifier: MIT
#include "link/terminal/ptyserver.h"

#include <asm/termbits.h>  // struct termios2; <termios.h> would clash with it
#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace nmc {

namespace {

std::string systemError(const std::string& what) {
    return what + ": " + std::strerror(errno);
}

/// No echo, no line editing, no translation; reads return at once. A host that never sets a rate is
/// understood at the one given, while any rate that it does set is its own choice. EXTPROC only makes packet
/// mode report settings.
bool makeRaw(int fd, std::uint32_t baud) {
    termios2 settings{};
    if (::ioctl(fd, TCGETS2, &settings) != 0)
        return false;
    settings.c_iflag = IGNBRK;
    settings.c_oflag = 0;
    settings.c_lflag = EXTPROC;
    settings.c_cflag &= ~static_cast<tcflag_t>(CBAUD | CBAUD << IBSHIFT);
    settings.c_cflag |= baud == kPowerUpBaud ? B19200 : BOTHER;
    settings.c_ispeed = settings.c_ospeed = baud;
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    return ::ioctl(fd, TCSETS2, &settings) == 0;
}

/// True when inotify has reported anything since the last call.
bool tookEvents(const Descriptor& inotify) {
    bool any = false;
    for (std::array<char, 4096> events{}; ::read(inotify.get(), events.data(), events.size()) > 0;)
        any = true;
    return any;
}

}  // namespace

tl::expected<PtyServer, std::string> PtyServer::create(const std::string& link, std::uint32_t baud) {
    PtyServer server;
    server.m_master = Descriptor(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    const int master = server.fd();
    std::array<char, 128> name{};
    if (!server.m_master.valid() || ::grantpt(master) != 0 || ::unlockpt(master) != 0 ||
        ::ptsname_r(master, name.data(), name.size()) != 0)
        return tl::unexpected(systemError("no pseudo-terminal can be made"));
    server.m_path = name.data();
    server.m_slave = Descriptor(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    if (!server.m_slave.valid() || !makeRaw(server.m_slave.get(), baud) ||
        ::fchmod(server.m_slave.get(), S_IRUSR | S_IWUSR) != 0)
        return tl::unexpected(systemError("the pseudo-terminal " + server.m_path + " cannot be set up"));
    const int on = 1;
    if (::ioctl(master, TIOCPKT, &on) != 0)
        return tl::unexpected(systemError("the pseudo-terminal " + server.m_path + " has no packet mode"));
    server.watchHost();
    if (!link.empty()) {
        // A link left by an earlier run may be replaced; anything else may be a file of the user.
        struct stat info {};
        if (::lstat(link.c_str(), &info) == 0 && S_ISLNK(info.st_mode))
            ::unlink(link.c_str());
        if (::symlink(server.m_path.c_str(), link.c_str()) != 0)
            return tl::unexpected(systemError("the link " + link + " cannot be made"));
        server.m_link = link;
    }
    return server;
}

PtyServer::~PtyServer() {
    if (!m_master.valid() || m_link.empty())  // it has been moved from, or has no link
        return;
    std::array<char, 128> target{};
    const auto length = ::readlink(m_link.c_str(), target.data(), target.size());
    if (length > 0 && std::string(target.data(), static_cast<std::size_t>(length)) == m_path)
        ::unlink(m_link.c_str());
}

void PtyServer::watchHost() {
    m_writes = Descriptor(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    m_leaves = Descriptor(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
    m_order = Descriptor(::epoll_create1(EPOLL_CLOEXEC));
    ::inotify_add_watch(m_leaves.get(), m_path.c_str(), IN_CLOSE_WRITE);
    const auto watch = [this](int fd, unsigned events, FirstAct act) {
        epoll_event event{};
        event.events = events | unsigned{EPOLLET};
        event.data.u32 = static_cast<std::uint32_t>(act);
        return ::epoll_ctl(m_order.get(), EPOLL_CTL_ADD, fd, &event) == 0;
    };
    if (::inotify_add_watch(m_writes.get(), m_path.c_str(), IN_MODIFY) < 0 ||
        !watch(m_writes.get(), EPOLLIN, FirstAct::Wrote) || !watch(fd(), EPOLLPRI, FirstAct::SetTerminal))
        m_order.reset();
}

FirstAct PtyServer::takeFirstAct() const {
    if (!m_order.valid())
        return FirstAct::Unknown;
    std::array<epoll_event, 2> acts{};
    const int count = ::epoll_wait(m_order.get(), acts.data(), static_cast<int>(acts.size()), 0);
    // A write is reported only while no earlier write is waiting to be read.
    tookEvents(m_writes);
    return count > 0 ? static_cast<FirstAct>(acts[0].data.u32) : FirstAct::Unknown;
}

HostActs PtyServer::takeActs() {
    HostActs acts;
    acts.first = takeFirstAct();
    Packets packets = readAll();
    acts.bytes = std::move(packets.bytes);
    termios2 settings{};
    if (::ioctl(fd(), TCGETS2, &settings) == 0 && settings.c_ospeed != 0)
        acts.baud = settings.c_ospeed;
    // A host that builds its settings from scratch has removed EXTPROC, which is reported only that once. And
    // a flush that came first says nothing about a rate that came as well.
    const unsigned news = packets.news & ~std::exchange(m_ownNews, 0U);
    const bool flushed = acts.first == FirstAct::SetTerminal && news != TIOCPKT_IOCTL;
    if (!std::exchange(m_tellsSettings, (settings.c_lflag & EXTPROC) != 0) || flushed)
        acts.first = FirstAct::Unknown;
    acts.hungUp = tookEvents(m_leaves);
    if (acts.hungUp && ::ioctl(m_slave.get(), TCFLSH, TCIFLUSH) == 0) {
        m_ownNews = TIOCPKT_FLUSHREAD;
        static_cast<void>(takeFirstAct());
    }
    return acts;
}

/// Each read(2) returns either bytes preceded by a 0, or one byte of packet-mode news; before it returns
/// nothing, it delivers what the kernel still has in transit.
PtyServer::Packets PtyServer::readAll() const {
    constexpr std::size_t kEnough = 65'536;
    Packets all;
    std::array<std::uint8_t, 4096> buffer{};
    while (all.bytes.size() < kEnough) {
        const auto got = ::read(fd(), buffer.data(), buffer.size());
        if (got <= 0)
            break;
        all.news |= buffer[0];
        all.bytes.insert(all.bytes.end(), buffer.begin() + 1, buffer.begin() + got);
    }
    return all;
}

void PtyServer::write(ByteSpan bytes) const {
    [[maybe_unused]] const auto written = ::write(fd(), bytes.data(), bytes.size());
}

}  // namespace nmc
