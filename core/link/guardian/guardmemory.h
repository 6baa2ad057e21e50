// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "link/guardian/beatmonitor.h"
#include "link/guardian/descriptor.h"
#include "link/guardian/stopburst.h"

namespace nmc {

/// The memory that a panel and its guardian share: the stop burst, the beat of the bus loop, and the owner of
/// the line. It is lock-free in both directions and never torn: the burst has two places under a sequence
/// number, so that a panel killed in the middle of writing a burst leaves the previous one, and the command
/// that needed the new burst has not been sent yet.
///
/// Each side has one writing thread.
class GuardMemory {
public:
    /// Both sides must have this version; anything else is ignored.
    static constexpr std::uint32_t kVersion = 2;

    /// Creates a memory whose size can no longer be changed. Returns nothing when the system provides none.
    [[nodiscard]] static std::optional<GuardMemory> create();
    /// Attaches to a memory created by another process. Returns nothing when its size, seals, magic number or
    /// version differ from what this version of the program creates.
    [[nodiscard]] static std::optional<GuardMemory> attach(int fd);

    // ---- the panel's side ----
    [[nodiscard]] int fd() const { return m_fd.get(); }
    void arm(const StopBurst& burst);
    void setBeat(const Beat& beat);
    /// From now on the guardian must ignore the end of the panel.
    void end();
    /// True while the guardian has the line. Call after setBeat(): either the panel sees that it must wait,
    /// or the guardian sees the beat and does not send.
    [[nodiscard]] bool guardianSpeaks() const;
    /// The number of times that the guardian has stopped the motors.
    [[nodiscard]] std::uint32_t stops() const;

    // ---- the guardian's side ----
    /// Empty when none is armed, or when the content cannot be a burst.
    [[nodiscard]] StopBurst burst() const;
    [[nodiscard]] Beat beat() const;
    [[nodiscard]] bool ended() const;
    void setGuardianSpeaks(bool speaks);
    void noteStop();

private:
    struct Layout;
    struct Unmap {
        void operator()(Layout* layout) const;
    };

    explicit GuardMemory(Layout* layout, Descriptor fd) : m_layout(layout), m_fd(std::move(fd)) {}
    static Layout* map(int fd);

    std::unique_ptr<Layout, Unmap> m_layout;
    Descriptor m_fd;
};

}  // namespace nmc
