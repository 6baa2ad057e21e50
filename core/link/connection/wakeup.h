// SPDX-License-Identifier: MIT
#pragma once

#include "link/guardian/descriptor.h"

namespace nmc {

/// An eventfd that ends another thread's wait. wake() may be called from any thread and from a signal
/// handler.
class Wakeup {
public:
    Wakeup();

    void wake() const;
    /// Clears all wake() calls so far; called by the waiting thread.
    void reset() const;
    [[nodiscard]] int fd() const { return m_fd.get(); }

private:
    Descriptor m_fd;
};

}  // namespace nmc
