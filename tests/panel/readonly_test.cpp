// SPDX-License-Identifier: GPL-3.0-or-later
// faults.md H-02: a read-only connection, in the whole window, to a chain that another program has started.
// The motor keeps running through everything that stops motors elsewhere; what is sent over the line is
// covered by tests/bus/readonly_test.cpp.
#include <atomic>

#include "model/intent/homingplan.h"
#include "model/intent/stepperplan.h"
#include "model/machinefile/machinegroups.h"
#include "model/procedure/procedures.h"
#include "tests/support/changes.h"
#include "tests/support/leaverunning.h"
#include "tests/support/virtualpanel.h"
#include "widgets/scope/scopefiles.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class H02_ReadOnly : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(testing_support::leaveRunning(sim, 2, 4));
        before = testing_support::changes(sim);
    }

    /// Connects as `nmcpanel --port ... --read-only` does.
    void begin() { panel.composition().show({sim.terminal(), 19'200, false, false, true}); }
    void look() {
        begin();
        ASSERT_TRUE(panel.waitFor([&] { return looks() && servo().moving() && stepper().latest; }));
    }
    [[nodiscard]] bool looks() { return panel.connected() && panel.composition().store().link().readOnly; }
    [[nodiscard]] const ModuleState& stepper() { return panel.module(); }
    [[nodiscard]] const ModuleState& servo() { return *panel.composition().store().module(ModuleIndex(1)); }
    template <typename Widget>
    [[nodiscard]] Widget* find(const QString& name) {
        auto* widget = panel.window().findChild<Widget*>(name);
        EXPECT_NE(widget, nullptr) << name.toStdString();
        return widget;
    }
    void click(const QString& button) { QTest::mouseClick(find<QAbstractButton>(button), Qt::LeftButton); }
    void expectRefused(const QString& button) {
        EXPECT_FALSE(find<QAbstractButton>(button)->isEnabled()) << button.toStdString();
        EXPECT_TRUE(find<QAbstractButton>(button)->toolTip().contains(u"read-only"_s))
            << button.toStdString() << ": " << find<QAbstractButton>(button)->toolTip().toStdString();
    }
    [[nodiscard]] bool ribbon() { return find<QWidget>(u"readOnlyRibbon"_s)->isVisible(); }
    [[nodiscard]] bool closes() {
        return panel.waitFor([&] { return !panel.composition().worker().isOpen(); });
    }
    /// Expects that no module was changed, and that the servo runs as it did.
    void expectUndisturbed() {
        EXPECT_NEAR(sim.state(2)[u"command_velocity"_s].toDouble(), 4.0, 0.01);
        EXPECT_EQ(testing_support::changes(sim), before);
        EXPECT_EQ(sim.violations(), "");
    }

    VirtualChain sim{u"step,servo"_s};
    QJsonArray before;
    VirtualPanel panel;
};

TEST_F(H02_ReadOnly, IsAskedForBesideConnectSaysSoAndIsNotRemembered) {
    panel.start();
    auto* port = find<QComboBox>(u"portBox"_s);
    port->setCurrentText(sim.terminal());
    click(u"moreWaysButton"_s);
    auto* menu = find<QMenu>(u"moreWaysMenu"_s);
    ASSERT_TRUE(menu->isVisible());
    QTest::keyClick(menu, Qt::Key_Down);
    QTest::keyClick(menu, Qt::Key_Return);
    ASSERT_TRUE(panel.waitFor([&] { return looks(); }));
    EXPECT_TRUE(find<QMenu>(u"chainMenu"_s)->actions().contains(find<QAction>(u"connectReadOnlyAction"_s)));
    EXPECT_TRUE(ribbon());
    EXPECT_EQ(find<QLabel>(u"readOnlyRibbonText"_s)->text(),
              u"READ-ONLY — only status requests are sent. STOP ALL still works."_s);
    EXPECT_TRUE(panel.window().windowTitle().endsWith(u"(read-only)"_s));
    EXPECT_TRUE(find<QLabel>(u"linkLabel"_s)->text().endsWith(u"2 modules, read-only"_s));
    expectUndisturbed();

    click(u"disconnectButton"_s);
    ASSERT_TRUE(closes());
    EXPECT_FALSE(ribbon());
    click(u"connectButton"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    EXPECT_FALSE(looks());
    EXPECT_FALSE(panel.window().windowTitle().contains(u"read-only"_s));
}

TEST_F(H02_ReadOnly, NoControlOfAModuleSends) {
    ASSERT_NO_FATAL_FAILURE(look());
    for (int module = 0; module < 2; ++module) {
        panel.select(module);
        auto* pages = find<QTabWidget>(module == 0 ? u"stepperPages"_s : u"servoPages"_s);
        for (int page = 0; page < pages->count(); ++page) {
            pages->setCurrentIndex(page);
            for (auto* control : panel.window().findChildren<QAbstractButton*>())
                if (control->isVisible() && pages->isAncestorOf(control) && !control->isCheckable())
                    QTest::mouseClick(control, Qt::LeftButton);
        }
    }
    for (const QString& name : {u"stopSmoothlyButton"_s, u"stopAbruptlyButton"_s, u"motorOffButton"_s})
        expectRefused(name);
    ASSERT_TRUE(panel.answersFor(0.3));
    expectUndisturbed();
}

/// Checks the rules that disable controls and those that plan, without the help of the window.
TEST_F(H02_ReadOnly, NoRuleLetsAnythingThroughButTheQuestion) {
    ASSERT_NO_FATAL_FAILURE(look());
    const servomotion::Trapezoid move{Counts(20'000), CountsPerTick(8 << 16), CountsPerTickSquared(1'311)};
    const StepperMotion run = steppermotion::VelocityProfile{40, 4, false};
    const std::vector<Intent> ofServo{
        intent::Move{move},
        intent::GoHome{ServoPace{CountsPerTick(1 << 16), CountsPerTickSquared(100)}},
        intent::Move{servomotion::VelocityProfile{CountsPerTick(1 << 16), CountsPerTickSquared(100)}},
        intent::ApplyGains{},
        intent::ClearStickyBits{},
        intent::LoadMove{move},
        intent::StopHere{},
        intent::ControlIo{},
        intent::MoveBy{{100}, ServoPace{CountsPerTick(1 << 16), CountsPerTickSquared(100)}},
        intent::StepResponse{100, ResponseMethod::Profile, 0.1},
        intent::ArmLimitStop{true}};
    const std::vector<Intent> ofStepper{stepperintent::SetParameters{}, stepperintent::SetOutputs{1},
                                        intent::Move{run}, intent::LoadMove{run}, intent::ChangeMotion{run}};
    for (const ModuleState* module : {&servo(), &stepper()}) {
        for (int kind = 0; kind <= static_cast<int>(IntentKind::SetOutputs); ++kind)
            EXPECT_EQ(whyNot(static_cast<IntentKind>(kind), *module), Refusal::ReadOnly) << kind;
        std::vector<Intent> intents{intent::Enable{},       intent::StopSmoothly{},
                                    intent::StopAbruptly{}, intent::MotorOff{},
                                    intent::SetAmplifier{}, intent::ResetPosition{},
                                    intent::SaveAsHome{},   intent::Home{firstRecipe(module->info.identity)}};
        const auto& own = module == &servo() ? ofServo : ofStepper;
        intents.insert(intents.end(), own.begin(), own.end());
        for (const Intent& intent : intents) {
            const auto planned = plan(intent, *module);
            ASSERT_FALSE(planned) << "intent " << intent.index();
            EXPECT_EQ(planned.error(), Refusal::ReadOnly) << "intent " << intent.index();
            EXPECT_EQ(procedureFor(intent, *module), nullptr) << "intent " << intent.index();
            emit panel.window().requests().intent(module->info.index, intent);
        }
        EXPECT_TRUE(plan(intent::AskAnew{}, *module));
    }
    EXPECT_EQ(whyInaccessible(panel.composition().store().link()), Refusal::ReadOnly);
    EXPECT_EQ(whyNotFromStandstill(run, stepper()), Refusal::ReadOnly);
    Machine machine;
    machine.groups.push_back({0x81, "gantry", {ModuleIndex(0)}, {}});
    EXPECT_TRUE(groupChanges(machine, {stepper(), servo()}).empty());

    EXPECT_TRUE(panel.waitFor([&] { return panel.count(u"Module 1 cannot do this now"_s) > 0; }));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_TRUE(panel.markers().isEmpty()) << "this panel is not responsible for that motion";
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, TheChainAsAWholeIsToldNothing) {
    ASSERT_NO_FATAL_FAILURE(look());
    const auto trigger = [&](const QString& action) { find<QAction>(action)->trigger(); };
    trigger(u"groupsAction"_s);
    EXPECT_FALSE(find<QComboBox>(u"group1Box"_s)->isEnabled());
    trigger(u"rateAction"_s);
    auto* rate = find<QComboBox>(u"chainRateBox"_s);
    rate->setCurrentIndex(rate->findData(57'600));
    expectRefused(u"changeRateButton"_s);
    trigger(u"chainDoctorAction"_s);
    expectRefused(u"restartChainButton"_s);
    EXPECT_FALSE(find<QAction>(u"restartNetworkAction"_s)->isEnabled());
    EXPECT_TRUE(find<QAbstractButton>(u"scanButton"_s)->isEnabled()) << "scanning only queries";
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, AModuleThatRestartsIsToldOfAndLeftSo) {
    ASSERT_NO_FATAL_FAILURE(look());
    std::ignore = sim.control(u"power-cycle 1"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(u"Module 1 restarted"_s) > 0; }))
        << panel.headlines().join(u'\n').toStdString();
    EXPECT_EQ(panel.window().findChild<QAbstractButton*>(u"bannerAction_readdress"_s), nullptr);
    EXPECT_EQ(panel.window().findChild<QAbstractButton*>(u"listAction_readdress"_s), nullptr);
    EXPECT_TRUE(sim.driven(1));
}

TEST_F(H02_ReadOnly, StopAllStopsAndTheConnectionStaysReadOnly) {
    ASSERT_NO_FATAL_FAILURE(look());
    EXPECT_TRUE(ribbon());
    EXPECT_TRUE(sim.driven(1));
    QTest::keyClick(&panel.window(), Qt::Key_Escape);
    EXPECT_TRUE(panel.waitFor([&] { return !sim.driven(1); }));
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(u"1 stopped and holding"_s) == 1; }));
    EXPECT_TRUE(looks());
    EXPECT_TRUE(ribbon());
}

/// A stop that was requested is carried out before the close that follows immediately.
TEST_F(H02_ReadOnly, StopsWhenItIsAskedToAndThenCloses) {
    ASSERT_NO_FATAL_FAILURE(look());
    QTest::mousePress(find<QAbstractButton>(u"stopAllButton"_s), Qt::LeftButton);
    panel.composition().worker().close();
    ASSERT_TRUE(closes());
    EXPECT_FALSE(sim.driven(1));
    EXPECT_TRUE(sim.state(2)[u"servo_on"_s].toBool()) << "it holds";
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(H02_ReadOnly, LeavingAsksNothingAndStopsNothing) {
    ASSERT_NO_FATAL_FAILURE(look());
    click(u"disconnectButton"_s);
    ASSERT_TRUE(closes());
    expectUndisturbed();
    ASSERT_NO_FATAL_FAILURE(look());
    EXPECT_TRUE(panel.window().close());
    ASSERT_TRUE(panel.waitFor([&] { return !panel.window().isVisible(); }));
    EXPECT_EQ(panel.count(u"stopped"_s), 0);
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, LeavingDuringTheLookStopsNothing) {
    begin();
    ASSERT_TRUE(panel.waitFor([&] { return panel.composition().store().link().found > 0; }));
    panel.composition().worker().close();
    ASSERT_TRUE(closes());
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, MotorsAreLeftAloneWhenThePanelFreezes) {
    ASSERT_NO_FATAL_FAILURE(look());
    panel.freeze(2'600ms);
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.count(u"motors were commanded to stop"_s), 0);
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, MotorsAreLeftAloneWhenTheMachineSlept) {
    std::atomic<Duration::rep> asleep{0};
    panel.composition().worker().setSleepClock([&asleep] { return Duration(asleep.load()); });
    ASSERT_NO_FATAL_FAILURE(look());
    asleep = Duration(2h).count();
    ASSERT_TRUE(panel.answersFor(1.0));
    EXPECT_EQ(panel.count(u"commanded to stop"_s), 0);
    expectUndisturbed();
    panel.composition().worker().close();
    ASSERT_TRUE(closes());
    expectUndisturbed();
}

TEST_F(H02_ReadOnly, ScanningAgainLooksAgainAndConnectFullyGoesOn) {
    ASSERT_NO_FATAL_FAILURE(look());
    find<QAction>(u"scanAction"_s)->trigger();
    ASSERT_TRUE(panel.waitFor([&] { return panel.chainsFound() == 2; }));
    ASSERT_TRUE(panel.waitFor([&] { return looks(); }));
    expectUndisturbed();
    click(u"connectFullyButton"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected() && !looks(); }));
    EXPECT_FALSE(ribbon());
    EXPECT_EQ(panel.composition().store().link().port, sim.terminal().toStdString());
}

TEST_F(H02_ReadOnly, TheMachineIsNamedAndRecordedAsEver) {
    ASSERT_NO_FATAL_FAILURE(look());
    QTemporaryDir directory;
    const QString file = directory.filePath(u"look.csv"_s);
    emit panel.window().scopeFiles().recordRequested(file);
    AxisSettings axis;
    axis.name = "X axis";
    emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
    EXPECT_EQ(texts::moduleName(ModuleIndex(0)), u"Module 1 \"X axis\""_s);
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_TRUE(panel.waitFor([&] { return QFileInfo(file).size() > 0; }));
    texts::setModuleNames({});
}

}  // namespace
}  // namespace nmc
