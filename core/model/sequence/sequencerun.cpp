// SPDX-License-Identifier: MIT
#include "model/sequence/sequencerun.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/intent/homingplan.h"

namespace nmc {

namespace {

/// Motions begin only when all of them are loaded: a load that is refused leaves every motor where it is.
void startsLast(std::vector<bus::Order>& steps) {
    std::stable_partition(steps.begin(), steps.end(),
                          [](const bus::Order& step) { return !is<StartMotion>(step.command); });
}

/// What stops its motor, tried whatever is believed of it; nothing where nothing is on.
std::vector<bus::Order> stopOf(ModuleState module) {
    module.silent = false;
    auto steps = plan(intent::StopSmoothly{}, module);
    return steps ? std::move(*steps) : std::vector<bus::Order>{};
}

}  // namespace

SequenceRun::SequenceRun(Machine machine, const std::string& sequence, std::size_t row, bool singleStep)
    : m_machine(std::move(machine)),
      m_parts(modulesOf(m_machine.program, sequence)),
      m_pauseWanted(singleStep),
      m_singleStep(singleStep) {
    m_report.places.push_back({sequence, row});
}

SequenceRun SequenceRun::toPoint(Machine machine, const std::string& point) {
    SequenceRun run(withMoveTo(std::move(machine), point), kMoveToPoint, 0);
    run.m_report.point = point;
    return run;
}

SequenceRun SequenceRun::homing(Machine machine, const std::vector<ModuleIndex>& axes) {
    return {withHoming(std::move(machine), axes), kHomeAll, 0};
}

// ---- what it is told ----

void SequenceRun::endBy(SequenceEnd end, std::optional<ModuleIndex> module, std::optional<Refusal> refusal) {
    if (ending())
        return;
    m_report.end = end;
    m_report.module = module;
    m_report.refusal = refusal;
    m_report.stage = SequenceStage::Stopping;
}

void SequenceRun::onFinished(ModuleIndex module, bus::Outcome outcome) {
    m_inFlight -= m_inFlight > 0 ? 1U : 0U;
    if (outcome == bus::Outcome::Done)
        return;
    if (outcome == bus::Outcome::Cancelled)
        endBy(SequenceEnd::TakenOver, module);  // by a stop of whatever kind
    else
        endBy(SequenceEnd::NotExecuted, module);
}

void SequenceRun::onProcedure(const ProcedureReport& report) {
    if (m_procedure == report.module && report.over())
        m_procedureEnd = report;
}

void SequenceRun::onNotBegun(ModuleIndex module, Refusal refusal) {
    m_procedure.reset();
    endBy(SequenceEnd::Refused, module, refusal);
}

void SequenceRun::onLinkSuspect() {
    endBy(SequenceEnd::LinkInDoubt);
}

void SequenceRun::onTakenOver(ModuleIndex module, bool sees) {
    if (!takesPart(module))
        return;
    if (sees)
        m_leftAlone.insert(module);
    endBy(SequenceEnd::TakenOver, module);
}

void SequenceRun::onStopOfAll() {
    m_saysNothingMore = true;
    endBy(SequenceEnd::StopOfAll);
}

void SequenceRun::onClosed() {
    m_saysNothingMore = true;
    endBy(SequenceEnd::LinkInDoubt);
    m_inFlight = 0;
    m_procedure.reset();
    m_report.stage = m_report.over() ? m_report.stage : SequenceStage::Over;
}

void SequenceRun::pause() {
    m_pauseWanted = true;
    if (m_report.stage == SequenceStage::Running)
        m_report.stage = SequenceStage::Pausing;
}

void SequenceRun::resume() {
    m_pauseWanted = m_singleStep = false;
    if (m_report.stage == SequenceStage::Pausing || m_report.stage == SequenceStage::Paused)
        m_report.stage = SequenceStage::Running;
}

void SequenceRun::step() {
    if (m_report.stage != SequenceStage::Paused)
        return;
    m_singleStep = m_pauseWanted = true;
    m_report.stage = SequenceStage::Running;
}

void SequenceRun::stop() {
    endBy(SequenceEnd::ByUser);
}

// ---- what is next ----

SequenceRun::Next SequenceRun::next(const Modules& modules, TimePoint now) {
    if (m_report.over())
        return End{};
    if (!ending())
        watch(modules, now);
    if (m_inFlight > 0 && !m_saysNothingMore)
        return Wait{};
    if (ending())
        return finishEnding(modules);
    if (m_report.stage == SequenceStage::Pausing && !m_rowBegan && currentRow() != nullptr) {
        m_report.stage = m_moves.empty() ? SequenceStage::Paused : SequenceStage::Pausing;
        return Wait{};
    }
    if (m_report.stage == SequenceStage::Paused)
        return Wait{};
    Next next = proceed(modules, now);
    return m_report.end ? finishEnding(modules) : next;
}

/// A procedure stops its own motor; the others that may move are told to.
SequenceRun::Next SequenceRun::finishEnding(const Modules& modules) {
    if (m_procedure && !m_procedureEnd && !m_saysNothingMore) {
        if (std::exchange(m_cancelled, true))
            return Wait{};
        return Ask{*m_procedure, intent::CancelProcedure{}};
    }
    if (!m_saysNothingMore && !std::exchange(m_stopsSent, true)) {
        std::vector<std::vector<bus::Order>> stops;
        for (const auto& [index, move] : m_moves)
            if (const ModuleState* module = moduleAt(index, modules);
                module != nullptr && !m_leftAlone.contains(index))
                if (auto steps = stopOf(*module); !steps.empty())
                    stops.push_back(std::move(steps));
        if (!stops.empty())
            return send(std::move(stops));
    }
    m_report.stage = SequenceStage::Over;
    return End{};
}

/// What is not as this run left it ends it, whoever did that.
void SequenceRun::watch(const Modules& modules, TimePoint now) {
    for (const ModuleIndex index : m_parts) {
        const ModuleState* module = moduleAt(index, modules);
        if (module == nullptr || module->silent || module->hasRestarted)
            return endBy(SequenceEnd::Unresponsive, index);
    }
    for (const ModuleIndex index : m_on)
        if (!modules[index.value()].driveOn())
            return endBy(SequenceEnd::WentOff, index);
    if (m_inFlight > 0)
        return;
    for (auto move = m_moves.begin(); move != m_moves.end() && !ending();) {
        const ModuleState& module = modules[move->first.value()];
        watchMove(module, move->second, now);
        const bool arrived =
            !ending() && move->second.since && module.latestTime > *move->second.since &&
            module.latest->position &&
            move->second.standstill.look(module.latestTime, *module.latest->position, module.moving());
        if (arrived && module.isStepper() && module.stepper.position() != move->second.goal)
            return endBy(SequenceEnd::NotArrived, move->first);
        move = arrived ? m_moves.erase(move) : std::next(move);
    }
}

void SequenceRun::watchMove(const ModuleState& module, Move& move, TimePoint now) {
    const ModuleIndex index = module.info.index;
    if (!move.since)
        move.since = now;
    // One that was closed before lets the motor leave it.
    for (std::size_t limit = 0; limit < move.closedBefore.size(); ++limit)
        if (module.limits.ranInto(limit) && !move.closedBefore[limit])
            return endBy(SequenceEnd::LimitClosed, index);
    // Its goal is not ours any more: something else moves it or has stopped it.
    if (module.isServo() && !module.headsFor(move.goal)) {
        m_leftAlone.insert(index);
        endBy(SequenceEnd::NotArrived, index);
    }
}

SequenceRun::Next SequenceRun::proceed(const Modules& modules, TimePoint now) {
    const Action* row = currentRow();
    if (row == nullptr) {
        if (!m_moves.empty())
            return Wait{};
        m_report.stage = SequenceStage::Done;
        return End{};
    }
    if (!m_rowBegan)
        m_rowBegan = now;
    return std::visit([&](const auto& action) { return perform(action, modules, now); }, *row);
}

/// Behind the last row of a called sequence its caller goes on; null behind that of the first one.
const Action* SequenceRun::currentRow() {
    for (;;) {
        SequenceReport::Place& place = m_report.places.back();
        const Sequence* sequence = m_machine.program.sequence(place.sequence);
        if (sequence != nullptr && place.row < sequence->rows.size())
            return &sequence->rows[place.row];
        if (m_report.places.size() == 1)
            return nullptr;
        m_report.places.pop_back();
        ++m_report.places.back().row;
    }
}

/// The place is the next row's already, or that of a sequence that was called.
SequenceRun::Next SequenceRun::rowDone() {
    m_rowSent = false;
    m_rowAxis = 0;
    m_rowBegan.reset();
    std::ignore = currentRow();
    if (m_pauseWanted)
        m_report.stage = SequenceStage::Pausing;
    return Wait{};
}

SequenceRun::Next SequenceRun::send(std::vector<std::vector<bus::Order>> operations) {
    m_inFlight = static_cast<unsigned>(operations.size());
    return Send{std::move(operations)};
}

SequenceRun::Next SequenceRun::refused(ModuleIndex module, Refusal refusal) {
    if (refusal == Refusal::Unresponsive)
        endBy(SequenceEnd::Unresponsive, module);
    else
        endBy(SequenceEnd::Refused, module, refusal);
    return Wait{};
}

// ---- the rows ----

bool SequenceRun::anyMoves(const std::vector<PointAxis>& axes) const {
    return std::ranges::any_of(axes, [this](const PointAxis& axis) { return m_moves.contains(axis.module); });
}

SequenceRun::Next SequenceRun::sendMoves(const std::vector<PointAxis>& axes, unsigned percent,
                                         const Modules& modules) {
    std::vector<bus::Order> steps;
    std::map<ModuleIndex, Move> moves;
    for (const PointAxis& axis : axes) {
        const ModuleState* module = moduleAt(axis.module, modules);
        if (module == nullptr)
            return refused(axis.module, Refusal::Unresponsive);
        const auto wanted = moveIntent(axis, percent, *module, m_machine.axis(axis.module));
        if (!wanted)
            return refused(axis.module, wanted.error());
        auto planned = plan(*wanted, *module);
        if (!planned)
            return refused(axis.module, planned.error());
        const std::int32_t goal = *goalOf(axis, *module);
        m_on.insert(axis.module);
        if (module->isStepper() && module->stepper.position() == goal)
            continue;  // it is there, and a motion of no steps is none
        moves[axis.module] = {.goal = goal,
                              .closedBefore = {module->limits.ranInto(0), module->limits.ranInto(1)}};
        steps.insert(steps.end(), planned->begin(), planned->end());
    }
    if (steps.empty())
        return Wait{};
    startsLast(steps);
    m_moves.merge(moves);
    return send({std::move(steps)});
}

SequenceRun::Next SequenceRun::perform(const action::MoveTo& move, const Modules& modules,
                                       TimePoint /*now*/) {
    const Point* point = m_machine.program.point(move.point);
    const std::vector<PointAxis>& axes = point->axes;
    if (move.together) {
        if (!m_rowSent) {
            if (anyMoves(axes))
                return Wait{};  // of a row above that was not waited for
            m_rowSent = true;
            return sendMoves(axes, move.percent, modules);
        }
        if (move.waits && anyMoves(axes))
            return Wait{};
    } else {
        if (m_rowAxis < axes.size()) {
            const bool before = m_rowAxis > 0 && m_moves.contains(axes[m_rowAxis - 1].module);
            if (before || m_moves.contains(axes[m_rowAxis].module))
                return Wait{};
            return sendMoves({axes[m_rowAxis++]}, move.percent, modules);
        }
        if (move.waits && anyMoves(axes))
            return Wait{};
    }
    ++m_report.places.back().row;
    return rowDone();
}

SequenceRun::Next SequenceRun::perform(const action::Wait& wait, const Modules& /*modules*/, TimePoint now) {
    if (toSeconds(now - *m_rowBegan) < wait.seconds)
        return Wait{};
    ++m_report.places.back().row;
    return rowDone();
}

SequenceRun::Next SequenceRun::perform(const action::WaitForArrival& /*wait*/, const Modules& /*modules*/,
                                       TimePoint /*now*/) {
    if (!m_moves.empty())
        return Wait{};
    ++m_report.places.back().row;
    return rowDone();
}

SequenceRun::Next SequenceRun::perform(const action::WaitForInput& wait, const Modules& modules,
                                       TimePoint now) {
    const ModuleState* module = moduleAt(wait.module, modules);
    const auto level = module != nullptr ? readPin(wait.pin, *module) : std::nullopt;
    if (level != wait.active) {
        if (toSeconds(now - *m_rowBegan) >= wait.timeout)
            endBy(SequenceEnd::InputTimeout, wait.module);
        return Wait{};
    }
    ++m_report.places.back().row;
    return rowDone();
}

SequenceRun::Next SequenceRun::perform(const action::WaitForAnalog& wait, const Modules& modules,
                                       TimePoint now) {
    const ModuleState* module = moduleAt(wait.module, modules);
    if (module == nullptr || !isMet(wait, *module)) {
        if (toSeconds(now - *m_rowBegan) >= wait.timeout)
            endBy(SequenceEnd::AnalogTimeout, wait.module);
        return Wait{};
    }
    ++m_report.places.back().row;
    return rowDone();
}

SequenceRun::Next SequenceRun::perform(const action::SetOutput& set, const Modules& modules,
                                       TimePoint /*now*/) {
    if (!std::exchange(m_rowSent, true)) {
        const ModuleState& module = modules[set.module.value()];
        const auto intent = outputIntent(set, module);
        if (!intent)
            return refused(set.module, Refusal::NotAStepper);
        auto steps = plan(*intent, module);
        if (!steps)
            return refused(set.module, steps.error());
        return send({std::move(*steps)});
    }
    ++m_report.places.back().row;
    return rowDone();
}

SequenceRun::Next SequenceRun::perform(const action::Home& home, const Modules& /*modules*/,
                                       TimePoint /*now*/) {
    if (!m_rowSent) {
        if (m_moves.contains(home.module))
            return Wait{};
        m_rowSent = true;
        m_on.erase(home.module);  // finding home may switch it off for a while
        m_procedure = home.module;
        m_procedureEnd.reset();
        return Ask{home.module, homeIntent(m_machine.axis(home.module))};
    }
    if (!m_procedureEnd)
        return Wait{};
    m_procedure.reset();
    if (m_procedureEnd->stage == ProcedureStage::Failed)
        endBy(SequenceEnd::NotHomed, home.module);
    else if (m_procedureEnd->stage == ProcedureStage::Cancelled)
        endBy(SequenceEnd::TakenOver, home.module);
    if (ending())
        return Wait{};
    ++m_report.places.back().row;
    return rowDone();
}

SequenceRun::Next SequenceRun::perform(const action::Repeat& repeat, const Modules& /*modules*/,
                                       TimePoint /*now*/) {
    SequenceReport::Place& place = m_report.places.back();
    const unsigned done = place.rounds[place.row] + 1;
    if (repeat.times != 0 && done >= repeat.times) {
        place.rounds.erase(place.row);
        ++place.row;
    } else {
        place.rounds[place.row] = done;
        place.row = repeat.from;
    }
    return rowDone();
}

SequenceRun::Next SequenceRun::perform(const action::Call& call, const Modules& /*modules*/,
                                       TimePoint /*now*/) {
    m_report.places.push_back({call.sequence, 0});
    return rowDone();
}

}  // namespace nmc
