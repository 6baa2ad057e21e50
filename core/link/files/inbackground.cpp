// SPDX-License-Identifier: MIT
#include "link/files/inbackground.h"

#include <thread>
#include <utility>

namespace nmc {

namespace {

std::function<void(std::function<void()>)>& background() {
    static std::function<void(std::function<void()>)> which = [](std::function<void()> work) {
        std::thread(std::move(work)).detach();
    };
    return which;
}

}  // namespace

void inBackground(std::function<void()> work) {
    background()(std::move(work));
}

void setBackground(std::function<void(std::function<void()> work)> other) {
    background() = std::move(other);
}

}  // namespace nmc
