// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace nmc {

/// Hands values of two kinds from one thread to another, in one order. News, each of which says something
/// that no other says, are all kept: they are as few as what happens. Samples come as fast as the wire
/// carries, and the reader wants the newest: when `samples` of them wait, the oldest makes room and is
/// counted (faults.md N8). All members may be called from any thread.
template <typename T>
class EventQueue {
public:
    explicit EventQueue(std::size_t samples) : m_capacity(samples) {}

    /// Both return true when the queue was empty before, that is when the reader needs waking.
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

    /// Takes everything that is there, oldest first.
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

    /// Samples that had to make room, so far.
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
