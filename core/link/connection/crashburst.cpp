// SPDX-License-Identifier: MIT
#include "link/connection/crashburst.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

namespace nmc::crashburst {

namespace {

struct Armed {
    int fd = -1;
    StopBurst burst;
};

constexpr std::array kDeadly{SIGSEGV, SIGABRT, SIGBUS, SIGFPE};
/// A port that no longer accepts bytes must not keep a dead program from ending.
constexpr unsigned kPatience = 3;  // s
constexpr std::size_t kStackSize = 64 * 1'024;

/// Two, so that the burst that a handler may be reading is never the one being written.
std::array<Armed, 2> g_bursts;
std::atomic<const Armed*> g_armed{nullptr};
std::atomic<bool> g_underWay{false};
static_assert(std::atomic<const Armed*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

// ---- Handler code: async-signal-safe calls only ----

void takeUsualCourse(int number) {
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    ::sigaction(number, &usual, nullptr);
    ::raise(number);  // delivered after the handler returns
}

void onDeadlySignal(int number) {
    if (g_underWay.exchange(true))
        while (true)  // another thread came first and ends the process
            ::pause();
    ::signal(SIGALRM, SIG_DFL);
    ::alarm(kPatience);
    if (const Armed* armed = g_armed.load(std::memory_order_acquire)) {
        ::signal(SIGPIPE, SIG_IGN);  // a line behind a network may have been closed at the other end
        // The burst is sent twice, because the bus thread may have been in the middle of writing a start to
        // the port.
        sendBurst(armed->fd, armed->burst);
        sendBurst(armed->fd, armed->burst);
    }
    takeUsualCourse(number);
}

}  // namespace

bool arm(int fd, ByteSpan bytes, std::uint32_t baud) {
    if (underWay())
        return true;
    const auto burst = StopBurst::of(bytes, baud);
    if (fd < 0 || bytes.empty() || !burst) {
        disarm();
        return burst.has_value();
    }
    Armed& next = g_armed.load(std::memory_order_relaxed) == g_bursts.data() ? g_bursts[1] : g_bursts[0];
    next = {fd, *burst};
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
