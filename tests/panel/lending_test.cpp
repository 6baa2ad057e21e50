// SPDX-License-Identifier: GPL-3.0-or-later
// The line lent to a program, in the whole window: what the program does is shown, and the panel does nothing
// but stop (docs/lending.md). The program is at a real terminal.
#include <numeric>

#include "link/api/apiserver.h"
#include "tests/support/otherprogram.h"
#include "tests/support/port.h"
#include "tests/support/virtualpanel.h"
#include "widgets/messages/messagemodel.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::moves;
using testing_support::OtherProgram;
using testing_support::Port;
using testing_support::RuntimeFolder;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;
using Bytes = std::vector<std::uint8_t>;

class Lending : public testing::Test {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal())); }
    /// As a user does it.
    void lend() {
        panel.window().findChild<QAction*>(u"lendLineAction"_s)->trigger();
        auto* field = panel.window().findChild<QLineEdit*>(u"lendPathField"_s);
        ASSERT_NE(field, nullptr);
        field->setText(path);
        ASSERT_NO_FATAL_FAILURE(panel.click("lendButton"));
        ASSERT_TRUE(panel.waitFor([&] { return lent().has_value(); }));
    }
    [[nodiscard]] const std::optional<LentLine>& lent() { return panel.composition().store().link().lent; }
    [[nodiscard]] QString ribbon() {
        auto* text = panel.window().findChild<QLabel*>(u"lentRibbonText"_s);
        return text->isVisible() ? text->text() : QString();
    }
    /// The program sends a command, and waits for the whole answer.
    Bytes ask(Port& port, std::uint8_t address, std::uint8_t command, const Bytes& data, std::size_t length) {
        Bytes bytes{0xAA, address, command};
        bytes.insert(bytes.end(), data.begin(), data.end());
        bytes.push_back(static_cast<std::uint8_t>(std::accumulate(bytes.begin() + 1, bytes.end(), 0U)));
        port.write(bytes);
        Bytes answer;
        EXPECT_TRUE(panel.waitFor([&] {
            const Bytes more = port.read(length, 0);
            answer.insert(answer.end(), more.begin(), more.end());
            return answer.size() >= length;
        }));
        return answer;
    }
    /// The program runs the first motor at 1 count per tick.
    void run(Port& port) {
        // Kp 200, Kd 2000, Ki 20, IL 200, OL 255, CL 0, EL 4000, SR 1, DB 0.
        ask(port, 1, 0xE6, {200, 0, 0xD0, 0x07, 20, 0, 200, 0, 255, 0, 0xA0, 0x0F, 1, 0}, 10);
        ask(port, 1, 0x17, {0x05}, 10);
        ask(port, 1, 0x94, {0xB6, 0, 0, 1, 0, 0x99, 0x19, 0, 0}, 10);
        for (int i = 0; i < 20; ++i)
            last = ask(port, 1, 0x0E, {}, 10);
        ASSERT_TRUE(moves(sim));
    }

    Bytes last;  ///< the last answer to run()
    QTemporaryDir folder;
    const QString path = folder.filePath(u"line"_s);
    VirtualChain sim{u"servo,servo"_s};
    VirtualPanel panel;
};

TEST_F(Lending, TheWindowShowsWhatTheProgramDoes) {
    ASSERT_NO_FATAL_FAILURE(lend());
    EXPECT_TRUE(ribbon().contains(path) && ribbon().contains(u"no program yet"_s)) << ribbon().toStdString();
    const std::uint64_t before = panel.composition().store().history().module(ModuleIndex(0))->count();
    Port port(path.toStdString());
    ASSERT_NO_FATAL_FAILURE(run(port));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().moving(); }));
    EXPECT_EQ(panel.module().gains->kp, 200);
    EXPECT_NEAR(*panel.module().latest->velocity, 1, 1);
    EXPECT_TRUE(panel.waitFor([&] { return panel.module().latest->position == (last[1] | last[2] << 8); }))
        << "of the last reply to the program";
    EXPECT_GE(panel.composition().store().history().module(ModuleIndex(0))->count(), before + 20)
        << "the scope's data";
    EXPECT_TRUE(ribbon().contains(u"a program has the line"_s)) << ribbon().toStdString();
    EXPECT_EQ(panel.count(u"A program has the line"_s), 1);
}

TEST_F(Lending, ControlsAreDisabledAndSayWhy) {
    ASSERT_NO_FATAL_FAILURE(lend());
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().lent; }));
    auto* enable = panel.window().findChild<QAbstractButton*>(u"enableButton"_s);
    ASSERT_TRUE(panel.waitFor([&] { return !enable->isEnabled(); }));
    EXPECT_EQ(enable->toolTip(), u"The line is lent to a program."_s);
    EXPECT_FALSE(panel.window().findChild<QAction*>(u"restartNetworkAction"_s)->isEnabled());
    EXPECT_FALSE(panel.window().findChild<QAction*>(u"scanAction"_s)->isEnabled());
    (void)sim.takePackets();
    panel.freeze(std::chrono::seconds(2));
    EXPECT_TRUE(sim.takePackets().empty()) << "the panel sends nothing";
}

/// The chain's dialog was open before.
TEST_F(Lending, NoButtonOfTheChainSendsAnything) {
    for (const char* page : {"rateAction", "groupsAction", "chainDoctorAction"})
        panel.window().findChild<QAction*>(QLatin1String(page))->trigger();
    ASSERT_NO_FATAL_FAILURE(lend());
    auto* pages = panel.window().findChild<QTabWidget*>(u"chainPages"_s);
    ASSERT_TRUE(pages->isVisible());
    (void)sim.takePackets();
    int clicked = 0;
    for (int page = 0; page < pages->count(); ++page) {
        pages->setCurrentIndex(page);
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().lent; }));
        for (QAbstractButton* button : pages->currentWidget()->findChildren<QAbstractButton*>())
            if (button->isVisible() && button->isEnabled()) {
                QTest::mouseClick(button, Qt::LeftButton);
                ++clicked;
            }
        panel.freeze(std::chrono::seconds(1));
        QCoreApplication::processEvents();
    }
    EXPECT_GT(clicked, 0);
    EXPECT_TRUE(sim.takePackets().empty());
    EXPECT_TRUE(lent());
}

TEST_F(Lending, EscapeStopsTheMotorsAndHoldsTheProgramOff) {
    ASSERT_NO_FATAL_FAILURE(lend());
    Port port(path.toStdString());
    ASSERT_NO_FATAL_FAILURE(run(port));
    QTest::keyClick(&panel.window(), Qt::Key_Escape);
    ASSERT_TRUE(panel.waitFor([&] { return lent()->heldOff && !moves(sim); }));
    ASSERT_TRUE(panel.waitFor([&] { return ribbon().contains(u"held off"_s); }));
    auto* release = panel.window().findChild<QAbstractButton*>(u"letProgramThroughButton"_s);
    ASSERT_TRUE(panel.waitFor([&] { return release->isVisible() && !panel.module().moving(); }));
    ASSERT_NO_FATAL_FAILURE(panel.click("letProgramThroughButton"));
    ASSERT_TRUE(panel.waitFor([&] { return !lent()->heldOff; }));
    port.flush();
    EXPECT_EQ(ask(port, 1, 0x13, {0x20}, 4).size(), 4U);
}

/// Nothing else happens on the line after the stop, neither from the program nor from the user.
TEST_F(Lending, AProgramReleasedDuringTheStopIsLetThroughAfterIt) {
    ASSERT_NO_FATAL_FAILURE(lend());
    Port port(path.toStdString());
    ASSERT_NO_FATAL_FAILURE(run(port));
    QTest::keyClick(&panel.window(), Qt::Key_Escape);
    for (int i = 0; i < 100 && !lent()->heldOff; ++i) {
        panel.freeze(std::chrono::microseconds(200));
        QCoreApplication::processEvents();
    }
    ASSERT_TRUE(lent()->heldOff) << "the stop has not begun";
    emit panel.window().requests().letProgramThrough();
    EXPECT_TRUE(panel.waitFor([&] { return !lent()->heldOff; }));
    EXPECT_FALSE(moves(sim));
}

TEST_F(Lending, TheProgramEndsItAndThePanelGoesOn) {
    ASSERT_NO_FATAL_FAILURE(lend());
    {
        Port port(path.toStdString());
        ask(port, 1, 0x13, {0x20}, 4);
    }
    ASSERT_TRUE(panel.waitFor([&] { return !lent() && panel.chainsFound() == 2 && panel.connected(); }));
    EXPECT_FALSE(QFileInfo(path).isSymLink());
    EXPECT_TRUE(ribbon().isEmpty());
    ASSERT_NO_FATAL_FAILURE(panel.makeReady());
}

TEST_F(Lending, WhatTheProgramMovesIsNotStoppedBecauseOfAnotherOneThatMovedItBefore) {
    const RuntimeFolder runtime;
    auto* letIn = panel.window().findChild<QAction*>(u"letProgramsInAction"_s);
    letIn->trigger();
    ASSERT_NO_FATAL_FAILURE(panel.enable());
    OtherProgram client(panel, ApiServer::pathFor(sim.terminal()));
    client.hello();
    const int asked = client.request("request_control");
    const auto grant = u"grantControlButton"_s;
    ASSERT_TRUE(panel.waitFor([&] { return panel.window().findChild<QAbstractButton*>(grant) != nullptr; }));
    QTest::mouseClick(panel.window().findChild<QAbstractButton*>(grant), Qt::LeftButton);
    ASSERT_EQ(client.answer(asked)["result"]["granted"], true);
    ASSERT_EQ(client.call("move", {{"axis", 1}, {"to", 500}})["result"]["accepted"], true);
    ASSERT_TRUE(client.call("wait", {{"axis", 1}}).contains("result"));
    ASSERT_NO_FATAL_FAILURE(lend());
    {
        Port port(path.toStdString());
        ASSERT_NO_FATAL_FAILURE(run(port));
    }
    ASSERT_TRUE(panel.waitFor([&] { return !lent() && panel.chainsFound() == 2 && panel.connected(); }));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().moving(); }));
    client.vanish();
    EXPECT_TRUE(panel.answersFor(1));
    EXPECT_TRUE(moves(sim));
    letIn->trigger();
}

TEST_F(Lending, AMachineThatIsNumberedAnewIsShownAsItReportsItself) {
    const RuntimeFolder runtime;
    ASSERT_NO_FATAL_FAILURE(lend());
    Port port(path.toStdString());
    port.setRate(B19200);
    const Bytes reset{0xAA, 0xFF, 0x0F, 0x0E};
    port.write(reset);
    // At its own rate nobody hears this one: the chain is at 115 200 Bd.
    port.setRate(B115200);
    port.write(reset);
    ASSERT_TRUE(panel.waitFor([&] { return panel.composition().store().link().modules.empty(); }));
    port.setRate(B19200);
    for (int i = 0; i < 10; ++i)
        panel.freeze(std::chrono::milliseconds(10));
    ask(port, 0, 0x21, {1, 0xFF}, 2);
    ask(port, 0, 0x21, {2, 0xFF}, 2);
    ASSERT_TRUE(panel.waitFor([&] { return panel.composition().store().link().modules.size() == 2; }));
    EXPECT_EQ(panel.module().info.identity, kUnheardModule);
    auto* letIn = panel.window().findChild<QAction*>(u"letProgramsInAction"_s);
    letIn->trigger();
    {
        OtherProgram client(panel, ApiServer::pathFor(sim.terminal()));
        client.hello();
        EXPECT_TRUE(client.call("wait").contains("result")) << "it cannot be known whether these move";
    }
    letIn->trigger();
    ask(port, 1, 0x13, {0x20}, 4);
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().isServo(); }));
    EXPECT_EQ(panel.composition().store().link().baud, 19'200U);
}

TEST_F(Lending, APathIsNeeded) {
    panel.window().findChild<QAction*>(u"lendLineAction"_s)->trigger();
    panel.window().findChild<QLineEdit*>(u"lendPathField"_s)->clear();
    auto* button = panel.window().findChild<QAbstractButton*>(u"lendButton"_s);
    EXPECT_TRUE(panel.waitFor([&] { return button->toolTip() == u"Enter a path."_s; }));
    EXPECT_FALSE(button->isEnabled());
    panel.window().findChild<QLineEdit*>(u"lendPathField"_s)->setText(path);
    EXPECT_TRUE(button->isEnabled());
}

class LendingBelowHome : public Lending, public testing::WithParamInterface<const char*> {
protected:
    LendingBelowHome() { qputenv("HOME", folder.path().toUtf8()); }
    ~LendingBelowHome() override { qputenv("HOME", m_before); }

private:
    const QByteArray m_before = qgetenv("HOME");
};

/// As in the manual, and wherever the panel was started.
TEST_P(LendingBelowHome, IsWhereTheUserFindsIt) {
    emit panel.window().requests().lend(QLatin1String(GetParam()));
    ASSERT_TRUE(panel.waitFor([&] { return lent().has_value(); }));
    EXPECT_EQ(lent()->path, path.toStdString());
    EXPECT_TRUE(QFileInfo(path).isSymLink());
}
INSTANTIATE_TEST_SUITE_P(Paths, LendingBelowHome, testing::Values("~/line", "line"));

TEST_F(Lending, APathThatIsTakenIsNotTouched) {
    QFile mine(path);
    ASSERT_TRUE(mine.open(QIODevice::WriteOnly) && mine.write("mine") == 4);
    mine.close();
    panel.window().findChild<QAction*>(u"lendLineAction"_s)->trigger();
    panel.window().findChild<QLineEdit*>(u"lendPathField"_s)->setText(path);
    ASSERT_NO_FATAL_FAILURE(panel.click("lendButton"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(u"The line was not lent."_s) == 1; }));
    EXPECT_EQ(mine.size(), 4);
    EXPECT_FALSE(lent());
}

}  // namespace
}  // namespace nmc
