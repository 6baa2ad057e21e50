// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "link/clock.h"
#include "protocol/servocommands.h"
#include "tests/support/gains.h"
#include "tests/support/lineprocess.h"
#include "tests/support/patience.h"
#include "tests/support/port.h"
#include "tests/support/simprocess.h"

namespace nmc::testing_support {

/// Checks the predicate until it holds; false if it never does.
template <typename Predicate>
bool comesTrue(Predicate predicate) {
    const TimePoint patience = monotonicNow() + std::chrono::milliseconds(kPatienceMs);
    while (!predicate()) {
        if (monotonicNow() > patience)
            return false;
        pollUntil({}, monotonicNow() + std::chrono::milliseconds(1));
    }
    return true;
}

/// A temporary folder for reports.
class ReportFolder {
public:
    ReportFolder() {
        std::string name = testing::TempDir() + "nmcguard-XXXXXX";
        m_path = ::mkdtemp(name.data());
    }
    ~ReportFolder() { std::filesystem::remove_all(m_path); }
    ReportFolder(const ReportFolder&) = delete;
    ReportFolder& operator=(const ReportFolder&) = delete;
    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] std::string file() const { return m_path + "/guardian-1.report"; }

private:
    std::string m_path;
};

/// nmcsim with two servos, at addresses 1 and 2, of which the first can be started.
class Chain {
public:
    /// `baud`: 19 200 or 115 200.
    explicit Chain(std::uint32_t baud = 19'200) : m_baud(baud) {
        Port port(m_sim.terminal());
        port.setRate(B19200);
        say(port, {0xAA, 0x00, 0x21, 0x01, 0xFF, 0x21});
        say(port, {0xAA, 0x00, 0x21, 0x02, 0xFF, 0x22});
        say(port, packet(encode(testing_support::kGains)));
        if (baud == 115'200) {
            port.write({0xAA, 0xFF, 0x1A, 0x0A, 0x23});  // Set Baud, which is not answered
            port.setRate(B115200);
            EXPECT_TRUE(comesTrue([&] { return m_sim.state(1)["baud"].get<int>() > 100'000; }));
        }
    }

    /// Runs motor 1 at 8 counts/tick without an end.
    void setGoing() {
        Port port(m_sim.terminal());
        say(port, {0xAA, 0x01, 0x17, 0x05, 0x1D});  // amplifier on, stop abruptly: the servo holds
        servo::LoadTrajectory load;
        load.velocity = CountsPerTick(8 << 16);
        load.acceleration = CountsPerTickSquared(65'536);
        load.profile = servo::ProfileMode::Velocity;
        load.startNow = true;
        say(port, packet(encode(load)));
        ASSERT_TRUE(comesTrue([&] { return velocity() > 7.9; }));
    }
    /// The velocity of the command: 0 if the motor is to hold.
    [[nodiscard]] double velocity() { return std::abs(m_sim.state(1)["command_velocity"].get<double>()); }
    [[nodiscard]] bool stops() {
        return comesTrue([&] { return velocity() < 0.01; });
    }
    /// Number of bytes that it has received so far.
    [[nodiscard]] int received() { return m_sim.control("time")["received"].get<int>(); }

    /// The stop of motor 1, as the engine composes it: nulls, the packet, and nulls for a servo tick.
    [[nodiscard]] std::vector<std::uint8_t> burst() const {
        std::vector<std::uint8_t> bytes(16, 0);
        const std::vector<std::uint8_t> stop{0xAA, 0x01, 0x17, 0x05, 0x1D};
        bytes.insert(bytes.end(), stop.begin(), stop.end());
        bytes.insert(bytes.end(), m_baud / 19'200 + 1, 0);
        return bytes;
    }
    [[nodiscard]] std::uint32_t baud() const { return m_baud; }
    SimProcess& sim() { return m_sim; }
    [[nodiscard]] static std::vector<std::uint8_t> packet(const Payload& payload) {
        const PacketBytes bytes = toPacket({BusAddress(1), payload});
        return {bytes.begin(), bytes.end()};
    }

private:
    /// Sends a packet, and waits for the status byte and the checksum.
    static void say(Port& port, const std::vector<std::uint8_t>& bytes) {
        port.write(bytes);
        std::size_t heard = 0;
        while (heard < 2) {
            const auto more = port.read(2 - heard, kPatienceMs);
            if (more.empty())
                throw std::runtime_error("no answer");
            heard += more.size();
        }
    }

    std::uint32_t m_baud;
    SimProcess m_sim{"servo,servo", {"--reset-dead-time", "0"}};
};

/// A panel reduced to a port and a guardian (host.cpp), on a Chain.
class GuardHost {
public:
    explicit GuardHost(const Chain& chain, const std::string& terminal, const std::string& reportFile,
                       const std::string& program = NMCGUARD_PATH)
        : m_chain(chain),
          m_process(std::in_place, std::vector<std::string>{GUARDHOST_PATH, terminal, program, reportFile}) {
        m_ready = m_process->answer();
    }
    /// Its guardian may still be writing its report, into a folder that the test is about to remove.
    ~GuardHost() {
        m_process.reset();
        EXPECT_TRUE(m_guard <= 0 || guardIsGone());
    }
    GuardHost(const GuardHost&) = delete;
    GuardHost& operator=(const GuardHost&) = delete;

    /// "ready" or "busy".
    [[nodiscard]] const std::string& ready() const { return m_ready; }
    std::string ask(const std::string& line) {
        m_process->tell(line);
        return m_process->answer();
    }
    /// Starts its guardian and arms it with the stop of motor 1, which moves. Its beats are steady.
    void guardMotion() {
        m_guard = std::stoi(ask("start"));
        ASSERT_EQ(ask("arm " + std::to_string(m_chain.baud()) + ' ' + toHex(m_chain.burst())), "ok");
        ASSERT_EQ(ask("steady"), "ok");
        ASSERT_EQ(ask("move"), "ok");
    }
    void write(const std::vector<std::uint8_t>& bytes) {
        ASSERT_EQ(ask("write " + toHex(bytes)), std::to_string(bytes.size()));
    }
    void send(int signal) const { ::kill(m_process->pid(), signal); }
    void die() {
        send(SIGKILL);
        m_process->wait();
    }
    [[nodiscard]] pid_t guard() const { return m_guard; }
    [[nodiscard]] bool guardIsGone() const {
        return comesTrue([this] { return ::kill(m_guard, 0) != 0 || isZombie(m_guard); });
    }
    LineProcess& process() { return *m_process; }

private:
    static bool isZombie(pid_t process);

    const Chain& m_chain;
    std::optional<LineProcess> m_process;
    std::string m_ready;
    pid_t m_guard = -1;
};

}  // namespace nmc::testing_support
