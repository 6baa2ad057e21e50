// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/virtualchain.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <QJsonDocument>
#include <algorithm>
#include <utility>

#include "base/bytes.h"
#include "sim/chainspec.h"
#include "sim/control.h"
#include "tests/support/virtualtime.h"

namespace nmc::testing_support {

namespace {

constexpr std::uint8_t kHeaderByte = 0xAA;
constexpr std::size_t kShortest = 4;      // header, address, command, checksum
constexpr std::uint8_t kStartNow = 0x80;  // in the control byte of Load Trajectory

/// In the order of their ports.
std::vector<VirtualChain*>& chains() {
    static std::vector<VirtualChain*> all;
    return all;
}

}  // namespace

bool Packet::starts() const {
    const std::uint8_t control = bytes.size() > kShortest ? bytes[3] : std::uint8_t{0};
    return code() == CommandCode::StartMotion ||
           (code() == CommandCode::LoadTrajectory && (control & kStartNow) != 0);
}

/// Used in the bus thread only.
class VirtualChain::Port : public Transport {
public:
    explicit Port(VirtualChain& chain) : m_on(chain) {
        std::unique_lock lock(m_on.m_mutex);
        m_on.waitForTurn(lock);
    }
    ~Port() override { m_on.end(); }

    tl::expected<void, PortError> open() override {
        if (!m_on.m_plugged)
            return tl::unexpected(error(PortProblem::NotFound));
        if (m_on.m_inUse)
            return tl::unexpected(error(PortProblem::InUse));
        discardInput();  // what arrived while no port was open
        return setBaud(19'200);
    }
    tl::expected<void, PortError> setBaud(std::uint32_t baud) override {
        m_on.m_chain.advanceTo(m_on.chainTime());
        m_on.m_chain.setHostBaud(baud);
        return {};
    }
    tl::expected<void, PortError> send(ByteSpan bytes) override {
        if (!m_on.m_plugged)
            return tl::unexpected(error(PortProblem::Gone));
        note(bytes);
        m_on.m_chain.hostSends(bytes, m_on.chainTime());
        return {};
    }
    void discardInput() override { (void)arrived(); }

    tl::expected<std::vector<std::uint8_t>, PortError> receive(std::optional<TimePoint> until,
                                                               int wakeFd) override {
        while (true) {
            if (!m_on.m_plugged)
                return tl::unexpected(error(PortProblem::Gone));
            std::vector<std::uint8_t> bytes = arrived();
            if (woken(wakeFd) || !bytes.empty() || (until && virtualtime::now() >= *until))
                return bytes;
            std::optional<TimePoint> next = until;
            if (const auto event = m_on.m_chain.nextEvent()) {
                const TimePoint due = m_on.m_powerUp + event->time_since_epoch();
                next = next ? std::min(*next, due) : due;
            }
            if (m_on.waitUntil(next))
                m_quietFd.reset();
        }
    }
    std::optional<std::string> control(std::string_view line) override {
        return sim::handleControlLine(m_on.m_chain, line, m_on.chainTime());
    }

private:
    [[nodiscard]] PortError error(PortProblem problem) const {
        PortError error;
        error.problem = problem;
        error.port = m_on.m_terminal.toStdString();
        return error;
    }
    /// Asks the kernel once for each turn of the GUI, which alone writes to it: a query for each byte would
    /// be an eighth of what such a test costs.
    bool woken(int wakeFd) {
        if (m_quietFd == wakeFd)
            return false;
        pollfd wake{wakeFd, POLLIN, 0};
        if (::poll(&wake, 1, 0) > 0)
            return true;
        m_quietFd = wakeFd;
        return false;
    }
    std::vector<std::uint8_t> arrived() {
        m_on.m_chain.advanceTo(m_on.chainTime());
        std::vector<std::uint8_t> bytes;
        for (const sim::HostByte& byte : m_on.m_chain.takeHostBytes())
            bytes.push_back(byte.value);
        return bytes;
    }
    /// Keeps the packets, without the nulls between them.
    void note(ByteSpan bytes) {
        for (std::size_t at = 0; at + kShortest <= bytes.size();) {
            if (bytes[at] != kHeaderByte) {
                ++at;
                continue;
            }
            const std::size_t end = std::min(at + kShortest + (bytes[at + 2] >> 4U), bytes.size());
            m_on.m_packets.push_back({virtualtime::now(),
                                      {bytes.begin() + static_cast<std::ptrdiff_t>(at),
                                       bytes.begin() + static_cast<std::ptrdiff_t>(end)}});
            at = end;
        }
    }

    VirtualChain& m_on;
    std::optional<int> m_quietFd;  ///< not readable since the GUI had its last turn
};

VirtualChain::VirtualChain(const std::vector<ModuleIdentity>& modules, std::uint64_t seed,
                           const QString& terminal)
    : m_chain(modules,
              [seed] {
                  sim::ChainOptions options;
                  options.seed = seed;
                  options.enableFaults = true;
                  return options;
              }()),
      m_terminal(terminal.isEmpty() ? QStringLiteral("/dev/ttyUSB%1").arg(chains().size()) : terminal),
      m_powerUp(beginning()) {
    chains().push_back(this);
}

/// A session begins at a whole second, as the first one in a process does. Otherwise it would depend on the
/// tests before it, because timers of the window and ticks of the modules would meet at other moments.
TimePoint VirtualChain::beginning() {
    if (chains().empty())
        virtualtime::set(
            TimePoint(std::chrono::ceil<std::chrono::seconds>(virtualtime::now().time_since_epoch())));
    return virtualtime::now();
}

VirtualChain::VirtualChain(const QString& modules, const QString& terminal)
    : VirtualChain(sim::parseChain(modules.toStdString()).value(), 1, terminal) {}

VirtualChain::~VirtualChain() {
    if (open())
        qFatal("A chain must outlive the panels at it.");
    std::erase(chains(), this);
}

VirtualChain* VirtualChain::at(const QString& terminal) {
    const auto chain = std::ranges::find(chains(), terminal, &VirtualChain::terminal);
    return chain != chains().end() ? *chain : nullptr;
}

void VirtualChain::runAll(Duration time) {
    const TimePoint until = virtualtime::now() + time;
    for (VirtualChain* chain : chains())
        if (chain->open())
            chain->run(until - virtualtime::now());
    virtualtime::set(until);
}

BusWorker::TransportFactory VirtualChain::transport() {
    m_open = true;
    return [this] { return std::make_unique<Port>(*this); };
}

void VirtualChain::run(Duration time) {
    std::unique_lock lock(m_mutex);
    m_until = virtualtime::now() + time;
    if (m_open) {
        m_guisTurn = false;
        m_changed.notify_all();
        m_changed.wait(lock, [this] { return m_guisTurn; });
    }
    virtualtime::set(m_until);
}

bool VirtualChain::open() {
    const std::scoped_lock lock(m_mutex);
    return m_open;
}

void VirtualChain::waitForTurn(std::unique_lock<std::mutex>& lock) {
    m_changed.wait(lock, [this] { return !m_guisTurn; });
}

bool VirtualChain::waitUntil(std::optional<TimePoint> time) {
    std::unique_lock lock(m_mutex);
    if (time && *time <= m_until) {
        virtualtime::set(std::max(virtualtime::now(), *time));
        return false;
    }
    m_guisTurn = true;
    m_changed.notify_all();
    waitForTurn(lock);
    return true;
}

void VirtualChain::end() {
    const std::scoped_lock lock(m_mutex);
    m_open = false;
    m_guisTurn = true;
    m_changed.notify_all();
}

TimePoint VirtualChain::chainTime() const {
    return TimePoint(virtualtime::now() - m_powerUp);
}

sim::ModuleSnapshot VirtualChain::look(std::size_t place) {
    return m_chain.snapshot(ModuleIndex(static_cast<std::uint8_t>(place)), chainTime());
}

QJsonObject VirtualChain::control(const QString& line) {
    return QJsonDocument::fromJson(
               QByteArray::fromStdString(sim::handleControlLine(m_chain, line.toStdString(), chainTime())))
        .object();
}

void VirtualChain::tell(const std::string& line) {
    const std::string answer = sim::handleControlLine(m_chain, line, chainTime());
    if (answer.find("error") != std::string::npos)
        ADD_FAILURE() << line << ": " << answer;
}

bool VirtualChain::driven(std::size_t place) {
    const sim::ModuleSnapshot module = look(place);
    if (module.stepper)
        return module.stepper->moving;
    const sim::ServoSnapshot& servo = module.servo;
    if (servo.servoOn)
        return servo.commandVelocity != 0.0;
    return servo.mode == sim::ServoMode::Pwm && servo.pwm != 0 && servo.ampEnabled;
}

bool VirtualChain::isOn(std::size_t place) {
    const sim::ModuleSnapshot module = look(place);
    return module.stepper ? module.stepper->ampEnabled : module.servo.servoOn || module.servo.pwm != 0;
}

std::string VirtualChain::violations() const {
    const auto& entries = m_chain.violations().entries();
    if (entries.empty())
        return {};
    const sim::Violation& first = entries.front();
    return std::string(sim::toText(first.kind)) + " of module " + std::to_string(first.module + 1) + ": " +
           toHex(first.bytes);
}

}  // namespace nmc::testing_support
