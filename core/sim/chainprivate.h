// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "sim/chain.h"
#include "sim/faultinjector.h"
#include "sim/line.h"
#include "sim/module.h"
#include "sim/random.h"

namespace nmc::sim {

/// The chain's clockwork: what happens next, and to whom. chain.cpp has the line and the modules as they
/// should be, chainfaults.cpp what goes wrong with them.
class Chain::Private {
public:
    Private(const std::vector<ModuleIdentity>& identities, const ChainOptions& options);

    void runTo(TimePoint now);
    [[nodiscard]] TimePoint nextEvent() const;
    void updateAddressLines();
    void powerUp(std::size_t module);
    void clearFaults();
    /// The first module that owes the host an answer.
    [[nodiscard]] const Module* busyModule() const;
    [[nodiscard]] double garbleChance(const Module& module, std::uint32_t baud) const {
        return garbleProbability(module.baud(), baud, options.lineMargin);
    }

    ChainOptions options;
    std::vector<std::unique_ptr<Module>> modules;
    /// Module::nextEvent() of each, side by side: the search for the next one is the inner loop.
    std::vector<TimePoint> moduleEvents;
    std::vector<bool> addressLineBroken;  ///< between a module and its neighbour towards the host
    HostLine line;
    std::vector<HostByte> toHost;
    ViolationLog violations;
    ChainStatistics statistics;
    FaultInjector faults;
    TimePoint now;
    bool hasteIsUnknown = false;  ///< what is on the line was read late

private:
    void runModule(std::size_t index);
    void execute(Module& module);
    void sendReplyByte(Module& module);
    std::uint8_t collide(Module& sender, std::uint8_t value);
    void deliverToHost(const Module& sender, std::uint8_t value, bool garbles);
    /// `due` may lie ahead; bytes do not overtake each other.
    void hostHears(std::uint8_t value, TimePoint due);
    void deliverLateBytes();
    void deliverToModules(const LineByte& byte);
    /// False when it does not listen.
    bool moduleHears(std::size_t index, std::uint8_t value, std::uint32_t baud, bool error, bool struck);
    void watchForHaste(const LineByte& byte);
    void catchUp();

    // Faults.
    /// A packet of the host on its way to the modules, and what becomes of it.
    struct PacketUnderway {
        PacketBytes bytes;  ///< up to the present one
        bool decided = false;
        std::optional<FrameEdit> busEdit;
        std::vector<std::optional<FrameEdit>> moduleEdits;
    };
    void carryOutFaults();
    void carryOut(const FaultInjector::Act& act);
    void updateHolds();
    /// False when the module misses its packet.
    [[nodiscard]] bool faultsLetExecute(Module& module);
    void strikeReply(Module& module);
    void followPacket(const LineByte& byte, bool insidePacket);
    void strikePacket(const PacketBytes& known, std::size_t first);
    void deliverWithFaults(const LineByte& byte);
    /// Every module; nothing of the host's.
    void disturbModules(std::uint8_t value, bool error);
    [[nodiscard]] FrameEdit::Byte fateOfByte(std::size_t module) const;

    Random m_random;
    Receiver m_monitor;  ///< hears the host as it is, to tell whole commands from nulls and garbage
    bool m_hasty = false;
    std::uint8_t m_hurried = 0;  ///< the module that was busy
    TimePoint m_nextCatchUp;
    PacketUnderway m_underway;
    /// Of each module: what it hears is not what the host sends, until both are between two packets.
    std::vector<bool> m_outOfStep;
    bool m_someAreOutOfStep = false;
    std::vector<Duration> m_heldUp;  ///< the delay on the line of each module's present reply
    std::deque<HostByte> m_late;
};

}  // namespace nmc::sim
