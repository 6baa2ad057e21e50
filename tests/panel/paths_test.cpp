// SPDX-License-Identifier: GPL-3.0-or-later
// Paths, with mouse and keys; the oracle is what the simulator knows about its modules.
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "tests/support/choosefile.h"
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class Paths : public testing::Test {
protected:
    explicit Paths(const QString& chain = u"servo@10"_s) : sim(chain) {}
    void begin(std::uint8_t axes = 1) {
        panel.window().resize(1'500, 1'100);
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        for (std::uint8_t axis = 0; axis < axes; ++axis)
            ASSERT_NO_FATAL_FAILURE(panel.makeReady(axis));
        ASSERT_TRUE(panel.waitFor([&] { return module(axes - 1).commandPosition().has_value(); }));
        QTest::keyClick(panel.window().windowHandle(), Qt::Key_F3, Qt::ShiftModifier);
    }
    [[nodiscard]] const ModuleState& module(std::uint8_t index) {
        return *panel.composition().store().module(ModuleIndex(index));
    }
    /// A path that swings by `counts` about 0 for `seconds`, in columns with these names.
    QString swing(const QStringList& names, double counts, double seconds) {
        QString text = u"# rate 60\n"_s + names.join(u',') + u'\n';
        const int points = qRound(seconds * 61);
        for (int n = 0; n <= points; ++n) {
            const long at = std::lround(counts * std::sin(2 * std::numbers::pi * n / 120.0));
            QStringList cells;
            for (qsizetype i = 0; i < names.size(); ++i)
                cells << QString::number(n == points ? qRound(counts) : at);
            text += cells.join(u',') + u'\n';
        }
        return text;
    }
    void askFor(const QString& text) {
        const QString name = directory.filePath(u"swing.csv"_s);
        QFile file(name);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text.toUtf8());
        file.close();
        ASSERT_NO_FATAL_FAILURE(panel.click("openPathButton"));
        auto* dialog = panel.window().findChild<QFileDialog*>(u"openPathDialog"_s);
        ASSERT_NE(dialog, nullptr);
        testing_support::chooseFile(*dialog, name);
    }
    void open(const QString& text) {
        ASSERT_NO_FATAL_FAILURE(askFor(text));
        ASSERT_TRUE(panel.waitFor([&] { return summary().contains(u"swing.csv"_s); }))
            << summary().toStdString();
    }
    void run() {
        ASSERT_NO_FATAL_FAILURE(panel.click("runPathButton"));
        ASSERT_NO_FATAL_FAILURE(panel.click("runPathGo"));
    }
    [[nodiscard]] QString said(const char* label) {
        return panel.window().findChild<QLabel*>(QLatin1String(label))->text();
    }
    [[nodiscard]] QString summary() { return said("pathSummary"); }
    [[nodiscard]] QString state() { return said("pathState"); }
    [[nodiscard]] bool holds() { return module(0).activity() == Activity::Holding; }
    [[nodiscard]] double commanded(int address) {
        return sim.state(address)[u"command_position"_s].toDouble();
    }

    QTemporaryDir directory;
    VirtualChain sim;
    VirtualPanel panel;
};

class PathsOfTwo : public Paths {
protected:
    PathsOfTwo() : Paths(u"servo@10,servo@10"_s) {}
};

TEST_F(Paths, AFileIsOpenedAndRunToItsLastPoint) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 1"_s}, 500, 2)));
    EXPECT_TRUE(summary().contains(u"123 points at 60 Hz, 2.0 s"_s)) << summary().toStdString();
    EXPECT_TRUE(summary().contains(u"Module 1 from \u2212500 counts to 500 counts"_s))
        << summary().toStdString();
    ASSERT_NO_FATAL_FAILURE(run());
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"Point "_s); })) << state().toStdString();
    EXPECT_TRUE(panel.waitFor([&] { return moves(sim); }));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"The path is done."_s); }))
        << state().toStdString();
    EXPECT_EQ(commanded(1), 500);
    EXPECT_EQ(sim.violations(), "");
}

/// Its columns are axes of the chain that it was opened for, which need not be those of the next one.
TEST_F(Paths, AFileThatASlowDiskReadsForAnEarlierConnectionIsDropped) {
    ASSERT_NO_FATAL_FAILURE(begin());
    std::vector<std::function<void()>> waiting;
    setBackground([&](std::function<void()> work) { waiting.push_back(std::move(work)); });
    ASSERT_NO_FATAL_FAILURE(askFor(swing({u"Module 1"_s}, 500, 2)));
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return module(0).latest.has_value(); }));
    setBackground([](const std::function<void()>& work) { work(); });
    for (const auto& work : waiting)
        work();
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_TRUE(summary().contains(u"Axes here: Module 1."_s)) << summary().toStdString();
    EXPECT_FALSE(panel.window().findChild<QAbstractButton*>(u"runPathButton"_s)->isEnabled());
}

TEST_F(Paths, WhyAFileOfAnEarlierConnectionCannotBeReadIsNotSaid) {
    ASSERT_NO_FATAL_FAILURE(begin());
    std::vector<std::function<void()>> waiting;
    setBackground([&](std::function<void()> work) { waiting.push_back(std::move(work)); });
    ASSERT_NO_FATAL_FAILURE(askFor(swing({u"Module 1"_s}, 500, 2)));
    ASSERT_TRUE(QFile::remove(directory.filePath(u"swing.csv"_s)));
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return module(0).latest.has_value(); }));
    setBackground([](const std::function<void()>& work) { work(); });
    for (const auto& work : waiting)
        work();
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_TRUE(summary().startsWith(u"A path file has a column for each axis."_s))
        << summary().toStdString();
}

TEST_F(Paths, NothingMovesWithoutAYes) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 1"_s}, 500, 2)));
    ASSERT_NO_FATAL_FAILURE(panel.click("runPathButton"));
    ASSERT_NO_FATAL_FAILURE(panel.click("cancelPathButton"));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(commanded(1), 0);
}

TEST_F(Paths, TheQuestionGoesWhenThePathCannotBeRunAnyMore) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 1"_s}, 500, 2)));
    ASSERT_NO_FATAL_FAILURE(panel.click("runPathButton"));
    const auto asked = [&] { return panel.window().findChild<QDialog*>(u"runPathDialog"_s) != nullptr; };
    ASSERT_TRUE(asked());
    panel.ask(intent::MotorOff{});
    EXPECT_TRUE(panel.waitFor([&] { return !asked(); }));
}

TEST_F(Paths, OneThatBeginsElsewhereIsMovedToFirst) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(u"Module 1\n9000\n9100\n"_s));
    EXPECT_TRUE(panel.waitFor([&] { return state().contains(u"Choose Move to start first."_s); }))
        << state().toStdString();
    ASSERT_NO_FATAL_FAILURE(panel.click("pathToStartButton"));
    ASSERT_TRUE(panel.waitFor([&] { return commanded(1) == 9'000; }));
    ASSERT_NO_FATAL_FAILURE(run());
    EXPECT_TRUE(panel.waitFor([&] { return commanded(1) == 9'100; }))
        << state().toStdString() << panel.headlines().join(u" | "_s).toStdString();
    EXPECT_EQ(sim.violations(), "");
}

/// Unless chosen otherwise, points are left to an operator, and other moves are not.
TEST_F(Paths, AnOperatorMovesToTheStartAsToAPoint) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(u"Module 1\n9000\n9100\n"_s));
    panel.window().findChild<QAction*>(u"operatorAction"_s)->trigger();
    for (const char* name : {"operatorPinField", "operatorPinAgainField"})
        QTest::keyClicks(panel.window().findChild<QLineEdit*>(QLatin1String(name)), u"4711"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("operatorBeginButton"));
    ASSERT_TRUE(panel.composition().store().link().rights);
    const auto* toStart = panel.window().findChild<QAbstractButton*>(u"pathToStartButton"_s);
    ASSERT_TRUE(panel.waitFor([&] { return toStart->isEnabled(); })) << toStart->toolTip().toStdString();
    ASSERT_NO_FATAL_FAILURE(panel.click("pathToStartButton"));
    EXPECT_TRUE(panel.waitFor([&] { return commanded(1) == 9'000; }));
    EXPECT_EQ(sim.violations(), "");
}

/// Positions do not depend on the servo rate.
TEST_F(Paths, OneCanBeRunOnceTheServoRateIsSetThatItNeeds) {
    ASSERT_NO_FATAL_FAILURE(begin());
    const auto setRate = [&](std::uint8_t divisor) {
        servo::SetGain gains = *module(0).gains;
        gains.sr = divisor;
        panel.ask(intent::ApplyGains{gains});
        ASSERT_TRUE(panel.waitFor([&] { return module(0).servoRate == divisor; }));
    };
    ASSERT_NO_FATAL_FAILURE(setRate(2));
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 1"_s}, 500, 2)));
    EXPECT_TRUE(panel.waitFor([&] { return state().contains(u"Apply the gains with SR = 1 first."_s); }))
        << state().toStdString();
    ASSERT_NO_FATAL_FAILURE(setRate(1));
    const auto* run = panel.window().findChild<QAbstractButton*>(u"runPathButton"_s);
    EXPECT_TRUE(panel.waitFor([&] { return run->isEnabled(); })) << state().toStdString();
}

TEST_F(Paths, EscEndsOneForGood) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 1"_s}, 500, 60)));
    ASSERT_NO_FATAL_FAILURE(run());
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    QTest::keyClick(panel.window().windowHandle(), Qt::Key_Escape);
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"The path was stopped."_s); }))
        << state().toStdString();
    const double stood = commanded(1);
    ASSERT_TRUE(panel.answersFor(1.0));
    EXPECT_EQ(commanded(1), stood) << "no point comes after a stop";
}

TEST_F(Paths, ItsOwnStopButtonSlowsItDown) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 1"_s}, 500, 60)));
    ASSERT_NO_FATAL_FAILURE(run());
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    ASSERT_NO_FATAL_FAILURE(panel.click("endPathButton"));
    ASSERT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_TRUE(panel.waitFor([&] { return state().startsWith(u"The path was stopped."_s); }))
        << state().toStdString();
    EXPECT_TRUE(module(0).servoOn());
}

TEST_F(PathsOfTwo, AreAGroupThatStartsTogether) {
    ASSERT_NO_FATAL_FAILURE(begin(2));
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 2"_s, u"Module 1"_s}, 300, 2)));
    EXPECT_TRUE(panel.waitFor([&] { return state().contains(u"into one group: Chain, Groups."_s); }))
        << state().toStdString();
    panel.window().findChild<QAction*>(u"groupsAction"_s)->trigger();
    for (const std::uint8_t index : {std::uint8_t{0}, std::uint8_t{1}}) {
        auto* group = panel.window().findChild<QComboBox*>(u"group%1Box"_s.arg(index + 1));
        ASSERT_NE(group, nullptr);
        group->setFocus();
        QTest::keyClick(group, Qt::Key_Down);
        ASSERT_TRUE(panel.waitFor([&] { return module(index).info.group->group == 0x81; }));
    }
    ASSERT_NO_FATAL_FAILURE(run());
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"The path is done."_s); }))
        << state().toStdString();
    EXPECT_EQ(commanded(1), 300);
    EXPECT_EQ(commanded(2), 300);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(Paths, AWrongFileIsRefusedByItsLinesAndNothingMoves) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(u"Module 1,Y\n0,0\n1e,0\n9000,0\n"_s));
    EXPECT_TRUE(summary().contains(u"Line 1: \"Y\" is not an axis that can follow a path."_s))
        << summary().toStdString();
    EXPECT_TRUE(summary().contains(u"Line 3, Module 1: \"1e\" is not a number."_s));
    const auto* run = panel.window().findChild<QAbstractButton*>(u"runPathButton"_s);
    EXPECT_FALSE(run->isEnabled());
    EXPECT_EQ(commanded(1), 0);
}

TEST_F(Paths, OneIsNotRunWhileAnotherIsBeingRead) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 1"_s}, 500, 2)));
    const auto* run = panel.window().findChild<QAbstractButton*>(u"runPathButton"_s);
    ASSERT_TRUE(panel.waitFor([&] { return run->isEnabled(); }));
    std::vector<std::function<void()>> waiting;
    setBackground([&](std::function<void()> work) { waiting.push_back(std::move(work)); });
    ASSERT_NO_FATAL_FAILURE(askFor(swing({u"Module 1"_s}, 300, 2)));
    EXPECT_FALSE(run->isEnabled());
    setBackground([](const std::function<void()>& work) { work(); });
    for (const auto& work : waiting)
        work();
    EXPECT_TRUE(panel.waitFor([&] { return run->isEnabled(); }));
}

TEST_F(Paths, WhatWasWrongWithAFileIsForgottenWithItsChain) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(u"Module 1,Y\n0,0\n"_s));
    ASSERT_TRUE(summary().contains(u"is not a path for this chain"_s)) << summary().toStdString();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return module(0).latest.has_value(); }));
    EXPECT_TRUE(summary().contains(u"Axes here: Module 1."_s)) << summary().toStdString();
}

TEST_F(Paths, OneIsDrawnFromTheMovesOfASequence) {
    ASSERT_NO_FATAL_FAILURE(begin());
    QTest::keyClick(panel.window().windowHandle(), Qt::Key_F3);
    const auto teach = [&](const QString& name) {
        auto* field = panel.window().findChild<QLineEdit*>(u"pointNameField"_s);
        field->clear();
        QTest::keyClicks(field, name);
        ASSERT_NO_FATAL_FAILURE(panel.click("teachButton"));
    };
    ASSERT_NO_FATAL_FAILURE(
        panel.waitFor([&] { return panel.window().findChild<QLineEdit*>(u"pointNameField"_s); }));
    const auto goTo = [&](std::int32_t counts) {
        panel.ask(intent::Move{
            servomotion::Trapezoid{Counts(counts), CountsPerTick(4 << 16), CountsPerTickSquared(1'311)}});
        ASSERT_TRUE(panel.waitFor([&] { return commanded(1) == counts && holds(); }));
    };
    ASSERT_NO_FATAL_FAILURE(goTo(3'000));
    ASSERT_NO_FATAL_FAILURE(teach(u"There"_s));
    ASSERT_NO_FATAL_FAILURE(goTo(0));
    ASSERT_NO_FATAL_FAILURE(panel.click("newSequenceButton"));
    ASSERT_NO_FATAL_FAILURE(panel.click("addRowButton"));
    QTest::keyClick(panel.window().windowHandle(), Qt::Key_F3, Qt::ShiftModifier);
    ASSERT_NO_FATAL_FAILURE(panel.click("drawPathButton"));
    ASSERT_TRUE(summary().contains(u"points at 60 Hz"_s)) << summary().toStdString();
    ASSERT_NO_FATAL_FAILURE(run());
    ASSERT_TRUE(panel.waitFor([&] { return state().startsWith(u"The path is done."_s); }))
        << state().toStdString();
    const int taught = panel.composition().machine().program.points.at(0).axes.at(0).counts;
    EXPECT_NEAR(taught, 3'000, 5);
    EXPECT_EQ(commanded(1), taught);

    // While home is unknown, a path counts from 0 of the counter, which is then somewhere else.
    const auto* toStart = panel.window().findChild<QAbstractButton*>(u"pathToStartButton"_s);
    const QString drawAgain = u"The counter or the home of an axis has changed. Draw the path again."_s;
    ASSERT_NO_FATAL_FAILURE(goTo(1'000));
    EXPECT_TRUE(panel.waitFor([&] { return toStart->isEnabled(); })) << toStart->toolTip().toStdString();
    panel.ask(intent::ResetPosition{});
    ASSERT_TRUE(panel.waitFor([&] { return commanded(1) == 0; }));
    EXPECT_TRUE(panel.waitFor([&] { return !toStart->isEnabled(); }));
    EXPECT_EQ(toStart->toolTip(), drawAgain);
    ASSERT_NO_FATAL_FAILURE(goTo(500));

    // The taught point follows the counter, because it counts from home, but a drawn path does not.
    panel.ask(intent::SaveAsHome{});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().home.place().has_value(); }));
    Program program = panel.composition().machine().program;
    const std::int32_t home = panel.module().home.place()->counts;
    program.points.at(0).axes.at(0) = {ModuleIndex(0), taught - home, true};
    emit panel.window().requests().programEdited(program);
    // From the taught point itself, there would be nothing to draw.
    ASSERT_NO_FATAL_FAILURE(goTo(0));
    ASSERT_NO_FATAL_FAILURE(panel.click("drawPathButton"));
    EXPECT_TRUE(toStart->isEnabled()) << toStart->toolTip().toStdString();
    ASSERT_NO_FATAL_FAILURE(goTo(3'000));
    panel.ask(intent::ResetPosition{});
    ASSERT_TRUE(panel.waitFor([&] { return commanded(1) == 0; }));
    EXPECT_TRUE(panel.waitFor([&] { return !toStart->isEnabled(); }));
    EXPECT_EQ(toStart->toolTip(), drawAgain);
    EXPECT_EQ(sim.violations(), "");
}

/// Something else that happens in the window, or on the line, while a path runs.
struct Phase {
    const char* name;
    void (*enter)(VirtualPanel& panel, VirtualChain& sim);
    friend void PrintTo(const Phase& phase, std::ostream* out) { *out << phase.name; }
};

void choose(VirtualPanel& panel, const char* action) {
    panel.window().findChild<QAction*>(QLatin1String(action))->trigger();
}

constexpr Phase kPhases[] = {
    {"AnotherModuleIsSelected",
     [](VirtualPanel& panel, VirtualChain&) {
         auto* list = panel.window().findChild<QAbstractItemView*>(u"chainList"_s);
         const QModelIndex other = list->model()->index(1, 0);
         QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(other).center());
     }},
    {"DisconnectingIsAskedAbout",
     [](VirtualPanel& panel, VirtualChain&) { panel.click("disconnectButton"); }},
    {"TheManualIsOpen", [](VirtualPanel& panel, VirtualChain&) { choose(panel, "manualAction"); }},
    {"ScanningAgain", [](VirtualPanel& panel, VirtualChain&) { choose(panel, "scanAction"); }},
    {"ItsModuleFallsSilent",
     [](VirtualPanel& panel, VirtualChain& sim) {
         (void)sim.control(u"fault module 1 silent"_s);
         EXPECT_TRUE(panel.waitFor([&] { return panel.module().silent; }));
     }},
    {"TheLineIsLost",
     [](VirtualPanel& panel, VirtualChain& sim) {
         (void)sim.control(u"fault bus mute tx"_s);
         EXPECT_TRUE(panel.waitFor([&] { return !panel.connected(); }));
     }},
    {"TheLineComesBack",
     [](VirtualPanel& panel, VirtualChain& sim) {
         (void)sim.control(u"fault bus mute tx"_s);
         EXPECT_TRUE(panel.waitFor([&] { return !panel.connected(); }));
         (void)sim.control(u"fault clear"_s);
     }},
};

class PathWhile : public Paths, public testing::WithParamInterface<Phase> {
protected:
    PathWhile() : Paths(u"servo@10,servo@10"_s) {}
};

TEST_P(PathWhile, EscEndsItForGood) {
    ASSERT_NO_FATAL_FAILURE(begin());
    ASSERT_NO_FATAL_FAILURE(open(swing({u"Module 1"_s}, 500, 60)));
    ASSERT_NO_FATAL_FAILURE(run());
    ASSERT_TRUE(panel.waitFor([&] { return moves(sim); }));
    ASSERT_NO_FATAL_FAILURE(GetParam().enter(panel, sim));
    QWindow* focused = QGuiApplication::focusWindow();  // offscreen, null for the main window
    QTest::keyClick(focused != nullptr ? focused : panel.window().windowHandle(), Qt::Key_Escape);
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    (void)sim.control(u"fault clear"_s);
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected() && !panel.module().silent; }));
    const double stood = commanded(1);
    ASSERT_TRUE(panel.answersFor(1.0));
    EXPECT_EQ(commanded(1), stood) << "no point comes after a stop";
    EXPECT_FALSE(moves(sim));
    EXPECT_FALSE(state().startsWith(u"Point "_s)) << state().toStdString();
}

INSTANTIATE_TEST_SUITE_P(U10, PathWhile, testing::ValuesIn(kPhases),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace nmc
