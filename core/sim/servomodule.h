// SPDX-License-Identifier: MIT
#pragma once

#include "sim/module.h"
#include "sim/servoloop.h"

namespace nmc::sim {

/// A PIC-SERVO, versions 1 to 4, with its PIC-ENC, amplifier and motor: its commands and status items (DS-V
/// 5).
class ServoModule final : public Module {
public:
    ServoModule(ModuleIdentity identity, std::uint8_t index, const ModuleOptions& options,
                ViolationLog& violations)
        : Module(identity, index, options, violations), m_loop(identity.version) {}

    void set(Input input, std::optional<double> value) override { m_loop.set(input, value); }
    [[nodiscard]] ModuleSnapshot snapshot(TimePoint now) const override;
    void holdShaft(bool held) override { m_loop.holdShaft(held); }
    void reverseEncoder(bool reversed) override { m_loop.reverseEncoder(reversed); }

private:
    void resetChip() override { m_loop.reset(); }
    void runTicks(std::uint64_t ticks) override { m_loop.run(ticks); }
    void executeOwn(const Packet& packet) override;
    [[nodiscard]] std::uint8_t reservedBits(CommandCode code) const override;
    [[nodiscard]] std::uint8_t statusByte() const override { return m_loop.statusByte(); }
    [[nodiscard]] Items statusItems() const override;

    void resetPosition();
    void loadTrajectory(const Packet& packet);
    void startMotion();
    void setGain(const Packet& packet);
    void stopMotor(const Packet& packet);
    void setHoming(std::uint8_t control);

    ServoLoop m_loop;
};

}  // namespace nmc::sim
