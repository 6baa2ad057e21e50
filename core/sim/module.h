// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "base/time.h"
#include "protocol/baud.h"
#include "protocol/moduletype.h"
#include "sim/line.h"
#include "sim/motorplant.h"
#include "sim/receiver.h"
#include "sim/snapshot.h"
#include "sim/statistics.h"
#include "sim/violations.h"

namespace nmc::sim {

/// A status packet: at most status, 17 item bytes and sum; and one byte that a fault may add.
using ReplyBytes = ByteBuffer<20>;

/// Writes the status items that a mask asks for, in the order of their bits.
class ItemWriter {
public:
    ItemWriter(ReplyBytes& reply, std::uint8_t mask) : m_reply(reply), m_mask(mask) {}
    template <std::integral T>
    ItemWriter& item(T value) {
        if ((m_mask & 1U) != 0)
            m_reply.appendLittleEndian(value);
        m_mask >>= 1U;
        return *this;
    }

private:
    ReplyBytes& m_reply;
    unsigned m_mask;
};

/// Later than any event.
inline constexpr TimePoint kNever = TimePoint::max();

struct ModuleOptions {
    Duration tickPhase{};      ///< when its first tick ends, 0 <= phase < kServoTick
    Duration resetDeadTime{};  ///< deaf for so long after power-up and Hard Reset
    bool unpaced = false;      ///< replies take no wire time
    bool deafWhenAddressInputRises = false;
    MotorParameters motor{};  ///< of a PIC-SERVO
    std::uint64_t seed = 1;   ///< of the noise of its encoder, with its index
};

/// What every NMC chip has, whatever it drives: UART and receive buffer, address and group, the daisy-chained
/// address pins, execution at the end of its tick, the reply (DS-V 4.1). A chip's own commands, status items
/// and motion are in a derived class.
///
/// A module is advanced only when something asks for it; between two events it runs its ticks in one go.
class Module {
public:
    Module(ModuleIdentity identity, std::uint8_t index, const ModuleOptions& options,
           ViolationLog& violations);
    virtual ~Module() = default;
    Module(const Module&) = delete;
    Module& operator=(const Module&) = delete;

    // Addressing.
    /// As after switching its supply off and on.
    void powerUp(TimePoint now);
    void setAddressInput(bool low, TimePoint now);
    [[nodiscard]] bool addressOutputIsLow() const { return m_addressOutputLow && !raisesAddressOutput(); }
    /// Whether its UART takes part in what happens on the line.
    [[nodiscard]] bool isAwake(TimePoint now);

    // The line.
    /// A byte of the host, while awake. `framingError`: it was not what the host sent. `struck`: as in
    /// Packet. `late`: nobody knows whether its host waited before it sent this.
    void hears(std::uint8_t byte, bool framingError, bool struck, bool late, TimePoint now);
    [[nodiscard]] bool inPacket() const { return m_receiver.inPacket(); }
    /// When it next executes a command or has sent a byte; kNever while it only moves its motor.
    [[nodiscard]] TimePoint nextEvent() const;
    /// Has a command to carry out or a reply on its way, and no fault to thank for either.
    [[nodiscard]] bool owesAnswer() const {
        return m_pending ? !m_pending->packet.struck : isReplying() && !m_replyStruck;
    }
    [[nodiscard]] TimePoint executesAt() const { return m_pending ? m_pending->due : kNever; }
    /// Runs up to the end of the tick and carries out the pending command.
    void execute();
    /// Bits per second of its UART.
    [[nodiscard]] double baud() const { return uartRate(m_identity, m_brd); }

    // The reply on its way. Only while isReplying().
    [[nodiscard]] bool isReplying() const { return m_sent < m_reply.size(); }
    [[nodiscard]] std::uint8_t replyByte() const { return m_reply[m_sent]; }
    [[nodiscard]] TimePoint replyByteStart() const { return m_replyStart + m_byteTime * m_sent; }
    [[nodiscard]] TimePoint replyByteDue() const { return m_replyStart + m_byteTime * (m_sent + 1); }
    /// True when that was the last byte.
    bool replyByteSent();
    /// It would not be what, when or at which address it is without a fault, or without another host.
    [[nodiscard]] bool replyIsStruck() const { return m_replyStruck || m_addressIsFaults; }
    void replyCollided(TimePoint now);
    /// A byte of the host has come: the rest of the reply is not sent.
    void dropReply();

    // Faults (simulator.md, Faults): what goes wrong in the module or on its way to the host.
    /// The packet that execute() will carry out; there must be one.
    [[nodiscard]] const Packet& pendingPacket() const { return m_pending->packet; }
    void damagePending() { m_pending->packet.framingError = true; }
    void forgetPending() { m_pending.reset(); }
    [[nodiscard]] bool isAddressedBy(std::uint8_t address) const {
        return address == m_address || address == m_group;
    }
    [[nodiscard]] std::uint8_t address() const { return m_address; }
    void takeAddress(std::uint8_t address);
    /// Unless the host has given it another one since.
    void giveAddressBack();
    void defineItems(std::uint8_t mask);
    /// The command that the reply on its way answers.
    [[nodiscard]] CommandCode answeredCode() const { return static_cast<CommandCode>(m_answered[2] & 0x0FU); }
    [[nodiscard]] ByteSpan reply() const { return m_reply; }
    /// Sends this instead, so much later; nothing when it is empty.
    void replaceReply(ByteSpan bytes, Duration later);
    virtual void holdShaft(bool) {}
    virtual void reverseEncoder(bool) {}

    // The world outside and the truth inside.
    /// Runs all ticks that have ended.
    void advanceTo(TimePoint now);
    /// `number`: which of several, from 1; 0 where there is one.
    virtual void set(Input input, std::optional<double> value, unsigned number) = 0;
    [[nodiscard]] virtual ModuleSnapshot snapshot(TimePoint now) const;
    [[nodiscard]] const ModuleStatistics& statistics() const { return m_statistics; }
    void countGarbled() { ++m_statistics.bytesGarbled; }
    void clearStatistics() { m_statistics = {m_statistics.identity}; }
    [[nodiscard]] std::uint8_t index() const { return m_index; }

protected:
    /// Logs a violation by the command that is being executed, or a remark.
    void violates(ViolationKind kind);
    void remarks(ViolationKind kind);
    [[nodiscard]] ModuleIdentity identity() const { return m_identity; }
    /// Type and version, as item 5 has them.
    [[nodiscard]] std::uint16_t identityItem() const {
        return static_cast<std::uint16_t>(m_identity.version << 8U | static_cast<unsigned>(m_identity.type));
    }

    struct Place {
        std::uint8_t address = 0;
        std::uint8_t group = 0xFF;
        bool leader = false;
    };
    [[nodiscard]] Place place() const { return {m_address, m_group, m_leader}; }
    /// As after the Set Address that gave it this place.
    void restorePlace(const Place& place);

    enum class Restart : std::uint8_t { PowerUp, HardReset };

    /// Whether the chip keeps up with the rate of this divisor.
    [[nodiscard]] virtual bool keepsUpWith(std::uint8_t brd) const;

private:
    struct Pending {
        Packet packet;
        TimePoint due;
        std::uint64_t tick = 0;
        bool toOwnAddress = false;
        bool answers = false;
    };

    /// Whether Hard Reset to address FF is obeyed in any group (DS-S 5.1).
    [[nodiscard]] virtual bool obeysResetOfAll() const { return false; }
    /// A fault that the chip tells on ADDR_OUT.
    [[nodiscard]] virtual bool raisesAddressOutput() const { return false; }
    /// Hard Reset with data, before it is carried out.
    virtual void configureReset(const Packet&) {}
    /// Power-up state of everything that is the chip's own.
    virtual void resetChip(Restart restart) = 0;
    virtual void addressed() {}
    virtual void runTicks(std::uint64_t ticks) = 0;
    /// A command that is not common to all chips. Its length is within the command table's bounds, or logged.
    virtual void executeOwn(const Packet& packet) = 0;
    /// The bits of a command's first data byte that the data sheet wants cleared to zero.
    [[nodiscard]] virtual std::uint8_t reservedBits(CommandCode code) const = 0;
    /// Without the communication error bit.
    [[nodiscard]] virtual std::uint8_t statusByte() const = 0;
    virtual void writeItems(ItemWriter writer) const = 0;

    void accept(const Packet& packet, bool late, TimePoint now);
    void runTo(std::uint64_t tick);
    void executeGood(const Pending& command);
    void checkForm(const Packet& packet);
    void setAddress(const Packet& packet);
    void setBaud(const Pending& command);
    void reset(TimePoint now, Restart restart);
    void reply(TimePoint now, std::uint8_t items, bool communicationError);
    [[nodiscard]] TimePoint tickEnd(std::uint64_t tick) const;
    /// Number of ticks that have ended at `now`.
    [[nodiscard]] std::uint64_t ticksAt(TimePoint now) const;

    ModuleIdentity m_identity;
    std::uint8_t m_index;
    ModuleOptions m_options;
    ViolationLog& m_violations;
    ModuleStatistics m_statistics;

    Receiver m_receiver;
    std::optional<Pending> m_pending;
    std::uint64_t m_ticks = 0;  ///< that have been run
    TimePoint m_deafUntil;
    bool m_addressInputLow = false;
    bool m_awake = false;
    bool m_addressOutputLow = false;
    std::uint8_t m_address = 0;
    std::uint8_t m_group = 0xFF;
    bool m_leader = false;
    std::uint8_t m_brd = kPowerUpBrd;
    std::uint8_t m_items = 0;
    std::optional<std::uint8_t> m_ownAddress;  ///< while a fault has given it another one
    bool m_addressIsFaults = false;
    bool m_itemsAreFaults = false;

    ReplyBytes m_reply;
    std::uint8_t m_sent = 0;
    bool m_collided = false;
    bool m_commandStruck = false;  ///< the command that is being executed
    bool m_replyStruck = false;
    TimePoint m_replyStart;
    Duration m_byteTime{};
    PacketBytes m_answered;  ///< the packet that m_reply answers
};

}  // namespace nmc::sim
