// SPDX-License-Identifier: MIT
#include "link/connection/requestbox.h"

namespace nmc {

void RequestBox::stopAll() {
    m_stop = true;
    m_wakeup.wake();
}

void RequestBox::close() {
    ++m_closes;
    m_wakeup.wake();
}

bool RequestBox::offer(BusRequest& request) {
    {
        const std::scoped_lock lock(m_mutex);
        if (!m_begun || m_pending.requests.size() == kCapacity)
            return false;
        m_pending.requests.push_back(std::move(request));
    }
    m_wakeup.wake();
    return true;
}

void RequestBox::begin(unsigned closes) {
    const std::scoped_lock lock(m_mutex);
    m_begun = true;
    m_pending = {};
    m_stop = false;
    m_closesBefore = closes;
}

std::vector<BusRequest> RequestBox::end() {
    const std::scoped_lock lock(m_mutex);
    m_begun = false;
    return std::exchange(m_pending, {}).requests;
}

RequestBox::Pending RequestBox::take() {
    // The wake-up is reset before anything is read, so that a request arriving meanwhile wakes the next
    // iteration.
    m_wakeup.reset();
    const bool stop = m_stop.exchange(false);
    const std::scoped_lock lock(m_mutex);
    Pending taken = std::exchange(m_pending, {});
    taken.stop = stop;
    return taken;
}

}  // namespace nmc
