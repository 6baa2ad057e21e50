// SPDX-License-Identifier: GPL-3.0-or-later
// How the window shows home, and whether it goes there.
#include "widgets/chain/chainmodel.h"
#include "widgets/common/words.h"
#include "windowtest.h"

namespace nmc {
namespace {

class HomeInTheWindow : public WindowTest {
protected:
    /// Shows a servo whose home register contains -304, whatever is known about home.
    void show(std::optional<std::int32_t> home, std::int32_t position = 10) {
        ModuleState module = Servo{.position = position}.state();
        module.latest->home = -304;
        if (home)
            module.home.found(*home, module.latestTime);
        window->showLink(connectedTo({module}));
    }
    QVariant inList(int role) {
        return find<QAbstractItemView>(u"chainList"_s)->model()->index(0, 0).data(role);
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(HomeInTheWindow, UnknownItSaysSoAndGoesNowhere) {
    show(std::nullopt);
    EXPECT_EQ(text(u"homeState"_s), u"Home: unknown"_s);
    EXPECT_FALSE(inList(ChainModel::HomeIsKnown).toBool());
    EXPECT_TRUE(inList(Qt::AccessibleTextRole).toString().endsWith(u"Home: unknown"_s));
    EXPECT_FALSE(button(u"goHomeButton"_s)->isEnabled());
    EXPECT_EQ(button(u"goHomeButton"_s)->toolTip(), texts::refusal(Refusal::HomeUnknown));
    click(u"goHomeButton"_s);
    QTest::keyClick(window.get(), Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(HomeInTheWindow, KnownItIsSeenAndGoneTo) {
    show(512);
    EXPECT_EQ(text(u"homeState"_s), u"Home: 512 counts"_s);
    EXPECT_TRUE(find<QLabel>(u"homeState"_s)
                    ->toolTip()
                    .startsWith(u"Home is at 512 counts. A search found it 0 min ago"_s));
    EXPECT_TRUE(inList(ChainModel::HomeIsKnown).toBool());
    EXPECT_TRUE(inList(Qt::ToolTipRole).toString().contains(u"Home is at 512 counts"_s));
    click(u"goHomeButton"_s);
    ASSERT_EQ(intents.size(), 1);
    const auto goHome = std::get<intent::GoHome>(intents.at(0).at(1).value<Intent>());
    EXPECT_EQ(std::get<ServoPace>(goHome.pace).velocity.value(), 65'536U) << "the velocity of Go to";
}

TEST_F(HomeInTheWindow, ZeroHereSaysWhatItDestroys) {
    show(std::nullopt);
    EXPECT_TRUE(button(u"zeroHereButton"_s)->toolTip().contains(u"The old zero is lost"_s));
    EXPECT_FALSE(button(u"zeroHereButton"_s)->toolTip().contains(u"This moves home"_s));
    show(512, 1'000);
    // 512 - 1000
    EXPECT_TRUE(button(u"zeroHereButton"_s)
                    ->toolTip()
                    .endsWith(u"This moves home from 512 counts to \u2212488 counts."_s))
        << button(u"zeroHereButton"_s)->toolTip().toStdString();
}

}  // namespace
}  // namespace nmc
