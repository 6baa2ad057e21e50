// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace nmc {

/// Passes values from one thread to another. When the queue is full, the oldest value is discarded and
/// counted: the reader of a status stream wants the newest, and nothing may grow without bound (faults.md
/// N8). All members may be called from any thread.
template <typename T>
class BoundedQueue {
public:
    explicit BoundedQueue(std::size_t capacity) : m_capacity(capacity) {}

    /// Returns true when the queue was empty before, that is, when the reader needs waking.
    bool push(T value) {
        const std::scoped_lock lock(m_mutex);
        const bool wasEmpty = m_values.empty();
        if (m_values.size() == m_capacity) {
            m_values.pop_front();
            ++m_dropped;
        }
        m_values.push_back(std::move(value));
        return wasEmpty;
    }

    /// Removes and returns all values, oldest first.
    [[nodiscard]] std::vector<T> takeAll() {
        const std::scoped_lock lock(m_mutex);
        std::vector<T> values(std::make_move_iterator(m_values.begin()),
                              std::make_move_iterator(m_values.end()));
        m_values.clear();
        return values;
    }

    [[nodiscard]] std::size_t dropped() const {
        const std::scoped_lock lock(m_mutex);
        return m_dropped;
    }

private:
    mutable std::mutex m_mutex;
    std::deque<T> m_values;
    std::size_t m_capacity;
    std::size_t m_dropped = 0;
};

}  // namespace nmc
