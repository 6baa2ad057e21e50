// SPDX-License-Identifier: GPL-3.0-or-later
// The table of link.md 2.4: how often a corrupted reply is accepted as a true one. NMC_CORRUPTION_TRIALS sets
// the number of trials for each row.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bus/plausibility.h"
#include "sim/random.h"
#include "tests/bus/replies.h"
#include "tests/support/campaign.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

constexpr std::uint8_t kNineBytes = 0x0D;     ///< position, velocity, aux
constexpr std::uint8_t kSixteenBytes = 0x3F;  ///< everything
constexpr double kTicksBetween = 10.0 / 0.512;
/// How far an accepted position may be from the straight line, in counts: 144 for an acceleration of 0.5, as
/// of a shaft turned by hand, over at most 12.3 ms or 24 ticks; 80 for 2 ms more or less at 20 counts per
/// tick; 72 for a velocity without a fraction that has just changed by 2; 16 for rounding and slack; and 88
/// for the half that the reply's own wrong velocity may add.
constexpr double kTolerance = 400;

enum class Damage : std::uint8_t {
    OneFlip,
    TwoFlips,
    ThreeFlips,
    FourToEightFlips,
    TwoBytesReplaced,
    Burst,
    AllRandom,
    ByteInserted,
    ByteLost,
    AllZero
};

/// A row of the page: the share of wrong replies that are accepted by the sum alone, and by all checks.
struct Row {
    const char* name;
    Damage damage;
    std::uint8_t items;
    double bySum;
    double byAll;

    friend void PrintTo(const Row& row, std::ostream* stream) { *stream << row.name; }
};

constexpr std::array kRows{
    Row{"OneFlipOfNine", Damage::OneFlip, kNineBytes, 0, 0},
    Row{"TwoFlipsOfNine", Damage::TwoFlips, kNineBytes, 6.2e-2, 7.0e-3},
    Row{"ThreeFlipsOfNine", Damage::ThreeFlips, kNineBytes, 1.1e-2, 4.8e-4},
    Row{"FourToEightFlipsOfNine", Damage::FourToEightFlips, kNineBytes, 8.7e-3, 1.8e-4},
    Row{"TwoBytesReplacedOfNine", Damage::TwoBytesReplaced, kNineBytes, 3.5e-3, 8.9e-5},
    Row{"BurstOfNine", Damage::Burst, kNineBytes, 3.9e-3, 3.0e-5},
    Row{"AllRandomOfNine", Damage::AllRandom, kNineBytes, 3.9e-3, 0},
    Row{"ByteInsertedOfNine", Damage::ByteInserted, kNineBytes, 3.5e-3, 3.4e-5},
    Row{"ByteLostOfNine", Damage::ByteLost, kNineBytes, 4.0e-3, 5.4e-5},
    Row{"AllZeroOfNine", Damage::AllZero, kNineBytes, 1, 0},
    Row{"OneFlipOfSixteen", Damage::OneFlip, kSixteenBytes, 0, 0},
    Row{"TwoFlipsOfSixteen", Damage::TwoFlips, kSixteenBytes, 6.5e-2, 3.9e-3},
    Row{"ThreeFlipsOfSixteen", Damage::ThreeFlips, kSixteenBytes, 1.1e-2, 2.1e-4},
    Row{"FourToEightFlipsOfSixteen", Damage::FourToEightFlips, kSixteenBytes, 8.5e-3, 5.5e-5},
    Row{"TwoBytesReplacedOfSixteen", Damage::TwoBytesReplaced, kSixteenBytes, 3.6e-3, 8.5e-5},
    Row{"BurstOfSixteen", Damage::Burst, kSixteenBytes, 3.9e-3, 1.6e-5},
    Row{"AllRandomOfSixteen", Damage::AllRandom, kSixteenBytes, 4.0e-3, 0},
    Row{"ByteInsertedOfSixteen", Damage::ByteInserted, kSixteenBytes, 3.7e-3, 0},
    Row{"ByteLostOfSixteen", Damage::ByteLost, kSixteenBytes, 4.4e-3, 0},
    Row{"AllZeroOfSixteen", Damage::AllZero, kSixteenBytes, 1, 0},
};

/// A servo whose speed wanders between -20 and 20 counts a tick, at most 0.1 counts per tick squared.
class Motor {
public:
    explicit Motor(sim::Random& random) : m_random(random) {
        m_state.position = static_cast<std::int32_t>(random.below(400'000)) - 200'000;
        m_state.home = static_cast<std::int32_t>(random.below(400'000)) - 200'000;
        m_state.analog = static_cast<std::uint8_t>(random.below(256));
    }

    /// Moves on and returns the time to the next query: 10 ms, plus or minus two.
    Duration advance() {
        const auto time = Duration(8ms) + Duration(m_random.below(4'000'000));
        const double ticks = toSeconds(time) / toSeconds(kServoTick);
        if (m_random.below(25) == 0)
            m_goal = 40 * m_random.unit() - 20;
        const double before = m_speed;
        m_speed += std::clamp(m_goal - m_speed, -0.1 * ticks, 0.1 * ticks);
        m_position += (before + m_speed) / 2 * ticks;
        m_state.velocity = static_cast<std::int16_t>(std::lround(m_speed));
        m_state.analog = static_cast<std::uint8_t>(m_state.analog + m_random.below(3) - 1);
        m_state.status = static_cast<std::uint8_t>(m_speed == m_goal ? 0x09 : 0x08);
        m_state.aux = static_cast<std::uint8_t>(0x04 + m_random.below(2) + (m_speed == m_goal ? 0x08 : 0));
        return time;
    }
    [[nodiscard]] ServoState state() const {
        ServoState now = m_state;
        now.position += static_cast<std::int32_t>(std::lround(m_position));
        return now;
    }
    [[nodiscard]] double speed() const { return m_speed; }

private:
    sim::Random& m_random;
    ServoState m_state;
    double m_position = 0;
    double m_speed = 0;
    double m_goal = 0;
};

using Bytes = std::vector<std::uint8_t>;

void flip(Bytes& bytes, std::size_t count, sim::Random& random) {
    std::vector<std::size_t> done;
    while (done.size() < count) {
        const std::size_t bit = random.below(bytes.size() * 8);
        if (std::find(done.begin(), done.end(), bit) != done.end())
            continue;
        done.push_back(bit);
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1U << bit % 8));
    }
}

[[nodiscard]] std::uint8_t anyByte(sim::Random& random) {
    return static_cast<std::uint8_t>(random.below(256));
}

/// Makes sixteen bits in a row random, in the order of the line: the least significant bit of a byte first.
void burst(Bytes& bytes, sim::Random& random) {
    const std::size_t first = random.below(bytes.size() * 8 - 16 + 1);
    for (std::size_t bit = first; bit < first + 16; ++bit)
        bytes[bit / 8] =
            static_cast<std::uint8_t>(bytes[bit / 8] ^ (random.below(2) << static_cast<unsigned>(bit % 8)));
}

[[nodiscard]] Bytes damaged(Damage damage, const Bytes& whole, std::uint8_t next, sim::Random& random) {
    Bytes bytes = whole;
    switch (damage) {
        case Damage::OneFlip:
            flip(bytes, 1, random);
            break;
        case Damage::TwoFlips:
            flip(bytes, 2, random);
            break;
        case Damage::ThreeFlips:
            flip(bytes, 3, random);
            break;
        case Damage::FourToEightFlips:
            flip(bytes, 4 + random.below(5), random);
            break;
        case Damage::TwoBytesReplaced: {
            const std::size_t first = random.below(bytes.size());
            const std::size_t second = (first + 1 + random.below(bytes.size() - 1)) % bytes.size();
            bytes[first] = anyByte(random);
            bytes[second] = anyByte(random);
            break;
        }
        case Damage::Burst:
            burst(bytes, random);
            break;
        case Damage::AllRandom:
            for (std::uint8_t& byte : bytes)
                byte = anyByte(random);
            break;
        case Damage::ByteInserted:
            bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(random.below(bytes.size())),
                         anyByte(random));
            bytes.pop_back();
            break;
        case Damage::ByteLost:
            bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(random.below(bytes.size())));
            bytes.push_back(next);
            break;
        case Damage::AllZero:
            std::fill(bytes.begin(), bytes.end(), std::uint8_t{0});
            break;
    }
    return bytes;
}

class Corruption : public testing::TestWithParam<Row> {};

TEST_P(Corruption, IsBelievedNoMoreOftenThanThePageSays) {
    const Row row = GetParam();
    sim::Random random(2'004);
    unsigned rightSum = 0;
    unsigned believed = 0;
    unsigned cleanRejected = 0;
    double farthest = 0;
    const auto count = static_cast<unsigned>(campaignSize("NMC_CORRUPTION_TRIALS", 200'000));
    Motor motor(random);
    Plausibility plausibility({ModuleType::Servo, 4});
    TimePoint now{};
    for (unsigned trial = 0; trial < count; ++trial) {
        const ServoState before = motor.state();
        const double speed = motor.speed();
        now += motor.advance();
        const ServoState state = motor.state();
        const Bytes whole = bytesOf(state, row.items);
        const Bytes bytes = damaged(row.damage, whole, state.status, random);
        const ReplyEnd end = accepted(ModuleType::Servo, row.items, bytes, now);
        const bool fits = bytes != whole && end.result == ReplyResult::Accepted;
        rightSum += fits ? 1U : 0U;
        // With bit 1 set, the reply is the module's refusal, and not a sample.
        Plausibility asNow = plausibility;
        if (fits && !end.report.commandRefused() && !asNow.check(end)) {
            ++believed;
            const double expected = before.position + speed * kTicksBetween;
            farthest = std::max(farthest, std::abs(static_cast<double>(*end.report.position) - expected));
        }
        // The true reply follows, so that the next one is checked against it, and then a full one, as polls
        // alternate.
        cleanRejected += plausibility.check(accepted(ModuleType::Servo, row.items, whole, now)) ? 1U : 0U;
        now += motor.advance();
        cleanRejected += plausibility.check(accepted(ModuleType::Servo, kSixteenBytes,
                                                     bytesOf(motor.state(), kSixteenBytes), now))
                             ? 1U
                             : 0U;
    }
    const double bySum = static_cast<double>(rightSum) / count;
    const double byAll = static_cast<double>(believed) / count;
    std::printf("%-26s sum %.1e (page %.1e)  all %.1e (page %.1e)  farthest %.0f counts\n", row.name, bySum,
                row.bySum, byAll, row.byAll, farthest);
    EXPECT_EQ(cleanRejected, 0U);
    EXPECT_GE(bySum, row.bySum * 0.7) << "otherwise this is not the corruption that the page describes";
    EXPECT_LE(bySum, row.bySum * 1.4);
    EXPECT_LE(byAll, 2 * row.byAll);
    EXPECT_LE(farthest, kTolerance);
}

INSTANTIATE_TEST_SUITE_P(Rows, Corruption, testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace

}  // namespace nmc::test
