// SPDX-License-Identifier: GPL-3.0-or-later
// A host program like those in the field, on nmcsim's terminal, using only POSIX and the data sheets. Every
// answer must arrive at once and be right, even at 57 600 Bd with code 20.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <map>

#include "tests/conformance/fieldhost.h"

namespace nmc {
namespace {

using namespace field;

std::uint8_t byte(unsigned value) {
    return static_cast<std::uint8_t>(value & 0xFFU);
}

Bytes little(std::uint32_t value, unsigned count) {
    Bytes bytes;
    for (unsigned i = 0; i < count; ++i)
        bytes.push_back(byte(value >> (8 * i)));
    return bytes;
}

/// A status packet, decoded by the items that were requested.
struct Status {
    unsigned byte = 0;
    std::int32_t position = 0;
    unsigned analog = 0;
    unsigned speed = 0;  ///< PIC-SERVO: minus the velocity; PIC-STEP: timer count
    unsigned pins = 0;   ///< PIC-SERVO: auxiliary byte; PIC-STEP: inputs
    std::int32_t home = 0;
    unsigned type = 99;
    unsigned version = 0;

    [[nodiscard]] bool has(unsigned bit) const { return (byte >> bit & 1U) != 0; }
    [[nodiscard]] int velocity() const { return -static_cast<std::int16_t>(speed); }
};

class FieldHost {
public:
    explicit FieldHost(Sim& sim) : m_wire(sim) {}

    /// 20 nulls and Hard Reset, twice; then Set Address until no module answers.
    unsigned enumerate() {
        for (int i = 0; i < 2; ++i) {
            m_wire.exchange(Bytes(20, 0));
            m_wire.exchange(packet(kEveryone, 0x0F), 0.1);
        }
        unsigned address = 1;
        while (m_wire.exchange(packet(0, 0x21, {byte(address), kEveryone})).size() == 2)
            ++address;
        m_wire.exchange(Bytes(30, 0));  // the last Set Address was for no module
        return address - 1;
    }

    void goTo(unsigned code, speed_t rate) {
        tell(kEveryone, 0x1A, {byte(code)});
        for (unsigned a = 1; a <= kModules; ++a)
            ++m_asked[{a, 0x0A}];
        m_wire.setRate(rate);
    }

    /// Sends one command and returns its answer.
    Status ask(unsigned address, unsigned command, const Bytes& data = {}) {
        const unsigned code = command & 0x0FU;
        if (code == 0x02)
            m_items[address] = data[0];
        const unsigned items = code == 0x03 ? data[0] : m_items[address];
        ++m_asked[{address, code}];
        const Bytes answer = answered(packet(address, command, data), items);
        if ((answer.front() & 0x02U) != 0)
            throw std::runtime_error("module " + std::to_string(address) + " has heard a wrong sum");
        return decoded(answer, items);
    }
    /// Sends a command that is not answered.
    void tell(unsigned group, unsigned command, const Bytes& data = {}) {
        EXPECT_EQ(m_wire.exchange(packet(group, command, data)), Bytes());
    }

    /// Reads all items until `wanted` is true.
    Status until(unsigned address, const std::function<bool(const Status&)>& wanted) {
        for (int i = 0; i < kPatience; ++i)
            if (const Status status = ask(address, 0x13, {0x3F}); wanted(status))
                return status;
        throw std::runtime_error("module " + std::to_string(address) + " never gets there");
    }

    /// Sends a packet with a wrong sum; returns the status byte of the answer.
    unsigned wrongSum(unsigned address) {
        Bytes bytes = packet(address, 0x00);
        bytes.back() ^= 0x40U;
        return answered(bytes, m_items[address]).front();
    }

    void becomes(unsigned before, unsigned after) { m_items[after] = m_items[before]; }

    static constexpr unsigned kModules = 4;
    [[nodiscard]] const Wire& wire() const { return m_wire; }
    [[nodiscard]] unsigned asked(unsigned address, unsigned code) { return m_asked[{address, code}]; }

private:
    static Bytes packet(unsigned address, unsigned command, const Bytes& data = {}) {
        Bytes bytes{0xAA, byte(address), byte(command)};
        unsigned sum = address + command;
        for (const std::uint8_t value : data) {
            bytes.push_back(value);
            sum += value;
        }
        bytes.push_back(byte(sum));
        return bytes;
    }

    /// Status byte, items and sum.
    static std::size_t replyLength(unsigned items) {
        static constexpr std::array<std::size_t, 6> kSizes{4, 1, 2, 1, 4, 2};
        std::size_t length = 2;
        for (unsigned i = 0; i < kSizes.size(); ++i)
            length += (items >> i & 1U) != 0 ? kSizes[i] : 0;
        return length;
    }

    static Status decoded(const Bytes& answer, unsigned items) {
        std::size_t at = 1;
        const auto next = [&](unsigned item, unsigned count) {
            std::uint32_t value = 0;
            if ((items >> item & 1U) == 0)
                return value;
            for (unsigned i = 0; i < count; ++i)
                value |= std::uint32_t{answer[at++]} << (8 * i);
            return value;
        };
        Status s;
        s.byte = answer[0];
        s.position = static_cast<std::int32_t>(next(0, 4));
        s.analog = next(1, 1);
        s.speed = next(2, 2);
        s.pins = next(3, 1);
        s.home = static_cast<std::int32_t>(next(4, 4));
        const unsigned identity = next(5, 2);
        s.type = identity & 0xFFU;
        s.version = identity >> 8U;
        return s;
    }

    /// Returns the answer, which must have the right length and sum.
    Bytes answered(const Bytes& bytes, unsigned items) {
        Bytes answer = m_wire.exchange(bytes);
        if (answer.size() != replyLength(items))
            throw std::runtime_error("an answer of " + std::to_string(answer.size()) + " bytes");
        unsigned sum = 0;
        for (std::size_t i = 0; i + 1 < answer.size(); ++i)
            sum += answer[i];
        if (byte(sum) != answer.back())
            throw std::runtime_error("an answer with a wrong sum");
        return answer;
    }

    using Key = std::pair<unsigned, unsigned>;  // address, command code
    Wire m_wire;
    std::map<unsigned, unsigned> m_items;  ///< by address; as defined, none after a reset
    std::map<Key, unsigned> m_asked;
};

/// A rate, its code, and the actual rate of the modules: 1 250 000 / (code + 1).
struct Rate {
    const char* name;
    speed_t speed;
    unsigned code;
    int real;
};

class HostProgram : public testing::TestWithParam<Rate> {
protected:
    HostProgram() : sim("servo,servo@1,servo@3,step", {"--stepped"}), host(sim) {}

    void everyServoCommand(unsigned address, unsigned version);
    void everyStepCommand(unsigned address);
    void groups();
    void addresses(unsigned address);
    void books();

    /// The simulator's state of the module at an address; both are numbered alike.
    nlohmann::json truth(unsigned address) { return sim.state(static_cast<int>(address)); }
    void set(unsigned address, const std::string& what) {
        const auto answer = sim.control("set " + std::to_string(address) + " " + what);
        ASSERT_FALSE(answer.contains("error")) << answer;
    }

    Sim sim;
    FieldHost host;
};

constexpr std::uint32_t perTick(double counts) {
    return static_cast<std::uint32_t>(counts * 65536.0);
}

// Without an integral the motor comes to rest where the filter's output no longer overcomes dry friction:
// 0.004 N*m are 0.105 A or 0.12 V, which is less than 2 of 255 at 24 V; 2 * 256 / Kp 200 is 2.6 counts.
constexpr int kAtGoal = 4;

auto reached(std::int32_t goal) {
    return [goal](const Status& s) { return s.has(0) && std::abs(s.position - goal) <= kAtGoal; };
}

void HostProgram::everyServoCommand(unsigned a, unsigned version) {
    EXPECT_EQ(host.ask(a, 0x0E).byte, 0x19U) << "No Operation: move done, power, servo off";
    EXPECT_EQ(host.wrongSum(a) & 0x02U, 0x02U);
    Status s = host.ask(a, 0x12, {0x3F});  // Define Status
    EXPECT_EQ(s.type, 0U);
    EXPECT_EQ(host.ask(a, 0x0E).version, version);

    // Set Gain, 14 and 15 data bytes: Kp, Kd, Ki, IL, OL, CL, EL, SR, DB.
    const Bytes rest =
        little(2000, 2) + little(0, 2) + little(0, 2) + Bytes{255, 0} + little(0x3FFF, 2) + Bytes{1};
    host.ask(a, 0xE6, little(100, 2) + rest + Bytes{0});
    EXPECT_EQ(truth(a)["gains"]["kp"], 100);
    host.ask(a, 0xF6, little(200, 2) + rest + Bytes{0, 0x77});
    const nlohmann::json gains{{"kp", 200}, {"kd", 2000},   {"ki", 0}, {"il", 0}, {"ol", 255},
                               {"cl", 0},   {"el", 0x3FFF}, {"sr", 1}, {"db", 0}};
    EXPECT_EQ(truth(a)["gains"], gains);

    s = host.ask(a, 0x18, {0x09});  // I/O Control: limit 1 is an output, and high
    EXPECT_TRUE(s.has(5));
    EXPECT_TRUE(truth(a)["limit1"]);
    EXPECT_FALSE(host.ask(a, 0x18, {0x0C}).has(5)) << "an input again";

    s = host.ask(a, 0x17, {0x05});  // Stop Motor: amplifier on, stop abruptly, which turns the servo on
    EXPECT_EQ(s.pins & 0x04U, 0x04U);
    EXPECT_TRUE(truth(a)["servo_on"]);
    EXPECT_TRUE(truth(a)["amp_enabled"]);
    EXPECT_FALSE(host.ask(a, 0x0B).has(4)) << "Clear Sticky Bits: no position error";
    host.ask(a, 0x00);  // Reset Position
    EXPECT_NEAR(host.ask(a, 0x0E).position, 0, 1);

    // Load Trajectory, trapezoidal; nothing moves before Start Motion.
    host.ask(a, 0xD4, Bytes{0x17} + little(1500, 4) + little(perTick(8), 4) + little(perTick(0.05), 4));
    EXPECT_NEAR(host.ask(a, 0x0E).position, 0, 1);
    host.ask(a, 0x05);
    s = host.until(a, reached(1500));
    EXPECT_NEAR(truth(a)["position"].get<int>(), s.position, 1);
    host.ask(a, 0x0C);  // Save as Home
    s = host.ask(a, 0x0E);
    EXPECT_NEAR(s.home, 1500, kAtGoal);
    EXPECT_EQ(truth(a)["home"], s.home);

    // Velocity mode, and a smooth stop.
    host.ask(a, 0x94, Bytes{0xB6} + little(perTick(3), 4) + little(perTick(0.1), 4));
    host.until(a, [](const Status& now) { return now.has(0) && std::abs(now.velocity() - 3) <= 1; });
    EXPECT_EQ(truth(a)["mode"], "velocity");
    host.ask(a, 0x17, {0x09});
    host.until(a, [](const Status& now) { return now.has(0) && now.velocity() == 0; });

    // Homing on a change of limit 1, abrupt stop, which versions 1 and 2 leave to the host.
    EXPECT_TRUE(host.ask(a, 0x19, {0x11}).has(7));
    host.ask(a, 0x94, Bytes{0xF6} + little(perTick(1), 4) + little(perTick(0.1), 4));
    set(a, "limit1 1");
    s = host.until(a, [](const Status& now) { return !now.has(7); });
    EXPECT_TRUE(s.has(5));
    EXPECT_EQ(truth(a)["home"], s.home);
    if (version < 3)
        host.ask(a, 0x17, {0x05});
    s = host.until(a, [](const Status& now) { return now.has(0) && now.velocity() == 0; });
    set(a, "limit1 0");

    if (version > 1) {  // stop here
        const std::int32_t here = s.position + 100;
        host.ask(a, 0x57, Bytes{0x11} + little(static_cast<std::uint32_t>(here), 4));
        host.until(a, reached(here));
        EXPECT_EQ(truth(a)["mode"], "stop-here");
    }

    host.ask(a, 0x24, {0x88, 30});  // PWM mode
    EXPECT_EQ(truth(a)["pwm"], 30);
    EXPECT_EQ(truth(a)["mode"], "pwm");
    s = host.ask(a, 0x17, {0x02});  // motor off
    EXPECT_EQ(s.pins & 0x04U, 0U);
    EXPECT_EQ(truth(a)["pwm"], 0);
    EXPECT_FALSE(truth(a)["amp_enabled"]);
}

void HostProgram::everyStepCommand(unsigned a) {
    EXPECT_EQ(host.ask(a, 0x0E).byte & 0x0FU, 0x08U) << "No Operation: power; amplifier off, at rest";
    EXPECT_EQ(host.wrongSum(a) & 0x02U, 0x02U);
    Status s = host.ask(a, 0x12, {0x3F});
    EXPECT_EQ(s.type, 3U);
    EXPECT_EQ(s.version, 1U);
    host.ask(a, 0x56, {0x03, 1, 200, 80, 0});  // Set Parameters: 1x, minimum speed 1
    EXPECT_TRUE(host.ask(a, 0x17, {0x01}).has(2)) << "amplifier on";
    host.ask(a, 0x18, {0x15});  // Set Outputs
    EXPECT_EQ(truth(a)["outputs"], 0x15);
    host.ask(a, 0x00);

    // A trapezoid of 200 steps at speed 40, 1000 steps/s; it does not begin before Start Motion.
    host.ask(a, 0x74, Bytes{0x07} + little(200, 4) + Bytes{40, 1});
    EXPECT_EQ(host.ask(a, 0x0E).position, 0);
    host.ask(a, 0x05);
    host.until(a, [](const Status& now) { return !now.has(0) && now.position == 200; });
    EXPECT_EQ(truth(a)["position"], 200);
    EXPECT_EQ(host.ask(a, 0x0C).home, 200);
    EXPECT_EQ(truth(a)["home"], 200);

    // Velocity mode at speed 20, 500 steps/s: count 65536 - 625000/500 + 2.
    host.ask(a, 0x34, {0x86, 20, 2});
    s = host.until(a, [](const Status& now) { return now.has(0) && now.has(4); });
    EXPECT_TRUE(s.has(5));
    EXPECT_EQ(s.speed, 64'288U);
    EXPECT_DOUBLE_EQ(truth(a)["step_rate"].get<double>(), 500.0);
    host.ask(a, 0x17, {0x09});
    host.until(a, [](const Status& now) { return !now.has(0); });

    // Unprofiled by its timer count, in reverse; stopped abruptly.
    host.ask(a, 0x44, Bytes{0x98} + little(64'288, 2) + Bytes{20});
    EXPECT_DOUBLE_EQ(truth(a)["step_rate"].get<double>(), -500.0);
    EXPECT_FALSE(host.ask(a, 0x17, {0x05}).has(0));

    // Homing on the home switch with an abrupt stop: the motor stops where home was captured.
    EXPECT_TRUE(host.ask(a, 0x19, {0x18}).has(7));
    host.ask(a, 0x34, {0x86, 20, 2});
    set(a, "home_switch 1");
    s = host.until(a, [](const Status& now) { return !now.has(7) && !now.has(0); });
    EXPECT_EQ(s.home, s.position);
    EXPECT_EQ(s.pins & 0x20U, 0x20U);
    EXPECT_EQ(truth(a)["home"], s.home);
    set(a, "home_switch 0");
    EXPECT_FALSE(host.ask(a, 0x17, {0x00}).has(2));
}

/// Moves a module to another address and back.
void HostProgram::addresses(unsigned a) {
    const unsigned other = a + 20;
    const auto move = [&](unsigned from, unsigned to) {
        host.becomes(from, to);
        host.ask(from, 0x21, {byte(to), kEveryone});
        EXPECT_EQ(truth(a)["address"], to);
    };
    move(a, other);
    EXPECT_EQ(host.ask(other, 0x13, {0x20}).type, truth(a)["type"] == "step" ? 3U : 0U);
    move(other, a);
}

/// A group of 1 and 2 with 1 as its leader, which is the only one to answer.
void HostProgram::groups() {
    host.ask(1, 0x21, {1, 0x05});
    host.ask(2, 0x21, {2, 0x85});
    EXPECT_EQ(truth(1)["group"], 0x85);
    EXPECT_TRUE(truth(1)["leader"]);
    EXPECT_FALSE(truth(2)["leader"]);
    host.becomes(1, 0x85);
    EXPECT_EQ(host.ask(0x85, 0x13, {0x20}).version, 4U) << "the leader has answered";
    host.ask(2, 0x00);
    host.ask(0x85, 0x0C);
    EXPECT_EQ(host.ask(2, 0x0E).home, host.ask(2, 0x0E).position);
    EXPECT_EQ(truth(1)["home"], truth(1)["position"]);
    EXPECT_EQ(truth(2)["home"], truth(2)["position"]);
    host.ask(1, 0x21, {1, kEveryone});
    host.ask(2, 0x21, {2, kEveryone});
}

/// Checks that nmcsim and this host have counted the same.
void HostProgram::books() {
    const nlohmann::json stats = sim.control("stats");
    EXPECT_EQ(stats["bytes_in"], host.wire().sent());
    EXPECT_EQ(stats["bytes_out"], host.wire().received());
    unsigned replies = 0;
    for (const auto& module : stats["modules"])
        replies += module["replies"].get<unsigned>();
    EXPECT_EQ(stats["exchanges"], replies);
    const std::map<std::string, unsigned> codes{
        {"define_status", 2},  {"load_trajectory", 4}, {"start_motion", 5},      {"set_gain", 6},
        {"set_parameters", 6}, {"stop_motor", 7},      {"io_control", 8},        {"set_outputs", 8},
        {"set_homing", 9},     {"set_baud", 10},       {"clear_sticky_bits", 11}};
    for (unsigned a = 1; a <= FieldHost::kModules; ++a) {
        for (const auto& [name, count] : stats["modules"][a - 1]["executed"].items()) {
            const auto code = codes.find(name);
            if (code == codes.end())
                continue;  // also sent to all, or while no module had an address
            EXPECT_EQ(count, host.asked(a, code->second)) << name << " " << a;
        }
        EXPECT_EQ(stats["modules"][a - 1]["checksum_errors"], 1);
    }
    EXPECT_EQ(stats["violations"], nlohmann::json::array());
}

TEST_P(HostProgram, WorksUnchangedWithEveryCommandOfBothModuleTypes) {
    ASSERT_EQ(host.enumerate(), FieldHost::kModules);
    const std::array<std::pair<unsigned, unsigned>, FieldHost::kModules> identities{
        {{0, 4}, {0, 1}, {0, 3}, {3, 1}}};
    for (unsigned a = 1; a <= FieldHost::kModules; ++a) {
        const Status s = host.ask(a, 0x13, {0x20});
        EXPECT_EQ(std::pair(s.type, s.version), identities[a - 1]);
    }
    host.goTo(GetParam().code, GetParam().speed);
    for (unsigned a = 1; a <= FieldHost::kModules; ++a)
        EXPECT_EQ(truth(a)["baud"], GetParam().real);

    for (unsigned a = 1; a <= 3; ++a)
        everyServoCommand(a, identities[a - 1].second);
    everyStepCommand(4);
    books();
    groups();
    for (unsigned a = 1; a <= FieldHost::kModules; ++a)
        addresses(a);

    host.tell(kEveryone, 0x0F);
    for (unsigned a = 1; a <= FieldHost::kModules; ++a) {
        EXPECT_EQ(truth(a)["address"], 0);
        EXPECT_EQ(truth(a)["baud"], 19'531);
    }
}

INSTANTIATE_TEST_SUITE_P(Rates, HostProgram,
                         testing::Values(Rate{"19200", B19200, 63, 19'531},
                                         Rate{"57600Code20", B57600, 20, 59'524},
                                         Rate{"57600Code21", B57600, 21, 56'818},
                                         Rate{"115200", B115200, 10, 113'636}),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace nmc
