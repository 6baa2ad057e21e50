// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "tests/faults/faultybus.h"
#include "tests/sessions/lookoath.h"
#include "tests/sessions/owedoath.h"
#include "tests/sessions/stopoath.h"
#include "tests/sessions/wire.h"

namespace nmc::test {

/// Interval at which an oath looks at the motors.
inline constexpr Duration kLookEvery = std::chrono::milliseconds(20);

struct World {
    std::vector<ModuleIdentity> chain = servos(2);
    std::uint32_t baud = 19'200;
    Duration latency{};  ///< of the adapter
    bool deafWhenAddressInputRises = false;
    bool readOnly = false;  ///< the connection is read-only
    bool echoes = false;    ///< the adapter returns what is sent
    std::uint64_t seed = 1;
};

/// The chain that the engine reported last.
struct KnownChain {
    struct Module {
        std::uint8_t place = 0;  ///< in the simulator; kNowhere if no module has that address
        std::uint8_t address = 0;
    };
    static constexpr std::uint8_t kNowhere = 0xFF;
    std::vector<Module> modules;  ///< by ModuleIndex
    std::uint32_t baud = 0;
};

/// Engine and simulator, whatever is done to them, and what can be seen of them from outside: the wire, the
/// events, the motors. All of it is checked all the time against the oaths (stopoath.h, owedoath.h and, for a
/// read-only connection, lookoath.h); violations are added to `complaints`.
class Rig {
public:
    explicit Rig(const World& world);
    Rig(const Rig&) = delete;
    Rig& operator=(const Rig&) = delete;
    ~Rig();

    // What an operator does, or the panel on the operator's behalf.
    void connect();
    void restart();
    void changeRate(std::uint32_t baud);
    void distrust();
    void submit(std::vector<bus::Order> steps);
    void submit(std::variant<bus::GroupChange, bus::GroupCommand> what);
    /// Repeats the request every 100 ms until `time` has passed; then releases it, or lets it lapse.
    void hold(const bus::HoldToMove& hold, Duration time, bool lapses);
    void stopAll();
    /// Another program takes over: a new engine, which knows nothing.
    void replaceEngine(std::uint32_t baud, bool readOnly = false);

    // What happens to the chain.
    void powerCycle(std::uint8_t place);
    /// Injects a line of simulator.md and adds " for=..." to it, unless it has " n=". `deafens`: commands may
    /// not arrive.
    void fault(const std::string& line, Duration time, bool deafens, std::optional<std::uint8_t> place = {});
    void clearFaults();
    /// Applies a load that turns the shaft from now on, whatever its motor is commanded to do.
    void load(std::uint8_t place, double newtonMetres);

    void run(Duration time);
    template <typename Condition>
    [[nodiscard]] bool runUntil(Condition condition, Duration limit) {
        const TimePoint end = bus.now + limit;
        while (true) {
            const Duration chunk = std::min<Duration>(end - bus.now, std::chrono::milliseconds(20));
            if (bus.runUntil([&] { return observe(), condition() || handIsDue(); }, chunk) && condition())
                return true;
            if (bus.now >= end)
                return condition();
            moveHand();
        }
    }
    /// Runs until this many more bytes have crossed the wire, in either direction, but no longer than
    /// `limit`.
    void runBytes(std::uint64_t bytes, Duration limit);
    [[nodiscard]] std::uint64_t bytesCrossed() const;
    /// Runs until searches, stops and rate changes have ended, and then for the time of another stop.
    void runToRest();
    /// Complains about whatever was requested and has not ended exactly once.
    void expectEnds();

    // The truth, as the simulator knows it.
    [[nodiscard]] std::size_t size() const { return bus.chain.moduleCount(); }
    /// True if the motor has current, or turns by command.
    [[nodiscard]] bool isOn(std::uint8_t place);
    /// True if the packet being sent resets it: it is off, and without an address, before another one can
    /// arrive.
    [[nodiscard]] bool resetOnTheWay(std::uint8_t place);
    [[nodiscard]] bool atRest(std::uint8_t place);
    [[nodiscard]] double shaft(std::uint8_t place);
    /// True if a command to this address at this rate arrives and is understood.
    [[nodiscard]] bool hears(std::uint8_t place, std::uint8_t address, std::uint32_t baud);
    [[nodiscard]] std::uint64_t replies(std::uint8_t place) const;
    [[nodiscard]] bool isDriven(std::uint8_t place) const { return m_driven[place]; }

    [[nodiscard]] bool searching() const { return m_searching || m_searchesItself; }
    [[nodiscard]] bool rateChanging() const { return m_rateChanges > m_rateEnds; }
    [[nodiscard]] bool stopping() const { return m_oath.running(); }
    [[nodiscard]] std::size_t stopsFinished() const { return bus.count<bus::StopFinished>(); }
    void complain(const std::string& what);

    World world;
    FaultyBus bus;
    std::optional<KnownChain> known;
    std::vector<WireItem> wire;
    TimePoint lineFree{};        ///< when the last byte given to the port will have left
    bool noisyCommands = false;  ///< there was noise on the way to the modules at some time
    TimePoint faultsUntil{};     ///< from then on, nothing is wrong with the line
    bool restartAsked = false;   ///< the current or last search restarts the network
    bool lost = false;           ///< the engine reports the link as lost
    std::vector<bool> everOn;    ///< by place: may have been on since it was given an address
    std::vector<std::string> complaints;
    std::set<std::string> situations;  ///< those in which stops of all were requested
    /// May change what is sent to the modules, after it has been noted.
    std::function<void(std::vector<std::uint8_t>&)> onPacket;

private:
    struct Hand {
        bus::HoldToMove hold;
        TimePoint next;
        TimePoint until;
        bool lapses;
        std::size_t wireFrom;
    };

    static sim::ChainOptions optionsOf(const World& world);
    static bus::EngineConfig configOf(const World& world);
    void plugIn();
    void observe();
    void handle(const bus::Event& event);
    void chainFound(const bus::ChainFound& found);
    void searchEnded(bool found);
    [[nodiscard]] std::string situation() const;
    void begin(bool asRestart);
    void settle() { bus.runFor(Duration{}); }
    [[nodiscard]] bool handIsDue() const { return m_hand && bus.now >= m_hand->next; }
    void moveHand();
    void note(ByteSpan bytes);

    StopOath m_oath;
    OwedStopOath m_owedStops;
    LookOath m_look;
    std::optional<Hand> m_hand;
    std::uint32_t m_presses = 0;
    bool m_searching = false;  ///< as asked
    bool m_searchesItself = false;
    bool m_givenUp = false;  ///< the link was, because of errors
    bool m_foundNobody = false;
    unsigned m_rateChanges = 0;
    unsigned m_rateEnds = 0;
    std::vector<bus::OperationId> m_operations;
    std::vector<bus::OperationId> m_groupOperations;
    std::vector<TimePoint> m_deafUntil;  ///< by place
    std::vector<bool> m_driven;          ///< by place: turned from outside
    std::size_t m_seen = 0;
    bool m_powerCycled = false;
    bool m_foreignHost = false;
};

}  // namespace nmc::test
