// SPDX-License-Identifier: MIT
#include "link/guardian/guardmemory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <array>
#include <atomic>
#include <bit>
#include <new>

namespace nmc {

namespace {

constexpr std::uint32_t kMagic = 0x4E4D4347;  // "NMCG"
constexpr int kSeals = F_SEAL_SHRINK | F_SEAL_GROW;
constexpr std::size_t kWords = sizeof(StopBurst) / sizeof(std::uint64_t);
using Words = std::array<std::uint64_t, kWords>;

}  // namespace

/// Accesses are atomic word by word, so that a read during a write yields a wrong value but no undefined
/// behaviour.
struct GuardMemory::Layout {
    std::uint32_t magic = kMagic;
    std::uint32_t version = kVersion;
    std::uint32_t size = sizeof(Layout);
    std::atomic<std::uint32_t> ended{0};
    std::atomic<std::int64_t> beat{0};  ///< ns, doubled; plus 1 while anything moves
    std::atomic<std::uint32_t> guardianSpeaks{0};
    std::atomic<std::uint32_t> stops{0};
    std::atomic<std::uint64_t> sequence{0};  ///< sequence number of the complete burst; its lowest bit is the
                                             ///< index in `bursts`
    std::array<std::array<std::atomic<std::uint64_t>, kWords>, 2> bursts{};
};
// A lock inside the library would not work between processes.
static_assert(std::atomic<std::uint32_t>::is_always_lock_free &&
              std::atomic<std::int64_t>::is_always_lock_free);

std::optional<GuardMemory> GuardMemory::create() {
    Descriptor fd(::memfd_create("nmcguard", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!fd.valid() || ::ftruncate(fd.get(), sizeof(Layout)) != 0 ||
        ::fcntl(fd.get(), F_ADD_SEALS, kSeals | F_SEAL_SEAL) != 0)
        return std::nullopt;
    Layout* layout = map(fd.get());
    if (layout == nullptr)
        return std::nullopt;
    return GuardMemory(new (layout) Layout, std::move(fd));
}

std::optional<GuardMemory> GuardMemory::attach(int fd) {
    struct stat info {};
    // A memory that could still shrink would later cause a SIGBUS.
    if (::fstat(fd, &info) != 0 || info.st_size != sizeof(Layout) ||
        (::fcntl(fd, F_GET_SEALS) & kSeals) != kSeals)
        return std::nullopt;
    Layout* layout = map(fd);
    if (layout == nullptr)
        return std::nullopt;
    GuardMemory memory(layout, {});
    if (layout->magic != kMagic || layout->version != kVersion || layout->size != sizeof(Layout))
        return std::nullopt;
    return memory;
}

GuardMemory::Layout* GuardMemory::map(int fd) {
    void* address = ::mmap(nullptr, sizeof(Layout), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    return address == MAP_FAILED ? nullptr : static_cast<Layout*>(address);
}

void GuardMemory::Unmap::operator()(Layout* layout) const {
    ::munmap(layout, sizeof(Layout));
}

// ---- the burst ----
//
// A reader that reads a word of burst n + 2, which takes the place of burst n, has thereby acquired sequence
// n + 1, which was stored before it: the reader sees that the sequence has changed, and reads again.

void GuardMemory::arm(const StopBurst& burst) {
    const auto words = std::bit_cast<Words>(burst);
    const std::uint64_t next = m_layout->sequence.load(std::memory_order_relaxed) + 1;
    auto& place = m_layout->bursts[next % 2];
    for (std::size_t i = 0; i < kWords; ++i)
        place[i].store(words[i], std::memory_order_release);
    m_layout->sequence.store(next, std::memory_order_release);
}

StopBurst GuardMemory::burst() const {
    Words words{};
    std::uint64_t sequence = 0;
    do {
        sequence = m_layout->sequence.load(std::memory_order_acquire);
        const auto& place = m_layout->bursts[sequence % 2];
        for (std::size_t i = 0; i < kWords; ++i)
            words[i] = place[i].load(std::memory_order_acquire);
    } while (m_layout->sequence.load(std::memory_order_acquire) != sequence);
    const auto burst = std::bit_cast<StopBurst>(words);
    return burst.size <= StopBurst::kCapacity ? burst : StopBurst{};
}

// ---- the beat, and who has the line ----

void GuardMemory::setBeat(const Beat& beat) {
    m_layout->beat = beat.at.time_since_epoch().count() * 2 + (beat.moving ? 1 : 0);
}

Beat GuardMemory::beat() const {
    const std::int64_t word = m_layout->beat;
    return {TimePoint(Duration(word >> 1)), (word & 1) != 0};
}

bool GuardMemory::guardianSpeaks() const {
    return m_layout->guardianSpeaks != 0;
}

void GuardMemory::setGuardianSpeaks(bool speaks) {
    m_layout->guardianSpeaks = speaks ? 1 : 0;
}

std::uint32_t GuardMemory::stops() const {
    return m_layout->stops;
}

void GuardMemory::noteStop() {
    ++m_layout->stops;
}

void GuardMemory::end() {
    m_layout->ended = 1;
}

bool GuardMemory::ended() const {
    return m_layout->ended != 0;
}

}  // namespace nmc
