// SPDX-License-Identifier: MIT
#include "sim/servomodule.h"

#include <bit>

#include "sim/datareader.h"

namespace nmc::sim {

namespace {

constexpr std::uint32_t kMaxMotion = 0x7FFF'FFFF;

std::uint16_t wordAt(const Packet& packet, std::size_t offset) {
    return readLittleEndian<std::uint16_t>(ByteSpan(packet.data).subspan(offset, 2));
}

}  // namespace

void ServoModule::executeOwn(const Packet& packet) {
    switch (packet.code()) {
        case CommandCode::ResetPosition:
            return resetPosition();
        case CommandCode::LoadTrajectory:
            return loadTrajectory(packet);
        case CommandCode::StartMotion:
            return startMotion();
        case CommandCode::SetGain:
            return setGain(packet);
        case CommandCode::StopMotor:
            return stopMotor(packet);
        case CommandCode::IoControl:
            return m_loop.controlPins(packet.data[0]);
        case CommandCode::SetHoming:
            return setHoming(packet.data[0]);
        case CommandCode::ClearStickyBits:
            return m_loop.clearStickyBits();
        case CommandCode::SaveAsHome:
            return m_loop.saveAsHome();
        case CommandCode::SetAddress:
        case CommandCode::DefineStatus:
        case CommandCode::ReadStatus:
        case CommandCode::SetBaud:
        case CommandCode::AddPathPoints:
        case CommandCode::Nop:
        case CommandCode::HardReset:
            return;  // Module's.
    }
}

void ServoModule::resetPosition() {
    if (m_loop.inTrapezoid())
        violates(ViolationKind::ResetInMotion);
    m_loop.resetPosition();
}

void ServoModule::loadTrajectory(const Packet& packet) {
    Trajectory t = m_loop.loaded();
    DataReader reader(packet);
    t.control = reader.next<std::uint8_t>();
    if ((t.control & 0x01U) != 0)
        t.position = reader.next<std::int32_t>();
    if ((t.control & 0x02U) != 0)
        t.velocity = reader.next<std::uint32_t>();
    if ((t.control & 0x04U) != 0)
        t.acceleration = reader.next<std::uint32_t>();
    if ((t.control & 0x08U) != 0)
        t.pwm = reader.next<std::uint8_t>();
    if (packet.length() > 0 && packet.length() != reader.taken())
        violates(ViolationKind::WrongLength);
    const bool goalIsFar = t.has(0x01) && !isGoal(t.position, m_loop.position());
    if (t.velocity > kMaxMotion || t.acceleration > kMaxMotion || goalIsFar)
        violates(ViolationKind::OutOfRange);
    t.velocity &= kMaxMotion;
    t.acceleration &= kMaxMotion;
    m_loop.load(t);
    if (t.has(Trajectory::kStartNow))
        startMotion();
}

void ServoModule::startMotion() {
    // DS-V 4.4: a trapezoid starts from standstill, and nothing about it changes while it runs.
    if (m_loop.loaded().isTrapezoidal() && (m_loop.inTrapezoid() || m_loop.commandVelocity() != 0))
        violates(ViolationKind::TrapezoidInMotion);
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
    constexpr unsigned kAmplifier = 0x01, kOff = 0x02, kAbrupt = 0x04, kSmooth = 0x08, kHere = 0x10;
    const unsigned control = packet.data[0];
    const bool here = (control & kHere) != 0;
    if (std::popcount(control & (kOff | kAbrupt | kSmooth | kHere)) > 1)
        violates(ViolationKind::StopBits);
    if (packet.length() > 0 && (packet.length() == 5) != here)
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
}

void ServoModule::setHoming(std::uint8_t control) {
    constexpr unsigned kStops = Homing::kMotorOff | Homing::kStopAbruptly | Homing::kStopSmoothly;
    if (identity().version >= 3 && std::popcount(control & kStops) > 1)
        violates(ViolationKind::StopBits);
    m_loop.setHoming(control);
}

/// DS-V 5.2: "not used", "clear to zero".
std::uint8_t ServoModule::reservedBits(CommandCode code) const {
    switch (code) {
        case CommandCode::DefineStatus:
        case CommandCode::ReadStatus:
            return 0xC0;
        case CommandCode::StopMotor:
            return 0xE0;
        case CommandCode::IoControl:
            return 0xF0;
        case CommandCode::LoadTrajectory:
        case CommandCode::SetGain:
        case CommandCode::SetHoming:
        case CommandCode::ResetPosition:
        case CommandCode::SetAddress:
        case CommandCode::StartMotion:
        case CommandCode::SetBaud:
        case CommandCode::ClearStickyBits:
        case CommandCode::SaveAsHome:
        case CommandCode::AddPathPoints:
        case CommandCode::Nop:
        case CommandCode::HardReset:
            return 0;
    }
    return 0;
}

Module::Items ServoModule::statusItems() const {
    // The wire carries the negative of the velocity (DS-V 5.2 Define Status).
    const auto velocity = static_cast<std::uint16_t>(-m_loop.velocity());
    return {m_loop.position(), m_loop.analog(), velocity, m_loop.auxiliaryByte(), m_loop.home()};
}

ModuleSnapshot ServoModule::snapshot(TimePoint now) const {
    ModuleSnapshot s = Module::snapshot(now);
    s.servo = m_loop.snapshot();
    s.homing = m_loop.homing();
    return s;
}

}  // namespace nmc::sim
