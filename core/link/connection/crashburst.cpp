// SPDX-License-Identifier: MIT
#include "link/connection/crashburst.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

namespace nmc::crashburst {

namespace {

struct Burst {
    int fd = -1;
    std::size_t size = 0;
    std::array<std::uint8_t, kCapacity> bytes{};
};

constexpr std::array kDeadly{SIGSEGV, SIGABRT, SIGBUS, SIGFPE};
/// A port that takes no bytes any more must not keep a dead program from ending.
constexpr unsigned kPatience = 3;  // s
constexpr int kPatienceMs = 1'000;
constexpr std::size_t kStackSize = 64 * 1'024;

/// Two, so that the one a handler may be reading is never the one being written.
std::array<Burst, 2> g_bursts;
std::atomic<const Burst*> g_armed{nullptr};
std::atomic<bool> g_underWay{false};
static_assert(std::atomic<const Burst*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

// ---- what runs in a handler: async-signal-safe calls only ----

void writeAll(const Burst& burst) {
    std::size_t written = 0;
    while (written < burst.size) {
        const auto n = ::write(burst.fd, burst.bytes.data() + written, burst.size - written);
        if (n > 0) {
            written += static_cast<std::size_t>(n);
            continue;
        }
        if (n < 0 && errno == EINTR)
            continue;
        pollfd writable{burst.fd, POLLOUT, 0};
        if (n == 0 || errno != EAGAIN || ::poll(&writable, 1, kPatienceMs) <= 0)
            return;
    }
    ::tcdrain(burst.fd);
}

void takeUsualCourse(int number) {
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    ::sigaction(number, &usual, nullptr);
    ::raise(number);  // held back until the handler returns
}

void onDeadlySignal(int number) {
    if (g_underWay.exchange(true))
        while (true)  // another thread was first, and ends the process
            ::pause();
    ::signal(SIGALRM, SIG_DFL);
    ::alarm(kPatience);
    if (const Burst* burst = g_armed.load(std::memory_order_acquire)) {
        // Twice: the bus thread may have been in the middle of handing a start to the port.
        writeAll(*burst);
        writeAll(*burst);
    }
    takeUsualCourse(number);
}

}  // namespace

bool arm(int fd, ByteSpan bytes) {
    if (underWay())
        return true;
    if (fd < 0 || bytes.empty() || bytes.size() > kCapacity) {
        disarm();
        return bytes.size() <= kCapacity;
    }
    Burst& next = g_armed.load(std::memory_order_relaxed) == g_bursts.data() ? g_bursts[1] : g_bursts[0];
    next.fd = fd;
    next.size = bytes.size();
    std::copy(bytes.begin(), bytes.end(), next.bytes.begin());
    g_armed.store(&next, std::memory_order_release);
    return true;
}

void disarm() {
    g_armed.store(nullptr, std::memory_order_release);
}

bool underWay() {
    return g_underWay.load(std::memory_order_acquire);
}

void installHandlers() {
    struct sigaction action {};
    action.sa_handler = onDeadlySignal;
    action.sa_flags = SA_ONSTACK;
    ::sigemptyset(&action.sa_mask);
    for (const int number : kDeadly)
        ::sigaddset(&action.sa_mask, number);
    for (const int number : kDeadly)
        ::sigaction(number, &action, nullptr);
}

// ---- the stack ----

struct HandlerStack::Memory {
    stack_t before{};
    std::array<std::byte, kStackSize> bytes;
};

HandlerStack::HandlerStack() : m_memory(new Memory) {
    stack_t stack{};
    stack.ss_sp = m_memory->bytes.data();
    stack.ss_size = m_memory->bytes.size();
    ::sigaltstack(&stack, &m_memory->before);
}

HandlerStack::~HandlerStack() {
    ::sigaltstack(&m_memory->before, nullptr);
    delete m_memory;
}

}  // namespace nmc::crashburst
