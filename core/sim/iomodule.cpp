// SPDX-License-Identifier: MIT
#include "sim/iomodule.h"

#include "sim/datareader.h"

namespace nmc::sim {

namespace {

constexpr unsigned kAllPins = 0x0FFF;
constexpr unsigned kCounterPin = 1U << 9U;  ///< IO10
/// 5.0 MHz times 512 us.
constexpr std::uint64_t kTimerClocksPerTick = 2560;

/// Reads a pin mask: IO1 to IO8, then IO9 to IO12 in the low nibble.
std::uint16_t pinsOf(DataReader& reader) {
    return reader.next<std::uint16_t>() & kAllPins;
}

}  // namespace

void IoModule::executeOwn(const Packet& packet) {
    DataReader reader(packet);
    switch (packet.code()) {
        case CommandCode::ResetPosition:  // Set Direction
            return watchingCounterPin([&] { m_chip.directions = pinsOf(reader); });
        case CommandCode::LoadTrajectory:  // Set PWM
            m_chip.pwm = {packet.data[0], packet.data[1]};
            return;
        case CommandCode::StartMotion:  // Synch Output
            m_chip.pwm = m_chip.storedPwm;
            return setPins(m_chip.storedOutputs);
        case CommandCode::SetGain:  // Set Output
            return setPins(pinsOf(reader));
        case CommandCode::StopMotor:  // Set Synch Output
            m_chip.storedOutputs = pinsOf(reader);
            m_chip.storedPwm = {packet.data[2], packet.data[3]};
            return;
        case CommandCode::IoControl:  // Set Timer Mode
            return setTimerMode(packet.data[0]);
        case CommandCode::SaveAsHome:  // Synch Input
            m_chip.latchedPins = levels();
            m_chip.latchedCount = count();
            return;
        case CommandCode::SetHoming:  // this chip has neither this command nor the next two
        case CommandCode::ClearStickyBits:
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

/// Sets the timer mode and restarts the count.
void IoModule::setTimerMode(std::uint8_t mode) {
    m_chip.counting = (mode & 0x01U) != 0;
    m_chip.countsPin = (mode & 0x02U) != 0;
    m_chip.prescaler = 1U << (mode >> 4U & 0x03U);
    m_events = 0;
}

void IoModule::setPins(std::uint16_t pins) {
    watchingCounterPin([&] {
        const unsigned inputs = m_chip.directions;
        m_chip.outputs = static_cast<std::uint16_t>((m_chip.outputs & inputs) | (pins & ~inputs));
    });
}

std::uint16_t IoModule::levels() const {
    const unsigned inputs = m_chip.directions;
    return static_cast<std::uint16_t>(((m_pinsOutside & inputs) | (m_chip.outputs & ~inputs)) & kAllPins);
}

template <typename Change>
void IoModule::watchingCounterPin(Change change) {
    const unsigned before = levels() & kCounterPin;
    change();
    if (m_chip.counting && m_chip.countsPin && before == 0 && (levels() & kCounterPin) != 0)
        ++m_events;
}

void IoModule::runTicks(std::uint64_t ticks) {
    if (m_chip.counting && !m_chip.countsPin)
        m_events += kTimerClocksPerTick * ticks;
}

void IoModule::set(Input input, std::optional<double> value, unsigned number) {
    if (input == Input::Analog)
        m_analog.at(number - 1) = static_cast<std::uint8_t>(value.value_or(0.0));
    if (input != Input::Pin)
        return;
    watchingCounterPin([&] {
        const unsigned pin = 1U << (number - 1);
        const bool high = value.value_or(0.0) != 0.0;
        m_pinsOutside = static_cast<std::uint16_t>(high ? m_pinsOutside | pin : m_pinsOutside & ~pin);
    });
}

void IoModule::writeItems(ItemWriter writer) const {
    writer.item(levels()).item(m_analog[0]).item(m_analog[1]).item(m_analog[2]);
    writer.item(count()).item(identityItem());
    writer.item(m_chip.latchedPins).item(m_chip.latchedCount);
}

ModuleSnapshot IoModule::snapshot(TimePoint now) const {
    ModuleSnapshot s = Module::snapshot(now);
    s.io = IoSnapshot{m_chip, levels(), m_analog, count()};
    return s;
}

}  // namespace nmc::sim
