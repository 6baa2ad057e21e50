// SPDX-License-Identifier: GPL-3.0-or-later
// The memory that a panel and its guardian share: it is never read torn, and forged memory is ignored.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <thread>

#include "link/guardian/guardmemory.h"
#include "tests/bus/steps.h"
#include "tests/support/virtualbus.h"

namespace nmc {
namespace {

/// A burst whose bytes and rate all follow from `number`, so that a torn one is recognised.
StopBurst numbered(std::uint32_t number) {
    StopBurst burst;
    burst.baud = number;
    burst.size = 1 + number % StopBurst::kCapacity;
    burst.bytes.fill(static_cast<std::uint8_t>(number));
    return burst;
}

bool isWhole(const StopBurst& burst) {
    const StopBurst whole = numbered(burst.baud);
    return burst.size == whole.size && burst.bytes == whole.bytes;
}

TEST(GuardMemory, HoldsNothingAtFirst) {
    const auto panel = GuardMemory::create();
    const auto guardian = GuardMemory::attach(panel->fd());
    ASSERT_TRUE(guardian);
    EXPECT_EQ(guardian->burst().size, 0U);
    EXPECT_FALSE(guardian->beat().moving);
    EXPECT_FALSE(guardian->ended());
    EXPECT_FALSE(panel->guardianSpeaks());
    EXPECT_EQ(panel->stops(), 0U);
}

TEST(GuardMemory, CarriesWhatEitherSideSays) {
    auto panel = GuardMemory::create();
    auto guardian = GuardMemory::attach(panel->fd());
    for (std::uint32_t i = 1; i < 5; ++i) {
        panel->arm(numbered(i));
        EXPECT_EQ(guardian->burst().baud, i);
        EXPECT_TRUE(isWhole(guardian->burst()));
    }
    const Beat beat{TimePoint(std::chrono::nanoseconds(123'456'789'012'345)), true};
    panel->setBeat(beat);
    EXPECT_EQ(guardian->beat(), beat);
    guardian->setGuardianSpeaks(true);
    guardian->noteStop();
    EXPECT_TRUE(panel->guardianSpeaks());
    EXPECT_EQ(panel->stops(), 1U);
    panel->end();
    EXPECT_TRUE(guardian->ended());
}

TEST(GuardMemory, IsNeverReadTorn) {
    auto panel = GuardMemory::create();
    const auto guardian = GuardMemory::attach(panel->fd());
    panel->arm(numbered(1));
    std::atomic<bool> enough{false};
    std::thread writer([&] {
        for (std::uint32_t i = 2; !enough; ++i)
            panel->arm(numbered(i));
    });
    std::uint32_t last = 0;
    for (int i = 0; i < 20'000; ++i) {
        const StopBurst burst = guardian->burst();
        ASSERT_TRUE(isWhole(burst));
        ASSERT_GE(burst.baud, last) << "it never goes back to an older one";
        last = burst.baud;
    }
    enough = true;
    writer.join();
}

TEST(GuardMemory, IsWholeWhereverItsWriterWasKilled) {
    for (int i = 0; i < 100; ++i) {
        auto panel = GuardMemory::create();
        const auto guardian = GuardMemory::attach(panel->fd());
        panel->arm(numbered(1));
        const pid_t writer = ::fork();
        if (writer == 0)
            for (std::uint32_t n = 2;; ++n)
                panel->arm(numbered(n));
        while (guardian->burst().baud < 10) {
        }
        ::kill(writer, SIGKILL);
        ::waitpid(writer, nullptr, 0);
        EXPECT_TRUE(isWhole(guardian->burst()));
    }
}

/// Memory made by another program, with the beginning of a valid one.
class Forged {
public:
    explicit Forged(int seals = F_SEAL_SHRINK | F_SEAL_GROW, long more = 0) {
        const auto good = GuardMemory::create();
        struct stat info {};
        ::fstat(good->fd(), &info);
        const auto size = static_cast<std::size_t>(info.st_size);
        void* from = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, good->fd(), 0);
        m_fd = ::memfd_create("forged", MFD_CLOEXEC | MFD_ALLOW_SEALING);
        EXPECT_EQ(::ftruncate(m_fd, info.st_size + more), 0);
        m_words =
            static_cast<std::uint32_t*>(::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, m_fd, 0));
        std::memcpy(m_words, from, more < 0 ? 16 : size);
        ::munmap(from, size);
        EXPECT_EQ(::fcntl(m_fd, F_ADD_SEALS, seals), 0);
    }
    ~Forged() { ::close(m_fd); }
    Forged(const Forged&) = delete;
    Forged& operator=(const Forged&) = delete;
    std::uint32_t& word(int index) { return m_words[index]; }
    [[nodiscard]] bool isTaken() const { return GuardMemory::attach(m_fd).has_value(); }

private:
    int m_fd = -1;
    std::uint32_t* m_words = nullptr;
};

TEST(ForgedMemory, IsTakenWhenItIsNoForgeryAtAll) {
    EXPECT_TRUE(Forged().isTaken()) << "otherwise the other tests of ForgedMemory would prove nothing";
}

TEST(ForgedMemory, OfAnotherSizeIsIgnored) {
    EXPECT_FALSE(Forged(F_SEAL_SHRINK | F_SEAL_GROW, 8).isTaken());
    EXPECT_FALSE(Forged(F_SEAL_SHRINK | F_SEAL_GROW, -8).isTaken());
}

TEST(ForgedMemory, ThatCouldStillChangeItsSizeIsIgnored) {
    EXPECT_FALSE(Forged(0).isTaken());
    EXPECT_FALSE(Forged(F_SEAL_GROW).isTaken());
    EXPECT_FALSE(Forged(F_SEAL_SHRINK).isTaken());
}

TEST(ForgedMemory, OfAnotherMagicNumberVersionOrLayoutIsIgnored) {
    for (const int word : {0, 1, 2}) {
        Forged forged;
        ++forged.word(word);
        EXPECT_FALSE(forged.isTaken()) << word;
    }
}

/// Its stop is the longest: the faster the line, the more nulls last as long as a servo tick.
TEST(StopBurst, HoldsTheStopOfTheLongestChainAtTheHighestRate) {
    bus::EngineConfig config;
    config.baud = 1'250'000;
    test::VirtualBus bus(test::servos(kMaxModules), config);
    ASSERT_TRUE(bus.connect());
    for (std::uint8_t i = 0; i < kMaxModules; ++i)
        ASSERT_EQ(bus.perform({test::gains(i), test::enable(i)}), bus::Outcome::Done);
    const std::vector<std::uint8_t> stop = bus.engine.stopBurst();
    // 16 nulls; for each module 5 bytes, and nulls for 512 us at 8 us each and one more.
    EXPECT_EQ(stop.size(), 16U + 32U * (5U + 65U));
    EXPECT_TRUE(StopBurst::of(stop, bus.engine.stopBurstBaud()));
    // Gains on trial are restored before: 19 bytes at most (Set Gain of CMC), and as many nulls.
    EXPECT_LE(stop.size() + 32U * (19U + 65U), StopBurst::kCapacity);
}

TEST(ForgedMemory, ThatIsNoMemoryIsIgnored) {
    const int file = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    EXPECT_FALSE(GuardMemory::attach(file));
    EXPECT_FALSE(GuardMemory::attach(-1));
    ::close(file);
}

TEST(ForgedMemory, WithABurstThatCannotBeOneIsEmpty) {
    auto panel = GuardMemory::create();
    StopBurst burst = numbered(1);
    burst.size = StopBurst::kCapacity + 1;
    panel->arm(burst);
    EXPECT_EQ(panel->burst().size, 0U);
}

}  // namespace
}  // namespace nmc
