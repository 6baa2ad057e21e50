// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/baud.h"
#include "tests/bus/groups.h"
#include "tests/sessions/operator.h"
#include "tests/sessions/plan.h"

namespace nmc::test {

using namespace bus;
using namespace std::chrono_literals;

namespace {

constexpr Duration kLongSilence = 4s;  // a search that finds no module takes about as long
constexpr Duration kForEver = 30s;
constexpr Duration kQuietLine = 2s;  // without a byte for this long, the stop comes all the same

class Session {
public:
    Session(const Plan& plan, Rig& rig) : m_plan(plan), m_rig(rig) {}

    void run() {
        begin();
        for (const Act& act : m_plan.acts) {
            perform(act);
            m_rig.run(act.pause);
        }
        m_rig.runBytes(m_plan.bytes, kQuietLine);
        if (m_plan.stops)
            m_rig.stopAll();
        follow();
        m_rig.runToRest();
        m_rig.expectEnds();
    }

private:
    void begin();
    void connected(std::size_t moving) { static_cast<void>(setRunning(m_rig, moving)); }
    void follow();
    void perform(const Act& act);
    void strike(const Act& act);
    void muteBoth(Duration time) {
        m_rig.fault("mute tx", time, true);
        m_rig.fault("mute rx", time, false);
    }
    [[nodiscard]] ModuleIdentity identity(std::uint8_t module) const { return m_plan.world.chain[module]; }

    const Plan& m_plan;
    Rig& m_rig;
};

void Session::begin() {
    switch (m_plan.prologue) {
        case Prologue::Fresh:
            if (m_plan.acts.empty())
                m_rig.connect();
            return;
        case Prologue::Running:
            return connected(m_rig.size());
        case Prologue::Holding:
            return connected(0);
        case Prologue::LeftBehind:
            m_rig.replaceEngine(m_plan.formerBaud);
            connected(m_rig.size());
            m_rig.replaceEngine(m_plan.world.baud, m_plan.world.readOnly);
            return m_rig.connect();
        case Prologue::Nobody:
            connected(m_rig.size());
            muteBoth(kLongSilence);
            return m_rig.connect();
        case Prologue::InVain:
            connected(m_rig.size());
            muteBoth(kForEver);
            m_rig.connect();
            static_cast<void>(m_rig.runUntil([&] { return !m_rig.searching(); }, StopOath::kSearchBound));
            return m_rig.clearFaults();
        case Prologue::Lost:
            connected(m_rig.size());
            muteBoth(kForEver);
            static_cast<void>(m_rig.runUntil([&] { return m_rig.lost; }, kForEver));
            return m_rig.clearFaults();
    }
}

void Session::follow() {
    m_rig.runBytes(m_plan.followBytes, 100ms);
    switch (m_plan.follow) {
        case Follow::Nothing:
            return;
        case Follow::StopAgain:
            return m_rig.stopAll();
        case Follow::Connect:
            return m_rig.connect();
        case Follow::Restart:
            return m_rig.restart();
        case Follow::Distrust:
            return m_rig.distrust();
    }
}

void Session::perform(const Act& act) {
    const std::uint8_t m = act.module;
    switch (act.kind) {
        case ActKind::Connect:
            return m_rig.connect();
        case ActKind::Restart:
            return m_rig.restart();
        case ActKind::ChangeRate:
            return m_rig.changeRate(kBaudRows[1 + act.value % 3].nominal);
        case ActKind::Distrust:
            return m_rig.distrust();
        case ActKind::PutIntoGroup:
            return m_rig.submit(GroupChange{ModuleIndex(m), {kGroup, act.value % 4 == 0}});
        case ActKind::StartGroup:
            m_rig.submit({loadFar(m, identity(m), act.value + 1)});
            return m_rig.submit(GroupCommand{kGroup, GroupCommand::Action::StartMotion});
        case ActKind::HoldAndRelease:
        case ActKind::HoldAndLapse:
            return m_rig.hold(holdOn(m, identity(m), act.value + 1), act.time,
                              act.kind == ActKind::HoldAndLapse);
        case ActKind::Move:
            return m_rig.submit(moveFar(m, identity(m), act.value + 1));
        case ActKind::Velocity:
            return m_rig.submit(runOn(m, identity(m), act.value + 1));
        case ActKind::Pwm:
            // The motor is so slow that it coasts for less than the bound: 40 of 255 at 24 V gives 100 rad/s,
            // from which dry friction of 0.004 N·m brings 1.7e-5 kg·m² to rest in 0.4 s.
            if (identity(m).type == ModuleType::Servo)
                m_rig.submit({toServo(m, servo::StopMotor{true, servo::StopManner::MotorOff, {}}),
                              loadPwm(m, static_cast<std::uint8_t>(20 + act.value % 20))});
            return;
        case ActKind::Enable:
            return m_rig.submit(switchOn(m, identity(m)));
        case ActKind::MotorOff:
            return m_rig.submit(switchOff(m, identity(m)));
        case ActKind::Wait:
            return m_rig.run(act.time);
        case ActKind::PowerCycle:
            return m_rig.powerCycle(act.module);
        case ActKind::PowerCycleAll:
            for (std::uint8_t i = 0; i < m_rig.size(); ++i)
                m_rig.powerCycle(i);
            return;
        case ActKind::Strike:
            return strike(act);
    }
}

void Session::strike(const Act& act) {
    const auto module = act.strike.ofOneModule ? std::optional(act.module) : std::nullopt;
    m_rig.fault(std::string(act.strike.line), act.time, act.strike.deafens, module);
    if (!act.strike.too.empty())
        m_rig.fault(std::string(act.strike.too), act.time, false, module);
}

}  // namespace

void carryOut(const Plan& plan, Rig& rig) {
    Session(plan, rig).run();
}

}  // namespace nmc::test
