// SPDX-License-Identifier: MIT
#pragma once

#include "sim/module.h"

namespace nmc::sim {

/// A PIC-I/O, version 1: twelve pins, three A/D inputs, two PWM outputs and a timer or counter
/// (docs/family.md). In pin masks, bit 0 is IO1.
class IoModule final : public Module {
public:
    using Module::Module;

    void set(Input input, std::optional<double> value, unsigned number) override;
    [[nodiscard]] ModuleSnapshot snapshot(TimePoint now) const override;

private:
    void resetChip(Restart) override {
        m_chip = {};
        m_events = 0;
    }
    void runTicks(std::uint64_t ticks) override;
    void executeOwn(const Packet& packet) override;
    [[nodiscard]] std::uint8_t statusByte() const override { return 0; }
    void writeItems(ItemWriter writer) const override;
    [[nodiscard]] std::uint8_t reservedBits(CommandCode code) const override {
        return code == CommandCode::IoControl ? 0xCC : 0x00;  // Set Timer Mode
    }

    void setTimerMode(std::uint8_t mode);
    /// The bits of input pins are ignored.
    void setPins(std::uint16_t pins);
    /// The levels of all pins, whether driven by the module or from outside.
    [[nodiscard]] std::uint16_t levels() const;
    [[nodiscard]] std::uint32_t count() const {
        return static_cast<std::uint32_t>(m_events / m_chip.prescaler);
    }
    /// Counts the edge that `change` may cause at the counter's pin.
    template <typename Change>
    void watchingCounterPin(Change change);

    IoChip m_chip;
    std::uint64_t m_events = 0;  ///< timer clock ticks, or edges
    // The world outside the module.
    std::uint16_t m_pinsOutside = 0;
    std::array<std::uint8_t, 3> m_analog{};
};

}  // namespace nmc::sim
