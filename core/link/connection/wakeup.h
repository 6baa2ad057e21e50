// SPDX-License-Identifier: MIT
#pragma once

namespace nmc {

/// Ends another thread's wait: an eventfd. wake() may be called from any thread and from a signal handler.
class Wakeup {
public:
    Wakeup();
    ~Wakeup();
    Wakeup(const Wakeup&) = delete;
    Wakeup& operator=(const Wakeup&) = delete;

    void wake() const;
    /// Takes back all wake() calls so far; by the waiting thread.
    void reset() const;
    [[nodiscard]] int fd() const { return m_fd; }

private:
    int m_fd;
};

}  // namespace nmc
