// SPDX-License-Identifier: MIT
#include "model/sequence/sequencerun.h"

#include <algorithm>
#include <utility>

#include "base/overloaded.h"
#include "model/intent/homingplan.h"

namespace nmc {

namespace {

/// Time for a limit stop that is due to be armed. Without a problem, it takes some milliseconds.
constexpr Duration kArmedWithin = std::chrono::seconds(2);

/// Puts the starts after all loads, so that a refused load leaves every motor where it is.
void startsLast(std::vector<bus::Order>& steps) {
    std::stable_partition(steps.begin(), steps.end(),
                          [](const bus::Order& step) { return !is<StartMotion>(step.command); });
}

LimitWatch::Limits limitsRunInto(const ModuleState& module) {
    return {module.limits.ranInto(0), module.limits.ranInto(1)};
}

SequenceEnd timeoutOf(const action::WaitForInput& /*wait*/) {
    return SequenceEnd::InputTimeout;
}
SequenceEnd timeoutOf(const action::WaitForAnalog& /*wait*/) {
    return SequenceEnd::AnalogTimeout;
}

/// For a row that has nothing to send and is done as soon as its condition is met.
std::optional<SequenceRun::Next> waitUntil(bool there) {
    return there ? std::nullopt : std::optional<SequenceRun::Next>(SequenceRun::Wait{});
}

}  // namespace

SequenceRun::SequenceRun(Machine machine, const std::string& sequence, std::size_t row, bool singleStep)
    : m_machine(std::move(machine)),
      m_parts(modulesOf(m_machine.program, sequence)),
      m_pauseWanted(singleStep) {
    m_report.places.push_back({sequence, row});
}

SequenceRun SequenceRun::toPoint(Machine machine, const std::string& point) {
    SequenceRun run(withMoveTo(std::move(machine), point), kMoveToPoint, 0);
    run.m_report.point = point;
    return run;
}

SequenceRun SequenceRun::homing(Machine machine, const std::vector<ModuleIndex>& axes) {
    Sequence homing{kHomeAll, {}};
    for (const ModuleIndex axis : axes)
        homing.rows.emplace_back(action::Home{axis});
    machine.program.sequences.push_back(std::move(homing));
    return {std::move(machine), kHomeAll, 0};
}

// ---- Results and events ----

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
    if (outcome == bus::Outcome::QueueFull)
        for (auto& [index, move] : m_moves)
            move.toStop = true;  // if it was one of the stops, they still have to go out
    if (outcome == bus::Outcome::Done)
        return;
    if (outcome == bus::Outcome::Cancelled)
        endBy(SequenceEnd::TakenOver, module);  // by a stop of any kind
    else
        endBy(SequenceEnd::NotExecuted, module);
}

void SequenceRun::onProcedure(const ProcedureReport& report) {
    // The end of a trial may come only when what the sequence asked for has begun.
    const bool own = m_procedure == report.module && report.kind != ProcedureKind::TryGains;
    if (own && report.over())
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
    endBy(SequenceEnd::Closed);
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
    m_pauseWanted = false;
    if (m_report.stage == SequenceStage::Pausing || m_report.stage == SequenceStage::Paused)
        m_report.stage = SequenceStage::Running;
}

void SequenceRun::step() {
    if (m_report.stage != SequenceStage::Paused)
        return;
    m_pauseWanted = true;
    m_report.stage = SequenceStage::Running;
}

void SequenceRun::stop() {
    endBy(SequenceEnd::ByUser);
}

// ---- The next request ----

SequenceRun::Next SequenceRun::next(const Modules& modules, TimePoint now) {
    if (m_report.over())
        return Wait{};
    if (!ending()) {
        // The next reply decides whether this is a failure (docs/link.md 2.4).
        if (std::ranges::any_of(modules, [this](const ModuleState& module) {
                return takesPart(module.info.index) && module.maybeOff();
            }))
            return Wait{};
        watch(modules, now);
    }
    if (ending())
        return finishEnding(modules);
    if (m_inFlight > 0)
        return Wait{};
    if (RowNext back = turnRound(modules, now))
        return m_report.end ? finishEnding(modules) : *std::move(back);
    if (m_report.stage == SequenceStage::Pausing && !m_row.began && row() != nullptr) {
        m_report.stage = m_moves.empty() ? SequenceStage::Paused : SequenceStage::Pausing;
        return Wait{};
    }
    if (m_report.stage == SequenceStage::Paused)
        return Wait{};
    Next next = proceed(modules, now);
    return m_report.end ? finishEnding(modules) : next;
}

/// A procedure stops its own motor; the other motors that may be moving are sent a stop. Neither waits for
/// the other, or for the result of an order, which a silent module may delay by a second.
SequenceRun::Next SequenceRun::finishEnding(const Modules& modules) {
    const bool inProcedure = m_procedure && !m_procedureEnd;
    if (inProcedure && !m_saysNothingMore && !std::exchange(m_cancelled, true))
        return Ask{*m_procedure, intent::CancelProcedure{}};
    if (!m_saysNothingMore) {
        const bool all = !std::exchange(m_stopsSent, true) || m_inFlight == 0;
        std::vector<std::vector<bus::Order>> stops;
        for (auto& [index, move] : m_moves) {
            const bool due = std::exchange(move.stopWaits, false) || all;
            // What is in flight to this motor may start it after this stop, so another one follows.
            const bool again = m_inFlight > 0 && !move.since;
            const ModuleState* module = moduleAt(index, modules);
            if (!due || !move.toStop || module == nullptr || m_leftAlone.contains(index))
                continue;
            // To a motor that is off, no stop is sent; the next reply decides whether it is.
            move.stopWaits = module->maybeOff();
            if (move.stopWaits)
                continue;
            move.toStop = again;
            if (auto steps = stopOf(*module); !steps.empty())
                stops.push_back(std::move(steps));
        }
        if (!stops.empty())
            return send(std::move(stops));
    }
    const bool waits = std::ranges::any_of(m_moves, [](const auto& entry) { return entry.second.stopWaits; });
    if (!m_saysNothingMore && (inProcedure || m_inFlight > 0 || waits))
        return Wait{};
    m_report.stage = SequenceStage::Over;
    return Wait{};
}

/// Ends the run if a module is no longer as the run left it, whatever the cause.
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
        const bool arrived = hasArrived(modules[move->first.value()], move->second, now);
        move->second.turns = arrived && move->second.then;
        move = arrived && !move->second.then ? m_moves.erase(move) : std::next(move);
    }
}

/// Ends the run if the motor can no longer arrive.
bool SequenceRun::hasArrived(const ModuleState& module, Move& move, TimePoint now) {
    const ModuleIndex index = module.info.index;
    if (!move.since)
        move.since = now;
    // A limit that was closed before the move does not count, because the motor may be leaving it.
    for (std::size_t limit = 0; limit < move.closedBefore.size(); ++limit)
        if (module.limits.ranInto(limit) && !move.closedBefore[limit])
            endBy(SequenceEnd::LimitClosed, index);
    // The goal is no longer that of this run: something else moves the motor or has stopped it.
    if (!ending() && module.isServo() && !module.headsFor(move.goal)) {
        m_leftAlone.insert(index);
        endBy(SequenceEnd::NotArrived, index);
    }
    if (ending() || module.latestTime <= *move.since || !module.latest->position)
        return false;
    const Arrival::State arrival = move.arrival.look(module, move.goal, m_machine.axis(index).arrival);
    if (arrival == Arrival::State::Missed)
        endBy(SequenceEnd::NotSettled, index);
    else if (arrival == Arrival::State::There && module.isStepper() && module.stepper.position() != move.goal)
        endBy(SequenceEnd::NotArrived, index);
    return arrival == Arrival::State::There && !ending();
}

SequenceRun::Next SequenceRun::proceed(const Modules& modules, TimePoint now) {
    if (row() == nullptr) {
        if (m_moves.empty())
            m_report.stage = SequenceStage::Done;
        return Wait{};
    }
    if (!m_row.began)
        m_row.began = now;
    if (RowNext wanted = perform(*row(), modules, now))
        return *std::move(wanted);
    m_row = {};
    goOn(m_machine.program, m_report.places);
    if (m_pauseWanted)
        m_report.stage = SequenceStage::Pausing;
    return Wait{};
}

SequenceRun::Next SequenceRun::send(std::vector<std::vector<bus::Order>> operations) {
    m_inFlight += static_cast<unsigned>(operations.size());
    return Send{std::move(operations)};
}

SequenceRun::Next SequenceRun::refused(ModuleIndex module, Refusal refusal) {
    if (refusal == Refusal::Unresponsive)
        endBy(SequenceEnd::Unresponsive, module);
    else
        endBy(SequenceEnd::Refused, module, refusal);
    return Wait{};
}

// ---- The rows ----

/// All modules of the run are present: watch() has checked that.
SequenceRun::RowNext SequenceRun::perform(const Action& row, const Modules& modules, TimePoint now) {
    const double seconds = toSeconds(now - *m_row.began);
    return std::visit(
        Overloaded{
            [&](const action::MoveTo& move) { return moveTo(move, modules, now); },
            [&](const action::Wait& wait) { return waitUntil(seconds >= wait.seconds); },
            [&](const action::WaitForArrival&) { return waitUntil(m_moves.empty()); },
            [&](const AnyOf<action::WaitForInput, action::WaitForAnalog> auto& wait) {
                const bool met = isMet(wait, modules[wait.module.value()]);
                if (!met && seconds >= wait.timeout) {
                    endBy(timeoutOf(wait), wait.module);
                    m_report.awaited = wait;
                }
                return waitUntil(met);
            },
            [&](const action::SetOutput& set) { return setOutput(set, modules[set.module.value()]); },
            [&](const action::Home& home) { return findHome(home); },
            [](const AnyOf<action::Repeat, action::Call> auto&) { return RowNext(); },
        },
        row);
}

bool SequenceRun::anyMoves(std::span<const PointAxis> axes) const {
    return std::ranges::any_of(axes, [this](const PointAxis& axis) { return m_moves.contains(axis.module); });
}

/// At standstill, the panel arms the limit stop of an axis that uses one for each motion, also after a home
/// search, which has replaced it. No motion starts before that.
bool SequenceRun::awaitsLimitStop(const ModuleState& module, TimePoint now) {
    if (!limitStopDue(module)) {
        m_unarmed.erase(module.info.index);
        return false;
    }
    const auto since = m_unarmed.try_emplace(module.info.index, now).first->second;
    return now - since < kArmedWithin;
}

SequenceRun::Next SequenceRun::sendMoves(std::span<const PointAxis> axes, unsigned percent,
                                         const Modules& modules) {
    std::vector<bus::Order> steps;
    std::map<ModuleIndex, Move> moves;
    for (const PointAxis& axis : axes) {
        const ModuleState& module = modules[axis.module.value()];
        const auto planned = planMove(axis, percent, module, m_machine.axis(axis.module));
        if (!planned)
            return refused(axis.module, planned.error());
        m_on.insert(axis.module);
        if (module.isStepper() && module.stepper.position() == planned->goal)
            continue;  // already there; a move of zero steps is not a motion
        moves[axis.module] = {
            .goal = planned->goal, .closedBefore = limitsRunInto(module), .then = planned->then};
        steps.insert(steps.end(), planned->orders.begin(), planned->orders.end());
    }
    if (steps.empty())
        return Wait{};
    startsLast(steps);
    m_moves.merge(moves);
    return send({std::move(steps)});
}

/// Sends back the motors that have arrived where they turn round, whichever row is in progress and even if a
/// pause is wanted. They arrive there at different times, so each one starts on its own.
SequenceRun::RowNext SequenceRun::turnRound(const Modules& modules, TimePoint now) {
    std::vector<std::vector<bus::Order>> operations;
    for (auto& [index, move] : m_moves) {
        const ModuleState& module = modules[index.value()];
        if (!move.turns || awaitsLimitStop(module, now))
            continue;
        const Leg back = *move.then;
        auto planned = planLeg(back, module);
        if (!planned)
            return refused(index, planned.error());
        move = {.goal = back.goal, .closedBefore = limitsRunInto(module)};
        operations.push_back(std::move(*planned));
    }
    if (operations.empty())
        return std::nullopt;
    return send(std::move(operations));
}

SequenceRun::RowNext SequenceRun::moveTo(const action::MoveTo& move, const Modules& modules, TimePoint now) {
    const std::span<const PointAxis> axes = m_machine.program.point(move.point)->axes;
    if (m_row.sent == axes.size())
        return waitUntil(!move.waits || !anyMoves(axes));
    const std::size_t count = move.together ? axes.size() : 1;
    // A row above may have moved these axes without waiting. If axes move one after the other, this row has
    // moved the previous one.
    const std::size_t before = m_row.sent > 0 ? 1 : 0;
    if (anyMoves(axes.subspan(m_row.sent - before, before + count)))
        return Wait{};
    const auto next = axes.subspan(m_row.sent, count);
    if (std::ranges::any_of(
            next, [&](const PointAxis& axis) { return awaitsLimitStop(modules[axis.module.value()], now); }))
        return Wait{};
    // Home may have been found in this run, or by other means, since the run was checked.
    for (const PointAxis& axis : axes.subspan(m_row.sent))
        if (taughtElsewhere(axis, modules[axis.module.value()])) {
            m_report.taught = move.point;
            endBy(SequenceEnd::TaughtElsewhere, axis.module);
            return Wait{};
        }
    m_row.sent += count;
    return sendMoves(next, move.percent, modules);
}

SequenceRun::RowNext SequenceRun::setOutput(const action::SetOutput& set, const ModuleState& module) {
    if (m_row.sent++ > 0)
        return std::nullopt;
    const auto intent = outputIntent(set, module);
    if (!intent) {
        const bool unknown = intent.error() == SequenceProblem::Kind::OutputsUnknown;
        endBy(unknown ? SequenceEnd::OutputsUnknown : SequenceEnd::NotAnOutput, set.module);
        return Wait{};
    }
    auto steps = plan(*intent, module);
    if (!steps)
        return refused(set.module, steps.error());
    return send({std::move(*steps)});
}

SequenceRun::RowNext SequenceRun::findHome(const action::Home& home) {
    if (m_row.sent == 0) {
        if (m_moves.contains(home.module))
            return Wait{};
        m_row.sent = 1;
        m_on.erase(home.module);  // the procedure may switch the motor off for a while
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
    return waitUntil(!ending());
}

}  // namespace nmc
