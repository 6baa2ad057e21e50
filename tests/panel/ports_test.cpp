// SPDX-License-Identifier: GPL-3.0-or-later
// Adapters that go and come back, and slow ones, in the whole window; and the messages about ports.
#include <optional>

#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using testing_support::moves;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

/// A machine whose ports the test defines.
class PortsMachine {
public:
    PortController::Places places() {
        PortController::Places places;
        places.list = [this] { return m_ports; };
        places.devices = m_directory.path();
        places.sysfs = m_directory.filePath(QStringLiteral("sys"));
        return places;
    }
    [[nodiscard]] QString port(const char* name) const { return m_directory.filePath(QLatin1String(name)); }
    /// Sets the list from now on, and changes something in the folder of devices.
    void set(const QList<PortEntry>& ports) {
        m_ports = ports;
        QFile file(m_directory.filePath(QStringLiteral("change%1").arg(++m_changes)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    }
    void setLatency(const QString& port, const char* ms) {
        const QString folder =
            m_directory.filePath(QStringLiteral("sys/bus/usb-serial/devices/") + QFileInfo(port).fileName());
        ASSERT_TRUE(QDir().mkpath(folder));
        QFile file(folder + QStringLiteral("/latency_timer"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(ms);
    }

private:
    QTemporaryDir m_directory;
    QList<PortEntry> m_ports;
    int m_changes = 0;
};

PortEntry adapter(const QString& name, const char* serial) {
    return {name, QStringLiteral("USB Serial"), QLatin1String(serial), 0x0403, 0x6001};
}

const QString kBack = QStringLiteral("The adapter is back as ");
const QString kDifferent = QStringLiteral("A different adapter is on ");

TEST(F29_BackUnderAnotherName, IsOfferedAndConnectsOnlyWhenAsked) {
    PortsMachine machine;
    const QString one = machine.port("ttyUSB0");
    const QString two = machine.port("ttyUSB1");
    machine.set({adapter(one, "A1")});
    VirtualChain before(QStringLiteral("servo"), one);
    VirtualChain sim(QStringLiteral("servo"), two);
    VirtualPanel panel({}, machine.places());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(one));
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(before));
    machine.set({adapter(two, "A1")});
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(kBack) == 1; }));
    EXPECT_TRUE(panel.headlines().first().contains(two));
    EXPECT_EQ(panel.composition().store().link().phase, LinkPhase::Disconnected);
    EXPECT_TRUE(sim.takePackets().empty());

    ASSERT_TRUE(panel.press(kBack, QStringLiteral("Reconnect")));
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    EXPECT_EQ(panel.composition().store().link().port, two.toStdString());
}

/// Otherwise, Reconnect would open whatever is plugged in there next.
TEST(F29_BackUnderAnotherName, IsNoLongerOfferedWhenItHasGoneAgain) {
    PortsMachine machine;
    const QString one = machine.port("ttyUSB0");
    const QString two = machine.port("ttyUSB1");
    machine.set({adapter(one, "A1")});
    VirtualChain sim(QStringLiteral("servo"), one);
    VirtualPanel panel({}, machine.places());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(one));
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    machine.set({adapter(two, "A1")});
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(kBack) != nullptr; }));
    machine.set({adapter(two, "B2")});
    EXPECT_TRUE(panel.waitFor([&] { return panel.standing(kBack) == nullptr; }));
}

/// Whichever way it is connected: the message's button, or the new name in the port's box.
class StopOfAnAdapterThatIsBack : public testing::TestWithParam<bool> {};

TEST_P(StopOfAnAdapterThatIsBack, UnderAnotherNameIsSent) {
    const bool typed = GetParam();
    PortsMachine machine;
    const QString one = machine.port("ttyUSB0");
    const QString two = machine.port("ttyUSB1");
    machine.set({adapter(one, "A1")});
    VirtualChain sim(QStringLiteral("servo"), one);
    VirtualPanel panel({}, machine.places());
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    panel.pressEsc();
    sim.plugIn();
    sim.rename(two);
    machine.set({adapter(two, "A1")});
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(kBack) == 1; }));
    ASSERT_TRUE(moves(sim));
    if (typed)
        panel.askFor(two);
    else
        ASSERT_TRUE(panel.press(kBack, QStringLiteral("Reconnect")));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
    EXPECT_EQ(panel.composition().store().link().port, two.toStdString());
}
INSTANTIATE_TEST_SUITE_P(F29, StopOfAnAdapterThatIsBack, testing::Bool(),
                         [](const auto& typed) { return typed.param ? "Typed" : "Offered"; });

TEST(F29_BackUnderAnotherName, GetsItsStopAlsoAfterARetryThatFailed) {
    PortsMachine machine;
    const QString one = machine.port("ttyUSB0");
    const QString two = machine.port("ttyUSB1");
    machine.set({adapter(one, "A1")});
    VirtualChain sim(QStringLiteral("servo"), one);
    VirtualPanel panel({}, machine.places());
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    panel.pressEsc();
    ASSERT_TRUE(panel.press(QStringLiteral("was unplugged"), QStringLiteral("Retry")));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }));
    sim.plugIn();
    sim.rename(two);
    machine.set({adapter(two, "A1")});
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(kBack) == 1; }));
    ASSERT_TRUE(moves(sim));
    ASSERT_TRUE(panel.press(kBack, QStringLiteral("Reconnect")));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

TEST(F30_OldName, WithAnotherAdapterIsSaidAlsoAfterARetryThatFailed) {
    PortsMachine machine;
    const QString port = machine.port("ttyUSB0");
    machine.set({adapter(port, "A1")});
    VirtualChain sim(QStringLiteral("servo"), port);
    VirtualPanel panel({}, machine.places());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(port));
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    ASSERT_TRUE(panel.press(QStringLiteral("was unplugged"), QStringLiteral("Retry")));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.composition().worker().isOpen(); }));
    machine.set({adapter(port, "B2")});
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(kDifferent) == 1; }));
}

/// Another adapter took the place of a broken one after a stop that was not confirmed.
TEST(F30_OldName, WithAnotherAdapterGetsTheStopThatWasNotConfirmed) {
    PortsMachine machine;
    const QString port = machine.port("ttyUSB0");
    machine.set({adapter(port, "A1")});
    VirtualChain sim(QStringLiteral("servo"), port);
    VirtualPanel panel({}, machine.places());
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    sim.tell("fault bus drop cmd");
    panel.pressEsc();
    panel.freeze(std::chrono::milliseconds(20));
    ASSERT_TRUE(moves(sim));
    sim.tell("fault clear");
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    sim.plugIn();
    machine.set({adapter(port, "B2")});
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(kDifferent) == 1; }));
    ASSERT_TRUE(panel.press(kDifferent, QStringLiteral("Connect anyway")));
    EXPECT_TRUE(panel.waitFor([&] { return !moves(sim); }));
}

TEST(F29_BackUnderAnotherName, IsOnlyLookedAtWhereItWasOnlyLookedAt) {
    PortsMachine machine;
    const QString one = machine.port("ttyUSB0");
    const QString two = machine.port("ttyUSB1");
    machine.set({adapter(one, "A1")});
    VirtualChain before(QStringLiteral("servo"), one);
    VirtualChain sim(QStringLiteral("servo"), two);
    VirtualPanel panel({}, machine.places());
    panel.start();
    const LinkState& link = panel.composition().store().link();
    emit panel.window().connectRequested(one, 115'200, true);
    // It does not matter here whether the chain has modules with addresses.
    ASSERT_TRUE(
        panel.waitFor([&] { return link.phase == LinkPhase::Connected || link.phase == LinkPhase::Lost; }));
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(before));
    machine.set({adapter(two, "A1")});
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(kBack) != nullptr; }));
    ASSERT_TRUE(panel.press(kBack, QStringLiteral("Reconnect")));
    EXPECT_TRUE(panel.waitFor([&] { return link.phase != LinkPhase::Disconnected && link.readOnly; }));
    EXPECT_EQ(link.port, two.toStdString());
}

TEST(F30_OldName, WithAnotherAdapterIsSaidAndConnectedOnlyWhenConfirmed) {
    PortsMachine machine;
    const QString port = machine.port("ttyUSB0");
    machine.set({adapter(port, "A1")});
    std::optional<VirtualChain> sim;
    VirtualPanel panel({}, machine.places());
    panel.start();
    sim.emplace(QStringLiteral("servo"), port);
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(port));
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(*sim));
    sim.emplace(QStringLiteral("servo"), port);
    machine.set({adapter(port, "B2")});
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(kDifferent) == 1; }));
    panel.askFor(port);
    EXPECT_EQ(panel.count(kDifferent), 2) << "a second request is reported again";
    EXPECT_EQ(panel.composition().store().link().phase, LinkPhase::Disconnected);

    ASSERT_TRUE(panel.press(kDifferent, QStringLiteral("Connect anyway")));
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    EXPECT_EQ(panel.count(kBack), 0);
}

/// The messages about a bad link stay when the adapter that made it is exchanged.
TEST(F30_OldName, WithAnotherAdapterIsSaidWhicheverMessageReconnects) {
    PortsMachine machine;
    const QString port = machine.port("ttyUSB0");
    machine.set({adapter(port, "A1")});
    VirtualChain sim(QStringLiteral("servo"), port);
    VirtualPanel panel({}, machine.places());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(port));
    panel.window().showMessage(texts::badLink({bus::LinkHealth::Lost, 5, 20, std::nullopt}));
    machine.set({});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    machine.set({adapter(port, "B2")});
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(kDifferent) == 1; }));
    ASSERT_TRUE(panel.press(QStringLiteral("The link is unreliable"), QStringLiteral("Reconnect")));
    EXPECT_EQ(panel.composition().store().link().phase, LinkPhase::Disconnected);
    EXPECT_NE(panel.standing(kDifferent), nullptr) << "it is the way to connect";
}

/// Its machine may be another one with the same modules, and no stop is owed to that.
TEST(F30_OldName, WithAnotherAdapterDoesNotGetTheStopsOfAnotherPort) {
    PortsMachine machine;
    const QString one = machine.port("ttyUSB0");
    const QString two = machine.port("ttyUSB1");
    machine.set({adapter(one, "A1"), adapter(two, "B2")});
    VirtualChain sim(QStringLiteral("servo"), one);
    VirtualChain other(QStringLiteral("servo"), two);
    VirtualPanel panel({}, machine.places());
    panel.start();
    const auto connectAt = [&](const QString& port) {
        ASSERT_NO_FATAL_FAILURE(panel.connectTo(port));
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().activity() != Activity::Unknown; }));
    };
    ASSERT_NO_FATAL_FAILURE(connectAt(two));
    ASSERT_NO_FATAL_FAILURE(panel.enable());  // a servo that is off is sent no stop
    ASSERT_NO_FATAL_FAILURE(connectAt(one));
    ASSERT_NO_FATAL_FAILURE(panel.setGoing());
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    panel.pressEsc();
    machine.set({adapter(two, "C3")});
    panel.askFor(two);
    (void)other.takePackets();
    ASSERT_TRUE(panel.press(kDifferent, QStringLiteral("Connect anyway")));
    ASSERT_TRUE(panel.waitFor([&] { return panel.connected(); }));
    ASSERT_TRUE(panel.answersFor(0.5));
    const std::vector<testing_support::Packet> packets = other.takePackets();
    EXPECT_FALSE(packets.empty());
    for (const testing_support::Packet& packet : packets)
        EXPECT_NE(packet.code(), CommandCode::StopMotor);
}

TEST(UnpluggedWhileItMoves, NamesTheModuleAndTheAgeOfItsPositionGoesOn) {
    VirtualChain sim(QStringLiteral("servo,servo"));
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startMoving(sim));
    const auto label = [&](const char* name) {
        return panel.window().findChild<QLabel*>(QLatin1String(name));
    };
    sim.unplug();
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(QStringLiteral("Module 1 was moving.")); }));
    EXPECT_TRUE(label("positionLabel")->font().strikeOut());
    EXPECT_NE(label("positionLabel")->text(), QStringLiteral("–"));
    for (int i = 0; i < 2; ++i) {
        const QString before = label("positionUnit")->text();
        EXPECT_TRUE(panel.waitFor([&] { return label("positionUnit")->text() != before; }));
    }
    EXPECT_TRUE(label("positionUnit")->text().endsWith(QStringLiteral("s old")));
}

TEST(Unplugged, EndsACommandOfWhichNoStopIsTold) {
    VirtualChain sim(QStringLiteral("servo"));
    VirtualPanel panel;
    ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
    panel.ask(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 8'000, 1, std::uint8_t{0}}});
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    EXPECT_EQ(panel.count(QStringLiteral("The command for module 1 was cancelled.")), 1);
    EXPECT_EQ(panel.count(QStringLiteral("A stop")), 0)
        << panel.headlines().join(QLatin1Char('\n')).toStdString();
}

/// The message about it stays, because its motors may still be moving.
TEST(Unplugged, IsConnectedByItsRetryWhateverIsConnectedMeanwhile) {
    VirtualChain sim(QStringLiteral("servo"));
    VirtualChain other(QStringLiteral("servo"));
    VirtualPanel panel;
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_NO_FATAL_FAILURE(panel.unplug(sim));
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(other.terminal()));
    sim.plugIn();
    ASSERT_TRUE(panel.press(QStringLiteral("was unplugged"), QStringLiteral("Retry")));
    const LinkState& link = panel.composition().store().link();
    EXPECT_TRUE(panel.waitFor([&] { return panel.connected() && link.port == sim.terminal().toStdString(); }))
        << link.port;
}

TEST(SlowAdapter, IsReckonedWithAndItsCureIsOneClickAway) {
    VirtualChain sim(QStringLiteral("servo"));
    PortsMachine machine;
    machine.setLatency(sim.terminal(), "16\n");
    PortController controller(machine.places());
    EXPECT_EQ(controller.adapterLatency(sim.terminal()), std::chrono::milliseconds(16));
    EXPECT_EQ(controller.adapterLatency(QStringLiteral("/dev/ttyS0")), std::chrono::milliseconds(4));

    VirtualPanel panel({}, machine.places());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.count(QStringLiteral("adapter waits 16 ms")) == 1; }));
    ASSERT_TRUE(panel.press(QStringLiteral("adapter waits 16 ms"), QStringLiteral("How")));
    EXPECT_EQ(panel.count(QStringLiteral("Set the latency timer")), 1);
}

TEST(SlowAdapter, IsNoLongerToldOfWhenAnotherPortIsOpened) {
    const QString slow = QStringLiteral("adapter waits 16 ms");
    VirtualChain sim(QStringLiteral("servo"));
    VirtualChain other(QStringLiteral("servo"));
    PortsMachine machine;
    machine.setLatency(sim.terminal(), "16\n");
    VirtualPanel panel({}, machine.places());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    ASSERT_TRUE(panel.waitFor([&] { return panel.standing(slow) != nullptr; }));
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(other.terminal()));
    EXPECT_EQ(panel.standing(slow), nullptr) << "the command of its cure would be for this port";
}

TEST(SlowAdapter, AtOneMillisecondIsNotSlow) {
    PortsMachine machine;
    const QString port = machine.port("ttyUSB0");
    machine.setLatency(port, "1\n");
    PortController controller(machine.places());
    EXPECT_EQ(controller.adapterLatency(port), std::chrono::milliseconds(4))
        << "it is never assumed to be less";
    int told = 0;
    QObject::connect(&controller, &PortController::reported, [&told] { ++told; });
    controller.opening({port, 19'200});
    controller.noteRate(200);
    EXPECT_EQ(told, 0);
    machine.setLatency(port, "16\n");
    controller.opening({port, 19'200});
    controller.noteRate(0);
    EXPECT_EQ(told, 0) << "its rate is not known yet";
    controller.noteRate(58);
    controller.noteRate(58);
    EXPECT_EQ(told, 1);
}

/// For example the simulator is opened next, whose rate says nothing about the adapter.
TEST(SlowAdapter, IsNotToldOfOnceItsPortIsClosed) {
    PortsMachine machine;
    const QString port = machine.port("ttyUSB0");
    machine.setLatency(port, "16\n");
    PortController controller(machine.places());
    int told = 0;
    QObject::connect(&controller, &PortController::reported, [&told] { ++told; });
    controller.opening({port, 19'200});
    controller.closed(std::nullopt);
    controller.noteRate(200);
    EXPECT_EQ(told, 0);
}

// ---- the sentences ----

PortError busy(const char* program, std::int64_t pid) {
    PortError error;
    error.problem = PortProblem::InUse;
    error.port = "/dev/ttyUSB0";
    error.program = program;
    error.pid = pid;
    return error;
}

TEST(F32_Text, NamesTheProgram) {
    const Message m = texts::portProblem(busy("minicom", 4711));
    EXPECT_EQ(m.headline, QStringLiteral("/dev/ttyUSB0 is used by minicom (pid 4711)."));
    EXPECT_EQ(m.body, QStringLiteral("Close it and try again."));
    EXPECT_EQ(texts::portProblem(busy("", 4711)).headline,
              QStringLiteral("/dev/ttyUSB0 is used by another program (pid 4711)."));
}

TEST(F33_Text, NamesTheFileItsOwnerAndTheCommand) {
    PortError error = busy("", 0);
    error.problem = PortProblem::StaleLock;
    error.lockFile = "/run/lock/LCK..ttyUSB0";
    error.user = "root";
    const Message m = texts::portProblem(error);
    EXPECT_TRUE(m.body.contains(QLatin1String("root left the lock file /run/lock/LCK..ttyUSB0 behind")));
    EXPECT_EQ(m.command, QStringLiteral("sudo rm /run/lock/LCK..ttyUSB0"));
    EXPECT_EQ(m.actions.first().id, MessageAction::CopyCommand);
}

TEST(F34_Text, SaysThatALockFileCannotBeMade) {
    PortError error = busy("", 0);
    error.problem = PortProblem::NoLockFolder;
    error.lockFile = "/var/lock";
    const Message m = texts::portProblem(error);
    EXPECT_TRUE(m.headline.contains(QLatin1String("no lock file can be created")));
    EXPECT_TRUE(m.body.contains(QLatin1String("/var/lock")));
}

TEST(F36_Text, HasTheUdevRuleToCopy) {
    const Message modem = texts::portProblem(busy("ModemManager", 800));
    EXPECT_TRUE(modem.command.contains(QLatin1String("ENV{ID_MM_PORT_IGNORE}=\"1\"")));
    EXPECT_TRUE(modem.body.contains(modem.command));
    EXPECT_EQ(modem.actions.first().id, MessageAction::CopyCommand);
    const Message braille = texts::portProblem(busy("brltty", 801));
    EXPECT_TRUE(braille.command.contains(QLatin1String("90-brltty-usb-generic.rules")));
}

TEST(H16_Text, SaysTooManyFiles) {
    PortError error = busy("", 0);
    error.problem = PortProblem::TooManyFiles;
    EXPECT_EQ(texts::portProblem(error).headline,
              QStringLiteral("Could not open /dev/ttyUSB0: this program has too many open files."));
}

TEST(SlowAdapter, HasItsCommandAndTheRuleForGood) {
    const Message m = texts::latencyCure(QStringLiteral("/sys/bus/usb-serial/devices/ttyUSB0/latency_timer"));
    EXPECT_EQ(m.command,
              QStringLiteral("echo 1 | sudo tee /sys/bus/usb-serial/devices/ttyUSB0/latency_timer"));
    EXPECT_TRUE(m.body.contains(QLatin1String("ATTR{latency_timer}=\"1\"")));
}

}  // namespace
}  // namespace nmc
