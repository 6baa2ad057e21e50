// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/conformance/rig.h"

#include <gtest/gtest.h>

#include "tests/conformance/inprocessrig.h"
#include "tests/conformance/terminalrig.h"

namespace nmc::conformance {

Bytes Rig::exchange(const Bytes& bytes) {
    send(bytes);
    return wait(std::chrono::milliseconds(20));
}

Bytes Rig::command(unsigned address, unsigned command, const Bytes& data) {
    return exchange(packet(address, command, data));
}

void Rig::address(unsigned count) {
    for (unsigned i = 1; i <= count; ++i)
        ASSERT_EQ(command(0, 0x21, {static_cast<std::uint8_t>(i), 0xFF}).size(), 2U) << "module " << i;
}

void Rig::must(const std::string& line) {
    const nlohmann::json answer = control(line);
    ASSERT_FALSE(answer.contains("error")) << line << ": " << answer;
}

std::vector<std::string> Rig::kinds(const char* list) {
    std::vector<std::string> all;
    const nlohmann::json stats = control("stats");
    for (const auto& entry : stats[list])
        all.push_back(entry["kind"]);
    return all;
}

Bytes packet(unsigned address, unsigned command, const Bytes& data) {
    Bytes bytes{0xAA, static_cast<std::uint8_t>(address), static_cast<std::uint8_t>(command)};
    bytes.insert(bytes.end(), data.begin(), data.end());
    return bytes + sumOf(Bytes(bytes.begin() + 1, bytes.end()));
}

Bytes sumOf(const Bytes& bytes) {
    unsigned sum = 0;
    for (const std::uint8_t byte : bytes)
        sum += byte;
    return {static_cast<std::uint8_t>(sum & 0xFFU)};
}

Bytes little(std::uint32_t value, int count) {
    Bytes bytes;
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU));
    return bytes;
}

Bytes operator+(Bytes left, const Bytes& right) {
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

unsigned byteAt(const Bytes& answer, std::size_t at) {
    EXPECT_LT(at, answer.size()) << "the answer is too short";
    return at < answer.size() ? answer[at] : 0U;
}

unsigned wordAt(const Bytes& answer, std::size_t at) {
    return byteAt(answer, at) | byteAt(answer, at + 1) << 8U;
}

std::int32_t longAt(const Bytes& answer, std::size_t at) {
    return static_cast<std::int32_t>(wordAt(answer, at) | wordAt(answer, at + 2) << 16U);
}

std::unique_ptr<Rig> makeRig(Place place, const std::string& chain, const std::vector<std::string>& options) {
    std::unique_ptr<Rig> rig;
    if (place == Place::InProcess)
        rig = std::make_unique<InProcessRig>(chain, options);
    else
        rig = std::make_unique<TerminalRig>(chain, options);
    rig->wait(std::chrono::milliseconds(10));
    return rig;
}

}  // namespace nmc::conformance
