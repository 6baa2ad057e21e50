// SPDX-License-Identifier: MIT
#include "model/sequence/sequencecheck.h"

#include <cmath>

#include "base/overloaded.h"
#include "bus/standstill.h"
#include "model/intent/homingplan.h"
#include "model/module/servodefaults.h"
#include "model/module/stepperdefaults.h"

namespace nmc {

namespace {

bool hasBit(std::uint16_t mask, unsigned bit) {
    return ((unsigned{mask} >> bit) & 1U) != 0;
}

/// As it was told in this connection; `pin` from 0.
bool isIoOutput(unsigned pin, const ModuleState& module) {
    return pin < io::kPins && module.pins.inputs && !hasBit(*module.pins.inputs, pin);
}

/// Whether `wanted` is called by the rows of `sequence`, or is it.
bool leadsTo(const Program& program, const std::string& sequence, const std::string& wanted,
             std::set<std::string>& seen) {
    if (sequence == wanted)
        return true;
    const Sequence* called = program.sequence(sequence);
    if (called == nullptr || !seen.insert(sequence).second)
        return false;
    return std::ranges::any_of(called->rows, [&](const Action& row) {
        const auto* call = std::get_if<action::Call>(&row);
        return call != nullptr && leadsTo(program, call->sequence, wanted, seen);
    });
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

/// What the row refers to.
std::optional<SequenceProblem> wrongRow(const Program& program, const Sequence& sequence, std::size_t row) {
    SequenceProblem problem{.sequence = sequence.name, .row = row};
    const Action& action = sequence.rows[row];
    if (const auto* move = std::get_if<action::MoveTo>(&action)) {
        problem.kind = SequenceProblem::Kind::NoSuchPoint;
        problem.name = move->point;
        return program.point(move->point) == nullptr ? std::optional(problem) : std::nullopt;
    }
    if (const auto* repeat = std::get_if<action::Repeat>(&action)) {
        problem.kind = SequenceProblem::Kind::RepeatsBelow;
        return repeat->from >= row ? std::optional(problem) : std::nullopt;
    }
    const auto* call = std::get_if<action::Call>(&action);
    if (call == nullptr)
        return std::nullopt;
    problem.name = call->sequence;
    problem.kind = SequenceProblem::Kind::NoSuchSequence;
    if (program.sequence(call->sequence) == nullptr)
        return problem;
    problem.kind = SequenceProblem::Kind::CallsItself;
    problem.name = sequence.name;
    std::set<std::string> seen;
    return leadsTo(program, call->sequence, sequence.name, seen) ? std::optional(problem) : std::nullopt;
}

/// Of a move that is not the first of its axis: what depends on where it will be then.
bool mayChange(Refusal refusal) {
    return refusal == Refusal::Moving || refusal == Refusal::NeedsStop || refusal == Refusal::Limit1Active ||
           refusal == Refusal::Limit2Active || refusal == Refusal::TooFar;
}

/// Goes through the rows as a run would, each once: what is done again changes nothing.
class Checker {
public:
    Checker(const Machine& machine, const std::vector<ModuleState>& modules)
        : m_machine(machine), m_modules(modules) {}

    void check(const std::string& name, std::size_t first) {
        const Sequence* sequence = m_machine.program.sequence(name);
        if (sequence == nullptr || !m_seen.insert(name).second)
            return;
        if (sequence->rows.empty())
            m_problems.push_back({.kind = SequenceProblem::Kind::NoRows, .sequence = name});
        for (std::size_t row = first; row < sequence->rows.size(); ++row) {
            m_at = {.sequence = name, .row = row};
            std::visit(*this, sequence->rows[row]);
        }
    }
    /// What a run from the top would have done by then.
    void checkEntry(const std::string& name, std::size_t row) {
        m_at = {.sequence = name, .row = row};
        const EntryState entry = entryState(m_machine, name, row);
        if (!entry.reached)
            report(SequenceProblem::Kind::Unreachable);
        for (const auto& [index, place] : entry.places)
            if (const ModuleState* module = moduleAt(index, m_modules);
                module != nullptr && !isAt(place, *module))
                report(SequenceProblem::Kind::NotThere, index, place.point);
        for (const auto& [which, on] : entry.outputs)
            if (const ModuleState* module = moduleAt(which.first, m_modules);
                module != nullptr && outputIs(which.second, *module) != on) {
                report(SequenceProblem::Kind::NotSet, which.first);
                m_problems.back().output = which.second;
            }
        for (const ModuleIndex index : entry.homed)
            if (const ModuleState* module = moduleAt(index, m_modules);
                module != nullptr && !module->home.place())
                refuse(index, Refusal::HomeUnknown);
    }
    std::vector<SequenceProblem> problems() && { return std::move(m_problems); }

    void operator()(const action::MoveTo& move) {
        const Point* point = m_machine.program.point(move.point);
        if (point == nullptr)
            return;
        if (point->axes.empty())
            report(SequenceProblem::Kind::NoAxes, {}, move.point);
        for (const PointAxis& axis : point->axes)
            checkMove(axis, move);
    }
    void operator()(const action::WaitForInput& wait) {
        const ModuleState* module = present(wait.module);
        if (module == nullptr || readPin(wait.pin, *module))
            return;
        const bool limit = wait.pin == InputPin::Limit1 || wait.pin == InputPin::Limit2;
        const bool output = (limit && module->isServo()) || (ioPin(wait.pin) && module->isIo());
        report(output ? SequenceProblem::Kind::NotAnInput : SequenceProblem::Kind::NoSuchPin, wait.module);
    }
    void operator()(const action::WaitForAnalog& wait) {
        const ModuleState* module = present(wait.module);
        if (module != nullptr && !readAnalog(wait.input, *module))
            report(SequenceProblem::Kind::NoSuchPin, wait.module);
    }
    void operator()(const action::SetOutput& set) {
        const ModuleState* module = present(set.module);
        if (module == nullptr)
            return;
        if (const auto intent = outputIntent(set, *module)) {
            if (const auto steps = plan(*intent, *module); !steps)
                refuse(set.module, steps.error());
            return;
        }
        const bool servoPin = module->isServo() && set.output <= 2;
        const bool stepperPin = module->isStepper() && set.output <= 5;
        const bool ioPin = module->isIo() && set.output <= io::kPins;
        report(stepperPin || (ioPin && !module->pins.inputs) ? SequenceProblem::Kind::OutputsUnknown
               : servoPin || ioPin                           ? SequenceProblem::Kind::NotAnOutput
                                                             : SequenceProblem::Kind::NoSuchPin,
               set.module);
        m_problems.back().output = set.output;
    }
    void operator()(const action::Home& home) {
        const ModuleState* module = present(home.module);
        if (module == nullptr)
            return;
        const AxisSettings& settings = m_machine.axis(home.module);
        if (!settings.homing)
            report(SequenceProblem::Kind::NoRecipe, home.module);
        else if (const auto refusal = whyNotHome(*settings.homing, *module))
            if (!m_moved.contains(home.module) || !mayChange(*refusal))
                refuse(home.module, *refusal);
        m_homed.insert(home.module);
        m_moved.insert(home.module);
    }
    void operator()(const action::Call& call) {
        const SequenceProblem at = m_at;
        check(call.sequence, 0);
        m_at = at;
    }
    void operator()(const AnyOf<action::Wait, action::WaitForArrival, action::Repeat> auto&) {}

private:
    void report(SequenceProblem::Kind kind, std::optional<ModuleIndex> module = {},
                const std::string& name = {}) {
        SequenceProblem problem = m_at;
        problem.kind = kind;
        problem.module = module;
        problem.name = name;
        m_problems.push_back(problem);
    }
    void refuse(ModuleIndex module, Refusal refusal) {
        report(SequenceProblem::Kind::Refused, module);
        m_problems.back().refusal = refusal;
    }
    const ModuleState* present(ModuleIndex index) {
        const ModuleState* module = moduleAt(index, m_modules);
        if (module == nullptr)
            report(SequenceProblem::Kind::NoSuchModule, index);
        else if (const auto refusal = whyInaccessible(IntentKind::Move, *module)) {
            refuse(index, *refusal);
            return nullptr;
        }
        return module;
    }
    void checkMove(const PointAxis& axis, const action::MoveTo& move) {
        const ModuleState* module = present(axis.module);
        if (module == nullptr)
            return;
        const bool homed = m_homed.contains(axis.module);
        const bool first = m_moved.insert(axis.module).second;
        if (!axis.fromHome && (homed || module->home.place()))
            return report(SequenceProblem::Kind::TaughtElsewhere, axis.module, move.point);
        PointAxis place = axis;
        if (homed && !module->home.place())
            place.fromHome = false;  // where home will be is not known yet: as if it were at 0
        const auto wanted = moveIntent(place, move.percent, *module, m_machine.axis(axis.module));
        const auto steps = wanted ? plan(*wanted, *module) : tl::unexpected(wanted.error());
        if (!steps && (first || !mayChange(steps.error())))
            refuse(axis.module, steps.error());
    }
    [[nodiscard]] bool isAt(const EntryState::Place& place, const ModuleState& module) const {
        const auto goal = goalOf(place.axis, module);
        if (!goal || module.moving() || !module.latest || !module.latest->position)
            return false;
        const std::int32_t off = std::abs(countsBetween(*goal, *module.latest->position));
        return module.goal() == *goal ||
               off <= std::max(kStillCounts, homeTolerance(m_machine.axis(place.axis.module).unit));
    }
    static std::optional<bool> outputIs(unsigned output, const ModuleState& module) {
        if (module.isStepper()) {
            const auto outputs = module.stepper.outputs();
            return outputs ? std::optional((unsigned{*outputs} >> (output - 1U) & 1U) != 0) : std::nullopt;
        }
        if (module.isIo()) {
            const auto levels = module.latest ? module.pins.levels(*module.latest) : std::nullopt;
            return levels ? std::optional(hasBit(*levels, output - 1U)) : std::nullopt;
        }
        if (!module.io)
            return std::nullopt;
        return output == 1 ? module.io->limit1Output : module.io->limit2Output;
    }

    const Machine& m_machine;
    const std::vector<ModuleState>& m_modules;
    std::vector<SequenceProblem> m_problems;
    SequenceProblem m_at;
    std::set<std::string> m_seen;
    std::set<ModuleIndex> m_homed;
    std::set<ModuleIndex> m_moved;
};

/// Adds up what rows leave behind. What a sequence leaves does not depend on what was before, so each is
/// gone through once.
class Effects {
public:
    explicit Effects(const Machine& machine) : m_machine(machine) {}

    const EntryState& of(const std::string& name) {
        const auto known = m_known.find(name);
        if (known != m_known.end())
            return known->second;
        m_known[name] = {};  // of one that calls itself
        const Sequence* sequence = m_machine.program.sequence(name);
        return m_known[name] = upTo(name, sequence != nullptr ? sequence->rows.size() : 0);
    }
    EntryState upTo(const std::string& name, std::size_t rows) {
        EntryState state;
        const Sequence* sequence = m_machine.program.sequence(name);
        for (std::size_t row = 0; sequence != nullptr && row < std::min(rows, sequence->rows.size()); ++row)
            add(sequence->rows[row], state);
        return state;
    }

private:
    void add(const Action& row, EntryState& state) {
        if (const auto* move = std::get_if<action::MoveTo>(&row)) {
            if (const Point* point = m_machine.program.point(move->point))
                for (const PointAxis& axis : point->axes)
                    state.places[axis.module] = {point->name, axis};
        } else if (const auto* set = std::get_if<action::SetOutput>(&row)) {
            state.outputs[{set->module, set->output}] = set->on;
        } else if (const auto* home = std::get_if<action::Home>(&row)) {
            state.homed.insert(home->module);
            state.places.erase(home->module);
            if (const auto& recipe = m_machine.axis(home->module).homing; recipe && recipe->goToHome)
                state.places[home->module] = {{}, {home->module, 0, true}};
        } else if (const auto* repeat = std::get_if<action::Repeat>(&row)) {
            state.reached = state.reached && repeat->times != 0;
        } else if (const auto* call = std::get_if<action::Call>(&row)) {
            const EntryState& called = of(call->sequence);
            for (const auto& [module, place] : called.places)
                state.places.insert_or_assign(module, place);
            for (const auto& [output, on] : called.outputs)
                state.outputs.insert_or_assign(output, on);
            state.homed.insert(called.homed.begin(), called.homed.end());
            state.reached = state.reached && called.reached;
        }
    }

    const Machine& m_machine;
    std::map<std::string, EntryState> m_known;
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

Machine withMoveTo(Machine machine, const std::string& point) {
    machine.program.sequences.push_back({kMoveToPoint, {action::MoveTo{point}}});
    return machine;
}

Machine withHoming(Machine machine, const std::vector<ModuleIndex>& axes) {
    Sequence homing{kHomeAll, {}};
    for (const ModuleIndex axis : axes)
        homing.rows.emplace_back(action::Home{axis});
    machine.program.sequences.push_back(std::move(homing));
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
    return Effects(machine).upTo(sequence, row);
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
    const double share = percent / 100.0;
    if (module.isStepper()) {
        const double wanted =
            settings.motion.velocity > 0 ? settings.motion.velocity : stepperdefaults::kMove;
        const StepperSpeed speed = stepperdefaults::speedMode(module.stepper, settings);
        return stepperintent::Move{
            steppermotion::Trapezoid{*goal, false, speed.speedFor(wanted * share),
                                     static_cast<std::uint8_t>(stepperdefaults::accelerationTime(settings))}};
    }
    const MotionSettings motion = servodefaults::motionOf(settings);
    return intent::GoTo{Counts(*goal),
                        CountsPerTick(std::max(1U, servodefaults::toFixed(motion.velocity * share))),
                        CountsPerTickSquared(servodefaults::toFixed(motion.acceleration))};
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
    switch (pin) {
        case InputPin::Limit1:
            return inputs.limit1();
        case InputPin::Limit2:
            return inputs.limit2();
        case InputPin::In1:
            return inputs.in1();
        case InputPin::In2:
            return inputs.in2();
        case InputPin::HomeSwitch:
            return inputs.homeSwitch();
        case InputPin::Io1:
        case InputPin::Io2:
        case InputPin::Io3:
        case InputPin::Io4:
        case InputPin::Io5:
        case InputPin::Io6:
        case InputPin::Io7:
        case InputPin::Io8:
        case InputPin::Io9:
        case InputPin::Io10:
        case InputPin::Io11:
        case InputPin::Io12:
            break;
    }
    return std::nullopt;
}

std::optional<unsigned> readAnalog(unsigned input, const ModuleState& module) {
    if (!module.isIo() || !module.latest || input < 1 || input > module.latest->analogs.size())
        return std::nullopt;
    return module.latest->analogs.at(input - 1);
}

bool isMet(const action::WaitForAnalog& wait, const ModuleState& module) {
    const auto value = readAnalog(wait.input, module);
    return value && (wait.above ? *value > wait.level : *value < wait.level);
}

std::optional<Intent> outputIntent(const action::SetOutput& set, const ModuleState& module) {
    if (module.isStepper() && set.output >= 1 && set.output <= 5 && module.stepper.outputs()) {
        const unsigned bit = 1U << (set.output - 1U);
        const unsigned now = *module.stepper.outputs();
        return stepperintent::SetOutputs{static_cast<std::uint8_t>(set.on ? now | bit : now & ~bit)};
    }
    if (module.isIo()) {
        const unsigned pin = set.output - 1U;
        return isIoOutput(pin, module) ? std::optional<Intent>(iointent::SetOutput{pin, set.on})
                                       : std::nullopt;
    }
    if (!module.isServo() || !module.io)
        return std::nullopt;
    servo::IoControl io = *module.io;
    if (set.output == 1 && !io.limit1IsInput)
        io.limit1Output = set.on;
    else if (set.output == 2 && !io.limit2IsInput)
        io.limit2Output = set.on;
    else
        return std::nullopt;
    return intent::ControlIo{io};
}

intent::Home homeIntent(const AxisSettings& settings) {
    return {settings.homing.value_or(HomingRecipe{}), homeTolerance(settings.unit)};
}

std::vector<PointAxis> teach(const std::vector<ModuleIndex>& axes, const std::vector<ModuleState>& modules) {
    std::vector<PointAxis> taught;
    for (const ModuleIndex index : axes) {
        const ModuleState* module = moduleAt(index, modules);
        if (module == nullptr || module->silent || !module->latest || !module->latest->position)
            continue;
        const std::int32_t position = *module->latest->position;
        const auto& home = module->home.place();
        taught.push_back({index, home ? countsBetween(home->counts, position) : position, home.has_value()});
    }
    return taught;
}

std::set<ModuleIndex> modulesOf(const Program& program, const std::string& sequence) {
    std::set<ModuleIndex> modules;
    std::set<std::string> seen;
    const auto collect = [&](const auto& self, const std::string& name) -> void {
        const Sequence* found = program.sequence(name);
        if (found == nullptr || !seen.insert(name).second)
            return;
        for (const Action& row : found->rows)
            std::visit(Overloaded{
                           [&](const action::MoveTo& move) {
                               if (const Point* point = program.point(move.point))
                                   for (const PointAxis& axis : point->axes)
                                       modules.insert(axis.module);
                           },
                           [&](const AnyOf<action::WaitForInput, action::SetOutput, action::Home,
                                           action::WaitForAnalog> auto& one) { modules.insert(one.module); },
                           [&](const action::Call& call) { self(self, call.sequence); },
                           [](const AnyOf<action::Wait, action::WaitForArrival, action::Repeat> auto&) {},
                       },
                       row);
    };
    collect(collect, sequence);
    return modules;
}

}  // namespace nmc
