// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/unixsignals.h"

#include <unistd.h>

#include <QSocketNotifier>
#include <atomic>
#include <chrono>
#include <csignal>

#include "link/connection/bussession.h"
#include "link/connection/busworker.h"
#include "link/connection/wakeup.h"

namespace nmc {

namespace {

using namespace std::chrono_literals;

/// Time for the stop to be confirmed, and a reserve for a slow disk.
constexpr auto kPatience = std::chrono::ceil<std::chrono::seconds>(BusSession::kLongestClose) + 2s;

/// All that the handler may access: it may do no more than write to a descriptor. Set while a UnixSignals
/// exists.
std::atomic<const Wakeup*> g_wakeup{nullptr};
std::atomic<BusWorker*> g_worker{nullptr};

void onSignal(int) {
    if (BusWorker* worker = g_worker)
        worker->close();
    if (const Wakeup* wakeup = g_wakeup)
        wakeup->wake();
    ::alarm(static_cast<unsigned>(kPatience.count()));
}

void handle(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        ::sigaction(number, &action, nullptr);
}

}  // namespace

UnixSignals::UnixSignals(BusWorker* worker) {
    static const Wakeup wakeup;
    g_wakeup = &wakeup;
    g_worker = worker;
    auto* notifier = new QSocketNotifier(wakeup.fd(), QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] {
        wakeup.reset();
        emit terminationAsked();
    });
    handle(onSignal);
}

UnixSignals::~UnixSignals() {
    handle(SIG_DFL);
    ::alarm(0);
    g_wakeup = nullptr;
    g_worker = nullptr;
}

}  // namespace nmc
