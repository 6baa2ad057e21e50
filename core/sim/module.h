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

/// A status packet: at most status, 17 item bytes and sum, plus one byte that a fault may add.
using ReplyBytes = ByteBuffer<20>;

/// Writes the status items selected by a mask, in the order of their bits.
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

/// A time later than any event.
inline constexpr TimePoint kNever = TimePoint::max();

struct ModuleOptions {
    Duration tickPhase{};      ///< end of its first tick, 0 <= phase < kServoTick
    Duration resetDeadTime{};  ///< time without listening after power-up and Hard Reset
    bool unpaced = false;      ///< replies take no wire time
    bool deafWhenAddressInputRises = false;
    MotorParameters motor{};  ///< motor of a PIC-SERVO
    std::uint64_t seed = 1;   ///< seed of its encoder's noise, together with its index
    bool hostHasOwnClock = false;
};

/// What every NMC chip has, regardless of what it drives: UART and receive buffer, address and group, the
/// daisy-chained address pins, execution at the end of its tick, and the reply (DS-V 4.1). The commands,
/// status items and motion specific to a chip are in a derived class.
///
/// A module is advanced only on demand; between two events it runs its ticks in one go.
class Module {
public:
    Module(ModuleIdentity identity, std::uint8_t index, const ModuleOptions& options,
           ViolationLog& violations);
    virtual ~Module() = default;
    Module(const Module&) = delete;
    Module& operator=(const Module&) = delete;

    // Addressing.
    /// Puts the module into the state after switching its supply off and on.
    void powerUp(TimePoint now);
    void setAddressInput(bool low, TimePoint now);
    [[nodiscard]] bool addressOutputIsLow() const {
        return m_state.addressOutputLow && !raisesAddressOutput();
    }
    /// True when the module's UART takes part in the traffic on the line.
    [[nodiscard]] bool isAwake(TimePoint now);

    // The line.
    /// Receives a byte of the host while awake. `framingError`: the byte is not what the host sent. `struck`:
    /// as in Packet. `late`: it is unknown whether the host waited for its answer before it sent this byte.
    void hears(std::uint8_t byte, bool framingError, bool struck, bool late, TimePoint now);
    [[nodiscard]] bool inPacket() const { return m_state.receiver.inPacket(); }
    /// The time at which it next executes a command or has sent a byte; kNever while it only moves its motor.
    [[nodiscard]] TimePoint nextEvent() const;
    /// True when it has a command to execute or a reply to send, and neither was caused by a fault.
    [[nodiscard]] bool owesAnswer() const {
        return m_pending ? !m_pending->packet.struck : isReplying() && !m_replyStruck;
    }
    [[nodiscard]] TimePoint executesAt() const { return m_pending ? m_pending->due : kNever; }
    /// Runs up to the end of the tick and executes the pending command.
    void execute();
    /// The rate of its UART in bits per second.
    [[nodiscard]] double baud() const { return uartRate(m_identity, m_state.brd); }

    // The reply being sent; valid only while isReplying().
    [[nodiscard]] bool isReplying() const { return m_sent < m_reply.size(); }
    [[nodiscard]] std::uint8_t replyByte() const { return m_reply[m_sent]; }
    [[nodiscard]] TimePoint replyByteStart() const { return m_replyStart + m_byteTime * m_sent; }
    [[nodiscard]] TimePoint replyByteDue() const { return m_replyStart + m_byteTime * (m_sent + 1); }
    /// Returns true when that was the last byte.
    bool replyByteSent();
    /// True when a fault or another host has changed the contents, the time or the address of the reply.
    [[nodiscard]] bool replyIsStruck() const { return m_replyStruck || m_state.addressIsFaults; }
    void replyCollided(TimePoint now);
    /// Called when a byte of the host arrives: the rest of the reply is not sent.
    void dropReply();

    // Faults in the module or on its way to the host (simulator.md, Faults).
    /// The packet that execute() will execute; there must be one.
    [[nodiscard]] const Packet& pendingPacket() const { return m_pending->packet; }
    void damagePending() { m_pending->packet.framingError = true; }
    void forgetPending() { m_pending.reset(); }
    [[nodiscard]] bool isAddressedBy(std::uint8_t address) const {
        return address == m_state.place.address || address == m_state.place.group;
    }
    /// True for a Stop Motor with a bit that stops this chip's motor.
    [[nodiscard]] bool isStop(const Packet& packet) const {
        return packet.code() == CommandCode::StopMotor && packet.length() > 0 &&
               (packet.data[0] & stopBits()) != 0;
    }
    [[nodiscard]] std::uint8_t address() const { return m_state.place.address; }
    void takeAddress(std::uint8_t address);
    /// Restores the own address, unless the host has set another one since.
    void giveAddressBack();
    void defineItems(std::uint8_t mask);
    /// The code of the command that the current reply answers.
    [[nodiscard]] CommandCode answeredCode() const { return static_cast<CommandCode>(m_answered[2] & 0x0FU); }
    [[nodiscard]] ByteSpan reply() const { return m_reply; }
    /// Sends `bytes` instead, delayed by `later`; sends nothing when `bytes` is empty.
    void replaceReply(ByteSpan bytes, Duration later);
    virtual void holdShaft(bool) {}
    virtual void reverseEncoder(bool) {}

    // The world outside the module, and the truth inside it.
    /// Runs all ticks that have ended by `now`.
    void advanceTo(TimePoint now);
    /// `number` selects one of several inputs, from 1; it is 0 where there is only one.
    virtual void set(Input input, std::optional<double> value, unsigned number) = 0;
    [[nodiscard]] virtual ModuleSnapshot snapshot(TimePoint now) const;
    [[nodiscard]] const ModuleStatistics& statistics() const { return m_statistics; }
    void countGarbled() { ++m_statistics.bytesGarbled; }
    void clearStatistics() { m_statistics = {m_statistics.identity}; }
    [[nodiscard]] std::uint8_t index() const { return m_index; }

protected:
    /// Log a violation, or a remark, about the command being executed.
    void violates(ViolationKind kind);
    void remarks(ViolationKind kind);
    [[nodiscard]] ModuleIdentity identity() const { return m_identity; }
    /// Type and version in the format of item 5.
    [[nodiscard]] std::uint16_t identityItem() const {
        return static_cast<std::uint16_t>(unsigned{m_identity.version} << 8U |
                                          static_cast<unsigned>(m_identity.type));
    }

    struct Place {
        std::uint8_t address = 0;
        std::uint8_t group = 0xFF;
        bool leader = false;
    };
    [[nodiscard]] Place place() const { return m_state.place; }
    /// Restores the state after the Set Address that assigned this place.
    void restorePlace(const Place& place);

    enum class Restart : std::uint8_t { PowerUp, HardReset };

    /// True when the chip can keep up with the rate of this divisor.
    [[nodiscard]] virtual bool keepsUpWith(std::uint8_t brd) const;

private:
    struct Pending {
        Packet packet;
        TimePoint due;
        std::uint64_t tick = 0;
        bool toOwnAddress = false;
        bool answers = false;
    };
    /// What a restart clears.
    struct State {
        Receiver receiver;
        bool awake = false;
        bool addressOutputLow = false;
        Place place;
        std::uint8_t brd = kPowerUpBrd;
        std::uint8_t items = 0;
        std::optional<std::uint8_t> ownAddress;  ///< set while a fault has assigned another one
        bool addressIsFaults = false;
        bool itemsAreFaults = false;
    };

    /// True when the chip obeys a Hard Reset to address FF whatever its group (DS-S 5.1).
    [[nodiscard]] virtual bool obeysResetOfAll() const { return false; }
    /// True while the chip signals a fault on ADDR_OUT.
    [[nodiscard]] virtual bool raisesAddressOutput() const { return false; }
    /// Handles a Hard Reset with data, before it is executed.
    virtual void configureReset(const Packet&) {}
    /// Resets everything specific to the chip to its power-up state.
    virtual void resetChip(Restart restart) = 0;
    virtual void addressed() {}
    virtual void runTicks(std::uint64_t ticks) = 0;
    /// Executes a command that is not common to all chips. Its length is within the bounds of the command
    /// table, or a violation has been logged.
    virtual void executeOwn(const Packet& packet) = 0;
    /// The bits of a command's first data byte that the data sheet requires to be zero.
    [[nodiscard]] virtual std::uint8_t reservedBits(CommandCode code) const = 0;
    /// The bits of Stop Motor's control byte that stop the motor; 0 without a motor, where its code means
    /// something else.
    [[nodiscard]] virtual std::uint8_t stopBits() const { return 0; }
    /// The status byte without the communication error bit.
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
    /// The number of ticks that have ended at `now`.
    [[nodiscard]] std::uint64_t ticksAt(TimePoint now) const;

    ModuleIdentity m_identity;
    std::uint8_t m_index;
    ModuleOptions m_options;
    ViolationLog& m_violations;
    ModuleStatistics m_statistics;

    State m_state;
    std::optional<Pending> m_pending;
    std::uint64_t m_ticks = 0;  ///< ticks run so far
    TimePoint m_deafUntil;
    bool m_addressInputLow = false;

    ReplyBytes m_reply;
    std::uint8_t m_sent = 0;
    bool m_collided = false;
    bool m_commandStruck = false;  ///< refers to the command being executed
    bool m_replyStruck = false;
    TimePoint m_replyStart;
    Duration m_byteTime{};
    PacketBytes m_answered;  ///< the packet that m_reply answers
};

}  // namespace nmc::sim
