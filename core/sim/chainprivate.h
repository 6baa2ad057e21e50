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

/// The mechanism of the chain: which event is next, and which module it concerns. chain.cpp implements the
/// line and the modules without faults, chainfaults.cpp the faults.
class Chain::Private {
public:
    Private(const std::vector<ModuleIdentity>& identities, const ChainOptions& options);

    void runTo(TimePoint now);
    [[nodiscard]] TimePoint nextEvent() const;
    void updateAddressLines();
    void powerUp(std::size_t module);
    void clearFaults();
    /// The first module that owes the host an answer, or nullptr.
    [[nodiscard]] const Module* busyModule() const;
    [[nodiscard]] double garbleChance(const Module& module, std::uint32_t baud) const {
        return garbleProbability(module.baud(), baud, options.lineMargin);
    }

    ChainOptions options;
    std::vector<std::unique_ptr<Module>> modules;
    /// Module::nextEvent() of each module, contiguous because the search for the next event is the inner
    /// loop.
    std::vector<TimePoint> moduleEvents;
    std::vector<bool> addressLineBroken;  ///< between a module and its neighbour towards the host
    HostLine line;
    std::vector<HostByte> toHost;
    ViolationLog violations;
    ChainStatistics statistics;
    FaultInjector faults;
    TimePoint now;
    bool hasteIsUnknown = false;  ///< since bytes were read late, until the host is known to wait again
    TimePoint readLateUntil;      ///< time at which the last byte that was read late leaves the line
    int waited = 0;               ///< commands since then that were sent while no module was busy

private:
    void runModule(std::size_t index);
    void execute(Module& module);
    void sendReplyByte(Module& module);
    std::uint8_t collide(Module& sender, std::uint8_t value);
    void deliverToHost(const Module& sender, std::uint8_t value, bool garbles);
    /// `due` may be in the future; bytes do not overtake each other.
    void hostHears(std::uint8_t value, TimePoint due);
    void deliverLateBytes();
    void deliverToModules(const LineByte& byte);
    /// Returns false when the module does not listen.
    bool moduleHears(std::size_t index, std::uint8_t value, std::uint32_t baud, bool error, bool struck);
    void watchForHaste(const LineByte& byte);
    void catchUp();

    // Faults.
    /// A packet of the host that is being sent to the modules, and the damage done to it.
    struct PacketUnderway {
        PacketBytes bytes;  ///< up to and including the current one
        bool decided = false;
        std::optional<FrameEdit> busEdit;
        std::vector<std::optional<FrameEdit>> moduleEdits;
    };
    void carryOutFaults();
    void carryOut(const FaultInjector::Act& act);
    void updateHolds();
    /// Returns false when the module misses its packet.
    [[nodiscard]] bool faultsLetExecute(Module& module);
    void strikeReply(Module& module);
    void followPacket(const LineByte& byte, bool insidePacket);
    void strikePacket(const PacketBytes& known, std::size_t first);
    void deliverWithFaults(const LineByte& byte);
    /// Disturbs every module; no byte of the host is involved.
    void disturbModules(std::uint8_t value, bool error);
    [[nodiscard]] FrameEdit::Byte fateOfByte(std::size_t module) const;

    Random m_random;
    Receiver m_monitor;  ///< receives the host's undamaged bytes, to distinguish whole commands from nulls
                         ///< and garbage
    bool m_hasty = false;
    std::uint8_t m_hurried = 0;  ///< the module that was busy
    TimePoint m_nextCatchUp;
    PacketUnderway m_underway;
    /// For each module: true while it does not receive what the host sends, until both are between two
    /// packets.
    std::vector<bool> m_outOfStep;
    bool m_someAreOutOfStep = false;
    std::vector<Duration> m_heldUp;  ///< line delay of each module's current reply
    std::deque<HostByte> m_late;
};

}  // namespace nmc::sim
