// SPDX-License-Identifier: MIT
#include "sim/steppermodule.h"

#include <algorithm>
#include <bit>

#include "sim/datareader.h"

namespace nmc::sim {

void StepperModule::executeOwn(const Packet& packet) {
    switch (packet.code()) {
        case CommandCode::ResetPosition:
            return resetPosition();
        case CommandCode::LoadTrajectory:
            return loadTrajectory(packet);
        case CommandCode::StartMotion:
            static_cast<void>(startMotion());
            return;
        case CommandCode::SetGain:  // Set Parameters
            return setParameters(packet);
        case CommandCode::StopMotor:
            return stopMotor(packet.data[0]);
        case CommandCode::IoControl:  // Set Outputs
            return m_control.setOutputs(packet.data[0]);
        case CommandCode::SetHoming:
            return setHoming(packet.data[0]);
        case CommandCode::SaveAsHome:
            return m_control.saveAsHome();
        case CommandCode::ClearStickyBits:  // this chip has neither this command nor the next
        case CommandCode::AddPathPoints:
        case CommandCode::SetAddress:
        case CommandCode::DefineStatus:
        case CommandCode::ReadStatus:
        case CommandCode::SetBaud:
        case CommandCode::Nop:
        case CommandCode::HardReset:
            return;  // Module executes these
    }
}

template <typename T>
T StepperModule::inRange(T value, T min, T max) {
    if (value < min || value > max)
        violates(ViolationKind::OutOfRange);
    return std::clamp(value, min, max);
}

void StepperModule::resetPosition() {
    if (m_control.motion().isMoving())
        violates(ViolationKind::ResetInMotion);
    m_control.resetPosition();
}

void StepperModule::loadTrajectory(const Packet& packet) {
    constexpr std::uint8_t kByte = 0xFF;
    const StepperTrajectory before = m_control.loaded();
    StepperTrajectory t = before;
    t.isLoaded = true;
    DataReader reader(packet);
    t.control = reader.next<std::uint8_t>();
    if (t.has(StepperTrajectory::kPosition))
        t.position = reader.next<std::int32_t>();
    if (t.has(StepperTrajectory::kSpeed))
        t.speed = inRange<std::uint8_t>(reader.next<std::uint8_t>(), 1, kMaxStepSpeed);
    if (t.has(StepperTrajectory::kAcceleration))
        t.accelerationTime = inRange<std::uint8_t>(reader.next<std::uint8_t>(), 1, kByte);
    if (t.has(StepperTrajectory::kTimer)) {
        t.timerCount = inRange(reader.next<std::uint16_t>(), kMinTimerCount, kMaxTimerCount);
        t.nearestSpeed = inRange<std::uint8_t>(reader.next<std::uint8_t>(), 0, kMaxStepSpeed);
    }
    if (t.has(StepperTrajectory::kPosition) && !isGoal(t.position, m_control.motion().position()))
        violates(ViolationKind::OutOfRange);
    if (packet.length() > 0 && packet.length() != reader.taken())
        violates(ViolationKind::WrongLength);
    m_control.load(t);
    if (t.has(StepperTrajectory::kStartNow) && !startMotion())
        m_control.load(before);
}

bool StepperModule::startMotion() {
    const StepperMotion& motion = m_control.motion();
    const StepperTrajectory& loaded = m_control.loaded();
    if (!m_control.hasParameters()) {
        violates(ViolationKind::ParametersNotSet);
        return false;
    }
    if (!loaded.isLoaded)
        return true;  // nothing to execute
    const auto goal = goalMode(motion.mode(), loaded.control);
    if (!goal) {
        violates(ViolationKind::ModeTransition);
        return false;
    }
    if (motion.isMoving() && motion.wouldReverse(*goal, loaded) != motion.isReverse()) {
        violates(ViolationKind::DirectionChange);
        return false;
    }
    // DS-S 5.1, Stop Motor: a smooth stop sets the goal velocity to zero, and the next load must set a new
    // one.
    if ((*goal == StepperMode::Trapezoidal || *goal == StepperMode::Velocity) && loaded.speed == 0)
        violates(ViolationKind::VelocityNotLoaded);
    m_control.start(*goal);
    return true;
}

void StepperModule::setParameters(const Packet& packet) {
    constexpr unsigned kIgnored = 0xE0;
    DataReader reader(packet);
    StepperParameters p;
    p.mode = reader.next<std::uint8_t>();
    if ((p.mode & kIgnored) != 0)
        remarks(ViolationKind::ReservedBits);
    p.minimumSpeed = inRange<std::uint8_t>(reader.next<std::uint8_t>(), 1, kMaxStepSpeed);
    p.runningCurrent = reader.next<std::uint8_t>();
    p.holdingCurrent = reader.next<std::uint8_t>();
    p.thermalLimit = reader.next<std::uint8_t>();
    m_control.setParameters(p);
}

void StepperModule::stopMotor(unsigned control) {
    constexpr unsigned kAmplifier = 0x01, kAbrupt = 0x04, kSmooth = 0x08;
    if (std::popcount(control & (kAbrupt | kSmooth)) > 1)
        violates(ViolationKind::StopBits);
    m_control.setAmplifier((control & kAmplifier) != 0);
    if ((control & kAbrupt) != 0)
        m_control.stopAbruptly();
    else if ((control & kSmooth) != 0)
        m_control.stopSmoothly();
}

void StepperModule::setHoming(std::uint8_t control) {
    constexpr unsigned kStops = Homing::kMotorOff | Homing::kStopAbruptly | Homing::kStopSmoothly;
    if (std::popcount(control & kStops) > 1)
        violates(ViolationKind::StopBits);
    m_control.setHoming(control);
}

/// Bits that DS-S 5.1 calls "not used" or "clear to zero".
std::uint8_t StepperModule::reservedBits(CommandCode code) const {
    if (code == CommandCode::DefineStatus || code == CommandCode::ReadStatus ||
        code == CommandCode::SetHoming)
        return 0xC0;
    if (code == CommandCode::LoadTrajectory)
        return 0x60;
    if (code == CommandCode::StopMotor)
        return 0xF0;
    if (code == CommandCode::IoControl)  // Set Outputs
        return 0xE0;
    return 0;
}

void StepperModule::writeItems(ItemWriter writer) const {
    const StepperMotion& motion = m_control.motion();
    writer.item(motion.position()).item(m_control.analog()).item(motion.timerCount());
    writer.item(m_control.inputsByte()).item(m_control.home()).item(identityItem());
}

ModuleSnapshot StepperModule::snapshot(TimePoint now) const {
    ModuleSnapshot s = Module::snapshot(now);
    s.stepper = m_control.snapshot();
    s.pins = m_control.inputsByte();
    s.homing = m_control.homing();
    return s;
}

}  // namespace nmc::sim
