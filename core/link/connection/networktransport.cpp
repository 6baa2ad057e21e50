// SPDX-License-Identifier: MIT
#include "link/connection/networktransport.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "link/clock.h"
#include "link/ports/linerate.h"

namespace nmc {

namespace {

/// The bus thread cannot be ended while it waits for these.
constexpr Duration kConnectTimeout = std::chrono::seconds(3);
constexpr Duration kAnswerTimeout = std::chrono::seconds(2);
constexpr Duration kSendTimeout = std::chrono::seconds(1);
/// What an adapter at the far end takes, unless its latency timer was set, which cannot be seen from here.
constexpr Duration kFarAdapter = std::chrono::milliseconds(16);
/// After this time without an acknowledgement, the peer is gone.
constexpr int kUserTimeoutMs = 4'000;
constexpr int kKeepIdle = 2, kKeepInterval = 1, kKeepCount = 3;  // s, s, probes

void set(int fd, int level, int option, int value) {
    (void)::setsockopt(fd, level, option, &value, sizeof value);
}

void prepare(int fd) {
    set(fd, IPPROTO_TCP, TCP_NODELAY, 1);
    set(fd, IPPROTO_TCP, TCP_USER_TIMEOUT, kUserTimeoutMs);
    set(fd, SOL_SOCKET, SO_KEEPALIVE, 1);
    set(fd, IPPROTO_TCP, TCP_KEEPIDLE, kKeepIdle);
    set(fd, IPPROTO_TCP, TCP_KEEPINTVL, kKeepInterval);
    set(fd, IPPROTO_TCP, TCP_KEEPCNT, kKeepCount);
}

bool isReady(int fd, short events, TimePoint until) {
    std::array<pollfd, 1> fds{{{fd, events, 0}}};
    return pollUntil(fds, until) > 0;
}

/// 0, or the error with which connecting failed.
int connectTo(int fd, const addrinfo& address) {
    if (::connect(fd, address.ai_addr, address.ai_addrlen) == 0)
        return 0;
    if (errno != EINPROGRESS)
        return errno;
    if (!isReady(fd, POLLOUT, monotonicNow() + kConnectTimeout))
        return ETIMEDOUT;
    int error = 0;
    socklen_t size = sizeof error;
    (void)::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size);
    return error;
}

}  // namespace

NetworkTransport::NetworkTransport(NetworkLine line, std::string name, std::uint32_t baud)
    : m_line(std::move(line)), m_name(std::move(name)), m_baud(baud) {}

tl::expected<void, PortError> NetworkTransport::open() {
    if (m_line.host.empty())
        return tl::unexpected(problem(PortProblem::NotANetworkLine));
    if (auto done = connectTo(); !done || m_line.protocol == NetworkLine::Protocol::Raw)
        return done;
    m_telnet.emplace();
    const TimePoint asked = monotonicNow();
    const auto agreed = ask([this] { return m_telnet->agreed().has_value(); });
    if (!agreed)
        return tl::unexpected(agreed.error());
    if (!m_telnet->agreed().value_or(false))
        return tl::unexpected(problem(PortProblem::NotRfc2217));
    m_latency = std::max(m_latency, 2 * (monotonicNow() - asked) + kFarAdapter);
    return setBaud(m_baud).and_then([this] { return setBaud(kPowerUpBaud); });
}

tl::expected<void, PortError> NetworkTransport::connectTo() {
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (const int error =
            ::getaddrinfo(m_line.host.c_str(), std::to_string(m_line.port).c_str(), &wanted, &found);
        error != 0) {
        PortError failed = problem(PortProblem::HostNotFound);
        failed.detail = ::gai_strerror(error);
        return tl::unexpected(failed);
    }
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> all(found, &::freeaddrinfo);
    int error = 0;
    for (const addrinfo* address = found; address != nullptr; address = address->ai_next) {
        m_socket = Descriptor(::socket(address->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
        const TimePoint begun = monotonicNow();
        error = m_socket.valid() ? nmc::connectTo(m_socket.get(), *address) : errno;
        if (error != 0)
            continue;
        // One handshake is one round trip; the next may take longer.
        m_latency = 2 * (monotonicNow() - begun) + kFarAdapter;
        prepare(m_socket.get());
        return {};
    }
    return tl::unexpected(problem(PortProblem::NotReached, error));
}

tl::expected<void, PortError> NetworkTransport::setBaud(std::uint32_t baud) {
    m_mute = !m_telnet && baud != kPowerUpBaud;
    if (!m_telnet)
        return {};
    m_telnet->setBaud(baud);
    const auto answered = ask([this] { return m_telnet->baud().has_value(); });
    if (!answered)
        return tl::unexpected(answered.error());
    if (m_telnet->baud() && rateIsGoodEnough(baud, *m_telnet->baud()))
        return {};
    PortError failed = problem(PortProblem::RateNotPossible);
    failed.detail = std::to_string(baud) + " Bd -> " + std::to_string(m_telnet->baud().value_or(0)) + " Bd";
    return tl::unexpected(failed);
}

template <typename Condition>
tl::expected<void, PortError> NetworkTransport::ask(const Condition& answered) {
    if (const auto asked = write(m_telnet->takeOutput()); !asked)
        return asked;
    const TimePoint until = monotonicNow() + kAnswerTimeout;
    while (!answered() && isReady(m_socket.get(), POLLIN, until)) {
        const auto bytes = read();
        if (!bytes)
            return tl::unexpected(bytes.error());
        m_early.insert(m_early.end(), bytes->begin(), bytes->end());
    }
    return {};
}

std::vector<std::uint8_t> NetworkTransport::onWire(ByteSpan bytes, std::uint32_t baud) const {
    if (!m_telnet || bytes.empty())
        return Transport::onWire(bytes, baud);
    std::vector<std::uint8_t> all = Rfc2217::settingBaud(baud);
    const std::vector<std::uint8_t> data = Rfc2217::encoded(bytes);
    all.insert(all.end(), data.begin(), data.end());
    return all;
}

tl::expected<void, PortError> NetworkTransport::send(ByteSpan bytes) {
    if (m_mute)
        return {};
    return m_telnet ? write(Rfc2217::encoded(bytes)) : write(bytes);
}

tl::expected<void, PortError> NetworkTransport::write(ByteSpan bytes) {
    while (!bytes.empty()) {
        const auto count = ::send(m_socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count >= 0)
            bytes = bytes.subspan(static_cast<std::size_t>(count));
        else if (errno != EINTR &&
                 (errno != EAGAIN || !isReady(m_socket.get(), POLLOUT, monotonicNow() + kSendTimeout)))
            return tl::unexpected(problem(PortProblem::Gone, errno));
    }
    return {};
}

void NetworkTransport::discardInput() {
    m_early.clear();
    while (true)
        if (const auto bytes = read(); !bytes || bytes->empty())
            break;
    if (!m_telnet)
        return;
    m_telnet->purgeInput();
    (void)write(m_telnet->takeOutput());
}

Transport::Received NetworkTransport::read() {
    std::vector<std::uint8_t> bytes(4'096);
    const auto count = ::recv(m_socket.get(), bytes.data(), bytes.size(), 0);
    if (count < 0 && (errno == EAGAIN || errno == EINTR))
        return std::vector<std::uint8_t>{};
    if (count <= 0)
        return tl::unexpected(problem(PortProblem::Gone, count < 0 ? errno : 0));
    // A server without TCP_NODELAY keeps the rest of a reply until its beginning is acknowledged, which the
    // kernel would put off by 40 ms.
    set(m_socket.get(), IPPROTO_TCP, TCP_QUICKACK, 1);
    bytes.resize(m_mute ? 0 : static_cast<std::size_t>(count));
    if (!m_telnet)
        return bytes;
    bytes = m_telnet->take(bytes);
    if (const auto answered = write(m_telnet->takeOutput()); !answered)
        return tl::unexpected(answered.error());
    return bytes;
}

Transport::Received NetworkTransport::receive(std::optional<TimePoint> until, int wakeFd) {
    if (!m_early.empty())
        return std::exchange(m_early, {});
    std::array<pollfd, 2> fds{{{m_socket.get(), POLLIN, 0}, {wakeFd, POLLIN, 0}}};
    if (pollUntil(fds, until) <= 0 || fds[0].revents == 0)
        return std::vector<std::uint8_t>{};
    return read();
}

PortError NetworkTransport::problem(PortProblem what, int error) const {
    return {what, m_name, {}, {}, error != 0 ? std::strerror(error) : ""};
}

}  // namespace nmc
