// SPDX-License-Identifier: GPL-3.0-or-later
// The machine file in the whole program, with a simulator that counts what reaches the modules: opening sends
// nothing, Apply sends what is ticked and nothing else, and no work is lost.
#include <gmock/gmock.h>

#include <functional>
#include <vector>

#include "link/files/machineio.h"
#include "model/machinefile/machinefile.h"
#include "tests/support/choosefile.h"
#include "tests/support/gains.h"
#include "tests/support/virtualpanel.h"
#include "widgets/machine/machinemenu.h"
#include "widgets/mainwindow/operatorlock.h"

namespace nmc {
namespace {

using testing_support::kGains;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

/// A machine for servo,servo: names and gains for both, limit pins for the first.
Machine twoServos() {
    Machine machine;
    machine.name = "Mill";
    machine.baud = 115'200;
    machine.axes.resize(2);
    machine.axes[0].name = "X axis";
    machine.axes[0].expected = ModuleIdentity{ModuleType::Servo, 4};
    machine.axes[0].gains = kGains;
    machine.axes[0].io = servo::IoControl{false, true, true, false};
    machine.axes[1] = machine.axes[0];
    machine.axes[1].name = "Y axis";
    machine.axes[1].gains->kp = 111;
    machine.axes[1].io.reset();
    return machine;
}

class MachineFiles : public testing::Test {
protected:
    MachineFiles() { file = write("mill.json", writeMachine(twoServos())); }

    QString write(const char* name, const std::string& content) {
        QString path = directory.filePath(QLatin1String(name));
        EXPECT_TRUE(writeFile(path, content).has_value());
        return path;
    }
    static Machine machineIn(const QString& path) {
        const auto text = readFile(path, kMaxMachineFile);
        EXPECT_TRUE(text.has_value());
        const auto parsed = parseMachine(text.value_or(""));
        return parsed ? parsed->machine : Machine{};
    }
    /// How often a module has carried out a command.
    static int executed(VirtualChain& sim, int module, const char* command) {
        const QJsonArray modules = sim.control(QStringLiteral("stats"))[QStringLiteral("modules")].toArray();
        return modules[module - 1]
            .toObject()[QStringLiteral("executed")]
            .toObject()[QLatin1String(command)]
            .toInt();
    }
    /// Everything that each module has been sent, as text, apart from queries.
    static std::string told(VirtualChain& sim) {
        std::string all;
        for (const QJsonValue& module :
             sim.control(QStringLiteral("stats"))[QStringLiteral("modules")].toArray()) {
            QJsonObject commands = module.toObject()[QStringLiteral("executed")].toObject();
            for (const char* look : {"read_status", "nop"})
                commands.remove(QLatin1String(look));
            all += QJsonDocument(commands).toJson(QJsonDocument::Compact).toStdString();
        }
        return all;
    }
    static MachineMenu& menu(VirtualPanel& panel) { return panel.window().machineMenu(); }
    static QTreeWidget* table(VirtualPanel& panel) {
        return panel.window().findChild<QTreeWidget*>(QStringLiteral("differencesTable"));
    }
    /// The row with this text; one that says nothing if there is none.
    static const QTreeWidgetItem* row(VirtualPanel& panel, const QString& text) {
        static const QTreeWidgetItem none;
        const QList<QTreeWidgetItem*> found = table(panel)->findItems(text, Qt::MatchExactly);
        EXPECT_EQ(found.size(), 1) << text.toStdString();
        return found.isEmpty() ? &none : found.first();
    }
    static void click(VirtualPanel& panel, const char* button) {
        auto* widget = panel.window().findChild<QAbstractButton*>(QLatin1String(button));
        ASSERT_NE(widget, nullptr) << button;
        ASSERT_TRUE(widget->isEnabled()) << button << ": " << widget->toolTip().toStdString();
        QTest::mouseClick(widget, Qt::LeftButton);
    }
    static void tickOnly(VirtualPanel& panel, const QStringList& rows) {
        for (int i = 0; i < table(panel)->topLevelItemCount(); ++i) {
            QTreeWidgetItem* row = table(panel)->topLevelItem(i);
            if (row->data(0, Qt::CheckStateRole).isValid())
                row->setCheckState(0, rows.contains(row->text(0)) ? Qt::Checked : Qt::Unchecked);
        }
    }
    static void connectTo(VirtualPanel& panel, VirtualChain& sim) {
        panel.start();
        panel.connectTo(sim.terminal());
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    }
    /// Presses keys in the main window, whatever was in front of it before.
    static void strike(VirtualPanel& panel, QKeyCombination keys) {
        panel.window().activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&panel.window()));
        QTest::keyClick(&panel.window(), keys.key(), keys.keyboardModifiers());
    }
    static void open(VirtualPanel& panel, const QString& path) {
        strike(panel, Qt::CTRL | Qt::Key_O);
        if (auto* drop = panel.window().findChild<QAbstractButton*>(QStringLiteral("goOnUnsavedButton")))
            QTest::mouseClick(drop, Qt::LeftButton);
        choose(panel, "openMachineDialog", path);
    }
    static void save(VirtualPanel& panel) {
        strike(panel, Qt::CTRL | Qt::Key_S);
        EXPECT_TRUE(panel.waitFor([&] { return !menu(panel).file().saving; }));
    }
    static void saveAs(VirtualPanel& panel, const QString& path) {
        strike(panel, Qt::CTRL | Qt::SHIFT | Qt::Key_S);
        choose(panel, "saveMachineDialog", path);
        EXPECT_TRUE(panel.waitFor([&] { return !menu(panel).file().saving; }));
    }
    static void choose(VirtualPanel& panel, const char* name, const QString& path) {
        auto* dialog = panel.window().findChild<QFileDialog*>(QLatin1String(name));
        ASSERT_NE(dialog, nullptr) << name;
        testing_support::chooseFile(*dialog, path);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    /// Begins operator mode.
    static void lock(VirtualPanel& panel) {
        panel.window().findChild<QAction*>(QStringLiteral("operatorAction"))->trigger();
        for (const char* field : {"operatorPinField", "operatorPinAgainField"})
            QTest::keyClicks(panel.window().findChild<QLineEdit*>(QLatin1String(field)),
                             QStringLiteral("4711"));
        ASSERT_NO_FATAL_FAILURE(click(panel, "operatorBeginButton"));
        ASSERT_TRUE(panel.window().operatorLock().isLocked());
    }
    static void rename(VirtualPanel& panel, const char* name) {
        AxisSettings axis;
        axis.name = name;
        emit panel.window().requests().axisEdited(ModuleIndex(0), axis);
    }

    QTemporaryDir directory;
    QString file;
};

TEST_F(MachineFiles, OneOfTheCommandLineIsOpenedAtTheStart) {
    VirtualPanel panel;
    Start start;
    start.machine = file;
    panel.composition().show(start);
    ASSERT_NE(table(panel), nullptr);
    EXPECT_GT(table(panel)->topLevelItemCount(), 0);
}

TEST_F(MachineFiles, ABadOneOfTheCommandLineIsASentenceInTheWindow) {
    for (const QString& bad : {directory.filePath(QStringLiteral("none.json")), write("bad.json", "{")}) {
        VirtualPanel panel;
        Start start;
        start.machine = bad;
        panel.composition().show(start);
        EXPECT_EQ(panel.count(QFileInfo(bad).fileName()), 1)
            << panel.headlines().join(QLatin1Char('|')).toStdString();
        EXPECT_EQ(table(panel), nullptr);
    }
}

/// The folder may be the wrong one, and there need never have been such a file.
TEST_F(MachineFiles, OneThatIsNotThereIsSaidToBeNowhereWithItsFolder) {
    VirtualPanel panel;
    Start start;
    start.machine = directory.filePath(QStringLiteral("none.json"));
    panel.composition().show(start);
    const MessageRow* problem = panel.standing(QStringLiteral("Could not open \"none.json\"."));
    ASSERT_NE(problem, nullptr);
    EXPECT_TRUE(problem->message().body.startsWith(QStringLiteral("There is no file ") + *start.machine +
                                                   QLatin1Char('.')))
        << problem->message().body.toStdString();
}

TEST_F(MachineFiles, OpeningSendsNothingAndCancellingChangesNothing) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    connectTo(panel, sim);
    const std::string before = told(sim);
    open(panel, file);
    ASSERT_NE(table(panel), nullptr);
    QStringList rows;
    for (int i = 0; i < table(panel)->topLevelItemCount(); ++i)
        rows << table(panel)->topLevelItem(i)->text(0);
    EXPECT_EQ(rows, (QStringList{QStringLiteral("Machine"), QStringLiteral("Baud rate"),
                                 QStringLiteral("Module 1: Name"), QStringLiteral("Module 1: Gains"),
                                 QStringLiteral("Module 1: Limit pins"), QStringLiteral("Module 2: Name"),
                                 QStringLiteral("Module 2: Gains")}));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(told(sim), before);
    click(panel, "cancelDifferencesButton");
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(told(sim), before);
    EXPECT_EQ(panel.window().windowTitle(), QStringLiteral("NMC Panel - ") + sim.terminal());
    EXPECT_FALSE(panel.module().gains.has_value());
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(MachineFiles, ApplySendsExactlyWhatIsTickedAndMovesNothing) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    connectTo(panel, sim);
    const std::string before = told(sim);
    open(panel, file);
    tickOnly(panel, {QStringLiteral("Module 1: Name"), QStringLiteral("Module 2: Gains")});
    click(panel, "applyDifferencesButton");
    ASSERT_TRUE(panel.waitFor([&] { return executed(sim, 2, "set_gain") == 1; }));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(told(sim).substr(0, before.find('}')), before.substr(0, before.find('}')));
    EXPECT_EQ(told(sim).size(), before.size() + std::string(",\"set_gain\":1").size()) << told(sim);
    EXPECT_EQ(sim.state(2)[QStringLiteral("gains")].toObject()[QStringLiteral("kp")].toInt(), 111);
    for (const int module : {1, 2}) {
        EXPECT_FALSE(sim.state(module)[QStringLiteral("servo_on")].toBool());
        EXPECT_FALSE(sim.state(module)[QStringLiteral("amp_enabled")].toBool());
        EXPECT_EQ(sim.state(module)[QStringLiteral("position")].toInt(), 0);
    }
    EXPECT_EQ(texts::moduleName(ModuleIndex(0)), QStringLiteral("Module 1 \"X axis\""));
    EXPECT_EQ(texts::moduleName(ModuleIndex(1)), QStringLiteral("Module 2"));
    EXPECT_TRUE(panel.window().isWindowModified()) << "it differs from the file";
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(MachineFiles, ApplyingAllOfItMakesItTheOpenFile) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    connectTo(panel, sim);
    open(panel, file);
    click(panel, "applyDifferencesButton");
    ASSERT_TRUE(panel.waitFor([&] { return executed(sim, 2, "set_gain") == 1; }));
    ASSERT_TRUE(panel.waitFor([&] { return executed(sim, 1, "io_control") == 1; }));
    EXPECT_EQ(executed(sim, 1, "set_gain"), 1);
    EXPECT_FALSE(panel.window().isWindowModified());
    EXPECT_TRUE(panel.window().windowTitle().endsWith(QStringLiteral(" - mill[*]")));
    EXPECT_EQ(panel.headlines().first(), QStringLiteral("\"mill.json\" is open. Settings applied: 7."));
    // When it is opened again, there is nothing to do.
    ASSERT_TRUE(panel.waitFor([&] {
        const auto& modules = panel.composition().store().link().modules;
        return modules[1].gains && modules[0].io;
    }));
    open(panel, file);
    EXPECT_EQ(panel.headlines().first(), QStringLiteral("\"mill.json\" is open. No differences."));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(MachineFiles, AMotorThatMovesGoesOnAndNothingIsSentToIt) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    panel.startMoving(sim);
    // It already has the gains of the file, but not the limit pins.
    ASSERT_EQ(kGains.kp, panel.module().gains->kp);
    open(panel, file);
    click(panel, "tickAllButton");
    ASSERT_TRUE(panel.waitFor([&] {
        return !panel.window()
                    .findChild<QAbstractButton*>(QStringLiteral("applyDifferencesButton"))
                    ->isEnabled();
    }));
    emit menu(panel).applyRequested({{ModuleIndex(0), MachinePart::Io}});
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(executed(sim, 1, "io_control"), 0);
    EXPECT_NE(panel.standing(QStringLiteral("Nothing was applied.")), nullptr)
        << "whoever was faster than the button is told";
    ASSERT_NE(table(panel), nullptr);
    EXPECT_TRUE(moves(sim));
    // Names can be applied in the meantime.
    tickOnly(panel, {QStringLiteral("Module 1: Name")});
    click(panel, "applyDifferencesButton");
    EXPECT_EQ(texts::moduleName(ModuleIndex(0)), QStringLiteral("Module 1 \"X axis\""));
    EXPECT_EQ(panel.standing(QStringLiteral("Nothing was applied.")), nullptr);
    EXPECT_TRUE(moves(sim));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(MachineFiles, GroupsSayThatTheyAreSentAndWaitUntilNothingMoves) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    panel.startMoving(sim);
    Machine grouped = twoServos();
    grouped.groups = {{0x81, "Table", {ModuleIndex(1)}, {}}};
    open(panel, write("grouped.json", writeMachine(grouped)));
    const QString groups = QStringLiteral("Groups, Group 81");
    EXPECT_EQ(row(panel, groups)->text(3), QStringLiteral("Sent to the module."));
    emit menu(panel).applyRequested({PartId{{}, MachinePart::Groups}});
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(sim.group(1), 0xFF);
    EXPECT_NE(panel.standing(QStringLiteral("Nothing was applied.")), nullptr);
    panel.ask(intent::StopSmoothly{});
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module().moving(); }));
    tickOnly(panel, {groups});
    click(panel, "applyDifferencesButton");
    EXPECT_TRUE(panel.waitFor([&] { return sim.group(1) == 0x81; }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(MachineFiles, AModuleThatAnswersMeanwhileIsNotSentWhatWasNotToBeSent) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    connectTo(panel, sim);
    const auto silent = [&] { return panel.composition().store().link().modules.at(1).silent; };
    (void)sim.control(QStringLiteral("fault module 2 silent"));
    ASSERT_TRUE(panel.waitFor(silent));
    open(panel, file);
    const QString gains = QStringLiteral("Module 2: Gains");
    ASSERT_TRUE(row(panel, gains)->text(3).startsWith(QStringLiteral("Filled in, not sent")));
    tickOnly(panel, {gains});
    (void)sim.control(QStringLiteral("fault clear"));
    ASSERT_TRUE(panel.waitFor([&] { return !silent(); }));
    click(panel, "applyDifferencesButton");
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(executed(sim, 2, "set_gain"), 0);
    EXPECT_NE(panel.standing(QStringLiteral("Nothing was applied.")), nullptr);
    ASSERT_EQ(row(panel, gains)->text(3), QStringLiteral("Sent to the module."));
    tickOnly(panel, {gains});
    click(panel, "applyDifferencesButton");
    EXPECT_TRUE(panel.waitFor([&] { return executed(sim, 2, "set_gain") == 1; }));
    EXPECT_EQ(panel.standing(QStringLiteral("Nothing was applied.")), nullptr);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(MachineFiles, AServoThatIsSwitchedOnMeanwhileIsNotSentGainsUnasked) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    connectTo(panel, sim);
    servo::SetGain others = kGains;
    others.kp = 100;
    panel.ask(intent::ApplyGains{others});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains.has_value(); }));
    open(panel, file);
    const QString gains = QStringLiteral("Module 1: Gains, Kp");
    ASSERT_EQ(row(panel, gains)->checkState(0), Qt::Checked);
    panel.ask(intent::Enable{});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().servoOn() && !panel.module().moving(); }));
    click(panel, "applyDifferencesButton");
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(executed(sim, 1, "set_gain"), 1) << "those from before";
    EXPECT_NE(panel.standing(QStringLiteral("Nothing was applied.")), nullptr);
    EXPECT_EQ(row(panel, gains)->checkState(0), Qt::Unchecked) << "as for any motor that is on";
    tickOnly(panel, {gains});
    click(panel, "applyDifferencesButton");
    EXPECT_TRUE(panel.waitFor([&] { return executed(sim, 1, "set_gain") == 2; }));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(MachineFiles, AFileForOtherHardwareSaysSoAndIsNotOverwritten) {
    VirtualChain sim(QStringLiteral("servo@3,servo"));
    VirtualPanel panel;
    connectTo(panel, sim);
    const std::string content = readFile(file, kMaxMachineFile).value();
    open(panel, file);
    ASSERT_EQ(table(panel)->topLevelItem(2)->text(0), QStringLiteral("Module 1: Type and version"));
    EXPECT_EQ(table(panel)->topLevelItem(2)->text(1), QStringLiteral("PIC-SERVO v4"));
    EXPECT_EQ(table(panel)->topLevelItem(2)->text(2), QStringLiteral("PIC-SERVO v3"));
    click(panel, "tickAllButton");
    click(panel, "applyDifferencesButton");
    ASSERT_TRUE(panel.waitFor([&] { return executed(sim, 2, "set_gain") == 1; }));
    EXPECT_EQ(executed(sim, 1, "set_gain"), 0);
    EXPECT_TRUE(menu(panel).file().path.isEmpty()) << "Save requests a name";
    EXPECT_EQ(readFile(file, kMaxMachineFile).value(), content);
}

TEST_F(MachineFiles, WhatThePanelKnowsIsSavedAndOpenedAgain) {
    VirtualChain sim(QStringLiteral("servo,step"));
    VirtualPanel panel;
    connectTo(panel, sim);
    rename(panel, "Spindle");
    panel.ask(intent::ApplyGains{kGains});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains.has_value(); }));
    EXPECT_TRUE(panel.window().isWindowModified());
    const QString path = directory.filePath(QStringLiteral("lathe.json"));
    saveAs(panel, path);
    EXPECT_FALSE(panel.window().isWindowModified());
    EXPECT_TRUE(panel.window().windowTitle().endsWith(QStringLiteral(" - lathe[*]")));
    const Machine saved = machineIn(path);
    EXPECT_EQ(saved.name, "lathe");
    EXPECT_EQ(saved.baud, 115'200U);
    ASSERT_EQ(saved.axes.size(), 2U);
    EXPECT_EQ(saved.axes[0].name, "Spindle");
    EXPECT_EQ(saved.axes[0].gains, kGains);
    EXPECT_EQ(saved.axes[0].expected, (ModuleIdentity{ModuleType::Servo, 4}));
    EXPECT_EQ(saved.axes[1].expected, (ModuleIdentity{ModuleType::Stepper, 1}));

    VirtualPanel another;
    another.start();
    open(another, path);
    click(another, "applyDifferencesButton");
    EXPECT_FALSE(another.window().isWindowModified());
    EXPECT_EQ(texts::moduleName(ModuleIndex(0)), QStringLiteral("Module 1 \"Spindle\""));
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(MachineFiles, UnknownKeysAreStillThereAfterSaving) {
    std::string text = writeMachine(twoServos());
    text.insert(1, "\n  \"serial\": \"A-17\",");
    const QString path = write("keys.json", text);
    VirtualPanel panel;
    panel.start();
    open(panel, path);
    click(panel, "applyDifferencesButton");
    rename(panel, "Z");
    save(panel);
    EXPECT_THAT(readFile(path, kMaxMachineFile).value(), testing::HasSubstr("\"serial\": \"A-17\""));
    EXPECT_EQ(machineIn(path).axes[0].name, "Z");
}

TEST_F(MachineFiles, UnknownKeysOfAnAxisThatLeftDuringASaveAreNotGivenToTheNext) {
    std::string text = writeMachine(twoServos());
    text.insert(text.find("\"name\": \"X axis\""), "\"note\": \"first\", ");
    text.insert(text.find("\"name\": \"Y axis\""), "\"note\": \"second\", ");
    const QString path = write("keys.json", text);
    VirtualPanel panel;
    panel.start();
    open(panel, path);
    click(panel, "applyDifferencesButton");
    rename(panel, "Z");
    std::vector<std::function<void()>> waits;
    setBackground([&waits](std::function<void()> work) { waits.push_back(std::move(work)); });
    strike(panel, Qt::CTRL | Qt::Key_S);
    emit panel.composition().connection().accepted({ModuleIdentity{ModuleType::Servo, 4}}, {ModuleIndex(0)});
    setBackground([](const std::function<void()>& work) { work(); });
    for (const auto& work : waits)
        work();
    EXPECT_TRUE(panel.waitFor([&] { return !menu(panel).file().saving; }));
    save(panel);
    const std::string saved = readFile(path, kMaxMachineFile).value();
    EXPECT_THAT(saved, testing::HasSubstr("\"note\": \"second\""));
    EXPECT_THAT(saved, testing::Not(testing::HasSubstr("\"note\": \"first\"")));
}

TEST_F(MachineFiles, ABadFileNamesLineAndFieldAndNothingChanges) {
    std::string text = writeMachine(twoServos());
    text.replace(text.find("\"Kp\": 200"), 9, "\"Kp\": 40000");
    const QString path = write("bad.json", text);
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("40000")), '\n');
    VirtualPanel panel;
    panel.start();
    open(panel, path);
    EXPECT_EQ(panel.headlines().first(),
              QStringLiteral("\"bad.json\" line %1: Kp is 40000; the module accepts 0 to 32767.").arg(line));
    EXPECT_EQ(table(panel), nullptr);
    EXPECT_EQ(panel.window().windowTitle(), QStringLiteral("NMC Panel"));
    // The dialog takes no file that is not there, but the list of recent files may name one.
    emit menu(panel).openRequested(directory.filePath(QStringLiteral("none.json")));
    EXPECT_EQ(panel.headlines().first(), QStringLiteral("Could not open \"none.json\"."));
}

TEST_F(MachineFiles, AFolderThatIsNotThereLosesNothing) {
    VirtualPanel panel;
    panel.start();
    rename(panel, "Z");
    saveAs(panel, directory.filePath(QStringLiteral("none/mill.json")));
    EXPECT_EQ(panel.count(QStringLiteral("Could not save")), 1);
    EXPECT_TRUE(panel.window().isWindowModified());
    EXPECT_TRUE(menu(panel).file().path.isEmpty());
    saveAs(panel, directory.path());
    EXPECT_TRUE(panel.window().isWindowModified());
    saveAs(panel, file);
    EXPECT_FALSE(panel.window().isWindowModified());
    EXPECT_EQ(machineIn(file).axes[0].name, "Z");
}

TEST_F(MachineFiles, OneThatSomeoneElseHasChangedIsNotOverwritten) {
    VirtualPanel panel;
    panel.start();
    open(panel, file);
    click(panel, "applyDifferencesButton");
    Machine changed = twoServos();
    changed.axes[1].name = "Changed elsewhere";
    const std::string theirs = writeMachine(changed);
    write("mill.json", theirs);
    rename(panel, "Z");
    save(panel);
    EXPECT_EQ(readFile(file, kMaxMachineFile).value(), theirs);
    EXPECT_NE(panel.standing(QStringLiteral("Could not save \"mill.json\".")), nullptr);
    EXPECT_TRUE(panel.window().isWindowModified());
    saveAs(panel, file);  // the dialog asks whether to replace it
    EXPECT_EQ(panel.standing(QStringLiteral("Could not save")), nullptr);
    EXPECT_EQ(machineIn(file).axes[0].name, "Z");
    rename(panel, "Spindle");
    save(panel);
    EXPECT_EQ(machineIn(file).axes[0].name, "Spindle") << "what it has saved itself is no change";
    ASSERT_TRUE(QFile::remove(file));
    rename(panel, "Z");
    save(panel);
    EXPECT_EQ(machineIn(file).axes[0].name, "Z") << "there was nothing to lose";
}

/// Otherwise what it applies would count as saved.
TEST_F(MachineFiles, SavingClosesTheTableOfTheSameFileOnly) {
    VirtualPanel panel;
    panel.start();
    open(panel, file);
    click(panel, "applyDifferencesButton");
    rename(panel, "Z");
    open(panel, file);
    ASSERT_NE(menu(panel).differences(), nullptr);
    save(panel);
    EXPECT_EQ(machineIn(file).axes[0].name, "Z");
    EXPECT_EQ(menu(panel).differences(), nullptr);
    EXPECT_FALSE(panel.window().isWindowModified());
    const QString other = write("other.json", writeMachine(twoServos()));
    rename(panel, "Spindle");
    open(panel, other);
    ASSERT_NE(menu(panel).differences(), nullptr);
    save(panel);
    EXPECT_EQ(machineIn(file).axes[0].name, "Spindle");
    ASSERT_NE(menu(panel).differences(), nullptr) << "that file is as it was";
    click(panel, "applyDifferencesButton");
    EXPECT_FALSE(panel.window().isWindowModified());
}

TEST_F(MachineFiles, TheLastEightFilesAreRemembered) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        for (int i = 1; i <= 9; ++i)
            saveAs(panel, directory.filePath(QStringLiteral("m%1.json").arg(i)));
        saveAs(panel, directory.filePath(QStringLiteral("m5.json")));
    }
    VirtualPanel panel(settings);
    panel.start();
    QStringList names;
    for (const QString& path : menu(panel).file().recent)
        names << QFileInfo(path).completeBaseName();
    EXPECT_EQ(names.join(QLatin1Char(' ')), QStringLiteral("m5 m9 m8 m7 m6 m4 m3 m2"));
}

// ---- operator mode ----

TEST_F(MachineFiles, AFileThatAwaitsAChoiceIsDroppedByOperatorMode) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    panel.start();
    open(panel, file);
    ASSERT_NE(table(panel), nullptr);
    ASSERT_NO_FATAL_FAILURE(lock(panel));
    // A different chain would be compared with the file, if there still were one.
    panel.connectTo(sim.terminal());
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(table(panel), nullptr);
    emit menu(panel).applyRequested({{ModuleIndex(0), MachinePart::Gains}});
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(executed(sim, 1, "set_gain"), 0);
    EXPECT_EQ(panel.composition().machine(), Machine{});
}

TEST_F(MachineFiles, AFileDialogThatIsLeftOpenOpensNothingInOperatorMode) {
    VirtualPanel panel;
    panel.start();
    strike(panel, Qt::CTRL | Qt::Key_O);
    ASSERT_NO_FATAL_FAILURE(lock(panel));
    choose(panel, "openMachineDialog", file);
    EXPECT_EQ(table(panel), nullptr);
    EXPECT_EQ(panel.composition().machine(), Machine{});
}

TEST_F(MachineFiles, InOperatorModeThatOfTheCommandLineIsLoadedWholeAndSendsNothing) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        ASSERT_NO_FATAL_FAILURE(lock(panel));
    }
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel(settings);
    Start start;
    start.machine = file;
    panel.composition().show(start);
    EXPECT_EQ(table(panel), nullptr) << "there is nothing to choose for an operator";
    EXPECT_EQ(panel.composition().machine(), twoServos());
    EXPECT_TRUE(panel.window().windowTitle().endsWith(QStringLiteral(" - mill[*]")));
    panel.connectTo(sim.terminal());
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(table(panel), nullptr);
    EXPECT_EQ(executed(sim, 1, "set_gain") + executed(sim, 1, "io_control"), 0);
}

/// Otherwise the operator would jog in counts, the other way round and beyond the limits.
TEST_F(MachineFiles, OperatorModeGoesOnWithTheUnsavedMachineOfTheSessionBefore) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    AxisSettings reversed;
    reversed.unit = {UnitKind::Degrees, -100.0, ""};
    reversed.travel = {-9'000, 9'000, 0.0};
    reversed.gains = kGains;
    const ModuleIndex second(1);
    {
        VirtualPanel panel(settings);
        panel.start();
        emit panel.window().requests().axisEdited(second, reversed);
        ASSERT_NO_FATAL_FAILURE(lock(panel));
    }
    VirtualChain sim(QStringLiteral("servo,servo"));
    for (const int starts : {1, 2}) {
        VirtualPanel panel(settings);
        connectTo(panel, sim);
        EXPECT_EQ(panel.composition().machine().axis(second), reversed) << starts;
        EXPECT_EQ(panel.module(1).travel, reversed.travel);
        EXPECT_EQ(panel.count(QStringLiteral("unsaved changes")), 0) << "nothing is left to be chosen";
        EXPECT_TRUE(panel.window().isWindowModified());
        EXPECT_EQ(table(panel), nullptr);
        ASSERT_TRUE(panel.answersFor(0.3));
        EXPECT_EQ(executed(sim, 2, "set_gain"), 0);
    }
    EXPECT_EQ(sim.violations(), "");
}

/// The work that was left is that of another machine.
TEST_F(MachineFiles, OperatorModeGoesOnWithTheMachineThatItWasBegunWith) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        rename(panel, "Another");
    }
    {
        VirtualPanel panel(settings);
        panel.start();
        open(panel, file);
        click(panel, "applyDifferencesButton");
        ASSERT_NO_FATAL_FAILURE(lock(panel));
    }
    VirtualPanel panel(settings);
    panel.start();
    EXPECT_EQ(panel.composition().machine(), twoServos());
    EXPECT_EQ(panel.window().windowTitle(), QStringLiteral("NMC Panel - mill[*]"));
    EXPECT_FALSE(panel.window().isWindowModified());
    EXPECT_EQ(table(panel), nullptr);
    EXPECT_EQ(panel.count(QStringLiteral("unsaved changes")), 1) << "whoever has the PIN may restore it";
}

/// Neither machine has a file, by which they could be told apart.
TEST_F(MachineFiles, OperatorModeGoesOnWithItsOwnUnsavedWorkAndNotWithThatOfAnotherSession) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        rename(panel, "Another");
    }
    {
        VirtualPanel panel(settings);
        panel.start();
        rename(panel, "Mine");
        ASSERT_NO_FATAL_FAILURE(lock(panel));
    }
    VirtualPanel panel(settings);
    panel.start();
    EXPECT_EQ(panel.composition().machine().axis(ModuleIndex(0)).name, "Mine");
    EXPECT_EQ(panel.count(QStringLiteral("unsaved changes")), 1) << "the other is still there";
}

TEST_F(MachineFiles, OperatorModeGoesOnWithItsMachineAlthoughTheFileIsNotThere) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        open(panel, file);
        click(panel, "applyDifferencesButton");
        ASSERT_NO_FATAL_FAILURE(lock(panel));
    }
    ASSERT_TRUE(QFile::remove(file));
    VirtualPanel panel(settings);
    panel.start();
    EXPECT_EQ(panel.composition().machine(), twoServos());
}

TEST_F(MachineFiles, OperatorModeThatWasBegunWithoutAMachineOpensNone) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        open(panel, file);
        click(panel, "applyDifferencesButton");
    }
    {
        VirtualPanel panel(settings);
        panel.start();
        ASSERT_NO_FATAL_FAILURE(lock(panel));
    }
    VirtualPanel panel(settings);
    panel.start();
    EXPECT_EQ(panel.composition().machine(), Machine{});
}

// ---- unsaved work ----

TEST_F(MachineFiles, UnsavedWorkIsOfferedAtTheNextStartAndRestored) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        open(panel, file);
        click(panel, "applyDifferencesButton");
        rename(panel, "Unsaved");
    }
    EXPECT_EQ(machineIn(file), twoServos()) << "only the user saves the file";
    {
        VirtualPanel panel(settings);
        panel.start();
        EXPECT_EQ(panel.headlines().first(),
                  QStringLiteral("An earlier session left unsaved changes to \"mill\"."));
        EXPECT_EQ(panel.window().windowTitle(), QStringLiteral("NMC Panel"))
            << "nothing is restored before the user requests it";
        ASSERT_TRUE(panel.press(QStringLiteral("unsaved changes"), QStringLiteral("Restore")));
        EXPECT_EQ(panel.window().windowTitle(), QStringLiteral("NMC Panel - mill[*]"));
        EXPECT_TRUE(panel.window().isWindowModified());
        EXPECT_EQ(texts::moduleName(ModuleIndex(0)), QStringLiteral("Module 1 \"Unsaved\""));
        save(panel);
        EXPECT_EQ(machineIn(file).axes[0].name, "Unsaved");
        EXPECT_EQ(machineIn(file).axes[1], twoServos().axes[1]);
    }
    VirtualPanel panel(settings);
    panel.start();
    EXPECT_EQ(panel.count(QStringLiteral("unsaved changes")), 0) << "it has been saved";
}

TEST_F(MachineFiles, RestoredWorkDoesNotReplaceWhatSomeoneElseHasChangedMeanwhile) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        open(panel, file);
        click(panel, "applyDifferencesButton");
        rename(panel, "Unsaved");
    }
    Machine changed = twoServos();
    changed.axes[1].name = "Changed elsewhere";
    const std::string theirs = writeMachine(changed);
    write("mill.json", theirs);
    VirtualPanel panel(settings);
    panel.start();
    ASSERT_TRUE(panel.press(QStringLiteral("unsaved changes"), QStringLiteral("Restore")));
    save(panel);
    EXPECT_EQ(readFile(file, kMaxMachineFile).value(), theirs);
    EXPECT_NE(panel.standing(QStringLiteral("Could not save \"mill.json\".")), nullptr);
    EXPECT_TRUE(panel.window().isWindowModified());
}

TEST_F(MachineFiles, UnsavedWorkThatIsDiscardedIsGone) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    for (const int starts : {1, 2}) {
        VirtualPanel panel(settings);
        panel.start();
        EXPECT_EQ(panel.count(QStringLiteral("unsaved changes")), starts - 1);
        if (starts == 1)
            rename(panel, "Z");
        else
            EXPECT_TRUE(panel.press(QStringLiteral("unsaved changes"), QStringLiteral("Discard")));
    }
    VirtualPanel panel(settings);
    panel.start();
    EXPECT_EQ(panel.count(QStringLiteral("unsaved changes")), 0);
}

TEST_F(MachineFiles, UnsavedWorkIsKeptAFewSecondsAfterTheChange) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    VirtualPanel panel(settings);
    panel.start();
    rename(panel, "Z");
    // The file is what a killed program would leave behind.
    const QString kept = directory.filePath(QStringLiteral("unsaved/unsaved-1"));
    EXPECT_FALSE(QFile::exists(kept));
    ASSERT_TRUE(panel.waitFor([&] { return QFile::exists(kept); }));
    EXPECT_THAT(readFile(kept, kMaxMachineFile).value(), testing::HasSubstr("\"name\": \"Z\""));
    saveAs(panel, file);
    EXPECT_TRUE(panel.waitFor([&] { return !QFile::exists(kept); })) << "nothing is unsaved any more";
}

TEST_F(MachineFiles, RestoringToAChainThatIsConnectedShowsTheTableAndSendsNothing) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        open(panel, file);
        click(panel, "applyDifferencesButton");
        rename(panel, "Unsaved");
    }
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel(settings);
    connectTo(panel, sim);
    const std::string before = told(sim);
    const MessageRow* offer = panel.standing(QStringLiteral("unsaved changes"));
    ASSERT_NE(offer, nullptr);
    EXPECT_TRUE(offer->message().body.contains(QStringLiteral("Nothing is sent before you choose Apply.")))
        << offer->message().body.toStdString();
    ASSERT_TRUE(panel.press(QStringLiteral("unsaved changes"), QStringLiteral("Restore")));
    ASSERT_NE(table(panel), nullptr);
    tickOnly(panel, {QStringLiteral("Module 1: Name")});
    click(panel, "applyDifferencesButton");
    ASSERT_TRUE(panel.answersFor(0.2));
    EXPECT_EQ(told(sim), before);
    EXPECT_EQ(texts::moduleName(ModuleIndex(0)), QStringLiteral("Module 1 \"Unsaved\""));
}

TEST_F(MachineFiles, UnsavedWorkForOtherHardwareIsOfferedAgainAtTheNextStart) {
    const QString settings = directory.filePath(QStringLiteral("panel.ini"));
    {
        VirtualPanel panel(settings);
        panel.start();
        open(panel, file);
        click(panel, "applyDifferencesButton");
        rename(panel, "Unsaved");
    }
    {
        VirtualChain sim(QStringLiteral("servo,servo@3"));
        VirtualPanel panel(settings);
        connectTo(panel, sim);
        ASSERT_TRUE(panel.press(QStringLiteral("unsaved changes"), QStringLiteral("Restore")));
        ASSERT_NE(table(panel), nullptr);
        tickOnly(panel, {QStringLiteral("Module 1: Name")});
        click(panel, "applyDifferencesButton");
        EXPECT_EQ(panel.composition().machine().axis(ModuleIndex(0)).name, "Unsaved");
        ASSERT_TRUE(panel.answersFor(0.2));
    }
    VirtualPanel panel(settings);
    panel.start();
    ASSERT_TRUE(panel.press(QStringLiteral("unsaved changes to \"mill\""), QStringLiteral("Restore")));
    EXPECT_EQ(panel.composition().machine().axis(ModuleIndex(1)), twoServos().axes[1])
        << "the other module took nothing of it";
}

TEST_F(MachineFiles, TheTableFollowsTheChainThatIsConnected) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    panel.start();
    open(panel, file);
    const auto gains = [&] { return table(panel)->topLevelItem(3)->text(3); };
    ASSERT_EQ(table(panel)->topLevelItem(3)->text(0), QStringLiteral("Module 1: Gains"));
    EXPECT_EQ(gains(), QStringLiteral("Filled in, not sent."));
    panel.connectTo(sim.terminal());
    EXPECT_TRUE(panel.waitFor([&] { return gains() == QStringLiteral("Sent to the module."); }));
    EXPECT_EQ(executed(sim, 1, "set_gain"), 0);
}

// ---- another type of module ----

/// Its go-to speed in steps/s would be 3.9 million counts/s.
TEST_F(MachineFiles, NumbersForAStepperAreKeptFromAServoUntilTheUserAcceptsIt) {
    Machine machine;
    machine.name = "Mill";
    AxisSettings& axis = machine.axes.emplace_back();
    axis.name = "Table";
    axis.expected = ModuleIdentity{ModuleType::Stepper, 1};
    axis.motion.velocity = 2'000;
    axis.motion.holdCap = 1'000;
    axis.travel = {-5'000, 40'000, 3'000};
    machine.program.points = {{"Pick", {{ModuleIndex(0), 30'000, false}}}};
    const QString path = write("table.json", writeMachine(machine));
    const QString replaced = QStringLiteral("is not the expected module");
    VirtualChain servo(QStringLiteral("servo"));
    VirtualChain stepper(QStringLiteral("step"));
    VirtualPanel panel;
    const BusStore& store = panel.composition().store();
    panel.start();
    open(panel, path);
    click(panel, "applyDifferencesButton");
    const auto attach = [&panel](const VirtualChain& sim) {
        panel.connectTo(sim.terminal());
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
        ASSERT_TRUE(panel.answersFor(0.3));
    };

    ASSERT_NO_FATAL_FAILURE(attach(servo));
    EXPECT_NE(panel.standing(replaced), nullptr);
    EXPECT_EQ(store.machine().axis(ModuleIndex(0)).motion, MotionSettings{});
    const std::string before = told(servo);
    panel.ask(intent::ApplyGains{kGains});
    panel.ask(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(2'000U << 16U), CountsPerTickSquared(131), false}});
    emit panel.window().requests().goToPoint("Pick");
    ASSERT_TRUE(panel.answersFor(0.3));
    EXPECT_EQ(told(servo), before) << "nothing is sent";
    panel.type("velocityField", QStringLiteral("0.25"));
    EXPECT_EQ(panel.composition().machine().axes, machine.axes) << "nor is anything stored";

    ASSERT_NO_FATAL_FAILURE(attach(stepper));
    EXPECT_EQ(panel.standing(replaced), nullptr);
    EXPECT_EQ(store.machine().axis(ModuleIndex(0)), machine.axes[0]);
    EXPECT_EQ(panel.module().travel, machine.axes[0].travel);

    ASSERT_NO_FATAL_FAILURE(attach(servo));
    EXPECT_NE(panel.standing(replaced), nullptr);
    emit panel.window().requests().acceptChain();
    EXPECT_EQ(panel.standing(replaced), nullptr);
    AxisSettings anew;
    anew.name = "Table";
    anew.expected = ModuleIdentity{ModuleType::Servo, 4};
    EXPECT_EQ(panel.composition().machine().axes, std::vector{anew});
    EXPECT_TRUE(panel.composition().machine().program.points.at(0).axes.empty());
    EXPECT_EQ(machineIn(path), machine) << "until it is saved";
    panel.ask(intent::ApplyGains{kGains});
    EXPECT_TRUE(panel.waitFor([&] { return panel.module().gains.has_value(); }));
    save(panel);
    EXPECT_EQ(machineIn(path).axes[0].motion, MotionSettings{});
    EXPECT_EQ(machineIn(path).axes[0].expected, anew.expected);
    EXPECT_EQ(servo.violations() + stepper.violations(), "");
}

TEST_F(MachineFiles, ANewModuleThatTheUserSetsUpIsExpectedFromThenOn) {
    VirtualChain one(QStringLiteral("servo"));
    VirtualChain stepper(QStringLiteral("servo,step"));
    VirtualChain servos(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    panel.start();
    const ModuleIndex second(1);
    const auto attach = [&panel](const VirtualChain& sim) {
        panel.connectTo(sim.terminal());
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
        ASSERT_TRUE(panel.answersFor(0.3));
    };
    ASSERT_NO_FATAL_FAILURE(attach(one));
    rename(panel, "X");
    ASSERT_EQ(panel.composition().machine().axes.at(0).expected, (ModuleIdentity{ModuleType::Servo, 4}));

    ASSERT_NO_FATAL_FAILURE(attach(stepper));
    AxisSettings table;
    table.name = "Table";
    table.motion.velocity = 2'000;
    emit panel.window().requests().axisEdited(second, table);
    table.expected = ModuleIdentity{ModuleType::Stepper, 1};
    ASSERT_EQ(panel.composition().machine().axis(second), table);

    ASSERT_NO_FATAL_FAILURE(attach(servos));
    EXPECT_NE(panel.standing(QStringLiteral("is not the expected module")), nullptr);
    EXPECT_EQ(panel.composition().store().machine().axis(second).motion, MotionSettings{});
    EXPECT_TRUE(panel.module(1).otherType());
    const QString path = directory.filePath(QStringLiteral("table.json"));
    saveAs(panel, path);
    EXPECT_EQ(machineIn(path).axes.at(1), table);
    EXPECT_EQ(one.violations() + stepper.violations() + servos.violations(), "");
}

/// This port has never had the stepper, so the chain found does not even have a place for it.
TEST_F(MachineFiles, AModuleThatIsMissingIsForgottenAtAPortWithoutMemoryAsWell) {
    Machine machine;
    machine.axes.resize(2);
    machine.axes[0].expected = ModuleIdentity{ModuleType::Servo, 4};
    machine.axes[1].expected = ModuleIdentity{ModuleType::Stepper, 1};
    machine.axes[1].motion.velocity = 2'000;
    const ModuleIndex first(0);
    const ModuleIndex second(1);
    machine.program.points = {{"Pick", {{first, 100, false}, {second, 30'000, false}}}};
    machine.program.sequences = {{"Main", {action::MoveTo{"Pick"}, action::Home{second}}}};
    const QString path = write("table.json", writeMachine(machine));
    VirtualChain one(QStringLiteral("servo"));
    VirtualChain servos(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    panel.start();
    open(panel, path);
    click(panel, "applyDifferencesButton");
    panel.connectTo(one.terminal());
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));

    emit panel.window().requests().acceptChain();
    const QString used = QStringLiteral("Row 2 of \"Main\" uses module 2, so the chain was not changed.");
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(used) != nullptr; }));
    EXPECT_EQ(panel.composition().machine().axes, machine.axes);

    Program program = machine.program;
    program.sequences[0].rows.pop_back();
    emit panel.window().requests().programEdited(program);
    emit panel.window().requests().acceptChain();
    EXPECT_EQ(panel.composition().machine().axes, std::vector{machine.axes[0]});
    EXPECT_EQ(panel.composition().machine().program.points.at(0).axes,
              (std::vector<PointAxis>{{first, 100, false}}));
    EXPECT_TRUE(panel.connected());

    panel.connectTo(servos.terminal());
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected() && panel.module(1).latest.has_value(); }));
    EXPECT_EQ(panel.composition().store().machine().axis(second).motion, MotionSettings{});
    EXPECT_EQ(one.violations() + servos.violations(), "");
}

/// The first edit of any axis has made the whole chain the expected one.
TEST_F(MachineFiles, AnAxisThatIsNotSetUpIsSetUpForWhateverModuleIsThere) {
    Machine machine;
    machine.axes.resize(1);
    machine.axes[0].name = "Table";
    machine.axes[0].expected = ModuleIdentity{ModuleType::Stepper, 1};
    const QString path = write("table.json", writeMachine(machine));
    VirtualChain sim(QStringLiteral("servo"));
    VirtualPanel panel;
    panel.start();
    open(panel, path);
    click(panel, "applyDifferencesButton");
    panel.connectTo(sim.terminal());
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    EXPECT_TRUE(panel.module().replaced());
    panel.ask(intent::ApplyGains{kGains});
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains.has_value(); }));
    const AxisSettings& axis = panel.composition().machine().axes.at(0);
    EXPECT_EQ(axis.gains, kGains);
    EXPECT_EQ(axis.expected, (ModuleIdentity{ModuleType::Servo, 4}));
    EXPECT_EQ(sim.violations(), "");
}

/// "IO4 on" would be OUT4 of the stepper.
TEST_F(MachineFiles, AModuleOfAnotherTypeIsNotAcceptedWhileARowUsesIt) {
    Machine machine;
    machine.axes.emplace_back().expected = ModuleIdentity{ModuleType::Io, 1};
    machine.program.sequences = {{"Main", {action::Wait{1}, action::SetOutput{ModuleIndex(0), 4}}}};
    const QString path = write("lamp.json", writeMachine(machine));
    VirtualChain sim(QStringLiteral("step"));
    VirtualPanel panel;
    panel.start();
    open(panel, path);
    click(panel, "applyDifferencesButton");
    panel.connectTo(sim.terminal());
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().latest.has_value(); }));
    EXPECT_TRUE(panel.module().otherType());
    emit panel.window().requests().acceptChain();
    const QString used = QStringLiteral("Row 2 of \"Main\" uses module 1, so the chain was not changed.");
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(used) != nullptr; }));
    EXPECT_EQ(panel.composition().machine().axes, machine.axes);

    Program program = machine.program;
    program.sequences[0].rows.pop_back();
    emit panel.window().requests().programEdited(program);
    emit panel.window().requests().acceptChain();
    EXPECT_EQ(panel.composition().machine().axes.at(0).expected, (ModuleIdentity{ModuleType::Stepper, 1}));
    EXPECT_EQ(sim.violations(), "");
}

}  // namespace
}  // namespace nmc
