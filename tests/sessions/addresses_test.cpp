// SPDX-License-Identifier: GPL-3.0-or-later
// Issue 13, "Mend first", c: a number once sent with Set Address is never sent again in that search, no two
// modules ever get the same one, and a collision is recognised and reported with its module.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "tests/faults/truth.h"
#include "tests/sessions/operator.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using testing::Contains;
using testing::IsEmpty;

/// What is lost at one place of the chain.
enum class Loss : std::uint8_t {
    Command,
    Answer,
    AnswerAndProbe,        ///< also the answer to the query at the new address
    AnswerAndProbes,       ///< also the answers to two such queries
    CommandThenAnswer,     ///< the command, then the answer to the next number
    AllThatTheModuleSays,  ///< every reply for a second
};

struct LossCase {
    Loss loss;
    bool restart;
    bool deaf;

    friend void PrintTo(const LossCase& c, std::ostream* stream) {
        static constexpr std::array kLosses{"Command",           "Answer",
                                            "AnswerAndProbe",    "AnswerAndProbes",
                                            "CommandThenAnswer", "AllThatTheModuleSays"};
        *stream << kLosses.at(static_cast<std::size_t>(c.loss)) << (c.restart ? "AtRestart" : "AtConnect")
                << (c.deaf ? "Deaf" : "");
    }
};

[[nodiscard]] std::vector<LossCase> lossCases() {
    std::vector<LossCase> all;
    for (unsigned loss = 0; loss <= static_cast<unsigned>(Loss::AllThatTheModuleSays); ++loss)
        for (const bool restart : {false, true})
            all.push_back({static_cast<Loss>(loss), restart, loss % 2 == 1});
    return all;
}

/// A search in which something is lost when the module at `place` is given its address.
class Search {
public:
    Search(const LossCase& c, std::size_t modules, std::size_t place)
        : rig(worldOf(c, modules)), m_loss(c.loss), m_place(place) {
        // The bus calls losesReply first, and only then onPacket, which may change the packet.
        rig.bus.losesReply = [this](ByteSpan bytes) { return losesReply(bytes); };
        rig.onPacket = [this](std::vector<std::uint8_t>& bytes) {
            if (std::exchange(m_losesCommand, false))
                bytes.clear();
        };
        c.restart ? rig.restart() : rig.connect();
        ended = rig.runUntil([&] { return !rig.searching(); }, StopOath::kSearchBound);
    }

    static bool isGiven(const WireItem& item) {
        return item.code() == CommandCode::SetAddress && item.address() == 0;
    }

    Rig rig;
    bool ended = false;

private:
    static World worldOf(const LossCase& c, std::size_t modules) {
        World world;
        world.chain = servos(modules);
        world.deafWhenAddressInputRises = c.deaf;
        return world;
    }
    void strike() {
        m_losesCommand = m_loss == Loss::Command || m_loss == Loss::CommandThenAnswer;
        m_until = rig.bus.now + 1s;
        switch (m_loss) {
            case Loss::Command:
            case Loss::CommandThenAnswer:
            case Loss::AllThatTheModuleSays:
                break;
            case Loss::Answer:
                m_answers = 1;
                break;
            case Loss::AnswerAndProbe:
                m_answers = 2;
                break;
            case Loss::AnswerAndProbes:
                m_answers = 3;
                break;
        }
    }
    [[nodiscard]] bool losesReply(ByteSpan bytes) {
        const auto items = itemsOf(bytes, rig.bus.now, 0);
        if (items.empty() || !items.back().code())
            return false;
        const bool given = isGiven(items.back());
        if (given && m_given++ == m_place)
            strike();
        if (given && m_given == m_place + 2 && m_loss == Loss::CommandThenAnswer)
            return true;
        const bool all = m_loss == Loss::AllThatTheModuleSays && rig.bus.now < m_until;
        return all || (m_answers > 0 && m_answers-- > 0);
    }

    Loss m_loss;
    std::size_t m_place;
    std::size_t m_given = 0;
    bool m_losesCommand = false;
    unsigned m_answers = 0;
    TimePoint m_until{};
};

class AddressesGiven : public testing::TestWithParam<LossCase> {
protected:
    static void expectNoNumberTwice(const Rig& rig) {
        std::map<int, int> times;
        for (const WireItem& item : rig.wire)
            if (Search::isGiven(item))
                ++times[item.control()];
        for (const auto& [number, n] : times)
            EXPECT_EQ(n, 1) << "number " << number << " was sent " << n << " times";
    }
    static void expectNoAddressTwice(Rig& rig) {
        std::map<int, int> times;
        for (std::uint8_t place = 0; place < rig.size(); ++place)
            ++times[rig.bus.chain.snapshot(ModuleIndex(place), rig.bus.now).address];
        for (const auto& [address, n] : times)
            EXPECT_TRUE(address == 0 || n == 1) << n << " modules have the address " << address;
    }
    /// True if a module that has got its address answers before the search can reasonably go on without it.
    static bool isHeardAgain(Loss loss) {
        return loss != Loss::AnswerAndProbes && loss != Loss::AllThatTheModuleSays;
    }
    /// Expects that the engine knows every module that has an address: it could not stop any other.
    static void expectAllListed(Rig& rig) {
        if (!rig.known)
            return;
        std::size_t there = 0;
        for (std::uint8_t place = 0; place < rig.size(); ++place)
            there += rig.bus.chain.snapshot(ModuleIndex(place), rig.bus.now).address != 0 ? 1U : 0U;
        EXPECT_EQ(rig.known->modules.size(), there);
    }
};

TEST_P(AddressesGiven, AreNeverGivenTwice) {
    for (const std::size_t modules : {1U, 2U, 4U, 8U, 32U})
        for (std::size_t place = 0; place < modules; place += modules == 32 ? 5 : 1) {
            SCOPED_TRACE(testing::Message() << place + 1 << " of " << modules);
            Search search(GetParam(), modules, place);
            EXPECT_TRUE(search.ended);
            expectNoNumberTwice(search.rig);
            expectNoAddressTwice(search.rig);
            if (isHeardAgain(GetParam().loss))
                expectAllListed(search.rig);
            EXPECT_THAT(search.rig.complaints, IsEmpty());
        }
}

/// One loss is no reason to give up, or to leave the rest of the chain without addresses.
TEST(AddressesGivenWithOneLoss, ReachTheWholeChain) {
    for (const Loss loss : {Loss::Command, Loss::Answer})
        for (const bool restart : {false, true})
            for (std::size_t place = 0; place < 4; ++place) {
                const LossCase c{loss, restart, false};
                SCOPED_TRACE(testing::PrintToString(c) + ", " + std::to_string(place));
                Search search(c, 4, place);
                ASSERT_TRUE(search.rig.known.has_value());
                EXPECT_EQ(search.rig.known->modules.size(), 4U);
            }
}

INSTANTIATE_TEST_SUITE_P(Losses, AddressesGiven, testing::ValuesIn(lossCases()),
                         testing::PrintToStringParamName());

/// F-37, at every position: the collision is reported with the module that the engine knows at that address.
TEST(AddressesThatCollide, AreNamed) {
    constexpr std::uint8_t kModules = 4;
    for (const std::uint32_t baud : {19'200U, 115'200U})
        for (std::uint8_t first = 0; first < kModules; ++first)
            for (std::uint8_t second = 0; second < kModules; ++second) {
                if (first == second)
                    continue;
                SCOPED_TRACE(testing::Message() << baud << " Bd, " << int{first} << " and " << int{second});
                EngineConfig config;
                config.baud = baud;
                FaultyBus bus(servos(kModules), config, std::uint64_t{7} + first * 4U + second);
                ASSERT_TRUE(bus.connectAndEnable());
                ASSERT_TRUE(Truth::spreadOut(bus));
                bus.fault("module " + std::to_string(first + 1) + "," + std::to_string(second + 1) +
                          " sameaddr");
                EXPECT_FALSE(bus.connect());
                ASSERT_EQ(bus.count<ConnectFailed>(), 1U);
                const ConnectFailed failed = *bus.last<ConnectFailed>();
                EXPECT_EQ(failed.reason, ConnectFailure::Collision);
                // Three modules remain that answer; the collision is at the address of the first.
                const int index = first - (second < first ? 1 : 0);
                EXPECT_THAT(failed.modules, Contains(ModuleIndex(static_cast<std::uint8_t>(index))));
            }
}

}  // namespace

}  // namespace nmc::test
