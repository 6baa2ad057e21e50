// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/conformance/conformance.h"

namespace nmc::conformance {

/// The statements about the PIC-I/O (statements-io.md): one module at address 1.
class PicIo : public Statement {
protected:
    PicIo() { start("io", 1); }
    void start(const std::string& chain, unsigned count);

    Bytes command(unsigned code, const Bytes& data = {}, unsigned at = 1) {
        return rig->command(at, code, data);
    }
    Bytes read(unsigned items, unsigned at = 1) {
        return command(0x13, {static_cast<std::uint8_t>(items)}, at);
    }
    /// IO1 is bit 0, IO12 bit 11.
    unsigned pins(unsigned at = 1) { return wordAt(read(0x01, at), 1); }
    std::uint32_t count() { return static_cast<std::uint32_t>(longAt(read(0x10), 1)); }
    void direction(unsigned inputs, unsigned at = 1) { command(0x20, little(inputs, 2), at); }
    void output(unsigned high, unsigned at = 1) { command(0x26, little(high, 2), at); }
    void synchOutput(unsigned high, unsigned pwm1, unsigned pwm2, unsigned at = 1) {
        command(0x47, little(high, 2) + little(pwm1, 1) + little(pwm2, 1), at);
    }
    void timer(unsigned mode) { command(0x18, little(mode, 1)); }
    void set(const std::string& nameAndValue, unsigned module = 1) {
        rig->must("set " + std::to_string(module) + ' ' + nameAndValue);
    }
    void pulse(unsigned pin, int times);
    nlohmann::json truth(const char* name) { return rig->state()[name]; }
    std::vector<unsigned> pwm(int module = 1) {
        return rig->state(module)["pwm"].get<std::vector<unsigned>>();
    }
    void expectNoViolation() { EXPECT_EQ(rig->violations(), std::vector<std::string>{}); }
};

}  // namespace nmc::conformance
