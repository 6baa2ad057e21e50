// SPDX-License-Identifier: MIT
#include "link/connection/requestbox.h"

namespace nmc {

template <typename Change>
void RequestBox::change(Change change) {
    {
        const std::scoped_lock lock(m_mutex);
        change(m_waiting);
    }
    m_wakeup.wake();
}

void RequestBox::stopAll() {
    m_stop = true;
    m_wakeup.wake();
}

void RequestBox::close() {
    ++m_closes;
    m_wakeup.wake();
}

void RequestBox::search(Search how) {
    change([how](Taken& waiting) { waiting.search = how; });
}

void RequestBox::watch(std::vector<ModuleIndex> modules) {
    change([&modules](Taken& waiting) { waiting.watched = std::move(modules); });
}

void RequestBox::keepTrial(ModuleIndex module) {
    change([module](Taken& waiting) { waiting.kept.push_back(module); });
}

void RequestBox::focus(std::optional<ModuleIndex> module) {
    change([module](Taken& waiting) { waiting.focused = module; });
}

void RequestBox::setStopOutputs(std::vector<bus::StopOutputs> outputs) {
    change([&outputs](Taken& waiting) { waiting.stopOutputs = std::move(outputs); });
}

void RequestBox::setTravelLimits(std::vector<bus::TravelLimits> limits) {
    change([&limits](Taken& waiting) { waiting.travelLimits = std::move(limits); });
}

void RequestBox::hold(const bus::HoldToMove& hold) {
    change([&hold](Taken& waiting) { waiting.held = hold; });
}

void RequestBox::release() {
    change([](Taken& waiting) {
        waiting.held.reset();
        waiting.released = true;
    });
}

void RequestBox::lend(std::string path) {
    change([&path](Taken& waiting) { waiting.lendAt = std::move(path); });
}

void RequestBox::letThrough() {
    change([](Taken& waiting) { waiting.letThrough = true; });
}

void RequestBox::endLending() {
    change([](Taken& waiting) {
        waiting.lendAt.reset();
        waiting.endLending = true;
    });
}

bool RequestBox::offer(BusRequest& request) {
    {
        const std::scoped_lock lock(m_mutex);
        if (!m_begun || m_waiting.requests.size() == kCapacity)
            return false;
        m_waiting.requests.push_back(std::move(request));
    }
    m_wakeup.wake();
    return true;
}

void RequestBox::begin(unsigned closes) {
    const std::scoped_lock lock(m_mutex);
    m_begun = true;
    m_waiting = {};
    m_stop = false;
    m_closesBefore = closes;
}

std::vector<BusRequest> RequestBox::end() {
    const std::scoped_lock lock(m_mutex);
    m_begun = false;
    return std::exchange(m_waiting, {}).requests;
}

RequestBox::Taken RequestBox::take() {
    // The wake-up is reset before anything is read, so that a request arriving meanwhile wakes the next
    // iteration.
    m_wakeup.reset();
    const bool stop = m_stop.exchange(false);
    const std::scoped_lock lock(m_mutex);
    Taken taken = std::exchange(m_waiting, {});
    taken.stop = stop;
    return taken;
}

}  // namespace nmc
