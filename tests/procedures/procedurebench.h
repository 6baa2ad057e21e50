// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <memory>
#include <set>

#include "model/procedure/procedures.h"
#include "tests/support/virtualbus.h"

namespace nmc::test {

/// The version of the servos of a test that does not state one: the tests run on each chip (CMakeLists.txt).
[[nodiscard]] inline std::uint8_t servoVersion() {
    const char* const version = std::getenv("NMC_SERVO_VERSION");
    return static_cast<std::uint8_t>(version != nullptr ? std::atoi(version) : 4);
}

/// Engine and simulator in virtual time, with the state that the GUI thread keeps of them and one procedure,
/// which is run as the procedure controller runs it.
class ProcedureBench {
public:
    explicit ProcedureBench(const std::vector<ModuleIdentity>& identities, sim::ChainOptions options = {},
                            std::uint32_t baud = 115'200)
        : bus(identities, bus::EngineConfig{baud}, withFaults(options)) {
        bus.onTime = [this] {
            workSwitches();
            if (watchesSpeed)
                noteSpeed();
        };
    }

    VirtualBus bus;
    std::vector<ModuleState> modules;
    /// Called in each turn before next() of the procedure.
    std::function<void(Procedure&)> onTurn;
    /// Called after each slice of a turn.
    std::function<void()> onSlice;
    Duration sliceTime = std::chrono::microseconds(500);
    std::set<ProcedureStage> stages;  ///< all that were reached so far
    bool watchesSpeed = false;        ///< takes time at each event, so only tests that ask for it have it
    double fastest = 0.0;             ///< highest command velocity of servo 1 since then, in counts per tick

    [[nodiscard]] bool connect() {
        if (!bus.connect())
            return false;
        take();
        return true;
    }
    [[nodiscard]] ModuleState& module() { return modules.front(); }
    [[nodiscard]] sim::ServoSnapshot truth() { return bus.servo(0); }
    [[nodiscard]] sim::StepperSnapshot stepperTruth() {
        return *bus.chain.snapshot(ModuleIndex(0), bus.now).stepper;
    }
    /// True while the chip of module 1 searches for home.
    [[nodiscard]] bool searches() { return bus.chain.snapshot(ModuleIndex(0), bus.now).homing.inProgress(); }
    void set(sim::Input input, std::optional<double> value) {
        bus.chain.set(ModuleIndex(0), input, value, bus.now);
    }
    /// Injects a fault in servo 1 that lasts from now on.
    void fault(sim::FaultKind kind) {
        sim::FaultSpec spec;
        spec.kind = kind;
        spec.modules = {0};
        EXPECT_TRUE(bus.chain.inject(spec, bus.now).has_value());
    }
    /// One reply says that a motor is off, and is wrong (link.md 2.4).
    void sayOff(std::uint8_t index = 0) {
        take();
        ModuleState& state = modules.at(index);
        bus::Sample wrong = *bus.lastSample(index);
        wrong.time += std::chrono::milliseconds(1);
        if (state.isStepper())
            wrong.report.status &= static_cast<std::uint8_t>(~0x04U);  // AMP_EN (DS-S 5.2)
        else
            wrong.report.aux = static_cast<std::uint8_t>(*state.latest->aux & ~0x04U);  // servo_on (DS-V 5.3)
        state.apply(wrong);
    }
    /// The servo's switch is closed while the shaft is below `at` if `below`, otherwise while it is above.
    void putSwitch(sim::Input input, double at, bool below) { m_switches.push_back({input, at, below}); }

    [[nodiscard]] bool perform(const Intent& intent) {
        const auto steps = plan(intent, module());
        if (!steps)
            return false;
        const auto outcome = bus.perform(*steps);
        bus.runFor(std::chrono::milliseconds(100));
        take();
        return outcome == bus::Outcome::Done;
    }

    void begin(const Intent& intent) {
        take();
        m_overtaken = m_stopping = false;
        procedure = procedureFor(intent, module());
        ASSERT_NE(procedure, nullptr);
    }
    /// STOP ALL and Motor off, as the user requests them while the procedure runs.
    void stopAll() {
        m_stopping = true;
        bus.engine.stopAll(bus.now);
        overtake();
    }
    void switchOff() {
        bus.submit(*plan(intent::MotorOff{}, module()));
        overtake();
    }
    /// One turn of the controller; returns false when the procedure has ended.
    bool turn() {
        // In slices, so that switches are operated on time even when the line is quiet.
        for (int i = 0; i < 32; ++i) {
            bus.runFor(sliceTime);
            if (onSlice)
                onSlice();
        }
        take();
        if (onTurn)
            onTurn(*procedure);
        if (m_stopping)
            return true;
        Procedure::Next next = procedure->next(module(), bus.now);
        stages.insert(procedure->report().stage);
        if (auto* send = std::get_if<Procedure::Send>(&next)) {
            if (m_overtaken)
                keepWhatIsHarmless(send->orders);
            if (procedure->ends())
                if (auto stops = takeStops(send->orders); !stops.empty())
                    bus.submit(std::move(stops));
            if (send->orders.empty())
                procedure->onFinished(bus::Outcome::Done);
            else
                m_operation = bus.submit(std::move(*send));
        }
        shareBus();
        return !std::holds_alternative<Procedure::End>(next);
    }
    ProcedureReport run(const Intent& intent, double seconds = 120.0) {
        begin(intent);
        if (!procedure)
            return {};
        return goOn(seconds);
    }
    ProcedureReport goOn(double seconds = 120.0) {
        const TimePoint end = bus.now + fromSeconds(seconds);
        while (turn())
            if (bus.now > end) {
                ADD_FAILURE() << "the procedure does not end, stage "
                              << static_cast<int>(procedure->report().stage);
                break;
            }
        const ProcedureReport report = procedure->report();
        settle();
        return report;
    }
    [[nodiscard]] bool runTo(ProcedureStage stage, double seconds = 60.0) {
        const TimePoint end = bus.now + fromSeconds(seconds);
        while (procedure->report().stage != stage && bus.now < end)
            if (!turn())
                return false;
        return procedure->report().stage == stage;
    }
    void settle() {
        bus.runFor(std::chrono::milliseconds(300));
        take();
    }
    void take() {
        for (; m_taken < bus.events.size(); ++m_taken)
            std::visit([this](const auto& event) { told(event); }, bus.events[m_taken]);
    }

    std::unique_ptr<Procedure> procedure;

private:
    struct Switch {
        sim::Input input;
        double at;
        bool below;
        std::optional<bool> last{};
    };

    void workSwitches() {
        if (m_switches.empty())
            return;
        const double shaft = truth().shaftCounts;
        for (Switch& s : m_switches) {
            const bool closed = s.below ? shaft < s.at : shaft > s.at;
            if (s.last != closed)
                set(s.input, closed ? 1.0 : 0.0);
            s.last = closed;
        }
    }
    /// Not with the servo off, because its command position then follows the motor.
    void noteSpeed() {
        const auto now = truth();
        if (now.servoOn)
            fastest = std::max(fastest, std::abs(now.commandVelocity));
    }

    void overtake() {
        procedure->cancel();
        m_overtaken = true;
    }
    /// At each change of the report, and once a second.
    void shareBus() {
        const ProcedureReport& report = procedure->report();
        if (!isTest(report.kind) || (report == m_shared && bus.now - m_sharedAt < std::chrono::seconds(1)))
            return;
        m_shared = report;
        m_sharedAt = bus.now;
        bus.engine.focus(report.over() ? std::nullopt : std::optional(report.module), bus.now);
    }

    void told(const bus::ChainFound& found) {
        modules.clear();
        for (const bus::ModuleInfo& info : found.modules) {
            modules.emplace_back();
            modules.back().info = info;
        }
    }
    void told(const bus::Sample& sample) { modules.at(sample.module.value()).apply(sample); }
    void told(const bus::GroupChanged& changed) {
        modules.at(changed.module.value()).info.group = changed.place;
    }
    void told(const bus::PathProgress& path) { modules.at(path.module.value()).path = path; }
    void told(const bus::CommandExecuted& executed) { modules.at(executed.module.value()).apply(executed); }
    void told(const bus::ModuleUnresponsive& silence) {
        modules.at(silence.module.value()).silent = silence.silent;
        if (procedure)
            procedure->onLinkSuspect();
    }
    void told(const bus::HealthChanged& health) {
        if (procedure && health.health != bus::LinkHealth::Good)
            procedure->onLinkSuspect();
    }
    void told(const bus::ModuleRestarted& restarted) {
        modules.at(restarted.module.value()).silent = true;
        modules.at(restarted.module.value()).restarted();
        if (procedure)
            procedure->onLinkSuspect();
    }
    void told(const bus::StopFinished&) {
        m_stopping = false;
        if (procedure)
            overtake();
    }
    void told(const bus::OperationFinished& finished) {
        if (m_operation == finished.id) {
            m_operation.reset();
            procedure->onFinished(finished.outcome, finished.sine, finished.trial);
        }
    }
    template <typename Other>
    void told(const Other&) {}

    std::vector<Switch> m_switches;
    std::size_t m_taken = 0;
    std::optional<bus::OperationId> m_operation;
    bool m_overtaken = false;
    bool m_stopping = false;
    std::optional<ProcedureReport> m_shared;  ///< the report with which the bus was last shared
    TimePoint m_sharedAt;
};

/// A PIC-SERVO that enable() switches on with gains that hold it.
class ServoBench : public ProcedureBench {
public:
    explicit ServoBench(std::uint8_t version = servoVersion(), std::size_t count = 1)
        : ProcedureBench(servos(count, version)) {}

    [[nodiscard]] bool enable(std::uint16_t positionErrorLimit = 4'000, std::uint8_t currentLimit = 0) {
        if (!connect())
            return false;
        bus.runFor(std::chrono::milliseconds(200));
        take();
        const servo::SetGain gains{200, 2'000,          20, 200, 255, currentLimit, positionErrorLimit,
                                   1,   std::uint8_t{0}};
        return perform(intent::ApplyGains{gains}) && perform(intent::Enable{});
    }
    [[nodiscard]] bool moveTo(std::int32_t position) {
        if (!perform(intent::Move{servomotion::Trapezoid{Counts(position), CountsPerTick(2 << 16),
                                                         CountsPerTickSquared(1'311)}}))
            return false;
        return bus.runUntil(
            [&] {
                take();
                return !module().moving() && std::abs(truth().positionError) < 5;
            },
            std::chrono::seconds(30));
    }
};

[[nodiscard]] inline HomingRecipe slowRecipe() {
    HomingRecipe recipe;
    recipe.velocity = 0.5;
    recipe.indexVelocity = 0.1;
    recipe.acceleration = 0.01;
    recipe.travelLimit = 10'000;
    recipe.timeLimit = 30;
    return recipe;
}

}  // namespace nmc::test
