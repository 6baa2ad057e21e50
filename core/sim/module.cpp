// SPDX-License-Identifier: MIT
#include "sim/module.h"

#include <algorithm>

#include "protocol/commandtable.h"

namespace nmc::sim {

namespace {

constexpr std::uint8_t kGroupBit = 0x80;
constexpr std::uint8_t kEveryone = 0xFF;
constexpr std::uint8_t kCommunicationError = 0x02;

}  // namespace

Module::Module(ModuleIdentity identity, std::uint8_t index, const ModuleOptions& options,
               ViolationLog& violations)
    : m_identity(identity), m_index(index), m_options(options), m_violations(violations) {
    m_statistics.identity = identity;
    m_deafUntil = TimePoint{} + options.resetDeadTime;
}

// ---- Addressing ----

void Module::powerUp(TimePoint now) {
    advanceTo(now);
    m_pending.reset();
    m_reply.clear();
    m_sent = 0;
    reset(now, Restart::PowerUp);
}

void Module::reset(TimePoint now, Restart restart) {
    m_state = {};
    m_deafUntil = now + m_options.resetDeadTime;
    resetChip(restart);
}

void Module::setAddressInput(bool low, TimePoint now) {
    if (low == m_addressInputLow)
        return;
    static_cast<void>(isAwake(now));  // The module may have woken up under the input's level until now.
    m_addressInputLow = low;
}

bool Module::isAwake(TimePoint now) {
    if (now < m_deafUntil)
        return false;
    if (m_addressInputLow)
        m_state.awake = true;
    else if (m_options.deafWhenAddressInputRises)
        m_state.awake = false;
    return m_state.awake;
}

void Module::setAddress(const Packet& packet) {
    m_state.place.address = packet.data[0];
    m_state.place.group = packet.data[1] | kGroupBit;
    m_state.place.leader = (packet.data[1] & kGroupBit) == 0;
    m_state.addressOutputLow = true;
    m_state.addressIsFaults = m_commandStruck;
    m_state.ownAddress.reset();
    addressed();
}

void Module::restorePlace(const Place& place) {
    m_state.place = place;
    m_state.addressOutputLow = true;
}

// ---- Commands ----

void Module::hears(std::uint8_t byte, bool framingError, bool struck, bool late, TimePoint now) {
    if (m_state.receiver.hears(byte, framingError, struck))
        accept(m_state.receiver.packet(), late, now);
}

void Module::accept(const Packet& packet, bool late, TimePoint now) {
    const bool own = packet.address == m_state.place.address;
    const bool member = packet.address == m_state.place.group;
    const bool good = !packet.framingError && packet.sumIsRight();
    const bool resetsAll =
        good && obeysResetOfAll() && packet.address == kEveryone && packet.code() == CommandCode::HardReset;
    if (!own && !member && !resetsAll)
        return;
    const bool mayBeEarly = late || (m_options.hostHasOwnClock && isStop(packet));
    if (m_pending && good && !mayBeEarly && !packet.struck && !m_pending->packet.struck)
        m_violations.add({now, m_index, ViolationKind::CommandOverwritten, packet.bytes()});
    const std::uint64_t tick = ticksAt(now) + 1;
    m_pending = Pending{packet, tickEnd(tick), tick, own, own || (member && m_state.place.leader)};
}

void Module::execute() {
    const Pending command = *m_pending;
    m_pending.reset();
    runTo(command.tick);
    m_answered = command.packet.bytes();
    m_commandStruck = command.packet.struck;

    const bool damaged = command.packet.framingError || !command.packet.sumIsRight();
    std::uint8_t items = m_state.items;
    if (damaged) {
        ++m_statistics.checksumErrors;
    } else {
        executeGood(command);
        items = command.packet.code() == CommandCode::ReadStatus ? command.packet.data[0] : m_state.items;
    }
    const bool isReset = !damaged && command.packet.code() == CommandCode::HardReset;
    if (command.answers && !isReset)
        reply(command.due, items, damaged);
}

void Module::executeGood(const Pending& command) {
    const Packet& packet = command.packet;
    checkForm(packet);
    ++m_statistics.executed[static_cast<std::size_t>(packet.code())];
    switch (packet.code()) {
        case CommandCode::SetAddress:
            setAddress(packet);
            return;
        case CommandCode::DefineStatus:
            m_state.items = packet.data[0];
            m_state.itemsAreFaults = m_commandStruck;
            return;
        case CommandCode::SetBaud:
            setBaud(command);
            return;
        case CommandCode::HardReset:
            configureReset(packet);
            reset(command.due, Restart::HardReset);
            return;
        case CommandCode::ReadStatus:
        case CommandCode::Nop:
            return;
        case CommandCode::AddPathPoints:
        case CommandCode::ResetPosition:
        case CommandCode::LoadTrajectory:
        case CommandCode::StartMotion:
        case CommandCode::SetGain:
        case CommandCode::StopMotor:
        case CommandCode::IoControl:
        case CommandCode::SetHoming:
        case CommandCode::ClearStickyBits:
        case CommandCode::SaveAsHome:
            executeOwn(packet);
            return;
    }
}

void Module::checkForm(const Packet& packet) {
    const auto row = findCommand(m_identity, packet.code());
    if (!row)
        violates(ViolationKind::UnknownCommand);
    else if (packet.length() < row->minData || packet.length() > row->maxData)
        violates(ViolationKind::WrongLength);
    if (packet.length() > 0 && (packet.data[0] & reservedBits(packet.code())) != 0)
        violates(ViolationKind::ReservedBits);
}

void Module::setBaud(const Pending& command) {
    if (command.toOwnAddress)
        violates(ViolationKind::SetBaudSingle);
    m_state.brd = command.packet.data[0];
    if (!keepsUpWith(m_state.brd))
        violates(ViolationKind::OutOfRange);
}

/// All chips but the SC support up to 115 200 Bd (DS-V 3.1, DS-S 3.1).
bool Module::keepsUpWith(std::uint8_t brd) const {
    constexpr std::uint8_t kFastestBrd = 10;
    return brd >= kFastestBrd;
}

void Module::violates(ViolationKind kind) {
    if (!m_commandStruck)
        m_violations.add({tickEnd(m_ticks), m_index, kind, m_answered});
}

void Module::remarks(ViolationKind kind) {
    if (!m_commandStruck)
        m_violations.remark({tickEnd(m_ticks), m_index, kind, m_answered});
}

// ---- Reply ----

void Module::reply(TimePoint now, std::uint8_t items, bool communicationError) {
    m_reply.clear();
    const unsigned error = communicationError ? kCommunicationError : 0U;
    m_reply.push_back(static_cast<std::uint8_t>(statusByte() | error));
    writeItems({m_reply, items});
    m_reply.push_back(sum8(m_reply));
    m_sent = 0;
    m_collided = false;
    const bool ownItems = answeredCode() != CommandCode::ReadStatus;
    m_replyStruck = m_commandStruck || (ownItems && m_state.itemsAreFaults);
    m_replyStart = now;
    m_byteTime = m_options.unpaced ? Duration{} : fromSeconds(10.0 / baud());
}

void Module::replaceReply(ByteSpan bytes, Duration later) {
    m_replyStruck = m_replyStruck || later > Duration::zero() || !std::ranges::equal(bytes, reply());
    m_reply = ReplyBytes(bytes);
    m_replyStart += later;
}

bool Module::replyByteSent() {
    ++m_sent;
    if (isReplying())
        return false;
    ++m_statistics.replies;
    return true;
}

void Module::replyCollided(TimePoint now) {
    if (!m_collided)
        m_violations.add({now, m_index, ViolationKind::ReplyCollision, m_answered});
    m_collided = true;
}

void Module::dropReply() {
    if (!isReplying())
        return;
    ++m_statistics.repliesDropped;
    m_reply.clear();
    m_sent = 0;
}

// ---- Faults ----

void Module::takeAddress(std::uint8_t address) {
    if (address == m_state.place.address)
        return;
    m_state.ownAddress = m_state.ownAddress.value_or(m_state.place.address);
    m_state.place.address = address;
    m_state.addressIsFaults = true;
}

void Module::giveAddressBack() {
    if (!m_state.ownAddress)
        return;
    m_state.place.address = *m_state.ownAddress;
    m_state.addressIsFaults = false;
    m_state.ownAddress.reset();
}

void Module::defineItems(std::uint8_t mask) {
    m_state.items = mask;
    m_state.itemsAreFaults = true;
}

// ---- Time ----

TimePoint Module::nextEvent() const {
    return std::min(executesAt(), isReplying() ? replyByteDue() : kNever);
}

TimePoint Module::tickEnd(std::uint64_t tick) const {
    return TimePoint{} + m_options.tickPhase + kServoTick * (static_cast<std::int64_t>(tick) - 1);
}

std::uint64_t Module::ticksAt(TimePoint now) const {
    const Duration sinceFirst = now - TimePoint{} - m_options.tickPhase;
    if (sinceFirst < Duration::zero())
        return 0;
    return static_cast<std::uint64_t>(sinceFirst / kServoTick) + 1;
}

void Module::runTo(std::uint64_t tick) {
    if (tick <= m_ticks)
        return;
    runTicks(tick - m_ticks);
    m_ticks = tick;
}

void Module::advanceTo(TimePoint now) {
    runTo(ticksAt(now));
}

ModuleSnapshot Module::snapshot(TimePoint now) const {
    ModuleSnapshot s;
    s.identity = m_identity;
    s.address = m_state.place.address;
    s.group = m_state.place.group;
    s.leader = m_state.place.leader;
    s.baud = baud();
    s.listening = m_state.awake;
    s.time = now;
    s.tick = m_ticks;
    s.status = statusByte();
    s.items = m_state.items;
    return s;
}

}  // namespace nmc::sim
