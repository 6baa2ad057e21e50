// SPDX-License-Identifier: GPL-3.0-or-later
// Step responses stay with their machine from session to session, and a file that cannot be read is not lost.
#include <functional>
#include <utility>
#include <vector>

#include "app/runkeeper.h"
#include "model/machinefile/machinefile.h"
#include "model/machinefile/responsestore.h"
#include "tests/support/choosefile.h"
#include "tests/support/virtualpanel.h"
#include "widgets/response/responsedock.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class RunsKept : public testing::Test {
protected:
    [[nodiscard]] QString file(const QString& name) const { return folder.filePath(name); }
    [[nodiscard]] QString withoutMachine() const { return file(u"runs/no-machine-file.runs"_s); }
    [[nodiscard]] static std::vector<KeptResponse> runsIn(const QString& path) {
        const auto text = readFile(path, kMaxRunFile);
        const auto runs = readResponses(text.value_or(""));
        return runs.value_or(std::vector<KeptResponse>{});
    }
    /// Shows a run like that of a step of module 2.
    static void makeRun(VirtualPanel& panel, int milliseconds) {
        KeptResponse kept;
        kept.run.module = ModuleIndex(1);
        kept.run.taken = {TimePoint{}, 0, 100, 0.1, ResponseMethod::Profile, servo::SetGain{}};
        for (int ms = 1; ms < 100; ++ms)
            kept.run.points.push_back({ms / 1e3, ms < 10 ? 10.0 * ms : 100.0});
        kept.startedAt = "2026-11-21T21:21:02." + std::to_string(milliseconds) + "+01:00";
        kept.moduleName = "Module 2";
        kept.axisName = panel.composition().machine().axis(ModuleIndex(1)).name;
        kept.port = "simulator";
        panel.window().stepResponses().showRun(kept);
    }
    [[nodiscard]] static std::size_t listed(VirtualPanel& panel) {
        return panel.window().stepResponses().runs().size();
    }
    static void name(VirtualPanel& panel, int row, const QString& words) {
        panel.window().stepResponses().open();
        auto* table = panel.window().findChild<QTableWidget*>(u"responseRunTable"_s);
        table->setFocus();
        table->setCurrentCell(row, 3);
        QTest::keyClick(table, Qt::Key_F2);
        auto* editor = table->findChild<QLineEdit*>();
        ASSERT_NE(editor, nullptr);
        QTest::keyClicks(editor, words);
        QTest::keyClick(editor, Qt::Key_Return);
    }
    static void choose(VirtualPanel& panel, QKeyCombination keys, const char* dialog, const QString& path) {
        panel.window().activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&panel.window()));
        QTest::keyClick(&panel.window(), keys.key(), keys.keyboardModifiers());
        auto* asked = panel.window().findChild<QFileDialog*>(QLatin1String(dialog));
        ASSERT_NE(asked, nullptr) << dialog;
        testing_support::chooseFile(*asked, path);
    }
    void startWith(VirtualPanel& panel, const QString& machine) {
        Start start;
        start.machine = file(machine);
        panel.composition().show(start);
        auto* apply = panel.window().findChild<QAbstractButton*>(u"applyDifferencesButton"_s);
        ASSERT_NE(apply, nullptr);
        QTest::mouseClick(apply, Qt::LeftButton);
    }
    [[nodiscard]] QStringList unread() const { return QDir(file(u"runs"_s)).entryList({u"*.unread-*"_s}); }
    void writeBad(const QByteArray& words) {
        ASSERT_TRUE(QDir().mkpath(file(u"runs"_s)));
        QFile bad(withoutMachine());
        ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
        bad.write(words);
    }

    QTemporaryDir folder;
    const QString notRead = u"Could not read the step responses"_s;
};

TEST_F(RunsKept, WithTheirNamesUntilTheNextSession) {
    VirtualChain sim(u"servo"_s);
    {
        VirtualPanel panel({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        ASSERT_NO_FATAL_FAILURE(panel.enable(4'000));
        panel.ask(intent::StopHere{});
        ASSERT_TRUE(panel.answersFor(0.2));
        panel.window().stepResponses().open();
        panel.click("responseButton");
        ASSERT_TRUE(panel.waitFor([&] { return listed(panel) == 1; }));
        name(panel, 0, u"first light"_s);
        ASSERT_TRUE(panel.waitFor([&] {
            const auto runs = runsIn(withoutMachine());
            return runs.size() == 1 && runs[0].name == "first light";
        }));
    }
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_TRUE(panel.waitFor([&] { return listed(panel) == 1; }));
    panel.window().stepResponses().open();
    auto* table = panel.window().findChild<QTableWidget*>(u"responseRunTable"_s);
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 3)->text(), u"first light"_s);
    EXPECT_EQ(table->item(0, 6)->text(), u"200"_s) << "Kp";
    EXPECT_TRUE(table->item(0, 10)->text().contains(u"ms"_s)) << "its settling time";
    EXPECT_EQ(panel.count(notRead), 0);
    table->setCurrentCell(0, 2);
    panel.click("responseRemoveButton");
    EXPECT_TRUE(panel.waitFor([&] { return runsIn(withoutMachine()).empty(); }));
}

TEST_F(RunsKept, BesideTheMachineFile) {
    {
        VirtualPanel panel({}, {}, folder.path());
        panel.start();
        makeRun(panel, 100);
        ASSERT_TRUE(panel.waitFor([&] { return runsIn(withoutMachine()).size() == 1; }));
        ASSERT_NO_FATAL_FAILURE(
            choose(panel, Qt::CTRL | Qt::SHIFT | Qt::Key_S, "saveMachineDialog", file(u"mill.json"_s)));
        ASSERT_TRUE(panel.waitFor([&] { return runsIn(file(u"mill.runs"_s)).size() == 1; }));
        EXPECT_TRUE(panel.waitFor([&] { return runsIn(withoutMachine()).empty(); }))
            << "they belong to the mill";
        makeRun(panel, 200);
        ASSERT_TRUE(panel.waitFor([&] { return runsIn(file(u"mill.runs"_s)).size() == 2; }));
    }
    Machine machine;
    machine.axes.resize(3);
    machine.axes[2].name = "X axis";
    ASSERT_TRUE(writeFile(file(u"lathe.json"_s), writeMachine(machine)));
    {
        VirtualPanel panel({}, {}, folder.path());
        ASSERT_NO_FATAL_FAILURE(startWith(panel, u"mill.json"_s));
        ASSERT_TRUE(panel.waitFor([&] { return listed(panel) == 2; }));
    }
    // A named axis is found again wherever it is in the chain.
    std::vector<KeptResponse> moved = runsIn(file(u"mill.runs"_s));
    moved[0].axisName = "X axis";
    moved[1].axisName = "Y axis";
    ASSERT_TRUE(writeFile(file(u"lathe.runs"_s), writeResponses(moved)));
    VirtualPanel panel({}, {}, folder.path());
    ASSERT_NO_FATAL_FAILURE(startWith(panel, u"lathe.json"_s));
    ASSERT_TRUE(panel.waitFor([&] { return listed(panel) == 2; }));
    EXPECT_EQ(panel.window().stepResponses().runs()[0].run.module, ModuleIndex(2));
    EXPECT_EQ(panel.window().stepResponses().runs()[1].run.module, ModuleIndex(1));
}

TEST_F(RunsKept, BesideAMachineThatIsSavedBeforeANewOneBegins) {
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    makeRun(panel, 100);
    ASSERT_TRUE(panel.waitFor([&] { return runsIn(withoutMachine()).size() == 1; }));
    AxisSettings axis;
    axis.name = "X axis";
    emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
    panel.window().activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel.window()));
    QTest::keyClick(&panel.window(), Qt::Key_N, Qt::ControlModifier);
    auto* save = panel.window().findChild<QAbstractButton*>(u"saveFirstButton"_s);
    ASSERT_NE(save, nullptr);
    QTest::mouseClick(save, Qt::LeftButton);
    auto* dialog = panel.window().findChild<QFileDialog*>(u"saveMachineDialog"_s);
    ASSERT_NE(dialog, nullptr);
    testing_support::chooseFile(*dialog, file(u"mill.json"_s));
    ASSERT_TRUE(panel.waitFor([&] { return panel.composition().machine() == Machine{}; }));
    EXPECT_TRUE(panel.waitFor([&] { return runsIn(file(u"mill.runs"_s)).size() == 1; }));
    EXPECT_TRUE(runsIn(withoutMachine()).empty());
    EXPECT_EQ(listed(panel), 0U) << "the new machine has none";
}

TEST_F(RunsKept, ThoseThatAreStillBeingReadMoveAlong) {
    {
        VirtualPanel panel({}, {}, folder.path());
        panel.start();
        makeRun(panel, 100);
        ASSERT_TRUE(panel.waitFor([&] { return runsIn(withoutMachine()).size() == 1; }));
    }
    QSettings settings(file(u"window.ini"_s), QSettings::IniFormat);
    MainWindow window(settings);
    RunKeeper keeper(file(u"runs"_s), window);
    keeper.open({}, Machine{});
    keeper.follow(file(u"mill.json"_s));
    EXPECT_TRUE(QTest::qWaitFor([this] { return runsIn(file(u"mill.runs"_s)).size() == 1; }));
    EXPECT_TRUE(QTest::qWaitFor([this] { return runsIn(withoutMachine()).empty(); }))
        << "they belong to the mill";
}

/// The disk carries out the last request first.
TEST_F(RunsKept, ThoseThatAreStillBeingMovedAreNotShownForTheNextMachine) {
    {
        VirtualPanel panel({}, {}, folder.path());
        panel.start();
        makeRun(panel, 100);
        ASSERT_TRUE(panel.waitFor([&] { return runsIn(withoutMachine()).size() == 1; }));
    }
    std::vector<std::function<void()>> waits;
    setBackground([&waits](std::function<void()> work) { waits.push_back(std::move(work)); });
    const auto answer = [&waits] {
        while (!waits.empty()) {
            const std::function<void()> last = std::move(waits.back());
            waits.pop_back();
            last();
            QCoreApplication::processEvents();
        }
    };
    {
        QSettings settings(file(u"window.ini"_s), QSettings::IniFormat);
        MainWindow window(settings);
        RunKeeper keeper(file(u"runs"_s), window);
        keeper.open({}, Machine{});
        answer();
        EXPECT_EQ(window.stepResponses().runs().size(), 1U);
        keeper.follow(file(u"mill.json"_s));
        keeper.open({}, Machine{});  // a new machine
        answer();
        EXPECT_TRUE(window.stepResponses().runs().empty());
    }
    setBackground([](const std::function<void()>& work) { work(); });
    EXPECT_EQ(runsIn(file(u"mill.runs"_s)).size(), 1U);
    EXPECT_TRUE(runsIn(withoutMachine()).empty());
}

TEST_F(RunsKept, ABadFileIsSaidAndSetAside) {
    const QByteArray bad = "{\n\"format\": \"nmc-panel-step-runs\",\n\"version\": 1,\n\"runs\": 7\n}\n";
    ASSERT_NO_FATAL_FAILURE(writeBad(bad));
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(notRead) != nullptr; }));
    EXPECT_TRUE(panel.standing(notRead)->message().body.contains(u"line 4: runs is not a list"_s))
        << panel.standing(notRead)->message().body.toStdString();
    EXPECT_TRUE(unread().isEmpty()) << "not before there is something to save";
    makeRun(panel, 100);
    ASSERT_TRUE(panel.waitFor([&] { return runsIn(withoutMachine()).size() == 1; }));
    ASSERT_EQ(unread().size(), 1);
    QFile aside(file(u"runs/"_s + unread().front()));
    ASSERT_TRUE(aside.open(QIODevice::ReadOnly));
    EXPECT_EQ(aside.readAll(), bad);
}

TEST_F(RunsKept, AFileOfANewerProgramIsNotOverwritten) {
    ASSERT_NO_FATAL_FAILURE(
        writeBad("{\"format\": \"nmc-panel-step-runs\", \"version\": 2, \"runs\": []}\n"));
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(notRead) != nullptr; }));
    EXPECT_TRUE(panel.standing(notRead)->message().body.contains(u"newer NMC Panel"_s));
    makeRun(panel, 100);
    ASSERT_TRUE(panel.waitFor([&] { return runsIn(withoutMachine()).size() == 1; }));
    EXPECT_EQ(unread().size(), 1);
}

TEST_F(RunsKept, TwoPanelsLoseNothingToEachOther) {
    VirtualPanel one({}, {}, folder.path());
    VirtualPanel other({}, {}, folder.path());
    one.start();
    other.start();
    makeRun(one, 100);
    ASSERT_TRUE(one.waitFor([&] { return runsIn(withoutMachine()).size() == 1; }));
    makeRun(other, 200);
    ASSERT_TRUE(one.waitFor([&] { return runsIn(withoutMachine()).size() == 2; }));
    makeRun(one, 300);
    EXPECT_TRUE(one.waitFor([&] { return runsIn(withoutMachine()).size() == 3; }));
}

TEST_F(RunsKept, ADiskThatTakesNothingIsSaidOnce) {
    std::atomic<bool> full = true;
    VirtualPanel panel({}, {}, folder.path(), [&full](const QString& path, std::string_view content) {
        return full ? FileWriter::Result(tl::unexpected(FileError{FileErrorKind::NoSpace, path}))
                    : writeFile(path, content);
    });
    panel.start();
    makeRun(panel, 100);
    const QString notKept = u"of this session are not saved"_s;
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(notKept) != nullptr; }));
    full = false;
    makeRun(panel, 200);
    EXPECT_TRUE(panel.waitFor([&] { return panel.standing(notKept) == nullptr; }));
    EXPECT_EQ(runsIn(withoutMachine()).size(), 2U);
}

}  // namespace
}  // namespace nmc
