// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/faultybus.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "sim/faultspec.h"

namespace nmc::test {

using namespace std::chrono_literals;

namespace {

sim::ChainOptions ofSeed(std::uint64_t seed) {
    sim::ChainOptions options;
    options.seed = seed;
    return options;
}

bus::EngineConfig atRate(std::uint32_t baud) {
    bus::EngineConfig config;
    config.baud = baud;
    return config;
}

}  // namespace

FaultyBus::FaultyBus(const std::vector<ModuleIdentity>& modules, bus::EngineConfig config, std::uint64_t seed)
    : FaultyBus(modules, config, ofSeed(seed)) {}

FaultyBus::FaultyBus(const std::vector<ModuleIdentity>& modules, std::uint32_t baud, std::uint64_t seed)
    : FaultyBus(modules, atRate(baud), seed) {}

FaultyBus::FaultyBus(const std::vector<ModuleIdentity>& modules, bus::EngineConfig config,
                     sim::ChainOptions options)
    : VirtualBus(modules, config, withFaults(std::move(options))) {}

void FaultyBus::fault(const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; stream >> word;)
        words.push_back(word);
    const std::vector<std::string_view> views(words.begin(), words.end());
    std::vector<ModuleIdentity> identities;
    for (std::uint8_t i = 0; i < chain.moduleCount(); ++i)
        identities.push_back(chain.identity(ModuleIndex(i)));
    const auto spec = sim::parseFault(views, identities);
    if (!spec) {
        ADD_FAILURE() << line << ": " << spec.error();
        return;
    }
    if (const auto number = chain.inject(*spec, now); !number)
        ADD_FAILURE() << line << ": " << number.error();
}

std::uint64_t FaultyBus::struck() const {
    std::uint64_t sum = 0;
    for (const sim::FaultReport& report : chain.faults())
        sum += report.struck;
    return sum;
}

bool FaultyBus::restart() {
    const std::size_t found = count<bus::ChainFound>();
    const std::size_t failed = count<bus::ConnectFailed>();
    restartNetwork(engine, now);
    const auto ended = [&] {
        return count<bus::ChainFound>() > found || count<bus::ConnectFailed>() > failed;
    };
    return runUntil(ended, 30s) && count<bus::ChainFound>() > found;
}

bool FaultyBus::connectAndEnable() {
    if (!connect())
        return false;
    for (std::uint8_t i = 0; i < chain.moduleCount(); ++i)
        if (chain.identity(ModuleIndex(i)).type == ModuleType::Servo &&
            perform({gains(i), enable(i)}) != bus::Outcome::Done)
            return false;
    return true;
}

std::uint64_t FaultyBus::sentTo(std::uint8_t module, CommandCode code, std::size_t from) const {
    std::uint64_t n = 0;
    for (std::size_t i = from; i < sent.size(); ++i) {
        const auto& bytes = sent[i].bytes;
        if (codeOf(bytes) != code)
            continue;
        n += bytes[1] == 0 || bytes[1] >= 0x80 || bytes[1] == module + 1 ? 1U : 0U;
    }
    return n;
}

void FaultyBus::expectOnlyExecutedWhatWasSent() const {
    for (std::uint8_t module = 0; module < chain.moduleCount(); ++module)
        for (unsigned c = 0; c < 16; ++c) {
            const auto code = static_cast<CommandCode>(c);
            EXPECT_LE(executed(module, code), sentTo(module, code))
                << "command " << c << " of module " << int{module};
        }
}

void FaultyBus::expectOnlyQuestions(std::size_t from) const {
    for (std::size_t i = from; i < sent.size(); ++i)
        if (const auto code = codeOf(sent[i].bytes); code && changesSomething(*code))
            ADD_FAILURE() << sent[i].hex() << " was sent at " << toSeconds(sent[i].time.time_since_epoch())
                          << " s";
}

std::size_t FaultyBus::packets(std::size_t from) const {
    std::size_t n = 0;
    for (std::size_t i = from; i < sent.size(); ++i)
        n += codeOf(sent[i].bytes) ? 1U : 0U;
    return n;
}

bus::LinkHealth FaultyBus::health() const {
    bus::LinkHealth health = bus::LinkHealth::Good;
    for (const auto& event : all<bus::HealthChanged>())
        if (ofWholeBus(event) || event.health == bus::LinkHealth::Lost)
            health = event.health;
    return health;
}

std::size_t FaultyBus::motionSuspects(std::uint8_t module) const {
    const auto suspects = all<bus::MotionSuspect>();
    return static_cast<std::size_t>(std::count_if(suspects.begin(), suspects.end(), [&](const auto& suspect) {
        return suspect.module.value() == module;
    }));
}

bool FaultyBus::stands(std::uint8_t module) {
    const sim::ModuleSnapshot snapshot = chain.snapshot(ModuleIndex(module), now);
    if (snapshot.stepper)
        return !snapshot.stepper->moving;
    // While the servo is off, its command position follows the shaft.
    const bool commanded = snapshot.servo.servoOn && snapshot.servo.commandVelocity != 0;
    return !commanded && std::abs(snapshot.servo.velocity) < 1;
}

bool FaultyBus::stopped(const bus::StopFinished& event, std::uint8_t module) {
    return std::ranges::count(event.stopped, ModuleIndex(module)) > 0;
}

std::optional<CommandCode> codeOf(ByteSpan packet) {
    if (packet.size() < 4 || packet[0] != kHeader)
        return std::nullopt;
    return static_cast<CommandCode>(packet[2] & 0x0FU);
}

bool changesSomething(CommandCode code) {
    switch (code) {
        case CommandCode::Nop:
        case CommandCode::ReadStatus:
        case CommandCode::DefineStatus:
        case CommandCode::StopMotor:
            return false;
        case CommandCode::ResetPosition:
        case CommandCode::SetAddress:
        case CommandCode::LoadTrajectory:
        case CommandCode::StartMotion:
        case CommandCode::SetGain:
        case CommandCode::IoControl:
        case CommandCode::SetHoming:
        case CommandCode::SetBaud:
        case CommandCode::ClearStickyBits:
        case CommandCode::SaveAsHome:
        case CommandCode::HardReset:
        case CommandCode::AddPathPoints:
            return true;
    }
    return true;
}

}  // namespace nmc::test
