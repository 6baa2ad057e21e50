// SPDX-License-Identifier: MIT
#pragma once

#include "sim/module.h"
#include "sim/steppercontrol.h"

namespace nmc::sim {

/// A PIC-STEP, version 1: its commands and status items (DS-S 5).
class StepperModule final : public Module {
public:
    using Module::Module;

    void set(Input input, std::optional<double> value, unsigned) override { m_control.set(input, value); }
    [[nodiscard]] ModuleSnapshot snapshot(TimePoint now) const override;

private:
    [[nodiscard]] bool obeysResetOfAll() const override { return true; }
    void resetChip(Restart) override { m_control.reset(); }
    void runTicks(std::uint64_t ticks) override {
        m_control.run(kServoTick * static_cast<Duration::rep>(ticks));
    }
    void executeOwn(const Packet& packet) override;
    [[nodiscard]] std::uint8_t reservedBits(CommandCode code) const override;
    [[nodiscard]] std::uint8_t stopBits() const override { return 0x0C; }
    [[nodiscard]] std::uint8_t statusByte() const override { return m_control.statusByte(); }
    void writeItems(ItemWriter writer) const override;

    void resetPosition();
    void loadTrajectory(const Packet& packet);
    /// Returns false when the chip does not execute the start.
    bool startMotion();
    void setParameters(const Packet& packet);
    void stopMotor(unsigned control);
    void setHoming(std::uint8_t control);
    /// Returns the value clamped to its range; a value outside is logged as a violation.
    template <typename T>
    T inRange(T value, T min, T max);

    StepperControl m_control;
};

}  // namespace nmc::sim
