// SPDX-License-Identifier: MIT
#include "sim/servomodule.h"

#include <bit>
#include <utility>

#include "sim/datareader.h"

namespace nmc::sim {

namespace {

constexpr std::uint32_t kMaxMotion = 0x7FFF'FFFF;
/// CMC and SC: 1280 counts per tick.
constexpr std::uint32_t kLaterMaxVelocity = 83'886'080;

std::uint16_t wordAt(const Packet& packet, std::size_t offset) {
    return readLittleEndian<std::uint16_t>(ByteSpan(packet.data).subspan(offset, 2));
}

}  // namespace

void ServoModule::executeOwn(const Packet& packet) {
    switch (packet.code()) {
        case CommandCode::ResetPosition:
            return resetPosition(packet);
        case CommandCode::LoadTrajectory:
            return loadTrajectory(packet);
        case CommandCode::StartMotion:
            return startMotion();
        case CommandCode::SetGain:
            return setGain(packet);
        case CommandCode::StopMotor:
            return stopMotor(packet);
        case CommandCode::IoControl:
            return controlIo(packet.data[0]);
        case CommandCode::SetHoming:
            return setHoming(packet.data[0]);
        case CommandCode::ClearStickyBits:
            return m_loop.clearStickyBits();
        case CommandCode::SaveAsHome:
            return m_loop.saveAsHome();
        case CommandCode::AddPathPoints:
            return addPathPoints(packet);
        case CommandCode::SetAddress:
        case CommandCode::DefineStatus:
        case CommandCode::ReadStatus:
        case CommandCode::SetBaud:
        case CommandCode::Nop:
        case CommandCode::HardReset:
            return;  // Module executes these
    }
}

void ServoModule::resetPosition(const Packet& packet) {
    constexpr unsigned kRelativeToHome = 0x01, kToValue = 0x02;
    if (!isSc() && m_loop.inTrapezoid())
        violates(ViolationKind::ResetInMotion);
    // Versions 1 to 4 ignore a control byte, and version 5 knows only its first bit.
    const unsigned known = isSc() ? kRelativeToHome | kToValue : isLater() ? kRelativeToHome : 0U;
    const unsigned control = packet.length() == 0 ? 0U : packet.data[0] & known;
    if (std::popcount(control) > 1)
        violates(ViolationKind::OutOfRange);
    if (isSc() && packet.length() > 0 && packet.length() != ((control & kToValue) != 0 ? 5U : 1U))
        violates(ViolationKind::WrongLength);
    if ((control & kRelativeToHome) != 0)
        m_loop.resetRelativeToHome();
    else if ((control & kToValue) != 0)
        m_loop.setPosition(readLittleEndian<std::int32_t>(ByteSpan(packet.data).subspan(1, 4)));
    else
        m_loop.resetPosition();
}

void ServoModule::controlIo(std::uint8_t control) {
    // Only one manner of stopping at a limit is allowed, and none with step and direction.
    constexpr unsigned kOneOf = ScControl::kLimitOff | ScControl::kLimitAbrupt | ScControl::kStepAndDirection;
    if (isSc() && std::popcount(control & kOneOf) > 1)
        violates(ViolationKind::OutOfRange);
    m_loop.controlPins(control);
}

void ServoModule::addPathPoints(const Packet& packet) {
    if (!isLater())
        return;
    if (!isSc() && !m_advancedFeatures)
        return violates(ViolationKind::Unsupported);
    if (packet.length() == 0)
        return m_loop.startPath();
    if (packet.length() % 2 != 0)
        violates(ViolationKind::WrongLength);
    for (std::size_t i = 0; i + 1 < packet.length(); i += 2)
        if (!m_loop.addPathPoint(wordAt(packet, i)))
            violates(ViolationKind::PathOverflow);
}

// ---- Saved configuration of an SC ----

std::uint8_t ServoModule::Saved::ioControl(Restart restart) const {
    unsigned bits = 0;
    bits |= has(kThreePhase) ? ScControl::kThreePhase : 0U;
    bits |= has(kAntiphase) ? ScControl::kAntiphase : 0U;
    if (restart == Restart::HardReset)
        return static_cast<std::uint8_t>(bits);
    bits |= has(kStepAndDirection) ? ScControl::kStepAndDirection : 0U;
    bits |= has(kLimitProtection) ? ScControl::kLimitAbrupt : 0U;
    return static_cast<std::uint8_t>(bits);
}

void ServoModule::configureReset(const Packet& packet) {
    if (!isSc() || packet.length() == 0)
        return;
    m_saved.reset();
    if ((packet.data[0] & Saved::kSave) != 0)
        m_saved = Saved{packet.data[0], place(), m_loop.loaded().velocity, m_loop.loaded().acceleration,
                        m_loop.gains()};
}

void ServoModule::resetChip(Restart restart) {
    m_loop.reset();
    m_advancedFeatures = false;
    m_switchesOnWhenAddressed = false;
    if (!m_saved)
        return;
    m_loop.controlPins(m_saved->ioControl(restart));
    if (restart == Restart::HardReset)
        return;
    m_loop.setGains(m_saved->gains);
    m_loop.load({.velocity = m_saved->velocity, .acceleration = m_saved->acceleration});
    m_switchesOnWhenAddressed = !m_saved->has(Saved::kAddresses);
    if (m_switchesOnWhenAddressed)
        return;
    restorePlace(m_saved->place);
    switchOnAsSaved();
}

void ServoModule::addressed() {
    if (std::exchange(m_switchesOnWhenAddressed, false))
        switchOnAsSaved();
}

void ServoModule::switchOnAsSaved() {
    if (m_saved->has(Saved::kAmplifier))
        m_loop.setAmplifier(true);
    if (m_saved->has(Saved::kServo))
        m_loop.stopAbruptly();  // "the motor will simply start servoing to its current position" (DS-V 5.2)
}

void ServoModule::loadTrajectory(const Packet& packet) {
    Trajectory t = m_loop.loaded();
    t.isLoaded = true;
    DataReader reader(packet);
    t.control = reader.next<std::uint8_t>();
    if ((t.control & 0x01U) != 0)
        t.position = reader.next<std::int32_t>();
    if ((t.control & 0x02U) != 0) {
        t.velocity = reader.next<std::uint32_t>();
        t.velocityZeroed = false;
    }
    if ((t.control & 0x04U) != 0)
        t.acceleration = reader.next<std::uint32_t>();
    if ((t.control & 0x08U) != 0)
        t.pwm = reader.next<std::uint8_t>();
    if (packet.length() > 0 && packet.length() != reader.taken())
        violates(ViolationKind::WrongLength);
    const bool relative = isLater() && t.isTrapezoidal() && t.has(Trajectory::kRelative);
    const bool goalIsFar = t.has(0x01) && !relative && !isGoal(t.position, m_loop.position());
    const std::uint32_t maxVelocity = isLater() ? kLaterMaxVelocity : kMaxMotion;
    if (t.velocity > maxVelocity || t.acceleration > kMaxMotion || goalIsFar)
        violates(ViolationKind::OutOfRange);
    t.velocity &= kMaxMotion;
    t.acceleration &= kMaxMotion;
    m_loop.load(t);
    if (t.has(Trajectory::kStartNow))
        startMotion();
}

void ServoModule::startMotion() {
    const Trajectory& loaded = m_loop.loaded();
    if (!loaded.isLoaded)
        return;  // nothing to execute
    // DS-V 5.1, notes 1 and 2: while moving, only velocity mode is started. A trapezoid starts from
    // standstill even with the servo off (DS-V 4.4). CMC and SC allow both.
    const bool moves = m_loop.inTrapezoid() || m_loop.commandVelocity() != 0;
    if (!isLater() && moves && !loaded.has(Trajectory::kVelocityProfile) &&
        (loaded.has(Trajectory::kServo) || m_loop.isServoOn()))
        violates(ViolationKind::TrapezoidInMotion);
    if (loaded.has(Trajectory::kServo) && loaded.velocityZeroed)
        violates(ViolationKind::VelocityNotLoaded);
    m_loop.start();
}

void ServoModule::setGain(const Packet& packet) {
    Gains g;
    g.kp = wordAt(packet, 0);
    g.kd = wordAt(packet, 2);
    g.ki = wordAt(packet, 4);
    g.il = wordAt(packet, 6);
    g.ol = packet.data[8];
    g.cl = packet.data[9];
    g.el = wordAt(packet, 10);
    g.sr = packet.data[12];
    const bool hasDeadband = identity().version >= 4 && packet.length() >= 14;
    g.db = hasDeadband ? packet.data[13] : std::uint8_t{0};
    if (isSc() && packet.length() >= 15)
        g.sm = packet.data[14];

    const auto tooLarge = [](std::uint16_t value) { return value > 0x7FFF; };
    if (tooLarge(g.kp) || tooLarge(g.kd) || tooLarge(g.ki) || tooLarge(g.il) || g.el > 0x3FFF || g.sr == 0)
        violates(ViolationKind::OutOfRange);
    g.kp &= 0x7FFF;
    g.kd &= 0x7FFF;
    g.ki &= 0x7FFF;
    g.il &= 0x7FFF;
    g.el &= 0x7FFF;
    m_loop.setGains(g);
}

void ServoModule::stopMotor(const Packet& packet) {
    constexpr unsigned kAmplifier = 0x01, kOff = 0x02, kAbrupt = 0x04, kSmooth = 0x08, kHere = 0x10,
                       kAdvanced = 0x20;
    const unsigned control = packet.data[0];
    const bool here = (control & kHere) != 0;
    // "If bit 1 is set, bits 2, 3 and 4 are ignored", although only one of them should be set (DS-V 5.2).
    if (std::popcount(control & (kOff | kAbrupt | kSmooth | kHere)) > 1) {
        if ((control & kOff) != 0)
            remarks(ViolationKind::StopBits);
        else
            violates(ViolationKind::StopBits);
    }
    if (packet.length() > 0 && packet.length() != (here ? 5U : 1U))
        violates(ViolationKind::WrongLength);
    m_loop.setAmplifier((control & kAmplifier) != 0);
    if ((control & kOff) != 0)
        m_loop.turnOff();
    else if ((control & kAbrupt) != 0)
        m_loop.stopAbruptly();
    else if ((control & kSmooth) != 0)
        m_loop.stopSmoothly();
    else if (here && identity().version >= 2)
        m_loop.stopHere(readLittleEndian<std::int32_t>(ByteSpan(packet.data).subspan(1, 4)));
    else if (here)
        violates(ViolationKind::Unsupported);
    else
        m_loop.endPath();
    // Only a CMC needs to have them switched on; an SC ignores the bit.
    m_advancedFeatures = m_advancedFeatures || (isLater() && !isSc() && (control & kAdvanced) != 0);
}

/// "Faster rates are possible at lower servo rates" (DS-V 3.1).
bool ServoModule::keepsUpWith(std::uint8_t brd) const {
    return Module::keepsUpWith(brd) || m_loop.gains().sr > 1 || (isSc() && brd == kScFastestBrd);
}

void ServoModule::setHoming(std::uint8_t control) {
    constexpr unsigned kStops = Homing::kMotorOff | Homing::kStopAbruptly | Homing::kStopSmoothly;
    if (identity().version >= 3 && std::popcount(control & kStops) > 1)
        violates(ViolationKind::StopBits);
    m_loop.setHoming(control);
}

/// Bits that DS-V 5.2 calls "not used" or "clear to zero"; later versions use some of them (docs/family.md).
std::uint8_t ServoModule::reservedBits(CommandCode code) const {
    if (code == CommandCode::DefineStatus || code == CommandCode::ReadStatus)
        return isLater() ? 0x00 : 0xC0;
    if (code == CommandCode::StopMotor)
        return isLater() ? 0xC0 : 0xE0;
    if (code == CommandCode::IoControl)
        return isSc() ? 0x03 : isLater() ? 0xB0 : 0xF0;
    return 0;
}

void ServoModule::writeItems(ItemWriter writer) const {
    // Up to version 4 the wire carries the negative of the velocity (DS-V 5.2 Define Status).
    const std::int32_t velocity = isLater() ? m_loop.velocity() : -m_loop.velocity();
    writer.item(m_loop.position()).item(m_loop.analog()).item(static_cast<std::uint16_t>(velocity));
    writer.item(m_loop.auxiliaryByte()).item(m_loop.home()).item(identityItem());
    if (isLater())
        writer.item(static_cast<std::uint16_t>(m_loop.positionError()))
            .item(static_cast<std::uint8_t>(m_loop.pathPoints()));
}

ModuleSnapshot ServoModule::snapshot(TimePoint now) const {
    ModuleSnapshot s = Module::snapshot(now);
    s.servo = m_loop.snapshot();
    s.pins = m_loop.auxiliaryByte();
    s.homing = m_loop.homing();
    if (s.servo.later) {
        s.servo.later->advancedFeatures = m_advancedFeatures || isSc();
        if (m_saved)
            s.servo.later->saved = m_saved->control;
    }
    return s;
}

}  // namespace nmc::sim
