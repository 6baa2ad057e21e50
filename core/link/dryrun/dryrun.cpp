// SPDX-License-Identifier: MIT
#include "link/dryrun/dryrun.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "bus/engine.h"
#include "model/intent/backlash.h"
#include "model/sequence/sequencenews.h"
#include "sim/chain.h"

namespace nmc {

namespace {

/// The interval at which the sequence controller runs.
constexpr Duration kTurn = std::chrono::milliseconds(20);
constexpr Duration kSettling = std::chrono::milliseconds(200);
constexpr Duration kPatience = std::chrono::seconds(20);

/// Engine and simulated chain, both in virtual time.
class Bus {
public:
    Bus(const std::vector<ModuleIdentity>& identities, std::uint32_t baud)
        : m_engine(bus::EngineConfig{.baud = baud}), m_chain(identities) {}

    [[nodiscard]] sim::Chain& simulated() { return m_chain; }
    [[nodiscard]] TimePoint now() const { return m_now; }
    void connect() { m_engine.connect(m_now); }
    bus::OperationId submit(std::vector<bus::Order> orders) {
        const bus::OperationId id(++m_lastId);
        m_engine.submit({id, std::move(orders)}, m_now);
        carryOut();
        return id;
    }
    std::vector<bus::Event> runFor(Duration time) {
        const TimePoint end = m_now + time;
        carryOut();
        while (m_now < end)
            step(end);
        return std::exchange(m_events, {});
    }

private:
    void step(TimePoint end) {
        const auto arrival = m_arriving.empty() ? std::nullopt : std::optional(m_arriving.front().due);
        m_now = std::max(m_now, *earliest({end, m_engine.nextDeadline(), m_chain.nextEvent(), arrival}));
        m_chain.advanceTo(m_now);
        for (const sim::HostByte& byte : m_chain.takeHostBytes())
            m_arriving.push_back(byte);
        std::vector<std::uint8_t> bytes;
        for (; !m_arriving.empty() && m_arriving.front().due <= m_now; m_arriving.pop_front())
            bytes.push_back(m_arriving.front().value);
        if (!bytes.empty())
            m_engine.onBytes(bytes, m_now);
        carryOut();
        if (const auto deadline = m_engine.nextDeadline(); deadline && *deadline <= m_now)
            m_engine.onDeadline(m_now);
        carryOut();
    }
    void carryOut() {
        for (const bus::Output& output : m_engine.takeOutput())
            std::visit(Overloaded{
                           [this](const bus::SetHostBaud& rate) { m_chain.setHostBaud(rate.baud); },
                           [this](const bus::Send& send) { m_chain.hostSends(send.bytes, m_now); },
                           [this](const bus::DiscardInput&) { m_arriving.clear(); },
                       },
                       output);
        for (bus::Event& event : m_engine.takeEvents())
            m_events.push_back(std::move(event));
    }

    bus::Engine m_engine;
    sim::Chain m_chain;
    TimePoint m_now{};
    std::deque<sim::HostByte> m_arriving;
    std::vector<bus::Event> m_events;
    std::uint32_t m_lastId = 0;
};

/// A module without a data sheet does not take part; a servo takes its place in the chain.
std::vector<ModuleIdentity> identitiesOf(const std::vector<ModuleState>& modules) {
    std::vector<ModuleIdentity> identities;
    for (const ModuleState& module : modules)
        identities.push_back(module.isKnown() ? module.info.identity : ModuleIdentity{ModuleType::Servo, 4});
    return identities;
}

class Copy {
public:
    Copy(const DryRunStart& start, const std::atomic<bool>& cancelled)
        : m_start(start), m_cancelled(cancelled), m_bus(identitiesOf(start.modules), start.baud) {}

    DryRun run() && {
        m_result.problems = whyNotRun(m_start.sequence, m_start.row, m_start.machine, m_start.modules);
        if (!m_result.problems.empty() || !setUp())
            return std::move(m_result);
        m_run.emplace(machineOfCopy(), m_start.sequence, m_start.row);
        for (const ModuleState& module : m_modules)
            m_result.axes.push_back(
                {module.info.index, origin(module.info.index), origin(module.info.index), 0.0, 0});
        const TimePoint began = m_bus.now();
        while (turn() && !m_cancelled && !m_result.tooLong)
            m_result.tooLong = toSeconds(m_bus.now() - began) > m_start.longest;
        m_result.cancelled = m_cancelled;
        m_result.seconds = toSeconds(m_bus.now() - began);
        m_result.report = m_run->report();
        if (const auto& module = m_result.report.module; module && m_leftOff.contains(*module))
            m_result.leftOff = m_leftOff.at(*module);
        std::erase_if(m_result.axes, [](const DryRun::Axis& axis) { return axis.moves == 0; });
        return std::move(m_result);
    }

private:
    /// The position from which the axis starts, which is 0 in the copy: the one that it holds, whatever
    /// friction makes of it.
    [[nodiscard]] std::int32_t origin(ModuleIndex index) const {
        const ModuleState& module = m_start.modules[index.value()];
        return module.goal().value_or(module.position().value_or(0));
    }
    [[nodiscard]] Machine machineOfCopy() {
        Machine machine = m_start.machine;
        for (Point& point : machine.program.points)
            for (PointAxis& axis : point.axes)
                if (!axis.fromHome && axis.module.value() < m_start.modules.size())
                    axis.counts = countsBetween(origin(axis.module), axis.counts);
        for (Sequence& sequence : machine.program.sequences)
            for (Action& row : sequence.rows)
                if (auto* repeat = std::get_if<action::Repeat>(&row); repeat && repeat->times == 0) {
                    repeat->times = 1;
                    m_result.onceOnly = true;
                }
        return machine;
    }

    // ---- State transferred to the copy before the run ----

    bool setUp() {
        m_bus.connect();
        for (const TimePoint end = m_bus.now() + kPatience;
             m_modules.size() != m_start.modules.size() && m_bus.now() < end && !m_cancelled;)
            take(m_bus.runFor(kTurn));
        take(m_bus.runFor(kSettling));
        if (m_modules.size() != m_start.modules.size())
            return false;
        for (const ModuleState& module : m_start.modules)
            setUp(module);
        take(m_bus.runFor(kSettling));
        return true;
    }
    void setUp(const ModuleState& real) {
        const ModuleIndex index = real.info.index;
        setPins(real);
        setDirections(real);
        if (real.gains)
            submit(index, intent::ApplyGains{*real.gains});
        if (real.io)
            submit(index, intent::ControlIo{*real.io});
        if (real.scIo)
            submit(index, intent::ControlSc{*real.scIo});
        if (real.stepper.parameters)
            submit(index, stepperintent::SetParameters{*real.stepper.parameters});
        if (real.isStepper() && real.stepper.outputs)
            submit(index, stepperintent::SetOutputs{*real.stepper.outputs});
        if (real.driveOn())
            if (const auto refusal = submit(index, intent::Enable{}))
                m_leftOff[index] = *refusal;
        if (real.home.place())
            m_modules[index.value()].home.found(countsBetween(origin(index), real.home.place()->counts),
                                                m_modules[index.value()].latestTime);
        m_modules[index.value()].travel = real.travel;  // last, so that nothing of the above is refused
        m_modules[index.value()].backlash = real.backlash;
    }
    void setPins(const ModuleState& real) {
        const ModuleIndex index = real.info.index;
        for (unsigned i = 0; i <= static_cast<unsigned>(InputPin::Io12); ++i)
            if (const auto level = readPin(static_cast<InputPin>(i), real))
                setPin(index, static_cast<InputPin>(i), *level);
        for (unsigned input = 1; input <= io::kAnalogInputs; ++input)
            if (const auto value = readAnalog(input, real))
                simulate(index, sim::Input::Analog, *value, input);
        if (real.isStepper())
            simulate(index, sim::Input::Estop, real.stepper.inputs().estop() ? 1.0 : 0.0);
    }
    void setPin(ModuleIndex index, InputPin pin, bool level) {
        constexpr sim::Input kInputs[] = {sim::Input::Limit1, sim::Input::Limit2, sim::Input::In1,
                                          sim::Input::In2, sim::Input::HomeSwitch};
        const auto number = ioPin(pin);
        simulate(index, number ? sim::Input::Pin : kInputs[static_cast<std::size_t>(pin)], level ? 1.0 : 0.0,
                 number ? *number + 1 : 0);
    }
    void simulate(ModuleIndex index, sim::Input input, double value, unsigned number = 0) {
        m_bus.simulated().set(index, input, value, m_bus.now(), number);
    }
    /// Sets the pin directions and the output levels. If they are unknown, they are unknown to the copy as
    /// well.
    void setDirections(const ModuleState& real) {
        if (!real.isIo() || !real.pins.inputs || !real.latest)
            return;
        const ModuleIndex index = real.info.index;
        submit(index, iointent::SetDirection{*real.pins.inputs});
        const unsigned outputs = io::kAllPins & ~unsigned{*real.pins.inputs};
        const unsigned levels = real.pins.levels(*real.latest).value_or(0);
        for (unsigned pin = 0; pin < io::kPins; ++pin)
            if ((outputs & levels) >> pin & 1U)
                submit(index, iointent::SetOutput{pin, true});
    }
    /// A move goes straight to its goal, as a home search does. Returns why nothing was sent.
    std::optional<Refusal> submit(ModuleIndex index, const Intent& intent) {
        auto orders = plan(intent, withoutBacklash(m_modules[index.value()]));
        if (!orders)
            return orders.error();
        m_bus.submit(std::move(*orders));
        take(m_bus.runFor(kSettling));
        return std::nullopt;
    }

    // ---- The run ----

    bool turn() {
        take(m_bus.runFor(kTurn));
        if (m_run->row() != nullptr)
            assumeWaited(*m_run->row());
        SequenceRun::Next next = m_run->next(m_modules, m_bus.now());
        if (auto* send = std::get_if<SequenceRun::Send>(&next))
            for (std::vector<bus::Order>& orders : send->operations)
                m_own.push_back(m_bus.submit(std::move(orders)));
        if (const auto* ask = std::get_if<SequenceRun::Ask>(&next))
            assumeHome(*ask);
        return !m_run->report().over();
    }
    /// Makes the input that a row waits for occur at once. An analog value goes to the end of the converter's
    /// range, because one count beyond the level does not exist there.
    void assumeWaited(const Action& row) {
        const auto lacks = [this](const auto& wait) { return !isMet(wait, m_modules[wait.module.value()]); };
        if (const auto* wait = std::get_if<action::WaitForInput>(&row); wait != nullptr && lacks(*wait)) {
            setPin(wait->module, wait->pin, wait->active);
            m_result.inputsAssumed = true;
        }
        if (const auto* wait = std::get_if<action::WaitForAnalog>(&row); wait != nullptr && lacks(*wait)) {
            simulate(wait->module, sim::Input::Analog, wait->above ? 255.0 : 0.0, wait->input);
            m_result.inputsAssumed = true;
        }
    }
    /// Replaces a home search, which cannot be simulated because the position of the home switch is unknown.
    /// Home is where it is known to be, otherwise at the present position.
    void assumeHome(const SequenceRun::Ask& ask) {
        const auto* home = std::get_if<intent::Home>(&ask.intent);
        ModuleState& module = m_modules[ask.module.value()];
        if (home == nullptr)
            return;
        if (!std::ranges::count(m_result.homeAssumed, ask.module))
            m_result.homeAssumed.push_back(ask.module);
        if (!module.home.place())
            module.home.found(module.latest->position.value_or(0), module.latestTime);
        if (home->recipe.goToHome) {
            const PointAxis atHome{ask.module, 0, true};
            if (const auto move = moveIntent(atHome, 100, module, m_start.machine.axis(ask.module)))
                submit(ask.module, *move);
            for (const TimePoint end = m_bus.now() + kPatience;
                 module.moving() && m_bus.now() < end && !m_cancelled;)
                take(m_bus.runFor(kSettling));
        }
        m_run->onProcedure({.module = ask.module, .stage = ProcedureStage::Done});
    }

    // ---- Events from the copy ----

    void take(const std::vector<bus::Event>& events) {
        for (const bus::Event& event : events) {
            std::visit([this](const auto& news) { take(news); }, event);
            if (m_run)
                std::visit(SequenceNews{*m_run}, event);
        }
    }
    void take(const bus::ChainFound& found) {
        for (const bus::ModuleInfo& info : found.modules)
            m_modules.emplace_back().info = info;
    }
    void take(const bus::Sample& sample) {
        ModuleState& module = m_modules.at(sample.module.value());
        const auto before = module.position();
        module.apply(sample);
        if (!m_run || !before || !sample.report.position)
            return;
        DryRun::Axis& axis = m_result.axes[sample.module.value()];
        axis.travelled += std::abs(static_cast<double>(countsBetween(*before, *sample.report.position)));
        const std::int32_t place = countsBetween(-origin(sample.module), *sample.report.position);
        axis.lowest = std::min(axis.lowest, place);
        axis.highest = std::max(axis.highest, place);
    }
    void take(const bus::CommandExecuted& executed) {
        m_modules.at(executed.module.value()).apply(executed);
        if (m_run && is<StartMotion>(executed.command))
            ++m_result.axes[executed.module.value()].moves;
    }
    void take(const bus::ModuleUnresponsive& silence) {
        m_modules.at(silence.module.value()).silent = silence.silent;
    }
    void take(const bus::OperationFinished& finished) {
        if (m_run && std::erase(m_own, finished.id) > 0)
            m_run->onFinished(finished.module, finished.outcome);
    }
    template <typename Other>
    void take(const Other&) {}

    const DryRunStart& m_start;
    const std::atomic<bool>& m_cancelled;
    Bus m_bus;
    std::vector<ModuleState> m_modules;
    std::optional<SequenceRun> m_run;
    std::vector<bus::OperationId> m_own;
    std::map<ModuleIndex, Refusal> m_leftOff;  ///< motors that are on in reality, but not in the copy
    DryRun m_result;
};

}  // namespace

DryRun dryRun(const DryRunStart& start, const std::atomic<bool>& cancelled) {
    return Copy(start, cancelled).run();
}

}  // namespace nmc
