// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/conformance/picio.h"

namespace nmc::conformance {

INSTANTIATE_TEST_SUITE_P(, PicIo, kPlaces, nameOf);

void PicIo::start(const std::string& chain, unsigned count) {
    make(chain);
    rig->address(count);
}

void PicIo::pulse(unsigned pin, int times) {
    for (int i = 0; i < times; ++i) {
        set("in " + std::to_string(pin) + " 1");
        set("in " + std::to_string(pin) + " 0");
    }
}

}  // namespace nmc::conformance
