// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes decide what an operator does, what goes wrong with a simulated chain, and when: whatever happens,
// the engine observes the universal nevers of the fault catalogue (tests/faults/catalogue.md).
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>

#include "tests/faults/faultybus.h"
#include "tests/faults/truth.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

void expect(bool condition, const char* what) {
    if (condition)
        return;
    std::fprintf(stderr, "session_fuzz: %s\n", what);
    std::abort();
}

/// The fuzzer's bytes, one after the other; zeros after the end.
class Input {
public:
    explicit Input(ByteSpan bytes) : m_bytes(bytes) {}
    [[nodiscard]] bool atEnd() const { return m_at >= m_bytes.size(); }
    std::uint8_t next() { return atEnd() ? std::uint8_t{0} : m_bytes[m_at++]; }

private:
    ByteSpan m_bytes;
    std::size_t m_at = 0;
};

/// What a line affects, and therefore what can no longer be required of the engine.
enum class Harm : std::uint8_t { None, Commands, Samples };
struct FaultLine {
    const char* text;
    Harm harm;
};
/// No line lasts: the engine has to survive what follows as well.
constexpr std::array kFaultLines{
    FaultLine{"bus drop status p=.2 for=1s", Harm::None},
    FaultLine{"bus flip status p=.2 for=1s", Harm::None},
    FaultLine{"bus truncate status p=.2 for=1s", Harm::None},
    FaultLine{"bus silent for=300ms", Harm::None},
    FaultLine{"bus silent for=5s", Harm::None},
    FaultLine{"module 1 silent for=2s", Harm::None},
    FaultLine{"bus cksum p=.2 for=1s", Harm::None},
    FaultLine{"bus mute rx for=400ms", Harm::None},
    FaultLine{"bus mute tx for=400ms", Harm::None},
    FaultLine{"module 1 ignore=start_motion n=1", Harm::None},
    FaultLine{"bus drop cmd p=.2 for=1s", Harm::Commands},
    FaultLine{"bus dup cmd p=.2 for=1s", Harm::Commands},
    FaultLine{"bus flip cmd p=.2 for=1s", Harm::Commands},
    FaultLine{"bus truncate cmd p=.2 for=1s", Harm::Commands},
    FaultLine{"bus overrun p=.2 for=1s", Harm::Commands},
    FaultLine{"bus dup status p=.2 for=1s", Harm::Samples},
    FaultLine{"bus delay p=.2 t=5ms..90ms for=1s", Harm::Samples},
    FaultLine{"bus delay p=.2 t=90ms..400ms for=1s", Harm::Samples},
    FaultLine{"bus garbage status p=.2 for=1s", Harm::Samples},
    FaultLine{"bus noise status n=50", Harm::Samples},
    FaultLine{"bus break status for=100ms", Harm::Samples},
    FaultLine{"bus echo for=100ms", Harm::Samples},
    FaultLine{"bus foreign on=read_status n=5", Harm::Samples},
    FaultLine{"module 1 stuck for=500ms", Harm::Samples},
    FaultLine{"module 1 powercycle", Harm::Samples},
    FaultLine{"module 1 definestat", Harm::Samples},
};

constexpr unsigned kAttempts = 3;  ///< retry table: a refused command is sent at most three times

/// What was requested of one module since the connection began.
struct Asked {
    struct Count {
        unsigned asked = 0;
        unsigned sent = 0;
    };
    std::map<std::vector<std::uint8_t>, Count> packets;  ///< by their exact bytes
    bool held = false;
    bool on = false;  ///< has been on, or was commanded to be
};

class Session {
public:
    struct World {
        explicit World(Input& input)
            : chain(chainOf(input.next())),
              baud(input.next() % 2 == 0 ? 19'200U : 115'200U),
              seed(input.next()) {}
        std::vector<ModuleIdentity> chain;
        std::uint32_t baud;
        std::uint64_t seed;
    };

    explicit Session(Input& input) : Session(input, World(input)) {}
    Session(Input& input, const World& world)
        : m_input(input), m_bus(world.chain, world.baud, world.seed), m_asked(world.chain.size()) {
        if (m_bus.connectAndEnable() && Truth::spreadOut(m_bus))
            m_truth = std::make_unique<Truth>(m_bus);
        // What was done to get here was requested.
        newConnection();
        m_connecting = false;
        if (const auto chain = m_bus.last<ChainFound>())
            found(*chain);
        for (std::uint8_t i = 0; i < m_asked.size(); ++i) {
            m_asked[i].on = true;
            m_starts.push_back(m_bus.executed(i, CommandCode::StartMotion));
        }
        forget();
    }

    void run() {
        while (!m_input.atEnd()) {
            act();
            pass((1 + m_input.next()) * 1ms);
        }
        m_bus.clearFaults();
        m_bus.engine.release(m_bus.now);
        pass(1s);
        stop();
        pass(4s);
        expect(!m_stopPending, "N7: a stop without an end");
    }

private:
    static std::vector<ModuleIdentity> chainOf(std::uint8_t byte) {
        static const std::array<std::vector<ModuleIdentity>, 4> kChains{
            servos(1), servos(2), servos(2, 1), {{ModuleType::Servo, 4}, {ModuleType::Stepper, 1}}};
        return kChains[byte % kChains.size()];
    }

    void act();
    void submit(std::uint8_t module, std::vector<Order> orders);
    void found(const ChainFound& chain);
    void stop() {
        m_bus.engine.stopAll(m_bus.now);
        m_stopPending = true;
    }
    void newConnection() {
        // A stop that is under way continues, so what is on can still be stopped.
        for (Asked& asked : m_asked)
            asked = {{}, false, asked.on};
        m_connecting = true;
    }
    void pass(Duration time);
    void checkSent();
    void checkPacket(const std::vector<std::uint8_t>& bytes);
    void checkExecuted();
    void checkBounds(Duration time);
    void checkEvents();
    void forget();

    Input& m_input;
    FaultyBus m_bus;
    std::unique_ptr<Truth> m_truth;
    std::vector<Asked> m_asked;
    std::vector<std::uint64_t> m_starts;  ///< Start Motion commands requested since the session began
    std::vector<std::uint8_t> m_places;   ///< in the chain, of the modules that the engine has found
    bool m_connecting = true;
    bool m_stopPending = false;
    bool m_commandsHarmed = false;
    bool m_samplesHarmed = false;
    bool m_anyFault = false;
    std::size_t m_submitted = 0;
};

/// A faulty line may hide some modules of a chain: the engine's first module is then another one.
void Session::found(const ChainFound& chain) {
    m_places.clear();
    for (const ModuleInfo& info : chain.modules) {
        expect(info.address.value() >= 1 && info.address.value() <= m_asked.size(),
               "a module that is not there");
        m_places.push_back(static_cast<std::uint8_t>(info.address.value() - 1));
        if (m_places.back() != info.index.value())
            m_truth.reset();
    }
}

void Session::submit(std::uint8_t module, std::vector<Order> orders) {
    ++m_submitted;
    if (module >= m_places.size()) {
        m_bus.submit(std::move(orders));
        return;
    }
    Asked& asked = m_asked[m_places[module]];
    for (const Order& order : orders) {
        const Payload payload = std::visit([](const auto& c) { return encode(c); }, order.command);
        const PacketBytes packet =
            toPacket({BusAddress(static_cast<std::uint8_t>(m_places[module] + 1)), payload});
        ++asked.packets[{packet.begin(), packet.end()}].asked;
        m_starts[m_places[module]] += payload.code == CommandCode::StartMotion ? 1U : 0U;
        asked.on = asked.on || payload.code != CommandCode::SetGain;
    }
    m_bus.submit(std::move(orders));
}

void Session::act() {
    const std::uint8_t choice = m_input.next() % 16;
    const auto module = static_cast<std::uint8_t>(m_input.next() % m_asked.size());
    const bool isServo = m_bus.chain.identity(ModuleIndex(module)).type == ModuleType::Servo;
    const std::uint8_t value = m_input.next();
    const std::int32_t goal = Truth::placeOf(module) + (value - 128) * 16;
    switch (choice) {
        case 0:
            newConnection();
            return m_bus.engine.connect(m_bus.now);
        case 1:
            newConnection();
            m_truth.reset();  // positions are lost
            return restartNetwork(m_bus.engine, m_bus.now);
        case 2:
        case 3:
            return submit(module, {loadMove(module, goal), start(module)});
        case 4:
            return submit(module, {loadVelocity(module, value * 1'024U, true)});
        case 5:
            if (module < m_places.size())
                m_asked[m_places[module]].held = m_asked[m_places[module]].on = true;
            return m_bus.engine.hold(forward(module, value * 1'024U), m_bus.now);
        case 6:
            return m_bus.engine.release(m_bus.now);
        case 7:
            return stop();
        case 8:
            return submit(module, {gains(module), enable(module)});
        case 9:
            return submit(module, {motorOff(module)});
        case 10:
            return submit(module, {start(module)});
        case 11:
            return submit(module, {loadPwm(module, value)});
        case 12:
            if (isServo)
                m_bus.chain.set(ModuleIndex(module), value % 2 == 0 ? sim::Input::Power : sim::Input::Limit1,
                                value / 2 % 2, m_bus.now);
            return;
        case 13: {
            const std::vector<std::uint8_t> noise(value, m_input.next());
            m_anyFault = m_samplesHarmed = true;
            return m_bus.engine.onBytes(noise, m_bus.now);
        }
        default: {
            const FaultLine& line = kFaultLines[value % kFaultLines.size()];
            m_anyFault = true;
            m_commandsHarmed = m_commandsHarmed || line.harm == Harm::Commands;
            m_samplesHarmed = m_samplesHarmed || line.harm == Harm::Samples;
            if (m_bus.chain.faults().size() > 50)
                m_bus.clearFaults();
            return m_bus.fault(line.text);
        }
    }
}

void Session::pass(Duration time) {
    m_bus.runFor(time);
    const auto deadline = m_bus.engine.nextDeadline();
    expect(!deadline || *deadline > m_bus.now, "a deadline that has passed already");
    checkSent();
    checkExecuted();
    checkBounds(time);
    checkEvents();
    forget();
}

/// N1, N2 and N6, checked on what the engine sends.
void Session::checkSent() {
    for (const auto& sent : m_bus.sent)
        if (codeOf(sent.bytes))
            checkPacket(sent.bytes);
    for (std::uint8_t i = 0; i < m_asked.size(); ++i)
        m_asked[i].on = m_asked[i].on || m_bus.servo(i).servoOn;
}

void Session::checkPacket(const std::vector<std::uint8_t>& bytes) {
    const CommandCode code = *codeOf(bytes);
    if (code == CommandCode::SetAddress || code == CommandCode::HardReset || code == CommandCode::SetBaud)
        return expect(m_connecting, "N1: the chain was changed without being asked");
    const std::size_t module = bytes[1] - std::size_t{1};
    if (code == CommandCode::StopMotor && module < m_asked.size()) {
        constexpr std::uint8_t kAbruptly = 0x04, kSmoothly = 0x08, kHere = 0x10;
        const bool enables = (bytes[3] & (kAbruptly | kSmoothly | kHere)) != 0;
        return expect(!enables || m_asked[module].on, "N1: a stop that switches a servo on");
    }
    if (!changesSomething(code) || (code == CommandCode::StopMotor && module >= m_asked.size()))
        return;
    expect(module < m_asked.size(), "N1: a command to nobody or to all");
    Asked& asked = m_asked[module];
    const auto found = asked.packets.find(bytes);
    if (found == asked.packets.end())
        return expect(asked.held && code == CommandCode::LoadTrajectory, "N1: nobody asked for this command");
    // A load that starts nothing may be repeated after silence as well, nine times at most.
    const unsigned most = code == CommandCode::LoadTrajectory ? kAttempts * kAttempts : kAttempts;
    if (asked.held && code == CommandCode::LoadTrajectory)
        return;
    expect(++found->second.sent <= most * found->second.asked,
           "N6: repeated more often than the table allows");
}

/// N6, checked on what the modules have done: a start that was requested once is not carried out twice.
void Session::checkExecuted() {
    if (m_commandsHarmed)
        return;
    for (std::uint8_t i = 0; i < m_starts.size(); ++i)
        expect(m_bus.executed(i, CommandCode::StartMotion) <= m_starts[i], "N6: a start carried out twice");
    // A requested reset may also cut off an answer that is under way.
    for (const sim::Violation& v : m_bus.chain.violations().entries())
        if (!m_anyFault && codeOf(ByteSpan(v.bytes)) != CommandCode::HardReset) {
            std::fprintf(stderr, "%s %s\n", std::string(sim::toText(v.kind)).c_str(), toHex(v.bytes).c_str());
            expect(false, "a violation on a perfect line");
        }
}

/// N8.
void Session::checkBounds(Duration time) {
    constexpr double kEventsPerSecond = 6'000;  // about 700 exchanges, and what each may report
    constexpr double kBytesPerSecond = 11'600;  // 115 200 Bd
    constexpr double kSome = 400;
    const double seconds = toSeconds(time);
    std::size_t bytes = 0;
    for (const auto& sent : m_bus.sent)
        bytes += sent.bytes.size();
    expect(static_cast<double>(m_bus.events.size()) <
               kSome + seconds * kEventsPerSecond + static_cast<double>(m_submitted),
           "N8: a flood of events");
    expect(static_cast<double>(bytes) < kSome + seconds * kBytesPerSecond,
           "N8: more bytes than the wire takes");
}

/// N3, N4 and N7.
void Session::checkEvents() {
    for (const Event& event : m_bus.events) {
        if (std::holds_alternative<StopFinished>(event))
            m_stopPending = false;
        if (std::holds_alternative<ChainFound>(event) || std::holds_alternative<ConnectFailed>(event))
            m_connecting = false;
        if (const auto* chain = std::get_if<ChainFound>(&event))
            found(*chain);
    }
    if (!m_truth)
        return;
    m_truth->look();
    if (!m_samplesHarmed && !m_commandsHarmed) {
        if (m_truth->wrong() + m_truth->wrongPermissions() > 0)
            std::fprintf(stderr, "%s\n", m_truth->first().c_str());
        expect(m_truth->wrong() == 0, "N3: a sample that is not true");
        expect(m_truth->wrongPermissions() == 0, "N3: a permission that is not true");
    }
}

void Session::forget() {
    m_bus.sent.clear();
    if (m_truth)
        m_truth->lookAndForget();
    else
        m_bus.events.clear();
}

}  // namespace

}  // namespace nmc::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 200)
        return 0;                            // longer inputs find nothing new and are slow
    GTEST_FLAG_SET(throw_on_failure, true);  // VirtualBus reports trouble in gtest's way
    nmc::test::Input input({data, size});
    nmc::test::Session(input).run();
    return 0;
}
