// SPDX-License-Identifier: MIT
#pragma once

namespace nmc {

/// An eventfd that ends another thread's wait. wake() may be called from any thread and from a signal
/// handler.
class Wakeup {
public:
    Wakeup();
    ~Wakeup();
    Wakeup(const Wakeup&) = delete;
    Wakeup& operator=(const Wakeup&) = delete;

    void wake() const;
    /// Clears all wake() calls so far; called by the waiting thread.
    void reset() const;
    [[nodiscard]] int fd() const { return m_fd; }

private:
    int m_fd;
};

}  // namespace nmc
