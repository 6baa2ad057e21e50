// SPDX-License-Identifier: MIT
#include "link/command/commander.h"

#include <algorithm>
#include <utility>

#include "link/clock.h"
#include "model/intent/gainsplan.h"
#include "model/intent/homingplan.h"
#include "model/intent/rights.h"
#include "model/intent/travel.h"
#include "model/procedure/procedures.h"
#include "model/settings/pinsof.h"
#include "module/commandfacts.h"

namespace nmc {

namespace {

constexpr int kFocusIntervalMs = 1'000;
/// Time for the answer to a limit stop to appear in the module's state.
constexpr Duration kArmingShows = std::chrono::milliseconds(250);

[[nodiscard]] bool startsMotion(const std::vector<bus::Order>& orders) {
    return std::ranges::any_of(orders, [](const bus::Order& order) { return mayStartMotion(order.command); });
}

}  // namespace

Commander::Commander(BusStore& store, BusWorker& worker, QObject* parent)
    : QObject(parent),
      m_store(store),
      m_worker(worker),
      m_procedures(
          store, [this](Procedure::Send send) { return submit(std::move(send)); }, this),
      m_sequences(
          store, m_procedures,
          [this](std::vector<bus::Order> orders) { return submit({.id = {}, .orders = std::move(orders)}); },
          this) {
    m_focusTimer.setInterval(kFocusIntervalMs);
    connect(&m_focusTimer, &QTimer::timeout, this, &Commander::shareBus);
    connect(&m_store, &BusStore::linkChanged, this, &Commander::look);
    connect(&m_procedures, &ProcedureController::reported, this, &Commander::noteTest);
}

std::optional<bus::OperationId> Commander::carryOut(ModuleIndex index, const Intent& intent) {
    const ModuleState* module = m_store.module(index);
    if (module == nullptr)
        return std::nullopt;
    if (std::holds_alternative<intent::KeepGains>(intent)) {
        if (const Plan allowed = plan(intent, *module); !allowed) {
            emit refused(index, allowed.error(), intent);
            return std::nullopt;
        }
        m_procedures.keep(index);
        m_worker.keepTrial(index);
        return std::nullopt;
    }
    if (const auto* gains = std::get_if<intent::ApplyGains>(&intent);
        gains != nullptr && plan(intent, *module) &&
        m_procedures.take(index, gainsFor(*module, gains->gains))) {
        emit sent(index, intent);
        return std::nullopt;
    }
    const bool stops = isStop(intent);
    if (!std::holds_alternative<intent::AskAnew>(intent))
        m_sequences.takeOver(index, stops);
    if (!stops)
        m_procedures.cancel(index);
    if (std::holds_alternative<intent::CancelProcedure>(intent))
        return std::nullopt;
    if (auto procedure = procedureFor(intent, *module)) {
        // The previous procedure is still stopping its motor; a motion must not wait in a queue.
        if (!m_procedures.begin(std::move(procedure)))
            emit refused(index, Refusal::Moving, intent);
        return std::nullopt;
    }
    auto orders = plan(intent, *module);
    // That stop would be sent after the motion, and end it.
    if (orders && m_procedures.stopsLater(index) && startsMotion(*orders))
        orders = tl::unexpected(Refusal::Moving);
    if (!orders) {
        m_procedures.cancel(index);
        emit refused(index, orders.error(), intent);
        return std::nullopt;
    }
    if (std::holds_alternative<intent::ResetModule>(intent)) {
        m_worker.ask(ResetModule{index});
        return std::nullopt;
    }
    if (const auto* save = std::get_if<intent::SaveConfiguration>(&intent)) {
        m_worker.ask(ResetModule{index, save->configuration});
        return std::nullopt;
    }
    if (const auto* declare = std::get_if<intent::DeclarePosition>(&intent)) {
        m_store.declarePosition(index, declare->right);
        return std::nullopt;
    }
    const bus::OperationId id = submit({.id = {}, .orders = std::move(*orders)});
    emit sent(index, intent);
    if (stops)
        m_procedures.overtake(index);
    else
        m_store.noteAsked(index, id);
    return id;
}

bool Commander::stop(ModuleIndex index) {
    return sendStop(index).has_value();
}

std::optional<bus::OperationId> Commander::sendStop(ModuleIndex index) {
    const ModuleState* module = m_store.module(index);
    Orders orders = module != nullptr ? stopOf(*module) : Orders();
    m_sequences.takeOver(index, true);
    if (orders.empty()) {
        m_procedures.cancel(index);
        return std::nullopt;
    }
    const bus::OperationId id = submit({.id = {}, .orders = std::move(orders)});
    m_procedures.overtake(index);
    return id;
}

bool Commander::hold(const bus::HoldToMove& wanted) {
    const ModuleState* module = m_store.module(wanted.module);
    const auto hold = module != nullptr ? withinTravel(wanted, *module) : tl::unexpected(TravelProblem{});
    if (!hold || whyNot(IntentKind::Hold, *module))
        return false;
    m_sequences.takeOver(wanted.module, false);
    m_procedures.cancel(wanted.module);
    // As in carryOut(): that stop would be sent after the motion, and end it.
    if (m_procedures.stopsLater(wanted.module))
        return false;
    emit aboutToHold(wanted.module);
    m_held = {wanted.module, monotonicNow()};
    m_worker.hold(*hold);
    return true;
}

void Commander::command(const bus::GroupCommand& command) {
    using enum bus::GroupCommand::Action;
    const bus::OperationId id = nextId();
    const std::vector<ModuleIndex> members = membersOf(command.group);
    const bool stops = isStop(command.action);
    if (command.action == StartMotion)
        emit aboutToMove(id, members);
    // The runs end as in carryOut(), where a module is addressed by itself.
    for (const ModuleIndex module : members) {
        if (stops || command.action == ResetPosition)
            m_sequences.takeOver(module, stops);
        if (command.action == ResetPosition)
            m_procedures.cancel(module);
    }
    m_worker.ask(bus::GroupOperation{id, command});
    for (const ModuleIndex module : members)
        if (stops)
            m_procedures.overtake(module);
}

void Commander::change(const bus::GroupChange& change) {
    m_worker.ask(bus::GroupOperation{nextId(), change});
}

std::vector<ModuleIndex> Commander::membersOf(std::uint8_t group) const {
    std::vector<ModuleIndex> members;
    for (const ModuleState& module : m_store.link().modules)
        if (!module.info.group || module.info.group->group == group)
            members.push_back(module.info.index);
    return members;
}

void Commander::stopRuns() {
    m_sequences.stop();
    m_procedures.cancelAll();
}

void Commander::endRuns() {
    m_sequences.stopAll();
    m_procedures.stopAll();
}

void Commander::opened() {
    m_stopOutputs.clear();
    sendStopOutputs();
}

bool Commander::take(const StoreEvent& event) {
    const auto* finished = std::get_if<bus::OperationFinished>(&event);
    if (std::holds_alternative<bus::ChainFound>(event))
        m_travelLimits.clear();
    if (finished != nullptr || std::holds_alternative<bus::GroupFinished>(event)) {
        // The operation may have set a counter, in which case the bus has dropped the limits of that axis.
        m_travelLimits.clear();
        sendTravelLimits();
    }
    const bool ofProcedure = m_procedures.take(event);
    const bool ofSequence = m_sequences.take(event);
    if (finished == nullptr)
        return false;
    const bool ofTravel =
        std::erase(m_travelStops, finished->id) > 0 && finished->outcome == bus::Outcome::Done;
    return ofProcedure || ofSequence || ofTravel;
}

bus::OperationId Commander::submit(bus::Operation operation) {
    const bus::OperationId id = nextId();
    std::vector<ModuleIndex> moved;
    for (const bus::Order& order : operation.orders)
        if (mayStartMotion(order.command))
            moved.push_back(order.module);
    if (!moved.empty())
        emit aboutToMove(id, moved);
    operation.id = id;
    m_worker.ask(std::move(operation));
    return id;
}

void Commander::look() {
    sendStopOutputs();
    const LinkState& link = m_store.link();
    if (link.phase != LinkPhase::Connected || link.readOnly || link.lent)
        return;
    sendTravelLimits();
    stopBeyondTravel();
    for (const ModuleState& module : link.modules)
        if (!module.silent && !m_procedures.running(module.info.index))  // a procedure arms its own
            keepArmed(module);
}

/// The bus thread stops a motion that would leave its limits, even while this thread is busy. A procedure
/// observes the limits itself.
void Commander::sendTravelLimits() {
    std::vector<bus::TravelLimits> limits;
    for (const ModuleState& module : m_store.link().modules) {
        const auto range = m_procedures.running(module.info.index) ? std::nullopt : travelRange(module);
        limits.push_back(range.value_or(TravelRange{}));
    }
    if (limits == m_travelLimits)
        return;
    m_travelLimits = limits;
    m_worker.setTravelLimits(std::move(limits));
}

/// The bus stops only a motion without an end. A run towards a limit was sent as a move that ends there,
/// which would pass one that is set nearer meanwhile, as any other move would. A motion that is held ends
/// with its next call, which has another limit for its goal, and says so.
void Commander::stopBeyondTravel() {
    const std::vector<bus::TravelLimits> before = std::exchange(m_goalsWithin, m_travelLimits);
    std::vector<ModuleIndex> beyond;
    for (const ModuleState& module : m_store.link().modules) {
        const std::size_t place = module.info.index.value();
        const bool changed = place >= before.size() || before[place] != m_travelLimits[place];
        const auto position = module.position();
        const auto goal = module.goal();
        const bool held = m_held && m_held->first == module.info.index &&
                          monotonicNow() - m_held->second < bus::EngineConfig{}.holdTimeout;
        if (changed && !held && module.moving() && position && goal &&
            beyondTravel(*position, *goal, m_travelLimits[place]))
            beyond.push_back(module.info.index);
    }
    for (const ModuleIndex module : beyond)
        if (const auto id = sendStop(module)) {
            m_travelStops.push_back(*id);
            emit stoppedBeyondTravel(module);
        }
}

/// The bus thread must know them before the stop is requested.
void Commander::sendStopOutputs() {
    std::vector<bus::StopOutputs> outputs;
    for (const AxisSettings& axis : m_store.machine().axes) {
        const PinSettings& pins = pinsOf(axis);
        outputs.push_back(
            {PinSettings::offAtStop(pins.pins), static_cast<std::uint8_t>(PinSettings::offAtStop(pins.pwm))});
    }
    if (outputs == m_stopOutputs)
        return;
    m_stopOutputs = outputs;
    m_worker.setStopOutputs(std::move(outputs));
}

void Commander::keepArmed(const ModuleState& module) {
    const auto arm = limitStopDue(module);
    if (!arm || module.awaited)
        return;
    const TimePoint now = monotonicNow();
    const auto last = m_armedAt.find(module.info.index);
    if (last != m_armedAt.end() && now - last->second < kArmingShows)
        return;
    m_armedAt[module.info.index] = now;
    if (auto orders = plan(*arm, asOfPanel(module)))
        submit({.id = {}, .orders = std::move(*orders)});
}

void Commander::noteTest(const ProcedureReport& report) {
    if (!isTest(report.kind))
        return;
    if (report.over())
        m_tested.erase(report.module);
    else
        m_tested.insert(report.module);
    shareBus();
    if (m_tested.empty())
        m_focusTimer.stop();
    else if (!m_focusTimer.isActive())
        m_focusTimer.start();
}

/// While another motor moves or is tested, that one is polled as often as ever, so this one gets fewer
/// samples.
void Commander::shareBus() {
    const std::vector<ModuleState>& modules = m_store.link().modules;
    const bool alone =
        m_tested.size() == 1 && std::ranges::none_of(modules, [this](const ModuleState& other) {
            return m_tested.count(other.info.index) == 0 && other.moving();
        });
    const auto focused = alone ? std::optional(*m_tested.begin()) : std::nullopt;
    m_worker.focus(focused);
    m_store.noteFocus(focused);
}

}  // namespace nmc
