// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/unixsignals.h"

#include <QSocketNotifier>
#include <csignal>

#include "link/wakeup.h"

namespace nmc {

namespace {

/// What the handler writes to: it may not do more. Set while a UnixSignals lives.
const Wakeup* g_wakeup = nullptr;

void onSignal(int) {
    if (g_wakeup != nullptr)
        g_wakeup->wake();
}

void handle(void (*handler)(int)) {
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        std::signal(number, handler);
}

}  // namespace

UnixSignals::UnixSignals(QObject* parent) : QObject(parent) {
    static const Wakeup wakeup;
    g_wakeup = &wakeup;
    auto* notifier = new QSocketNotifier(wakeup.fd(), QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] {
        wakeup.reset();
        emit terminationAsked();
    });
    handle(onSignal);
}

UnixSignals::~UnixSignals() {
    handle(SIG_DFL);
    g_wakeup = nullptr;
}

}  // namespace nmc
