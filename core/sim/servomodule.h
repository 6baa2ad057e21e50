// SPDX-License-Identifier: MIT
#pragma once

#include "sim/module.h"
#include "sim/servoloop.h"

namespace nmc::sim {

/// A PIC-SERVO with its PIC-ENC, amplifier and motor: its commands and status items. Versions 1 to 4 (DS-V
/// 5), 5 and 10 (docs/family.md).
class ServoModule final : public Module {
public:
    ServoModule(ModuleIdentity identity, std::uint8_t index, const ModuleOptions& options,
                ViolationLog& violations)
        : Module(identity, index, options, violations), m_loop(identity.version) {
        m_loop.setMotor(options.motor, options.seed + index);
    }

    void set(Input input, std::optional<double> value, unsigned) override { m_loop.set(input, value); }
    [[nodiscard]] ModuleSnapshot snapshot(TimePoint now) const override;
    void holdShaft(bool held) override { m_loop.holdShaft(held); }
    void reverseEncoder(bool reversed) override { m_loop.reverseEncoder(reversed); }

private:
    [[nodiscard]] bool obeysResetOfAll() const override { return isLater(); }
    [[nodiscard]] bool keepsUpWith(std::uint8_t brd) const override;
    [[nodiscard]] bool raisesAddressOutput() const override { return m_loop.steppingFault(); }
    void configureReset(const Packet& packet) override;
    void resetChip(Restart restart) override;
    void addressed() override;
    void runTicks(std::uint64_t ticks) override { m_loop.run(ticks); }
    void executeOwn(const Packet& packet) override;
    [[nodiscard]] std::uint8_t reservedBits(CommandCode code) const override;
    [[nodiscard]] std::uint8_t stopBits() const override { return 0x1E; }
    [[nodiscard]] std::uint8_t statusByte() const override { return m_loop.statusByte(); }
    void writeItems(ItemWriter writer) const override;

    [[nodiscard]] bool isLater() const { return identity().version >= 5; }
    [[nodiscard]] bool isSc() const { return identity().version >= 10; }
    void resetPosition(const Packet& packet);
    void controlIo(std::uint8_t control);
    void addPathPoints(const Packet& packet);
    void switchOnAsSaved();
    void loadTrajectory(const Packet& packet);
    void startMotion();
    void setGain(const Packet& packet);
    void stopMotor(const Packet& packet);
    void setHoming(std::uint8_t control);

    /// The configuration that an SC keeps across a power cycle.
    struct Saved {
        static constexpr std::uint8_t kSave = 0x01;
        static constexpr std::uint8_t kAddresses = 0x02;
        static constexpr std::uint8_t kAmplifier = 0x04;
        static constexpr std::uint8_t kServo = 0x08;
        static constexpr std::uint8_t kStepAndDirection = 0x10;
        static constexpr std::uint8_t kLimitProtection = 0x20;
        static constexpr std::uint8_t kThreePhase = 0x40;
        static constexpr std::uint8_t kAntiphase = 0x80;

        std::uint8_t control = 0;
        Place place;
        std::uint32_t velocity = 0;
        std::uint32_t acceleration = 0;
        Gains gains;

        [[nodiscard]] bool has(std::uint8_t bit) const { return (control & bit) != 0; }
        /// Returns the saved bits in the format of I/O Control: after a Hard Reset the two that survive it,
        /// otherwise all.
        [[nodiscard]] std::uint8_t ioControl(Restart restart) const;
    };

    ServoLoop m_loop;
    std::optional<Saved> m_saved;
    bool m_switchesOnWhenAddressed = false;
    bool m_advancedFeatures = false;  ///< CMC only
};

}  // namespace nmc::sim
