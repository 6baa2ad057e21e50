// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "model/sequence/sequencenews.h"
#include "tests/procedures/procedurebench.h"

namespace nmc::test {

inline constexpr ModuleIndex kX{0};
inline constexpr ModuleIndex kY{1};
inline constexpr ModuleIndex kTable{2};

/// Two servos and a stepper, all on and at home, with two points and a sequence that moves between them.
class SequenceBench : public ProcedureBench {
public:
    SequenceBench()
        : ProcedureBench({{ModuleType::Servo, servoVersion()},
                          {ModuleType::Servo, servoVersion()},
                          {ModuleType::Stepper, 1}}) {
        machine.axes.resize(3);
        for (AxisSettings& axis : machine.axes) {
            axis.motion.velocity = 2.0;
            axis.motion.acceleration = 0.02;
        }
        machine.axes[2].motion.velocity = 500.0;
        machine.axes[2].accelerationTime = 10.0;
        machine.program.points = {{"A", {{kX, 1'000}, {kY, -500}, {kTable, 200}}},
                                  {"B", {{kX, 0}, {kTable, 0}}}};
        machine.program.sequences = {
            {"Main",
             {action::MoveTo{"A"}, action::SetOutput{kTable, 2, true}, action::MoveTo{"B", false},
              action::Wait{0.3}, action::MoveTo{"A", true, false}, action::WaitForArrival{},
              action::SetOutput{kTable, 2, false}}}};
    }
    [[nodiscard]] bool ready() {
        if (!connect())
            return false;
        bus.runFor(std::chrono::milliseconds(200));
        take();
        const servo::SetGain gains{200, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}};
        const stepper::SetParameters parameters{stepper::SpeedMode::X1, false, false, false, 4, 200, 50, 0};
        for (const ModuleIndex index : {kX, kY})
            if (!order(index, intent::ApplyGains{gains}) || !order(index, intent::Enable{}))
                return false;
        if (!order(kTable, stepperintent::SetParameters{parameters}) || !order(kTable, intent::Enable{}))
            return false;
        for (ModuleState& module : modules)
            module.home.found(0, module.latestTime);
        m_seen = bus.events.size();
        return true;
    }
    [[nodiscard]] bool order(ModuleIndex index, const Intent& intent) {
        const auto steps = plan(intent, modules[index.value()]);
        const bool done = steps && bus.perform(*steps) == bus::Outcome::Done;
        bus.runFor(std::chrono::milliseconds(100));
        take();
        return done;
    }

    void start(const std::string& sequence, std::size_t row = 0, bool singleStep = false) {
        take();
        run.emplace(machine, sequence, row, singleStep);
    }
    /// One turn of the controller; returns false when the run has ended.
    bool turn() {
        for (int slice = 0; slice < 16; ++slice)
            bus.runFor(std::chrono::milliseconds(1));
        take();
        for (; m_seen < bus.events.size(); ++m_seen)
            tell(bus.events[m_seen]);
        if (procedure)
            workProcedure();
        SequenceRun::Next next = run->next(modules, bus.now);
        if (auto* send = std::get_if<SequenceRun::Send>(&next))
            for (auto& steps : send->operations)
                m_own.push_back(bus.submit(std::move(steps)));
        if (auto* ask = std::get_if<SequenceRun::Ask>(&next))
            obey(*ask);
        return !run->report().over();
    }
    SequenceReport goOn(double seconds = 120.0) {
        for (const TimePoint end = bus.now + fromSeconds(seconds); turn();)
            if (bus.now > end) {
                ADD_FAILURE() << "it does not end, stage " << static_cast<int>(run->report().stage);
                break;
            }
        return run->report();
    }
    void turns(int count) {
        for (int i = 0; i < count && turn(); ++i) {
        }
    }
    /// Expects that nothing moves and that no motion begins.
    void expectRest() {
        const std::size_t before = bus.sent.size();
        bus.runFor(std::chrono::seconds(3));
        const auto was = shafts();
        bus.runFor(std::chrono::seconds(2));
        EXPECT_EQ(shafts(), was);
        for (const char* start : {"AA 01 05", "AA 02 05", "AA 03 05"})
            EXPECT_EQ(bus.sends(start, before), 0U) << "nothing starts after the end of the run";
        bus.expectNoViolations();
    }
    [[nodiscard]] std::vector<std::int64_t> shafts() {
        std::vector<std::int64_t> all;
        for (std::uint8_t i = 0; i < 2; ++i)
            all.push_back(std::llround(bus.servo(i).commandPosition));
        all.push_back(bus.chain.snapshot(kTable, bus.now).stepper->shaft);
        return all;
    }
    [[nodiscard]] std::uint8_t outputs() { return bus.chain.snapshot(kTable, bus.now).stepper->outputs; }
    /// The motions that were loaded, in order: module and goal.
    [[nodiscard]] std::vector<std::pair<int, std::int32_t>> goals() const {
        std::vector<std::pair<int, std::int32_t>> all;
        for (const auto& executed : bus.all<bus::CommandExecuted>()) {
            std::optional<Counts> goal;
            if (const auto* command = std::get_if<ServoCommand>(&executed.command)) {
                if (const auto* load = std::get_if<servo::LoadTrajectory>(command))
                    goal = load->position;
            } else if (const auto* load =
                           std::get_if<stepper::LoadTrajectory>(&std::get<StepperCommand>(executed.command)))
                goal = load->position;
            if (goal)
                all.emplace_back(executed.module.value(), goal->value());
        }
        return all;
    }

    Machine machine;
    std::optional<SequenceRun> run;

private:
    void tell(const bus::Event& event) {
        if (const auto* finished = std::get_if<bus::OperationFinished>(&event)) {
            if (std::erase(m_own, finished->id) > 0)
                run->onFinished(finished->module, finished->outcome);
            else if (procedure && finished->id == m_procedureOperation) {
                m_procedureOperation.reset();
                procedure->onFinished(finished->outcome);
            }
            return;
        }
        std::visit(SequenceNews{*run}, event);
    }
    void obey(const SequenceRun::Ask& ask) {
        if (std::holds_alternative<intent::CancelProcedure>(ask.intent)) {
            procedure->cancel();
            return;
        }
        procedure = procedureFor(ask.intent, modules[ask.module.value()]);
        ASSERT_NE(procedure, nullptr);
    }
    void workProcedure() {
        ModuleState& module = modules[procedure->report().module.value()];
        if (!m_procedureOperation) {
            Procedure::Next next = procedure->next(module, bus.now);
            if (auto* send = std::get_if<Procedure::Send>(&next))
                m_procedureOperation = bus.submit(std::move(send->orders));
        }
        const ProcedureReport report = procedure->report();
        if (report.home && !module.home.place())
            module.home.found(*report.home, module.latestTime);
        run->onProcedure(report);
        if (report.over())
            procedure.reset();
    }

    std::size_t m_seen = 0;
    std::vector<bus::OperationId> m_own;
    std::optional<bus::OperationId> m_procedureOperation;
};

}  // namespace nmc::test
