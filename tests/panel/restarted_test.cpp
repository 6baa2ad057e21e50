// SPDX-License-Identifier: GPL-3.0-or-later
// A module restarts in the middle of the chain.
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;

/// The modules have addresses in the order X, Y, Z. When Y is gone, Z must not become the second module: the
/// controls of Y would drive it.
TEST(OneModuleRestarted, GetsItsAddressBackByAButtonAndTheOthersKeepTheirPlaces) {
    VirtualChain sim(QStringLiteral("servo,servo,step"));
    VirtualPanel panel;
    const BusStore& store = panel.composition().store();
    ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
    (void)sim.control(QStringLiteral("power-cycle 2"));
    const QString restarted = QStringLiteral("Module 2 restarted");
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(restarted) != nullptr; }));
    EXPECT_TRUE(store.link().quiet);
    EXPECT_TRUE(panel.waitFor([&] {
        return panel.count(QStringLiteral("Module 2 is off after a restart.")) == 1;
    })) << panel.headlines().join(QLatin1Char('\n')).toStdString();
    EXPECT_EQ(panel.count(QStringLiteral("use the hardware stop")), 0);
    EXPECT_FALSE(store.link().modules[1].stopUnconfirmed);

    ASSERT_TRUE(panel.press(restarted, QStringLiteral("Scan again")));
    const auto found = [&] {
        return panel.connected() && store.link().modules.size() == 3 && store.link().modules[1].hasRestarted;
    };
    ASSERT_TRUE(panel.waitFor(found)) << panel.headlines().join(QLatin1Char('\n')).toStdString();
    EXPECT_EQ(store.link().modules[2].info.address, BusAddress(3));
    EXPECT_TRUE(store.link().modules[2].isStepper()) << "Z is in its old place";
    EXPECT_FALSE(store.link().quiet);
    EXPECT_TRUE(store.link().modules[1].silent) << "STOP ALL does not reach it";

    // Before it has been watched, a chain that was left running may be moving, and no address is assigned.
    const auto rests = [&](std::size_t i) { return store.link().modules[i].activity() != Activity::Unknown; };
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(restarted) != nullptr && rests(0) && rests(2); }));
    ASSERT_TRUE(panel.press(restarted, QStringLiteral("address")));
    const auto back = [&] { return panel.count(QStringLiteral("has its address again")) == 1; };
    ASSERT_TRUE(panel.waitFor(back)) << panel.headlines().join(QLatin1Char('\n')).toStdString();
    EXPECT_TRUE(panel.waitFor([&] {
        const ModuleState& y = store.link().modules[1];
        return !y.hasRestarted && !y.silent && y.latest.has_value();
    }));
    EXPECT_EQ(sim.state(2)[QStringLiteral("address")].toInt(), 2);
    EXPECT_EQ(panel.standing(restarted), nullptr);
}

}  // namespace
}  // namespace nmc
