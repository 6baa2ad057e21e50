// SPDX-License-Identifier: MIT
#include "model/sequence/sequencecheck.h"

#include <cmath>

#include "base/overloaded.h"
#include "bus/standstill.h"
#include "model/intent/backlash.h"
#include "model/intent/homingplan.h"
#include "model/intent/pace.h"
#include "model/module/modulescale.h"

namespace nmc {

namespace {

bool hasBit(unsigned mask, unsigned bit) {
    return ((mask >> bit) & 1U) != 0;
}

/// True if the pin was set to be an output in this connection. `pin` counts from 0.
bool isIoOutput(unsigned pin, const ModuleState& module) {
    return pin < io::kPins && module.pins.inputs && !hasBit(*module.pins.inputs, pin);
}

template <typename Named>
std::optional<SequenceProblem> wrongName(const std::vector<Named>& all, std::size_t i) {
    if (all[i].name.empty())
        return SequenceProblem{.kind = SequenceProblem::Kind::NoName, .row = i};
    for (std::size_t k = 0; k < i; ++k)
        if (all[k].name == all[i].name)
            return SequenceProblem{.kind = SequenceProblem::Kind::NameTwice, .row = i, .name = all[i].name};
    return std::nullopt;
}

std::optional<SequenceProblem> wrongPoint(const Program& program, std::size_t i) {
    if (auto problem = wrongName(program.points, i)) {
        problem->ofPoint = true;
        return problem;
    }
    std::set<ModuleIndex> seen;
    for (const PointAxis& axis : program.points[i].axes)
        if (!seen.insert(axis.module).second)
            return SequenceProblem{.kind = SequenceProblem::Kind::AxisTwice,
                                   .row = i,
                                   .ofPoint = true,
                                   .module = axis.module,
                                   .name = program.points[i].name};
    return std::nullopt;
}

/// Checks what the row refers to.
std::optional<SequenceProblem> wrongRow(const Program& program, const Sequence& sequence, std::size_t row) {
    using Kind = SequenceProblem::Kind;
    const auto wrong = [&](Kind kind, const std::string& name = {}) {
        return SequenceProblem{.kind = kind, .sequence = sequence.name, .row = row, .name = name};
    };
    const Action& action = sequence.rows[row];
    if (const auto* move = std::get_if<action::MoveTo>(&action))
        if (program.point(move->point) == nullptr)
            return wrong(Kind::NoSuchPoint, move->point);
    if (const auto* repeat = std::get_if<action::Repeat>(&action))
        if (repeat->from >= row)
            return wrong(Kind::RepeatsBelow);
    if (const auto* call = std::get_if<action::Call>(&action)) {
        if (program.sequence(call->sequence) == nullptr)
            return wrong(Kind::NoSuchSequence, call->sequence);
        const auto called = rowsFrom(program, {call->sequence});
        if (std::ranges::find(called, sequence.name, &RowPlace::sequence) != called.end())
            return wrong(Kind::CallsItself, sequence.name);
    }
    return std::nullopt;
}

/// True if the refusal depends on where the axis is at the time; it then counts only for the first row that
/// moves the axis.
bool mayChange(Refusal refusal) {
    return refusal == Refusal::Moving || refusal == Refusal::NeedsStop || refusal == Refusal::LimitClosed ||
           refusal == Refusal::Limit1Active || refusal == Refusal::Limit2Active || refusal == Refusal::TooFar;
}

/// Checks the program against the machine in its present state, with each axis where the rows above leave it.
/// A row that runs more than once is checked only for the first time: the other times differ at most in where
/// the axis comes from, which the run checks before it moves anything.
class Checker {
public:
    Checker(const Machine& machine, const std::vector<ModuleState>& modules)
        : m_machine(machine), m_modules(modules) {}

    void check(const std::string& name, std::size_t first) {
        checkHasRows(name);
        for (const RowPlace& place : rowsFrom(m_machine.program, {name, first})) {
            m_at = {.sequence = place.sequence, .row = place.row};
            const Action& row = *rowAt(m_machine.program, place);
            if (const auto module = moduleOf(row); !module || present(*module) != nullptr)
                std::visit(*this, row);
        }
    }
    /// Checks that the machine is in the state in which a run from the top would reach the row.
    void checkEntry(const std::string& name, std::size_t row) {
        m_at = {.sequence = name, .row = row};
        const EntryState entry = entryState(m_machine, name, row);
        if (!entry.reached)
            report(SequenceProblem::Kind::Unreachable);
        for (const auto& [index, place] : entry.places) {
            const ModuleState* module = moduleAt(index, m_modules);
            if (module != nullptr && taughtElsewhere(place.axis, *module))
                report(SequenceProblem::Kind::TaughtElsewhere, index, place.point);
            else if (module != nullptr && !isAt(place, *module))
                report(SequenceProblem::Kind::NotThere, index, place.point);
        }
        for (const auto& [which, on] : entry.outputs)
            if (const ModuleState* module = moduleAt(which.first, m_modules);
                module != nullptr && outputIs(which.second, *module) != on)
                report(SequenceProblem::Kind::NotSet, which.first).output = which.second;
        for (const ModuleIndex index : entry.homed)
            if (const ModuleState* module = moduleAt(index, m_modules);
                module != nullptr && !module->home.place())
                refuse(index, Refusal::HomeUnknown);
    }
    std::vector<SequenceProblem> problems() && { return std::move(m_problems); }

    void operator()(const action::MoveTo& move) {
        const std::vector<PointAxis>& axes = m_machine.program.point(move.point)->axes;
        if (axes.empty())
            report(SequenceProblem::Kind::NoAxes, {}, move.point);
        for (const PointAxis& axis : axes)
            if (const ModuleState* module = present(axis.module))
                checkMove(axis, *module, move);
    }
    void operator()(const action::WaitForInput& wait) {
        const ModuleState& module = m_modules[wait.module.value()];
        if (readPin(wait.pin, module))
            return;
        const bool limit = wait.pin == InputPin::Limit1 || wait.pin == InputPin::Limit2;
        const bool output = (limit && module.isServo()) || (ioPin(wait.pin) && module.isIo());
        report(output ? SequenceProblem::Kind::NotAnInput : SequenceProblem::Kind::NoSuchPin, wait.module);
    }
    void operator()(const action::WaitForAnalog& wait) {
        if (!readAnalog(wait.input, m_modules[wait.module.value()]))
            report(SequenceProblem::Kind::NoSuchPin, wait.module);
    }
    void operator()(const action::SetOutput& set) {
        const ModuleState& module = m_modules[set.module.value()];
        const auto wanted = outputIntent(set, module);
        if (!wanted)
            report(wanted.error(), set.module).output = set.output;
        else if (const auto steps = plan(*wanted, module); !steps)
            refuse(set.module, steps.error());
    }
    void operator()(const action::Home& home) {
        const AxisSettings& settings = m_machine.axis(home.module);
        const ModuleState& module = m_modules[home.module.value()];
        const auto& recipe = settings.homing;
        if (!recipe)
            report(SequenceProblem::Kind::NoRecipe, home.module);
        else if (const auto refusal = whyNotHome(*recipe, module))
            if (!m_moved.contains(home.module) || !mayChange(*refusal))
                refuse(home.module, *refusal);
        m_homed.insert(home.module);
        m_moved.insert(home.module);
        const PointAxis place{home.module, 0, true};
        const auto back = moveIntent(place, 100, module, settings);
        if (back && recipe && recipe->goToHome)
            arrive(home.module, *goalOf(place, module), plan(*back, withoutBacklash(module)));
    }
    void operator()(const action::Call& call) { checkHasRows(call.sequence); }
    void operator()(const AnyOf<action::Wait, action::WaitForArrival, action::Repeat> auto&) {}

private:
    SequenceProblem& report(SequenceProblem::Kind kind, std::optional<ModuleIndex> module = {},
                            const std::string& name = {}) {
        SequenceProblem& problem = m_problems.emplace_back(m_at);
        problem.kind = kind;
        problem.module = module;
        problem.name = name;
        return problem;
    }
    SequenceProblem& refuse(ModuleIndex module, Refusal refusal) {
        SequenceProblem& problem = report(SequenceProblem::Kind::Refused, module);
        problem.refusal = refusal;
        return problem;
    }
    /// Reports an empty sequence only once, even if it is called more than once.
    void checkHasRows(const std::string& name) {
        const SequenceProblem none{.kind = SequenceProblem::Kind::NoRows, .sequence = name};
        if (m_machine.program.sequence(name)->rows.empty() && !std::ranges::count(m_problems, none))
            m_problems.push_back(none);
    }
    /// Reports a module that is missing or may not be sent anything, and returns null for it.
    const ModuleState* present(ModuleIndex index) {
        const ModuleState* module = moduleAt(index, m_modules);
        if (module == nullptr)
            report(SequenceProblem::Kind::NoSuchModule, index);
        // Of everything a run does, only homing has an operator right of its own.
        else if (const auto refusal = whyInaccessible(IntentKind::Home, *module)) {
            refuse(index, *refusal);
            return nullptr;
        }
        return module;
    }
    void checkMove(const PointAxis& axis, const ModuleState& module, const action::MoveTo& move) {
        const bool homed = m_homed.contains(axis.module);
        const bool first = m_moved.insert(axis.module).second;
        if (taughtElsewhere(axis, module) || (homed && !axis.fromHome)) {
            report(SequenceProblem::Kind::TaughtElsewhere, axis.module, move.point);
            return;
        }
        PointAxis place = axis;
        if (homed && !module.home.place())
            place.fromHome = false;  // where home will be is unknown yet; 0 is assumed
        const AxisSettings& settings = m_machine.axis(axis.module);
        const auto planned = planMove(place, move.percent, module, settings);
        if (!planned && (first || !mayChange(planned.error()))) {
            SequenceProblem& problem = refuse(axis.module, planned.error());
            const auto wanted = moveIntent(place, move.percent, module, settings);
            const auto travel = wanted ? travelProblem(*wanted, module) : std::nullopt;
            if (travel && travel->refusal == planned.error())
                problem.travel =
                    SequenceProblem::Travel{*travel, module.home.workZero(), scaleOf(module, settings)};
        }
        if (planned)
            arrive(axis.module, planned->goal, planned->orders);
        if (planned && planned->then)
            arrive(axis.module, planned->then->goal, planLeg(*planned->then, module));
    }
    /// Leaves the axis at rest where this leads, for the rows below.
    void arrive(ModuleIndex index, std::int32_t goal, const Plan& steps) {
        ModuleState& module = m_modules[index.value()];
        if (!steps)
            return;
        for (const bus::Order& step : *steps)
            module.apply(bus::CommandExecuted{index, module.latestTime, step.command});
        StatusReport there = *module.latest;
        there.position = goal;
        module.apply(bus::Sample{index, module.latestTime + Standstill::kFor, there});
    }
    [[nodiscard]] bool isAt(const EntryState::Place& place, const ModuleState& module) const {
        const auto goal = goalOf(place.axis, module);
        const auto position = module.position();
        if (!goal || module.moving() || !position)
            return false;
        const std::int64_t off = std::abs(std::int64_t{countsBetween(*goal, *position)});
        return module.goal() == *goal ||
               off <= std::max(kStillCounts, homeTolerance(m_machine.axis(place.axis.module).unit));
    }
    static std::optional<bool> outputIs(unsigned output, const ModuleState& module) {
        if (module.isServo() && module.io)
            return output == 1 ? module.io->limit1Output : module.io->limit2Output;
        std::optional<unsigned> levels;
        if (module.isStepper())
            levels = module.stepper.outputs;
        else if (module.isIo() && module.latest)
            levels = module.pins.levels(*module.latest);
        return levels ? std::optional(hasBit(*levels, output - 1U)) : std::nullopt;
    }

    const Machine& m_machine;
    std::vector<ModuleState> m_modules;  ///< as the rows checked so far leave them
    std::vector<SequenceProblem> m_problems;
    SequenceProblem m_at;
    std::set<ModuleIndex> m_homed;
    std::set<ModuleIndex> m_moved;
};

}  // namespace

std::optional<SequenceProblem> contradiction(const Program& program) {
    for (std::size_t i = 0; i < program.points.size(); ++i)
        if (auto problem = wrongPoint(program, i))
            return problem;
    for (std::size_t i = 0; i < program.sequences.size(); ++i) {
        const Sequence& sequence = program.sequences[i];
        if (auto problem = wrongName(program.sequences, i)) {
            problem->sequence = sequence.name;
            return problem;
        }
        for (std::size_t row = 0; row < sequence.rows.size(); ++row)
            if (auto problem = wrongRow(program, sequence, row))
                return problem;
    }
    return std::nullopt;
}

std::vector<SequenceProblem> whyNotRun(const std::string& sequence, std::size_t row, const Machine& machine,
                                       const std::vector<ModuleState>& modules) {
    if (const auto problem = contradiction(machine.program))
        return {*problem};
    if (machine.program.sequence(sequence) == nullptr)
        return {{.kind = SequenceProblem::Kind::NoSuchSequence, .sequence = sequence, .name = sequence}};
    Checker checker(machine, modules);
    if (row > 0)
        checker.checkEntry(sequence, row);
    checker.check(sequence, row);
    return std::move(checker).problems();
}

Machine withPlace(Machine machine, const Point& place) {
    std::erase_if(machine.program.points, [&](const Point& point) { return point.name == place.name; });
    machine.program.points.push_back(place);
    return machine;
}

Machine withMoveTo(Machine machine, const std::string& point) {
    machine.program.sequences.push_back({kMoveToPoint, {action::MoveTo{point}}});
    return machine;
}

std::vector<ModuleIndex> axesToHome(const Machine& machine, const std::vector<ModuleState>& modules) {
    std::vector<ModuleIndex> order = machine.homeOrder;
    for (const ModuleState& module : modules)
        if (!std::ranges::count(order, module.info.index))
            order.push_back(module.info.index);
    std::erase_if(order, [&](ModuleIndex index) {
        return moduleAt(index, modules) == nullptr || !machine.axis(index).homing;
    });
    return order;
}

EntryState entryState(const Machine& machine, const std::string& sequence, std::size_t row) {
    EntryState state;
    std::set<ModuleIndex> settled;  // a row nearer to this one sets its place, or leaves it unknown
    for (const RowPlace& above : rowsAbove(machine.program, {sequence, row}))
        std::visit(
            Overloaded{
                [&](const action::MoveTo& move) {
                    if (const Point* point = machine.program.point(move.point))
                        for (const PointAxis& axis : point->axes)
                            if (settled.insert(axis.module).second)
                                state.places[axis.module] = {point->name, axis};
                },
                [&](const action::SetOutput& set) {
                    state.outputs.try_emplace({set.module, set.output}, set.on);
                },
                [&](const action::Home& home) {
                    state.homed.insert(home.module);
                    const auto& recipe = machine.axis(home.module).homing;
                    if (settled.insert(home.module).second && recipe && recipe->goToHome)
                        state.places[home.module] = {{}, {home.module, 0, true}};
                },
                [&](const action::Repeat& repeat) { state.reached = state.reached && repeat.times != 0; },
                [](const AnyOf<action::Wait, action::WaitForArrival, action::WaitForInput,
                               action::WaitForAnalog, action::Call> auto&) {},
            },
            *rowAt(machine.program, above));
    return state;
}

bool taughtElsewhere(const PointAxis& axis, const ModuleState& module) {
    return !axis.fromHome && module.home.place();
}

tl::expected<std::int32_t, Refusal> goalOf(const PointAxis& axis, const ModuleState& module) {
    if (axis.fromHome && !module.home.place())
        return tl::unexpected(Refusal::HomeUnknown);
    const std::int64_t goal = std::int64_t{axis.counts} + (axis.fromHome ? module.home.place()->counts : 0);
    if (goal < servo::kPositionRange.min || goal > servo::kPositionRange.max)
        return tl::unexpected(Refusal::GoalOutOfRange);
    return static_cast<std::int32_t>(goal);
}

tl::expected<Intent, Refusal> moveIntent(const PointAxis& axis, unsigned percent, const ModuleState& module,
                                         const AxisSettings& settings) {
    const auto goal = goalOf(axis, module);
    if (!goal)
        return tl::unexpected(goal.error());
    return intent::Move{moveTo(*goal, paceOf(module, settings, percent / 100.0))};
}

Plan planLeg(const Leg& leg, const ModuleState& module) {
    return plan(leg.intent, withoutBacklash(module));
}

tl::expected<PointMove, Refusal> planMove(const PointAxis& axis, unsigned percent, const ModuleState& module,
                                          const AxisSettings& settings) {
    const auto wanted = moveIntent(axis, percent, module, settings);
    Plan orders = wanted.and_then([&](const Intent& intent) { return plan(intent, module); });
    if (!orders)
        return tl::unexpected(orders.error());
    const Leg whole{*goalOf(axis, module), *wanted};
    const auto turn = turningPoint(whole.goal, module);
    if (!turn)
        return PointMove{whole.goal, std::move(*orders)};
    if (!servo::kPositionRange.contains(*turn))
        return tl::unexpected(Refusal::GoalOutOfRange);
    const auto place = static_cast<std::int32_t>(*turn);
    orders = planLeg({place, intent::Move{endingAt(place, std::get<intent::Move>(*wanted).motion)}}, module);
    if (!orders)
        return tl::unexpected(orders.error());
    return PointMove{place, std::move(*orders), whole};
}

std::optional<bool> readPin(InputPin pin, const ModuleState& module) {
    if (!module.latest)
        return std::nullopt;
    if (module.isServo()) {
        const servo::StatusByte status = module.latest->servoStatus();
        if (pin == InputPin::Limit1 && (!module.io || module.io->limit1IsInput))
            return status.limit1();
        if (pin == InputPin::Limit2 && (!module.io || module.io->limit2IsInput))
            return status.limit2();
        return std::nullopt;
    }
    if (module.isIo()) {
        const auto number = ioPin(pin);
        if (!number || isIoOutput(*number, module) || !module.latest->pins)
            return std::nullopt;
        return hasBit(*module.latest->pins, *number);
    }
    if (!module.isStepper())
        return std::nullopt;
    const stepper::InputsByte inputs = module.stepper.inputs();
    const bool levels[] = {inputs.limit1(), inputs.limit2(), inputs.in1(), inputs.in2(), inputs.homeSwitch()};
    return ioPin(pin) ? std::nullopt : std::optional(levels[static_cast<std::size_t>(pin)]);
}

std::optional<unsigned> readAnalog(unsigned input, const ModuleState& module) {
    if (!module.isIo() || !module.latest || input < 1 || input > module.latest->analogs.size())
        return std::nullopt;
    return module.latest->analogs.at(input - 1);
}

bool isMet(const action::WaitForInput& wait, const ModuleState& module) {
    return readPin(wait.pin, module) == wait.active;
}

bool isMet(const action::WaitForAnalog& wait, const ModuleState& module) {
    const auto value = readAnalog(wait.input, module);
    return value && (wait.above ? *value > wait.level : *value < wait.level);
}

tl::expected<Intent, SequenceProblem::Kind> outputIntent(const action::SetOutput& set,
                                                         const ModuleState& module) {
    using Kind = SequenceProblem::Kind;
    const unsigned pin = set.output - 1U;
    if (module.isStepper() && pin < 5) {
        const auto now = module.stepper.outputs;
        if (!now)
            return tl::unexpected(Kind::OutputsUnknown);
        const unsigned others = *now & ~(1U << pin);
        return stepperintent::SetOutputs{static_cast<std::uint8_t>(others | (set.on ? 1U << pin : 0U))};
    }
    if (module.isIo() && pin < io::kPins) {
        if (!isIoOutput(pin, module))
            return tl::unexpected(module.pins.inputs ? Kind::NotAnOutput : Kind::OutputsUnknown);
        return iointent::SetOutput{pin, set.on};
    }
    if (!module.isServo() || pin >= 2)
        return tl::unexpected(Kind::NoSuchPin);
    servo::IoControl io = module.io.value_or(servo::IoControl{});
    if (pin == 0 ? io.limit1IsInput : io.limit2IsInput)
        return tl::unexpected(module.limitPinsKnown() ? Kind::NotAnOutput : Kind::OutputsUnknown);
    (pin == 0 ? io.limit1Output : io.limit2Output) = set.on;
    return intent::ControlIo{io};
}

intent::Home homeIntent(const AxisSettings& settings) {
    return {settings.homing.value_or(HomingRecipe{}), homeTolerance(settings.unit)};
}

std::vector<PointAxis> teach(const std::vector<ModuleIndex>& axes, const LinkState& link) {
    std::vector<PointAxis> taught;
    for (const ModuleIndex index : axes) {
        const ModuleState* module = moduleAt(index, link.modules);
        const auto position = module != nullptr ? module->position() : std::nullopt;
        if (!position || !isLive(link, *module) || module->otherType())
            continue;
        const auto& home = module->home.place();
        taught.push_back(
            {index, home ? countsBetween(home->counts, *position) : *position, home.has_value()});
    }
    return taught;
}

}  // namespace nmc
