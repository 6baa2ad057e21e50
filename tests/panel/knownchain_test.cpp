// SPDX-License-Identifier: GPL-3.0-or-later
// The chain that was connected when the panel last ran: what is remembered, and what the next run makes of
// it.
#include "app/knownchain.h"

#include "model/machinefile/responsestore.h"
#include "tests/support/virtualpanel.h"
#include "widgets/mainwindow/operatorlock.h"
#include "widgets/response/responsedock.h"
#include "widgets/sequences/sequencesdock.h"

namespace nmc {
namespace {

using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class KnownChain : public testing::Test {
protected:
    /// A run of the panel with the settings of the previous one.
    void run(const QString& port) {
        panel = std::make_unique<VirtualPanel>(directory.filePath(QStringLiteral("panel.ini")));
        panel->start();
        ASSERT_NO_FATAL_FAILURE(panel->connectTo(port));
    }
    void end() { panel.reset(); }
    [[nodiscard]] const std::vector<ModuleState>& modules() const {
        return panel->composition().store().link().modules;
    }
    bool comes(const QString& words) {
        return panel->waitFor([&] { return panel->standing(words) != nullptr; });
    }
    std::string told() { return panel->headlines().join(QLatin1Char('\n')).toStdString(); }

    QTemporaryDir directory;
    VirtualChain sim{QStringLiteral("servo,servo,step")};
    std::unique_ptr<VirtualPanel> panel;
};

TEST_F(KnownChain, AModuleThatWasPowerCycledMeanwhileIsNamedAndNoneTakesItsPlace) {
    ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
    ASSERT_EQ(modules().size(), 3U);
    end();
    (void)sim.control(QStringLiteral("power-cycle 2"));
    ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
    ASSERT_EQ(modules().size(), 3U);
    EXPECT_TRUE(modules()[2].isStepper()) << "Z is in its old place";
    EXPECT_EQ(modules()[2].info.address, BusAddress(3));
    ASSERT_TRUE(comes(QStringLiteral("Module 2 restarted"))) << told();
    ASSERT_TRUE(panel->press(QStringLiteral("Module 2 restarted"), QStringLiteral("address")));
    EXPECT_TRUE(comes(QStringLiteral("Module 2 has its address again"))) << told();
    EXPECT_EQ(sim.state(2)[QStringLiteral("address")].toInt(), 2);
}

TEST_F(KnownChain, AModuleThatWasTakenOutOnPurposeIsForgotten) {
    const QString missing = QStringLiteral("Module 2 of this chain does not answer");
    ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
    end();
    (void)sim.control(QStringLiteral("fault module 2 silent"));
    for (const bool first : {true, false}) {
        ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
        if (first) {
            ASSERT_EQ(modules().size(), 3U);
            ASSERT_TRUE(comes(missing)) << told();
            EXPECT_EQ(panel->count(QStringLiteral("does not answer")), 1) << "reported once";
            ASSERT_TRUE(panel->press(missing, QStringLiteral("Work with 2")));
            ASSERT_TRUE(panel->waitFor([&] { return panel->connected() && modules().size() == 2; }))
                << told();
        }
        ASSERT_TRUE(panel->answersFor(0.3));
        EXPECT_EQ(modules().size(), 2U);
        EXPECT_TRUE(modules()[1].isStepper());
        EXPECT_EQ(panel->standing(missing), nullptr) << told();
        end();
    }
    EXPECT_EQ(sim.violations(), "");
}

/// X, Y and Z are of the same type. In the second run, Y does not answer any more.
class WithoutY : public KnownChain {
protected:
    void TearDown() override { end(); }
    void lookAgain() {
        end();
        (void)xyz.control(QStringLiteral("fault module 2 silent"));
        ASSERT_NO_FATAL_FAILURE(run(xyz.terminal()));
        ASSERT_TRUE(comes(missing)) << told();
    }
    void workWithTheOthers() {
        ASSERT_TRUE(panel->press(missing, QStringLiteral("Work with 2")));
        ASSERT_TRUE(panel->waitFor([&] { return panel->connected() && modules().size() == 2; })) << told();
    }
    [[nodiscard]] static AxisSettings axisCalled(const char* name, std::int32_t highest) {
        AxisSettings settings;
        settings.name = name;
        settings.travel.highest = highest;
        return settings;
    }
    /// Shows a step response of this module.
    void showRun(ModuleIndex module) {
        KeptResponse kept;
        kept.run.module = module;
        kept.run.taken = {TimePoint{}, 0, 100, 0.1, ResponseMethod::Profile, servo::SetGain{}};
        for (int ms = 1; ms < 100; ++ms)
            kept.run.points.push_back({ms / 1e3, ms < 10 ? 10.0 * ms : 100.0});
        kept.startedAt = "2026-11-21T21:21:0" + std::to_string(module.value()) + "+01:00";
        panel->window().stepResponses().showRun(kept);
    }
    /// Saves home where the module stands, at counter 0.
    void saveHomeOf(ModuleIndex module) {
        ASSERT_NO_FATAL_FAILURE(run(xyz.terminal()));
        const auto state = [&]() -> const ModuleState& { return modules()[module.value()]; };
        ASSERT_TRUE(panel->waitFor([&] { return state().latest.has_value(); }));
        emit panel->window().requests().intent(module, intent::SaveAsHome{});
        ASSERT_TRUE(panel->waitFor([&] { return state().home.place().has_value(); })) << told();
    }

    const QString missing = QStringLiteral("Module 2 of this chain does not answer");
    const ModuleIndex x{0}, y{1}, z{2};
    VirtualChain xyz{QStringLiteral("servo,servo,servo")};
};

TEST_F(WithoutY, ZKeepsItsSettings) {
    ASSERT_NO_FATAL_FAILURE(run(xyz.terminal()));
    ASSERT_NO_FATAL_FAILURE(lookAgain());
    Requests& requests = panel->window().requests();
    emit requests.axisEdited(x, axisCalled("X", 1'000));
    emit requests.axisEdited(y, axisCalled("Y", 2'000));
    emit requests.axisEdited(z, axisCalled("Z", 3'000));
    Program program;
    program.points = {{"P", {{x, 1, true}, {y, 2, true}, {z, 3, true}}}};
    program.sequences = {{"Main", {action::MoveTo{"P"}, action::Home{z}}}};
    emit requests.programEdited(program);
    emit requests.homeOrderEdited({z, y, x});
    showRun(y);
    showRun(z);
    ASSERT_NO_FATAL_FAILURE(workWithTheOthers());

    const Machine& machine = panel->composition().machine();
    ASSERT_EQ(machine.axes.size(), 2U);
    EXPECT_EQ(machine.axes[0].name, "X");
    EXPECT_EQ(machine.axes[1].name, "Z");
    const ModuleIndex second{1};
    EXPECT_EQ(machine.program.points[0].axes, (std::vector<PointAxis>{{x, 1, true}, {second, 3, true}}));
    EXPECT_EQ(machine.program.sequences[0].rows[1], Action(action::Home{second}));
    EXPECT_EQ(machine.homeOrder, (std::vector{second, x}));
    EXPECT_EQ(modules()[1].info.address, BusAddress(3)) << "the second module is Z";
    EXPECT_EQ(modules()[1].travel.highest, 3'000) << "so it is bound by Z's limits";
    const std::vector<KeptResponse> runs = panel->window().stepResponses().runs();
    ASSERT_EQ(runs.size(), 1U) << "no model of Z is made of what Y did";
    EXPECT_EQ(runs[0].run.module, second);
    EXPECT_EQ(runs[0].startedAt, "2026-11-21T21:21:02+01:00");
    EXPECT_EQ(xyz.violations(), "");
}

TEST_F(WithoutY, TheStepResponsesOfZHaveItsNewNumberAfterTheNextStart) {
    ASSERT_NO_FATAL_FAILURE(run(xyz.terminal()));
    ASSERT_NO_FATAL_FAILURE(lookAgain());
    showRun(z);
    ASSERT_NO_FATAL_FAILURE(workWithTheOthers());
    end();
    ASSERT_NO_FATAL_FAILURE(run(xyz.terminal()));
    ASSERT_TRUE(panel->waitFor([&] { return !panel->window().stepResponses().runs().empty(); }));
    const std::vector<KeptResponse> runs = panel->window().stepResponses().runs();
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].run.module, ModuleIndex(1));
}

/// They are in the file with the numbers of before.
TEST_F(WithoutY, StepResponsesThatASlowDiskReadsLateHaveTheNewNumbers) {
    ASSERT_NO_FATAL_FAILURE(run(xyz.terminal()));
    showRun(y);
    showRun(z);
    end();
    (void)xyz.control(QStringLiteral("fault module 2 silent"));
    panel = std::make_unique<VirtualPanel>(directory.filePath(QStringLiteral("panel.ini")));
    std::vector<std::function<void()>> waiting;
    setBackground([&](std::function<void()> work) { waiting.push_back(std::move(work)); });
    panel->start();
    ASSERT_NO_FATAL_FAILURE(panel->connectTo(xyz.terminal()));
    ASSERT_TRUE(comes(missing)) << told();
    ASSERT_NO_FATAL_FAILURE(workWithTheOthers());
    ASSERT_TRUE(panel->window().stepResponses().runs().empty());
    setBackground([](const std::function<void()>& work) { work(); });
    for (const auto& work : waiting)
        work();
    ASSERT_TRUE(panel->waitFor([&] { return !panel->window().stepResponses().runs().empty(); }));
    const std::vector<KeptResponse> runs = panel->window().stepResponses().runs();
    ASSERT_EQ(runs.size(), 1U) << "Y's is no longer listed";
    EXPECT_EQ(runs[0].run.module, ModuleIndex(1));
    EXPECT_EQ(runs[0].startedAt, "2026-11-21T21:21:02+01:00");
    end();
    const auto stored = readResponses(
        readFile(directory.filePath(QStringLiteral("runs/no-machine-file.runs")), kMaxRunFile).value_or(""));
    ASSERT_TRUE(stored.has_value());
    for (const KeptResponse& run : *stored)
        EXPECT_EQ(run.run.module, ModuleIndex(1)) << run.startedAt;  // Y's had that number already
}

/// The port has to close first. Positions, step responses and the port's own list follow in any case.
TEST_F(WithoutY, ZKeepsItsSettingsEvenIfOperatorModeBeginsMeanwhile) {
    ASSERT_NO_FATAL_FAILURE(run(xyz.terminal()));
    ASSERT_NO_FATAL_FAILURE(lookAgain());
    for (const auto& [module, name] : {std::pair{x, "X"}, std::pair{y, "Y"}, std::pair{z, "Z"}})
        emit panel->window().requests().axisEdited(module, axisCalled(name, 1'000));
    ASSERT_TRUE(panel->press(missing, QStringLiteral("Work with 2")));
    panel->window().findChild<QAction*>(QStringLiteral("operatorAction"))->trigger();
    for (const char* field : {"operatorPinField", "operatorPinAgainField"})
        QTest::keyClicks(panel->window().findChild<QLineEdit*>(QLatin1String(field)), QStringLiteral("4711"));
    panel->window().findChild<QAbstractButton*>(QStringLiteral("operatorBeginButton"))->click();
    ASSERT_TRUE(panel->window().operatorLock().isLocked());
    ASSERT_TRUE(panel->waitFor([&] { return panel->connected() && modules().size() == 2; })) << told();
    ASSERT_EQ(panel->composition().machine().axes.size(), 2U);
    EXPECT_EQ(panel->composition().machine().axes[1].name, "Z");
}

TEST_F(WithoutY, ASequenceThatNeedsYPreventsItAndIsNamed) {
    ASSERT_NO_FATAL_FAILURE(run(xyz.terminal()));
    ASSERT_NO_FATAL_FAILURE(lookAgain());
    Program program;
    program.sequences = {{"Main", {action::Home{x}, action::Home{y}}}};
    emit panel->window().requests().programEdited(program);
    const Machine before = panel->composition().machine();
    ASSERT_TRUE(panel->press(missing, QStringLiteral("Work with 2")));
    ASSERT_TRUE(comes(QStringLiteral("Row 2 of \"Main\" uses module 2, so the chain was not changed.")))
        << told();
    ASSERT_TRUE(panel->answersFor(0.3));
    EXPECT_EQ(modules().size(), 3U);
    EXPECT_EQ(panel->composition().machine(), before);
    EXPECT_EQ(knownChain(panel->settings(), xyz.terminal()).size(), 3U);

    // The row is removed in the window, where this could be undone.
    panel->window().resize(1'500, 1'100);
    panel->window().sequences().open();
    QAbstractItemView* rows = nullptr;
    ASSERT_TRUE(panel->waitFor([&] {
        rows = panel->window().findChild<QAbstractItemView*>(QStringLiteral("rowTable"));
        return rows != nullptr && rows->isVisible() && rows->model()->rowCount() == 2;
    }));
    rows->setCurrentIndex(rows->model()->index(1, 0));
    ASSERT_NO_FATAL_FAILURE(panel->click("removeRowButton"));
    ASSERT_NO_FATAL_FAILURE(workWithTheOthers());
    auto* undo = panel->window().findChild<QAbstractButton*>(QStringLiteral("undoEditButton"));
    ASSERT_NE(undo, nullptr);
    EXPECT_FALSE(undo->isEnabled()) << "module 2 is Z now, and would be homed instead";
}

TEST_F(WithoutY, TheHomeOfZIsOfferedToZ) {
    ASSERT_NO_FATAL_FAILURE(saveHomeOf(z));
    ASSERT_NO_FATAL_FAILURE(lookAgain());
    ASSERT_NO_FATAL_FAILURE(workWithTheOthers());
    EXPECT_TRUE(panel->waitFor([&] { return modules()[1].home.offered() == 0; })) << told();
}

TEST_F(WithoutY, TheHomeOfYIsNotOfferedToZ) {
    ASSERT_NO_FATAL_FAILURE(saveHomeOf(y));
    ASSERT_NO_FATAL_FAILURE(lookAgain());
    ASSERT_NO_FATAL_FAILURE(workWithTheOthers());
    ASSERT_TRUE(panel->waitFor([&] { return modules()[1].latest.has_value(); }));
    ASSERT_TRUE(panel->answersFor(0.3));
    EXPECT_EQ(modules()[1].home.offered(), std::nullopt);
}

TEST_F(KnownChain, OneThatIsLongerThanBeforeIsTakenAsItIs) {
    {
        QSettings settings(directory.filePath(QStringLiteral("panel.ini")), QSettings::IniFormat);
        rememberChain(settings, sim.terminal(), {{ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}}});
    }
    ASSERT_NO_FATAL_FAILURE(run(sim.terminal()));
    EXPECT_EQ(modules().size(), 3U);
    EXPECT_EQ(knownChain(panel->settings(), sim.terminal()).size(), 3U);
}

TEST_F(KnownChain, IsRememberedByPort) {
    QSettings settings(directory.filePath(QStringLiteral("x.ini")), QSettings::IniFormat);
    const std::vector<bus::ModuleInfo> chain{
        {ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}},
        {ModuleIndex(1), BusAddress(77), {ModuleType::Stepper, 1}},
        {ModuleIndex(2), BusAddress(3), {ModuleType::Servo, 4}},  // addresses need not be in order
    };
    rememberChain(settings, QStringLiteral("/dev/ttyUSB0"), chain);
    EXPECT_EQ(knownChain(settings, QStringLiteral("/dev/ttyUSB0")), chain);
    EXPECT_TRUE(knownChain(settings, QStringLiteral("/dev/ttyUSB1")).empty());
}

TEST_F(KnownChain, ARateThatNoLookTriesIsRemembered) {
    QSettings settings(directory.filePath(QStringLiteral("x.ini")), QSettings::IniFormat);
    const QString port = QStringLiteral("/dev/ttyUSB0");
    rememberRate(settings, port, 250'000);
    EXPECT_EQ(knownRate(settings, port), 250'000U);
    rememberRate(settings, port, 57'600);
    EXPECT_EQ(knownRate(settings, port), 0U) << "each search tries it anyway";
    settings.setValue(QStringLiteral("chainRate/_dev_ttyUSB0"), QStringLiteral("4000"));
    EXPECT_EQ(knownRate(settings, port), 0U) << "1 250 000 / 256 = 4883 is the slowest";
}

TEST_F(KnownChain, WhatIsNoneOfOursIsIgnored) {
    QSettings settings(directory.filePath(QStringLiteral("x.ini")), QSettings::IniFormat);
    QString many;
    for (int i = 1; i <= 33; ++i)
        many += QStringLiteral("%1/0/4 ").arg(i);
    for (const QVariant& foreign :
         {QVariant(3), QVariant(QStringLiteral("1/0/4 1/0/4")), QVariant(QStringLiteral("0/0/4")),
          QVariant(QStringLiteral("128/0/4")), QVariant(QStringLiteral("1/256/4")),
          QVariant(QStringLiteral("1/0/256")), QVariant(QStringLiteral("1/0")),
          QVariant(QStringLiteral("1/0/4;2/0/4")), QVariant(QStringLiteral("1/0/-4")), QVariant(many),
          QVariant(QByteArray(1 << 20, '1')),
          QVariant(QStringList{QStringLiteral("1/0/4"), QStringLiteral("2/0/4")})}) {
        settings.setValue(QStringLiteral("chain/x"), foreign);
        EXPECT_TRUE(knownChain(settings, QStringLiteral("x")).empty())
            << foreign.toString().left(40).toStdString();
    }
}

}  // namespace
}  // namespace nmc
