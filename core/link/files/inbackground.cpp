// SPDX-License-Identifier: MIT
#include "link/files/inbackground.h"

#include <atomic>
#include <thread>
#include <utility>

namespace nmc {

namespace {
std::atomic<bool> g_atOnce = false;
}  // namespace

void inBackground(std::function<void()> work) {
    if (g_atOnce)
        work();
    else
        std::thread(std::move(work)).detach();
}

void workAtOnce() {
    g_atOnce = true;
}

}  // namespace nmc
