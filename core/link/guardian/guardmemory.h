// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "link/guardian/beatjudge.h"
#include "link/guardian/descriptor.h"
#include "link/guardian/stopburst.h"

namespace nmc {

/// The memory that a panel and its guardian share: the stop burst, the beat of the bus loop, and who has the
/// line. Lock-free both ways, and never torn: the burst lies in two places under a sequence number, so that a
/// panel which is killed in the middle of writing one leaves the one before, and the command that the new one
/// was for has not left yet.
///
/// One writing thread on each side.
class GuardMemory {
public:
    /// Both sides must be of this version; anything else is not looked at.
    static constexpr std::uint32_t kVersion = 1;

    /// A new one, whose size nobody can change any more. Nothing when the system gives none.
    [[nodiscard]] static std::optional<GuardMemory> create();
    /// The one that somebody else made. Nothing when it is not what this version of the program makes: size,
    /// seals, magic number, version.
    [[nodiscard]] static std::optional<GuardMemory> attach(int fd);
    GuardMemory(GuardMemory&& other) noexcept;
    GuardMemory& operator=(GuardMemory&& other) noexcept;
    ~GuardMemory();

    // ---- the panel's side ----
    [[nodiscard]] int fd() const { return m_fd.get(); }
    void arm(const StopBurst& burst);
    void setBeat(const Beat& beat);
    /// From now on the panel's end is none to worry about.
    void end();
    /// The guardian has the line. Asked after setBeat(): either the panel sees that it must wait, or the
    /// guardian sees the beat and keeps silent.
    [[nodiscard]] bool guardianSpeaks() const;
    /// How many times it has stopped the motors.
    [[nodiscard]] std::uint32_t stops() const;

    // ---- the guardian's side ----
    /// Empty when none was armed, and when what is there cannot be one.
    [[nodiscard]] StopBurst burst() const;
    [[nodiscard]] Beat beat() const;
    [[nodiscard]] bool ended() const;
    void setGuardianSpeaks(bool speaks);
    void noteStop();

private:
    struct Layout;

    explicit GuardMemory(Layout* layout, Descriptor fd) : m_layout(layout), m_fd(std::move(fd)) {}
    static Layout* map(int fd);

    Layout* m_layout;
    Descriptor m_fd;
};

}  // namespace nmc
