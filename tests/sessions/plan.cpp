// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sessions/plan.h"

#include <array>
#include <cmath>
#include <sstream>

#include "sim/random.h"

namespace nmc::test {

using namespace std::chrono_literals;

namespace {

struct Weighed {
    ActKind kind;
    std::string_view text;
    unsigned weight;
};
/// What brings the engine into another state is more frequent than what only moves a motor.
constexpr std::array kActs{
    Weighed{ActKind::Connect, "connect", 8},
    Weighed{ActKind::Restart, "restart", 3},
    Weighed{ActKind::ChangeRate, "change the rate", 5},
    Weighed{ActKind::Distrust, "distrust", 3},
    Weighed{ActKind::PutIntoGroup, "put into a group", 3},
    Weighed{ActKind::StartGroup, "start the group", 3},
    Weighed{ActKind::HoldAndRelease, "hold and release", 4},
    Weighed{ActKind::HoldAndLapse, "hold and let lapse", 3},
    Weighed{ActKind::Move, "move", 4},
    Weighed{ActKind::Velocity, "velocity", 4},
    Weighed{ActKind::Pwm, "pwm", 2},
    Weighed{ActKind::Enable, "enable", 2},
    Weighed{ActKind::MotorOff, "motor off", 2},
    Weighed{ActKind::PowerCycle, "power-cycle", 2},
    Weighed{ActKind::PowerCycleAll, "power-cycle all", 1},
    Weighed{ActKind::Strike, "", 28},
    Weighed{ActKind::Wait, "wait", 2},
};

/// None of them holds a shaft or reverses an encoder: no stop would help there. Replies are late by less than
/// the quarantine (link.md 2.2).
constexpr std::array kStrikes{
    Strike{"silent", false, true},
    Strike{"mute tx", true, true, "mute rx"},
    Strike{"mute rx"},
    Strike{"mute rx"},
    Strike{"mute tx", true},
    Strike{"mute tx", true, false, "mute rx"},
    Strike{"mute tx", true, false, "mute rx"},
    Strike{"noise status t=1ms..30ms"},
    Strike{"noise cmd t=2ms..40ms", true},
    Strike{"drop cmd p=.1", true},
    Strike{"drop status p=.2"},
    Strike{"flip status p=.2"},
    Strike{"delay p=.3 t=5ms..80ms"},
    Strike{"echo"},
    Strike{"foreign on=read_status t=10ms..50ms", true},
};

constexpr std::array<std::uint32_t, 3> kRates{19'200, 57'600, 115'200};
/// One session in this many has an adapter that echoes.
constexpr std::uint64_t kEchoing = 4;

class Maker {
public:
    explicit Maker(std::uint64_t seed) : m_random(seed * 0x9E37'79B9U + 1) {}

    Plan make(std::uint64_t seed) {
        Plan plan;
        plan.seed = seed;
        plan.world = world(seed);
        plan.prologue = prologue();
        plan.formerBaud = kRates[below(kRates.size())];
        const std::size_t acts = below(8);
        for (std::size_t i = 0; i < acts; ++i)
            plan.acts.push_back(act(plan.world.chain.size()));
        if (plan.prologue == Prologue::Holding && below(2) == 0)
            plan.acts.push_back({ActKind::ChangeRate, {}, 0, static_cast<unsigned>(below(256)), {}, {}});
        plan.bytes = few(2'000);
        constexpr std::array kFollows{Follow::Nothing, Follow::Nothing, Follow::Nothing, Follow::StopAgain,
                                      Follow::Connect, Follow::Restart, Follow::Distrust};
        plan.follow = kFollows[below(kFollows.size())];
        plan.followBytes = few(300);
        return plan;
    }

private:
    std::size_t below(std::size_t limit) { return m_random.below(limit); }
    /// A number from 0 to below `most`; small ones are as frequent as large ones.
    std::uint64_t few(double most) {
        return static_cast<std::uint64_t>(std::exp(m_random.unit() * std::log(most)) - 1.0);
    }

    World world(std::uint64_t seed) {
        World world;
        world.seed = seed;
        // Mostly short chains: the situations that a stop can meet do not depend on the length.
        const std::size_t length = below(8) == 0 ? 5 + below(4) : 1 + below(4);
        world.chain.clear();
        for (std::size_t i = 0; i < length; ++i)
            world.chain.push_back(below(4) == 0 ? ModuleIdentity{ModuleType::Stepper, 1}
                                                : ModuleIdentity{ModuleType::Servo, version()});
        world.baud = kRates[below(kRates.size())];
        world.latency = static_cast<Duration::rep>(below(3) == 0 ? 0 : below(17)) * 1ms;
        world.deafWhenAddressInputRises = below(2) == 0;
        world.echoes = seed % kEchoing == 0;
        return world;
    }
    std::uint8_t version() { return static_cast<std::uint8_t>(below(2) == 0 ? 4 : 1 + below(4)); }

    Prologue prologue() {
        constexpr std::array kPrologues{
            Prologue::Fresh,   Prologue::Running, Prologue::Running,    Prologue::Running,
            Prologue::Running, Prologue::Running, Prologue::LeftBehind, Prologue::LeftBehind,
            Prologue::Holding, Prologue::Holding, Prologue::Nobody,     Prologue::InVain,
            Prologue::Lost,
        };
        return kPrologues[below(kPrologues.size())];
    }

    Act act(std::size_t modules) {
        unsigned weights = 0;
        for (const Weighed& w : kActs)
            weights += w.weight;
        std::size_t at = below(weights);
        std::size_t chosen = 0;
        for (; at >= kActs[chosen].weight; ++chosen)
            at -= kActs[chosen].weight;
        Act act;
        act.kind = kActs[chosen].kind;
        act.strike = kStrikes[below(kStrikes.size())];
        act.module = static_cast<std::uint8_t>(below(modules));
        act.value = static_cast<unsigned>(below(256));
        act.time = static_cast<Duration::rep>(5 + few(1'500)) * 1ms;
        act.pause = static_cast<Duration::rep>(few(900)) * 1ms;
        return act;
    }

    sim::Random m_random;
};

}  // namespace

namespace {

[[nodiscard]] std::string toText(const Act& act) {
    if (act.kind == ActKind::Strike)
        return std::string(act.strike.line) + (act.strike.too.empty() ? "" : ", ") +
               std::string(act.strike.too) + (act.strike.ofOneModule ? " of one" : "");
    for (const Weighed& w : kActs)
        if (w.kind == act.kind)
            return std::string(w.text);
    return {};
}

}  // namespace

Plan makePlan(std::uint64_t seed) {
    return Maker(seed).make(seed);
}

Plan makeReadOnlyPlan(std::uint64_t seed) {
    Plan plan = makePlan(seed);
    plan.world.readOnly = true;
    plan.prologue = Prologue::LeftBehind;
    plan.stops = seed % 3 == 0;
    if (!plan.stops && plan.follow == Follow::StopAgain)
        plan.follow = Follow::Nothing;
    return plan;
}

std::string toText(const Plan& plan) {
    constexpr std::array kPrologues{"fresh",  "running", "left behind", "holding",
                                    "nobody", "in vain", "lost"};
    constexpr std::array kFollows{"nothing", "stop again", "connect", "restart", "distrust"};
    std::ostringstream text;
    text << "seed " << plan.seed << ": ";
    for (const ModuleIdentity& module : plan.world.chain)
        text << (module.type == ModuleType::Stepper ? "step" : "servo@" + std::to_string(int{module.version}))
             << ",";
    text << " " << plan.world.baud << " Bd, latency " << plan.world.latency / 1ms << " ms"
         << (plan.world.deafWhenAddressInputRises ? ", deaf" : "") << (plan.world.echoes ? ", echo" : "")
         << (plan.world.readOnly ? ", read-only" : "") << "; "
         << kPrologues.at(static_cast<std::size_t>(plan.prologue));
    if (plan.prologue == Prologue::LeftBehind)
        text << " at " << plan.formerBaud;
    for (const Act& act : plan.acts)
        text << "; " << toText(act) << " m" << int{act.module} << " v" << act.value << " for "
             << act.time / 1ms << " ms, then " << act.pause / 1ms << " ms";
    text << "; after " << plan.bytes << " bytes " << (plan.stops ? "STOP" : "no stop") << "; after "
         << plan.followBytes << " bytes " << kFollows.at(static_cast<std::size_t>(plan.follow));
    return text.str();
}

}  // namespace nmc::test
