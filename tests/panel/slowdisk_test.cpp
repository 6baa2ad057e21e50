// SPDX-License-Identifier: GPL-3.0-or-later
// A disk that does not answer, or refuses: the panel goes on, only the user stops motors, and the result of
// each request is reported when it is known.
#include <functional>
#include <utility>
#include <vector>

#include "tests/support/choosefile.h"
#include "tests/support/virtualpanel.h"
#include "widgets/scope/scopefiles.h"

namespace nmc {
namespace {

using testing_support::turnTo;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

/// A disk that answers when the test says so.
class SlowDisk : public testing::Test {
protected:
    SlowDisk() {
        setBackground([this](std::function<void()> work) { m_waits.push_back(std::move(work)); });
    }
    ~SlowDisk() override { answer(); }
    /// Carries out what is waiting; from then on, everything is done at once.
    void answer() {
        setBackground([](const std::function<void()>& work) { work(); });
        for (const auto& work : std::exchange(m_waits, {}))
            work();
    }
    template <typename Widget = QWidget>
    Widget* find(const char* name) {
        return panel.window().findChild<Widget*>(QLatin1String(name));
    }
    void click(const char* name) {
        auto* button = find<QAbstractButton>(name);
        ASSERT_NE(button, nullptr) << name;
        turnTo(*button);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void choose(const char* dialog, const QString& path) {
        auto* asked = find<QFileDialog>(dialog);
        ASSERT_NE(asked, nullptr) << dialog;
        testing_support::chooseFile(*asked, path);
    }
    void nameTheAxis() {
        auto* name = find<QLineEdit>("axisNameField");
        turnTo(*name);
        QTest::keyClicks(name, QStringLiteral("Spindle"));
    }
    void saveTheMachine() {
        QTest::keyClick(&panel.window(), Qt::Key_S, Qt::ControlModifier);
        choose("saveMachineDialog", file);
    }
    void connect() {
        panel.start();
        panel.connectTo(sim.terminal());
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    }

    QTemporaryDir directory;
    const QString file = directory.filePath(QStringLiteral("mill.json"));
    VirtualChain sim{QStringLiteral("servo,servo")};
    VirtualPanel panel;

private:
    std::vector<std::function<void()>> m_waits;
};

TEST_F(SlowDisk, LetsMotorsRunAndBeStoppedWhileTheMachineIsSaved) {
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    nameTheAxis();
    ASSERT_NO_FATAL_FAILURE(saveTheMachine());
    ASSERT_TRUE(panel.answersFor(0.5)) << "the panel goes on";
    EXPECT_TRUE(sim.driven(0));
    EXPECT_TRUE(panel.window().windowTitle().endsWith(QStringLiteral("(being saved)")));
    EXPECT_FALSE(QFile::exists(file));
    panel.pressStopAll();
    EXPECT_TRUE(panel.waitFor([&] { return !sim.driven(0); }));
    EXPECT_TRUE(panel.window().isWindowModified()) << "it is not saved yet";
    answer();
    EXPECT_TRUE(panel.waitFor([&] { return !panel.window().isWindowModified(); }));
    EXPECT_TRUE(QFile::exists(file));
    EXPECT_TRUE(panel.window().windowTitle().endsWith(QStringLiteral(" - mill[*]")));
}

TEST_F(SlowDisk, KeepsWhatIsEditedWhileTheMachineIsSaved) {
    ASSERT_NO_FATAL_FAILURE(connect());
    nameTheAxis();
    ASSERT_NO_FATAL_FAILURE(saveTheMachine());
    nameTheAxis();
    answer();
    ASSERT_TRUE(panel.waitFor([&] { return QFile::exists(file); }));
    ASSERT_TRUE(
        panel.waitFor([&] { return panel.window().windowTitle().endsWith(QStringLiteral(" - mill[*]")); }));
    EXPECT_TRUE(panel.window().isWindowModified());
    EXPECT_EQ(find<QLineEdit>("axisNameField")->text(), QStringLiteral("SpindleSpindle"));
}

TEST_F(SlowDisk, IsWaitedForBeforeTheWindowCloses) {
    ASSERT_NO_FATAL_FAILURE(connect());
    nameTheAxis();
    ASSERT_NO_FATAL_FAILURE(saveTheMachine());
    panel.window().close();
    EXPECT_TRUE(panel.window().isVisible());
    ASSERT_NE(find("savingDialog"), nullptr);
    answer();
    EXPECT_TRUE(panel.waitFor([&] { return !panel.window().isVisible(); }));
    EXPECT_TRUE(QFile::exists(file));
}

TEST_F(SlowDisk, IsNotWaitedForByWhoStays) {
    ASSERT_NO_FATAL_FAILURE(connect());
    nameTheAxis();
    ASSERT_NO_FATAL_FAILURE(saveTheMachine());
    panel.window().close();
    ASSERT_NO_FATAL_FAILURE(click("staySavingButton"));
    answer();
    ASSERT_TRUE(panel.waitFor([&] { return !panel.window().isWindowModified(); }));
    EXPECT_TRUE(panel.window().isVisible());
}

TEST_F(SlowDisk, LetsMotorsRunWhileUnsavedWorkIsKept) {
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    nameTheAxis();
    ASSERT_TRUE(panel.answersFor(4)) << "longer than a save is delayed, and than a frozen panel is tolerated";
    EXPECT_TRUE(sim.driven(0));
    EXPECT_EQ(panel.count(QStringLiteral("not backed up")), 0);
}

TEST_F(SlowDisk, GetsTheNextRecordingWhenItHasTakenTheOneBefore) {
    ASSERT_NO_FATAL_FAILURE(connect());
    ScopeFiles& files = panel.window().scopeFiles();
    emit files.recordRequested(directory.filePath(QStringLiteral("first.csv")));
    emit files.recordingEndRequested();
    emit files.recordRequested(directory.filePath(QStringLiteral("second.csv")));
    ASSERT_TRUE(panel.answersFor(0.2));
    answer();
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("Recorded \"first.csv\"")) == 1; }));
    ASSERT_TRUE(panel.answersFor(0.2));
    emit files.recordingEndRequested();
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("Recorded \"second.csv\"")) == 1; }));
}

TEST_F(SlowDisk, SaysSoIfTheNextRecordingCannotBeginAnyMore) {
    ASSERT_NO_FATAL_FAILURE(connect());
    ScopeFiles& files = panel.window().scopeFiles();
    emit files.recordRequested(directory.filePath(QStringLiteral("first.csv")));
    emit files.recordingEndRequested();
    emit files.recordRequested(directory.filePath(QStringLiteral("second.csv")));
    panel.disconnect();
    ASSERT_TRUE(panel.waitFor([&] { return !panel.connected(); }));
    answer();
    EXPECT_TRUE(panel.waitFor(
        [&] { return panel.count(QStringLiteral("Nothing is recorded to \"second.csv\"")) == 1; }));
}

TEST_F(SlowDisk, LetsMotorsRunWhilePacketsAreSaved) {
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    find<QDockWidget>("monitorDock")->toggleViewAction()->trigger();
    find<QDockWidget>("monitorDock")->raise();
    ASSERT_TRUE(panel.waitFor([&] { return find("packetSave") != nullptr; }));
    ASSERT_NO_FATAL_FAILURE(click("packetSave"));
    ASSERT_NO_FATAL_FAILURE(choose("packetSaveDialog", directory.filePath(QStringLiteral("packets.txt"))));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_TRUE(sim.driven(0));
    EXPECT_EQ(panel.count(QStringLiteral("\"packets.txt\"")), 0) << "the result is not known yet";
    answer();
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("Saved \"packets.txt\".")) == 1; }));
}

TEST(FullDisk, IsToldOnceOfUnsavedWorkAndOfEachSave) {
    QTemporaryDir directory;
    VirtualPanel panel({}, {}, {}, [](const QString& path, std::string_view /*content*/) {
        return FileWriter::Result(tl::unexpected(FileError{FileErrorKind::NoSpace, path}));
    });
    panel.start();
    AxisSettings axis;
    for (const char* name : {"X", "Y"}) {
        axis.name = name;
        emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
        panel.window().activateWindow();
        ASSERT_TRUE(panel.waitFor([&] { return panel.window().isActiveWindow(); }));
        QTest::keyClick(&panel.window(), Qt::Key_S, Qt::ControlModifier);
        auto* dialog = panel.window().findChild<QFileDialog*>(QStringLiteral("saveMachineDialog"));
        ASSERT_NE(dialog, nullptr);
        const QString file = QLatin1String(name) + QStringLiteral(".json");
        testing_support::chooseFile(*dialog, directory.filePath(file));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        ASSERT_TRUE(panel.waitFor([&] { return panel.standing(file) != nullptr; }));
        EXPECT_TRUE(panel.window().isWindowModified());
    }
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("not backed up")) == 1; }));
}

}  // namespace
}  // namespace nmc
