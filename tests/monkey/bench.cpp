// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/monkey/bench.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>
#include <utility>

#include "base/bytes.h"
#include "sim/control.h"
#include "tests/monkey/virtualtime.h"

namespace nmc::monkey {

namespace {

constexpr std::uint8_t kHeaderByte = 0xAA;
constexpr std::size_t kShortest = 4;      // header, address, command, sum
constexpr std::uint8_t kStartNow = 0x80;  // of Load Trajectory's control byte

}  // namespace

bool Packet::starts() const {
    const std::uint8_t control = bytes.size() > kShortest ? bytes[3] : std::uint8_t{0};
    return code() == CommandCode::StartMotion ||
           (code() == CommandCode::LoadTrajectory && (control & kStartNow) != 0);
}

/// Lives in the bus thread, all of it.
class Bench::Port : public Transport {
public:
    Port(Bench& bench, std::string name) : m_bench(bench), m_name(std::move(name)) {
        std::unique_lock lock(m_bench.m_mutex);
        m_bench.waitForTurn(lock);
    }
    ~Port() override { m_bench.end(); }

    tl::expected<void, PortError> open() override {
        if (!m_bench.m_plugged)
            return tl::unexpected(error(PortProblem::NotFound));
        return setBaud(19'200);
    }
    tl::expected<void, PortError> setBaud(std::uint32_t baud) override {
        m_bench.m_chain.advanceTo(m_bench.chainTime());
        m_bench.m_chain.setHostBaud(baud);
        return {};
    }
    tl::expected<void, PortError> send(ByteSpan bytes) override {
        if (!m_bench.m_plugged)
            return tl::unexpected(error(PortProblem::Gone));
        note(bytes);
        m_bench.m_chain.hostSends(bytes, m_bench.chainTime());
        return {};
    }
    void discardInput() override { (void)arrived(); }

    tl::expected<std::vector<std::uint8_t>, PortError> receive(std::optional<TimePoint> until,
                                                               int wakeFd) override {
        while (true) {
            if (!m_bench.m_plugged)
                return tl::unexpected(error(PortProblem::Gone));
            std::vector<std::uint8_t> bytes = arrived();
            pollfd wake{wakeFd, POLLIN, 0};
            const bool woken = ::poll(&wake, 1, 0) > 0;
            if (woken || !bytes.empty() || (until && virtualtime::now() >= *until))
                return bytes;
            std::optional<TimePoint> next = until;
            if (const auto event = m_bench.m_chain.nextEvent()) {
                const TimePoint due = m_bench.m_powerUp + event->time_since_epoch();
                next = next ? std::min(*next, due) : due;
            }
            m_bench.waitUntil(next);
        }
    }
    std::optional<std::string> control(std::string_view line) override {
        return sim::handleControlLine(m_bench.m_chain, line, m_bench.chainTime());
    }

private:
    [[nodiscard]] PortError error(PortProblem problem) const {
        PortError error;
        error.problem = problem;
        error.port = m_name;
        return error;
    }
    std::vector<std::uint8_t> arrived() {
        m_bench.m_chain.advanceTo(m_bench.chainTime());
        std::vector<std::uint8_t> bytes;
        for (const sim::HostByte& byte : m_bench.m_chain.takeHostBytes())
            bytes.push_back(byte.value);
        return bytes;
    }
    /// Without the nulls between packets.
    void note(ByteSpan bytes) {
        for (std::size_t at = 0; at + kShortest <= bytes.size();) {
            if (bytes[at] != kHeaderByte) {
                ++at;
                continue;
            }
            const std::size_t end = std::min(at + kShortest + (bytes[at + 2] >> 4U), bytes.size());
            m_bench.m_packets.push_back({virtualtime::now(),
                                         {bytes.begin() + static_cast<std::ptrdiff_t>(at),
                                          bytes.begin() + static_cast<std::ptrdiff_t>(end)}});
            at = end;
        }
    }

    Bench& m_bench;
    std::string m_name;
};

Bench::Bench(const std::vector<ModuleIdentity>& modules, std::uint64_t seed)
    : m_chain(modules,
              [seed] {
                  sim::ChainOptions options;
                  options.seed = seed;
                  options.enableFaults = true;
                  return options;
              }()),
      m_powerUp(virtualtime::now()) {}

Composition::Transports Bench::transports() {
    return [this](const ConnectTarget& target) {
        m_open = true;
        return [this, name = target.port.toStdString()] { return std::make_unique<Port>(*this, name); };
    };
}

void Bench::run(Duration time) {
    std::unique_lock lock(m_mutex);
    m_until = virtualtime::now() + time;
    if (m_open) {
        m_guisTurn = false;
        m_changed.notify_all();
        m_changed.wait(lock, [this] { return m_guisTurn; });
    }
    virtualtime::set(m_until);
}

bool Bench::open() {
    const std::scoped_lock lock(m_mutex);
    return m_open;
}

void Bench::waitForTurn(std::unique_lock<std::mutex>& lock) {
    m_changed.wait(lock, [this] { return !m_guisTurn; });
}

void Bench::waitUntil(std::optional<TimePoint> time) {
    std::unique_lock lock(m_mutex);
    if (time && *time <= m_until) {
        virtualtime::set(std::max(virtualtime::now(), *time));
        return;
    }
    m_guisTurn = true;
    m_changed.notify_all();
    waitForTurn(lock);
}

void Bench::end() {
    const std::scoped_lock lock(m_mutex);
    m_open = false;
    m_guisTurn = true;
    m_changed.notify_all();
}

TimePoint Bench::chainTime() const {
    return TimePoint(virtualtime::now() - m_powerUp);
}

sim::ModuleSnapshot Bench::look(std::size_t place) {
    return m_chain.snapshot(ModuleIndex(static_cast<std::uint8_t>(place)), chainTime());
}

void Bench::tell(const std::string& line) {
    const std::string answer = sim::handleControlLine(m_chain, line, chainTime());
    if (answer.find("error") != std::string::npos)
        ADD_FAILURE() << line << ": " << answer;
}

bool Bench::driven(std::size_t place) {
    const sim::ModuleSnapshot module = look(place);
    if (module.stepper)
        return module.stepper->moving;
    const sim::ServoSnapshot& servo = module.servo;
    if (servo.servoOn)
        return servo.commandVelocity != 0.0;
    return servo.mode == sim::ServoMode::Pwm && servo.pwm != 0 && servo.ampEnabled && servo.power;
}

bool Bench::isOn(std::size_t place) {
    const sim::ModuleSnapshot module = look(place);
    return module.stepper ? module.stepper->ampEnabled : module.servo.servoOn || module.servo.pwm != 0;
}

std::string Bench::firstViolation() const {
    const auto& entries = m_chain.violations().entries();
    if (entries.empty())
        return {};
    const sim::Violation& first = entries.front();
    return std::string(sim::toText(first.kind)) + " of module " + std::to_string(first.module + 1) + ": " +
           toHex(first.bytes);
}

}  // namespace nmc::monkey
