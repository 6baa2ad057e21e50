// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace nmc {

/// Passes values of two kinds from one thread to another in a single order. News items are all kept, because
/// each carries information that no other does; there are only as many as there are events. Samples arrive as
/// fast as the line can carry them, and the reader wants the newest: when `samples` of them are waiting, the
/// oldest is discarded and counted (faults.md N8). All members may be called from any thread.
template <typename T>
class EventQueue {
public:
    explicit EventQueue(std::size_t samples) : m_capacity(samples) {}

    /// Both return true when the queue was empty before, that is, when the reader needs waking.
    bool pushNews(T value) {
        const std::scoped_lock lock(m_mutex);
        return push(m_news, std::move(value));
    }
    bool pushSample(T value) {
        const std::scoped_lock lock(m_mutex);
        if (m_samples.size() == m_capacity) {
            m_samples.pop_front();
            ++m_dropped;
        }
        return push(m_samples, std::move(value));
    }

    /// Removes and returns all values, oldest first.
    [[nodiscard]] std::vector<T> takeAll() {
        const std::scoped_lock lock(m_mutex);
        std::vector<T> values;
        values.reserve(m_news.size() + m_samples.size());
        while (!m_news.empty() || !m_samples.empty()) {
            const bool newsFirst =
                m_samples.empty() || (!m_news.empty() && m_news.front().number < m_samples.front().number);
            Numbered& first = newsFirst ? m_news.front() : m_samples.front();
            values.push_back(std::move(first.value));
            (newsFirst ? m_news : m_samples).pop_front();
        }
        return values;
    }

    /// The number of samples discarded so far.
    [[nodiscard]] std::size_t dropped() const {
        const std::scoped_lock lock(m_mutex);
        return m_dropped;
    }

private:
    struct Numbered {
        std::uint64_t number;
        T value;
    };

    bool push(std::deque<Numbered>& queue, T value) {
        const bool wasEmpty = m_news.empty() && m_samples.empty();
        queue.push_back({++m_last, std::move(value)});
        return wasEmpty;
    }

    mutable std::mutex m_mutex;
    std::deque<Numbered> m_news;
    std::deque<Numbered> m_samples;
    std::size_t m_capacity;
    std::size_t m_dropped = 0;
    std::uint64_t m_last = 0;
};

}  // namespace nmc
