// SPDX-License-Identifier: GPL-3.0-or-later
// Each deterministic fault at one per cent, for a hundred thousand exchanges with moving motors; ten million
// with NMC_CAMPAIGN_EXCHANGES=10000000 (scripts/test nightly). Oracles count what must never happen.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "sim/random.h"
#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"
#include "tests/support/campaign.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;
using sim::ViolationKind;

constexpr std::uint8_t kServos = 3;
constexpr std::size_t kCodes = 16;

struct Fault {
    const char* name;
    const char* line;
    /// A short fault that recurs, instead of one that lasts.
    bool again = false;
    /// Violations that the fault itself causes on a chain, whatever the host does.
    std::set<ViolationKind> itsOwn{};
    /// Modules carry out commands that the host did not send.
    bool sendsCommands = false;

    friend void PrintTo(const Fault& fault, std::ostream* stream) { *stream << fault.line; }
};

/// The host takes something for the end of an answer that is still arriving, and sends the next command.
const std::set<ViolationKind> kFalseEnd{ViolationKind::CommandInFlight};
/// A packet of the other host that reaches a module right behind ours takes its place before it is carried
/// out, and is answered when ours would have been. No bit shows it: a start then finds what was loaded
/// before, such as the velocity 0 that a stop has left.
const std::set<ViolationKind> kReplaced{ViolationKind::CommandInFlight, ViolationKind::VelocityNotLoaded,
                                        ViolationKind::TrapezoidInMotion};

/// Delays are 1.05 to 5 times the time-out of a poll, which is 16.3 ms with this adapter's latency and this
/// machine's margin. An exchange takes about 1.5 ms, so a fault that comes every 150 ms strikes one exchange
/// in a hundred.
const std::array kFaults{
    Fault{"None", "bus drop p=0"},
    Fault{"DropCommand", "bus drop cmd p=.01"},
    Fault{"DropStatus", "bus drop status p=.01"},
    Fault{"DupCommand", "bus dup cmd p=.01"},
    Fault{"DupStatus", "bus dup status p=.01"},
    Fault{"FlipCommand", "bus flip cmd p=.01"},
    Fault{"FlipStatus", "bus flip status p=.01"},
    Fault{"TruncateCommand", "bus truncate cmd p=.01"},
    Fault{"TruncateStatus", "bus truncate status p=.01"},
    Fault{"Delay", "bus delay p=.01 t=17ms..81ms"},
    Fault{"Silent", "bus silent p=.01"},
    Fault{"Cksum", "bus cksum p=.01"},
    Fault{"Overrun", "bus overrun p=.01"},
    Fault{"Noise", "bus noise status t=100ms..200ms", false, kFalseEnd},
    Fault{"Foreign", "bus foreign on=nop t=100ms..200ms", false, kReplaced, true},
    Fault{"Echo", "bus echo for=10ms", true, kFalseEnd},
    Fault{"EchoForEver", "bus echo"},
    Fault{"Break", "bus break status for=10ms", true, kFalseEnd},
};

class Campaign : public testing::TestWithParam<Fault> {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connectAndEnable());
        ASSERT_TRUE(Truth::spreadOut(bus));
    }

    void act();
    void stopEverything();
    void noteSent();
    /// True if polling has ended, according to the events since they were last forgotten.
    [[nodiscard]] bool isLost() const {
        return bus.health() == LinkHealth::Lost || bus.count<LinkLost>() > 0;
    }
    void recover();
    void lookAndForget();
    void expectOnlySentCommands();
    void expectNoViolationsOfOurs();

    const std::uint64_t seed = 4'711;
    FaultyBus bus{servos(kServos), kFast, seed};
    Truth truth{bus};
    sim::Random random{seed};
    std::array<std::array<std::uint64_t, kCodes>, kServos> sentTo{};
    std::uint64_t exchanges = 0;
    std::uint64_t struck = 0;
    unsigned stops = 0, unreached = 0, lost = 0, restarts = 0, claims = 0;
    std::size_t traffic = 0, motions = 0;  ///< attributed to another host
};

/// Does what an operator might do next.
void Campaign::act() {
    const auto module = static_cast<std::uint8_t>(random.below(kServos));
    const auto way = static_cast<std::int32_t>(random.below(4'000)) - 2'000;
    switch (random.below(8)) {
        case 0:
        case 1:
        case 2:
            bus.submit({loadMove(module, Truth::placeOf(module) + way), start(module)});
            break;
        case 3:
            bus.engine.hold(forward(module, 2 * 65'536), bus.now);
            break;
        case 4:
            bus.submit({loadVelocity(module, 65'536, true)});
            bus.runFor(200ms);
            bus.submit({toServo(module, servo::StopMotor{true, servo::StopManner::Smoothly, {}})});
            break;
        case 5:
            bus.chain.set(ModuleIndex(module), sim::Input::Limit1, bus.servo(module).limit1 ? 0.0 : 1.0,
                          bus.now);
            break;
        case 6:
            bus.chain.set(ModuleIndex(module), sim::Input::Power, bus.servo(module).power ? 0.0 : 1.0,
                          bus.now);
            break;
        default:
            bus.submit({gains(module), enable(module)});
            break;
    }
}

/// Each module has to be confirmed or reported, each time.
void Campaign::stopEverything() {
    const std::size_t before = bus.count<StopFinished>();
    const auto stop = bus.stopAll();
    ++stops;
    ASSERT_TRUE(stop) << "every stop must end";
    EXPECT_EQ(bus.count<StopFinished>(), before + 1);
    EXPECT_EQ(stop->stopped.size() + stop->unreached.size(), std::size_t{kServos});
    unreached += static_cast<unsigned>(stop->unreached.size());
    for (const ModuleIndex module : stop->stopped)
        if (!bus.stands(module.value()))
            ++claims;
}

void Campaign::noteSent() {
    for (const auto& sent : bus.sent) {
        const auto code = codeOf(sent.bytes);
        if (!code)
            continue;
        ++exchanges;
        for (std::uint8_t module = 0; module < kServos; ++module)
            if (const std::uint8_t to = sent.bytes[1]; to == 0 || to >= 0x80 || to == module + 1)
                ++sentTo[module][static_cast<std::size_t>(*code)];
    }
    bus.sent.clear();
}

/// Connects again as an operator would after "link lost", and moves the motors back to where they can be told
/// apart.
void Campaign::recover() {
    const bool connect = isLost();
    bool astray = false;
    for (std::uint8_t i = 0; i < kServos; ++i)
        astray = astray || std::abs(bus.servo(i).position - Truth::placeOf(i)) > 6'000;
    if (!connect && !astray)
        return;
    lost += connect ? 1U : 0U;
    restarts += static_cast<unsigned>(bus.count<ModuleRestarted>());
    struck += bus.struck();
    bus.clearFaults();
    bus.runFor(500ms);
    for (std::uint8_t i = 0; i < kServos; ++i)
        bus.chain.set(ModuleIndex(i), sim::Input::Power, 1.0, bus.now);
    lookAndForget();
    ASSERT_TRUE(!connect || bus.connect());
    ASSERT_TRUE(bus.stopAll());
    for (std::uint8_t i = 0; i < kServos; ++i)
        ASSERT_EQ(bus.perform({gains(i), enable(i)}), Outcome::Done);
    ASSERT_TRUE(Truth::spreadOut(bus));
    if (!GetParam().again)
        bus.fault(GetParam().line);
}

void Campaign::lookAndForget() {
    traffic += bus.count<ForeignTraffic>();
    motions += bus.count<ForeignMotion>();
    truth.lookAndForget();
}

void Campaign::expectOnlySentCommands() {
    if (GetParam().sendsCommands)
        return;
    for (std::uint8_t module = 0; module < kServos; ++module)
        for (std::size_t code = 0; code < kCodes; ++code)
            EXPECT_LE(bus.executed(module, static_cast<CommandCode>(code)), sentTo[module][code])
                << "command " << code << " of module " << int{module};
}

void Campaign::expectNoViolationsOfOurs() {
    int told = 0;
    for (const sim::Violation& v : bus.chain.violations().entries())
        if (!GetParam().itsOwn.contains(v.kind) && ++told <= 5)
            ADD_FAILURE() << sim::toText(v.kind) << " at " << toSeconds(v.time.time_since_epoch())
                          << " s: " << toHex(v.bytes);
    EXPECT_EQ(told, 0);
}

TEST_P(Campaign, HasNoWrongSampleNoWrongPermissionAndNoLostStop) {
    const Fault& fault = GetParam();
    const std::uint64_t wanted = campaignSize("NMC_CAMPAIGN_EXCHANGES", 100'000);
    if (!fault.again)
        bus.fault(fault.line);
    for (unsigned round = 1; exchanges < wanted && !HasFatalFailure(); ++round) {
        if (fault.again) {
            struck += bus.struck();
            bus.clearFaults();
            bus.fault(fault.line);
        }
        act();
        bus.runFor(static_cast<Duration::rep>(50 + random.below(200)) * 1ms);
        if (round % 20 == 0)
            stopEverything();
        recover();
        noteSent();
        if (!isLost())
            lookAndForget();
    }
    struck += bus.struck();
    std::printf(
        "seed %llu: %llu exchanges, %.0f s; fault struck %llu; %llu samples; %u stops, %u times "
        "unreached; lost %u times\n",
        static_cast<unsigned long long>(seed), static_cast<unsigned long long>(exchanges),
        toSeconds(bus.now.time_since_epoch()), static_cast<unsigned long long>(struck),
        static_cast<unsigned long long>(truth.samples()), stops, unreached, lost);
    EXPECT_EQ(truth.wrong(), 0U) << "of " << truth.samples() << "; the first: " << truth.first();
    EXPECT_EQ(truth.wrongPermissions(), 0U) << truth.first();
    EXPECT_GT(bus.executed(0, CommandCode::StartMotion), 50U) << "they really move";
    EXPECT_EQ(restarts, 0U) << "no module has restarted";
    if (fault.line == std::string("bus drop p=0")) {
        EXPECT_EQ(lost, 0U) << "the line is perfect";
        EXPECT_EQ(bus.engine.statistics().errors() + bus.engine.statistics().rejected, 0U);
    }
    EXPECT_EQ(claims, 0U) << "no module was reported as stopped while it moved";
    EXPECT_TRUE(traffic == 0 || fault.sendsCommands) << "no other host is on the line";
    EXPECT_EQ(motions, 0U) << "no other host moves a motor";
    expectOnlySentCommands();
    expectNoViolationsOfOurs();
}

INSTANTIATE_TEST_SUITE_P(Faults, Campaign, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace

}  // namespace nmc::test
