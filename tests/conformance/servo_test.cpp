// SPDX-License-Identifier: GPL-3.0-or-later
// The command reference of DS-V (5.2), statement by statement.
#include "tests/conformance/conformance.h"

namespace nmc::conformance {
namespace {

class PicServo : public Statement {
protected:
    PicServo() {
        make("servo");
        rig->address(1);
    }
};

INSTANTIATE_TEST_SUITE_P(, PicServo, kPlaces, nameOf);

TEST_P(PicServo, NoOperation1_DoesNothingButCauseAStatusPacketWithTheDefinedItems) {
    EXPECT_EQ(rig->command(1, 0x0E), (Bytes{0x19, 0x19}));
    rig->command(1, 0x12, {0x20});
    EXPECT_EQ(rig->command(1, 0x0E), (Bytes{0x19, 0x00, 0x04, 0x1D}));
    EXPECT_TRUE(rig->violations().empty());
}

}  // namespace
}  // namespace nmc::conformance
