// SPDX-License-Identifier: MIT
#include "bus/trust.h"

namespace nmc::bus {

namespace {

/// The bits that permit something when set, and those that do when clear.
struct Meaning {
    std::uint8_t whenSet = 0;
    std::uint8_t whenClear = 0;

    [[nodiscard]] std::uint8_t permits(std::uint8_t bits) const {
        return static_cast<std::uint8_t>((bits & whenSet) | (~bits & whenClear));
    }
    /// The bits with everything withheld that has not been granted.
    [[nodiscard]] std::uint8_t withhold(std::uint8_t bits, std::uint8_t granted) const {
        const unsigned without = bits & ~(unsigned{whenSet} & ~unsigned{granted});
        return static_cast<std::uint8_t>(without | (unsigned{whenClear} & ~unsigned{granted}));
    }
};

constexpr Meaning kServoStatus{0x01 | 0x08, 0x20 | 0x40 | 0x80};  // move_done, power; limits, homing
constexpr Meaning kStepperStatus{0x08, 0x01 | 0x80};              // power; moving, homing
constexpr Meaning kStepperInputs{0x00, 0x01 | 0x08 | 0x10};       // E-stop, limits
constexpr std::uint8_t kStandstill = 0x01;                        // bit 0 on both chips

[[nodiscard]] Meaning statusMeaning(ModuleType type) {
    return type == ModuleType::Servo     ? kServoStatus
           : type == ModuleType::Stepper ? kStepperStatus
                                         : Meaning{};
}

[[nodiscard]] Meaning auxMeaning(ModuleType type) {
    return type == ModuleType::Stepper ? kStepperInputs : Meaning{};
}

}  // namespace

Trust::Permits Trust::permitsOf(const StatusReport& report) const {
    Permits permits;
    permits.status = statusMeaning(m_module.type).permits(report.status);
    // If the inputs were not requested, nothing changes for them.
    permits.aux = report.aux ? auxMeaning(m_module.type).permits(*report.aux) : m_granted.aux;
    return permits;
}

std::optional<StatusReport> Trust::confirm(const StatusReport& report) {
    const Permits now = permitsOf(report);
    const std::size_t length = replyLength(m_module, report.items);
    const bool second = m_last && m_last->length != length;
    const auto grant = [&](std::uint8_t granted, std::uint8_t asked, std::uint8_t before) {
        const unsigned confirmed = second ? unsigned{before} : 0U;
        return static_cast<std::uint8_t>(asked & (granted | confirmed));
    };
    const Permits last = m_last ? m_last->permits : Permits{};
    m_granted.status = grant(m_granted.status, now.status, last.status);
    m_granted.aux = grant(m_granted.aux, now.aux, last.aux);
    m_last = Last{now, length};
    if (std::exchange(m_first, false))
        return std::nullopt;
    StatusReport trusted = report;
    trusted.status = statusMeaning(m_module.type).withhold(report.status, m_granted.status);
    if (report.aux)
        trusted.aux = auxMeaning(m_module.type).withhold(*report.aux, m_granted.aux);
    return trusted;
}

void Trust::expectMotion() {
    m_granted.status &= static_cast<std::uint8_t>(~kStandstill);
    m_last.reset();
}

}  // namespace nmc::bus
