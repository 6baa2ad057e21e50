// SPDX-License-Identifier: GPL-3.0-or-later
// Ports that are in use, slow, gone, or back under another name: the parts that need no port.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "link/ports/adaptermemory.h"
#include "link/ports/latencytimer.h"
#include "link/ports/linerate.h"
#include "link/ports/portuser.h"
#include "link/ports/portwatcher.h"
#include "tests/support/eventually.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;

const QString kUsb0 = QStringLiteral("/dev/ttyUSB0");
const QString kUsb1 = QStringLiteral("/dev/ttyUSB1");

PortEntry adapter(const QString& name, const QString& serial, std::uint16_t product = 0x6001) {
    return {name, QStringLiteral("USB Serial"), serial, 0x0403, product};
}

const QString kA = QStringLiteral("A50285BI");
const QString kB = QStringLiteral("A50285BJ");

// ---- F-29, F-30: adapters by their serial number ----

TEST(F29_BackUnderAnotherName, IsKnownByItsSerialNumberAndToldOnce) {
    AdapterMemory memory;
    memory.opened(kUsb0, {adapter(kUsb0, kA), adapter(kUsb1, kB)});
    memory.lost(kUsb0);
    EXPECT_EQ(memory.back({adapter(kUsb1, kB)}), std::nullopt) << "that is another adapter";
    const QList<PortEntry> ports{adapter(QStringLiteral("/dev/ttyUSB2"), kA), adapter(kUsb1, kB)};
    EXPECT_EQ(memory.back(ports), (AdapterMemory::Back{QStringLiteral("/dev/ttyUSB2"), true}));
    EXPECT_EQ(memory.back(ports), std::nullopt);
}

TEST(F29_BackUnderAnotherName, OneWithoutASerialNumberIsOnlyOfTheSameKind) {
    AdapterMemory memory;
    memory.opened(kUsb0, {adapter(kUsb0, {}, 0x7523)});
    memory.lost(kUsb0);
    EXPECT_EQ(memory.back({adapter(kUsb1, {}, 0x6001)}), std::nullopt);
    EXPECT_EQ(memory.back({adapter(kUsb1, {}, 0x7523)}), (AdapterMemory::Back{kUsb1, false}));
}

/// Otherwise, the stops owed to one machine would be sent to the other.
TEST(F29_BackUnderAnotherName, OneOfTheSameKindThatWasThereAllAlongIsPassedOver) {
    const QString usb2 = QStringLiteral("/dev/ttyUSB2");
    const PortEntry first = adapter(kUsb0, {}, 0x7523);
    const PortEntry second = adapter(kUsb1, {}, 0x7523);
    const PortEntry third = adapter(usb2, {}, 0x7523);
    AdapterMemory memory;
    memory.opened(kUsb0, {first, second});
    memory.lost(kUsb0);
    EXPECT_EQ(memory.back({second}), std::nullopt);
    EXPECT_EQ(memory.back({second, third}), (AdapterMemory::Back{usb2, false}));

    memory.opened(kUsb0, {first, second});
    memory.lost(kUsb0);
    EXPECT_EQ(memory.back({}), std::nullopt);
    EXPECT_EQ(memory.back({second}), (AdapterMemory::Back{kUsb1, false})) << "it may have changed its place";

    memory.opened(kUsb0, {first});
    EXPECT_EQ(memory.back({first, second}), std::nullopt) << "plugged in while the other was there";
    memory.lost(kUsb0);
    EXPECT_EQ(memory.back({second}), std::nullopt);
    EXPECT_EQ(memory.back({first, second}), (AdapterMemory::Back{kUsb0, false}));
}

TEST(F29_BackUnderAnotherName, IsLookedForAgainWhenItHasGoneAgain) {
    AdapterMemory memory;
    memory.opened(kUsb0, {adapter(kUsb0, kA)});
    memory.lost(kUsb0);
    EXPECT_EQ(memory.back({adapter(kUsb1, kA)}), (AdapterMemory::Back{kUsb1, true}));
    EXPECT_TRUE(memory.isBackAt(kUsb1));
    EXPECT_EQ(memory.back({adapter(kUsb1, kB)}), std::nullopt);
    EXPECT_FALSE(memory.isBackAt(kUsb1)) << "another adapter has taken its place";
    EXPECT_EQ(memory.back({adapter(kUsb1, kB), adapter(kUsb0, kA)}), (AdapterMemory::Back{kUsb0, true}));
    memory.opened(kUsb0, {adapter(kUsb1, kB), adapter(kUsb0, kA)});
    EXPECT_FALSE(memory.isBackAt(kUsb0));
}

TEST(F29_BackUnderAnotherName, IsNotLookedForWhenNothingWasLostOrAConnectionIsOpen) {
    AdapterMemory memory;
    memory.opened(kUsb0, {adapter(kUsb0, kA)});
    EXPECT_EQ(memory.back({adapter(kUsb1, kA)}), std::nullopt);
    memory.lost(kUsb0);
    memory.opened(kUsb1, {adapter(kUsb1, kB)});
    EXPECT_EQ(memory.back({adapter(kUsb0, kA), adapter(kUsb1, kB)}), std::nullopt);
}

TEST(F30_OldName, WithAnotherAdapterIsRecognised) {
    AdapterMemory memory;
    EXPECT_FALSE(memory.differs(kUsb0, {adapter(kUsb0, kA)})) << "nothing is known about it yet";
    memory.opened(kUsb0, {adapter(kUsb0, kA)});
    EXPECT_FALSE(memory.differs(kUsb0, {adapter(kUsb0, kA)}));
    EXPECT_TRUE(memory.differs(kUsb0, {adapter(kUsb0, kB)}));
    EXPECT_FALSE(memory.differs(kUsb0, {})) << "no adapter is there";
    memory.opened(kUsb0, {adapter(kUsb0, kB)});
    EXPECT_FALSE(memory.differs(kUsb0, {adapter(kUsb0, kB)})) << "the user has agreed";
}

TEST(F30_OldName, OfAPortWithoutAnyIdentityIsNeverDifferent) {
    AdapterMemory memory;
    const PortEntry plain{QStringLiteral("/dev/ttyS0"), {}};
    memory.opened(plain.name, {plain});
    EXPECT_FALSE(memory.differs(plain.name, {plain}));
    memory.lost(plain.name);
    EXPECT_EQ(memory.back({plain}), std::nullopt);
}

TEST(F29_PortWatcher, AsksForTheListOnlyAfterSomethingHasChanged) {
    QTemporaryDir devices;
    int asked = 0;
    QList<PortEntry> there;
    PortWatcher watcher(
        [&] {
            ++asked;
            return there;
        },
        devices.path());
    QSignalSpy changes(&watcher, &PortWatcher::portsChanged);
    EXPECT_EQ(asked, 0);
    there = {adapter(kUsb1, kA)};
    for (const char* name : {"one", "two", "three"}) {
        QFile file(devices.filePath(QLatin1String(name)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    }
    ASSERT_TRUE(changes.wait(testing_support::kPatienceMs));
    EXPECT_EQ(asked, 1) << "three files at once are one change";
    EXPECT_EQ(changes.takeFirst().at(0).value<QList<PortEntry>>(), there);
    QFile::remove(devices.filePath(QStringLiteral("one")));
    EXPECT_TRUE(testing_support::eventually([&] { return asked == 2; }));
    EXPECT_TRUE(changes.isEmpty()) << "the same ports as before";
}

/// For example by opening the list of ports right after the adapter was plugged in.
TEST(F29_PortWatcher, AnnouncesAlsoAChangeThatWasAskedForBefore) {
    QTemporaryDir devices;
    QList<PortEntry> there;
    PortWatcher watcher([&] { return there; }, devices.path());
    QSignalSpy changes(&watcher, &PortWatcher::portsChanged);
    there = {adapter(kUsb1, kA)};
    QFile file(devices.filePath(QStringLiteral("ttyUSB1")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    EXPECT_EQ(watcher.ports(), there);
    ASSERT_TRUE(changes.wait(testing_support::kPatienceMs));
    EXPECT_EQ(changes.takeFirst().at(0).value<QList<PortEntry>>(), there);
}

// ---- F-32, F-33, F-34, F-36: who uses the port ----

/// A simulated machine: lock files, and processes with their open files.
class FakeSystem {
public:
    FakeSystem() {
        places.lockFolders = QStringList{m_directory.filePath(QStringLiteral("lock"))};
        places.proc = m_directory.filePath(QStringLiteral("proc"));
        QDir(m_directory.path()).mkdir(QStringLiteral("lock"));
        QDir(m_directory.path()).mkdir(QStringLiteral("proc"));
    }
    void process(int pid, const QString& name, const QStringList& files = {}) {
        const QString folder = QStringLiteral("proc/%1").arg(pid);
        QDir(m_directory.path()).mkpath(folder + QStringLiteral("/fd"));
        write(folder + QStringLiteral("/comm"), name + QLatin1Char('\n'));
        for (qsizetype i = 0; i < files.size(); ++i)
            QFile::link(files[i], m_directory.filePath(folder + QStringLiteral("/fd/%1").arg(i)));
    }
    QString lock(const QString& name, const QString& content) {
        write(QStringLiteral("lock/") + name, content);
        return places.lockFolders[0] + QLatin1Char('/') + name;
    }
    void removeLockFolder() { QDir(places.lockFolders[0]).removeRecursively(); }

    PortUserPlaces places;

private:
    void write(const QString& name, const QString& content) {
        QFile file(m_directory.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(content.toUtf8());
    }

    QTemporaryDir m_directory;
};

TEST(F32_LockOfALiveProcess, NamesTheProgram) {
    FakeSystem machine;
    machine.process(4711, QStringLiteral("minicom"));
    machine.lock(QStringLiteral("LCK..ttyUSB0"), QStringLiteral("      4711 minicom anna\n"));
    const PortError error = whyBusy(kUsb0, machine.places);
    EXPECT_EQ(error.problem, PortProblem::InUse);
    EXPECT_EQ(error.port, kUsb0.toStdString());
    EXPECT_EQ(error.program, "minicom");
    EXPECT_EQ(error.pid, 4711);
}

TEST(F32_LockOfALiveProcess, IsFoundUnderThePathOfALongName) {
    FakeSystem machine;
    machine.process(12, QStringLiteral("nmcpanel"));
    machine.lock(QStringLiteral("LCK..pts_4000"), QStringLiteral("12\nnmcpanel\nbench\n"));
    EXPECT_EQ(whyBusy(QStringLiteral("/dev/pts/4000"), machine.places).pid, 12);
}

TEST(F32_OpenFile, NamesAProgramThatMakesNoLockFile) {
    FakeSystem machine;
    machine.process(99, QStringLiteral("cat"), {QStringLiteral("/dev/zero")});
    machine.process(100, QStringLiteral("picocom"),
                    {QStringLiteral("/dev/zero"), QStringLiteral("/dev/null")});
    const PortError error = whyBusy(QStringLiteral("/dev/null"), machine.places);
    EXPECT_EQ(error.problem, PortProblem::InUse);
    EXPECT_EQ(error.program, "picocom");
    EXPECT_EQ(error.pid, 100);
}

TEST(F32_OpenFile, OfTheOtherEndOfATerminalIsNotAUser) {
    FakeSystem machine;
    machine.process(100, QStringLiteral("nmcsim"),
                    {QStringLiteral("/dev/ptmx"), QStringLiteral("/dev/null")});
    EXPECT_EQ(whyBusy(QStringLiteral("/dev/null"), machine.places).pid, 0);
}

TEST(F33_StaleLock, IsToldWithItsOwnerAndTheFileToRemove) {
    FakeSystem machine;
    const QString file = machine.lock(QStringLiteral("LCK..ttyUSB0"), QStringLiteral("4711\nminicom\n"));
    const PortError error = whyBusy(kUsb0, machine.places);
    EXPECT_EQ(error.problem, PortProblem::StaleLock);
    EXPECT_EQ(error.lockFile, file.toStdString());
    EXPECT_FALSE(error.user.empty());
}

TEST(F33_StaleLock, WithoutANumberInItIsStaleAsWell) {
    FakeSystem machine;
    machine.lock(QStringLiteral("LCK..ttyUSB0"), QStringLiteral("\x04\x03 garbage"));
    EXPECT_EQ(whyBusy(kUsb0, machine.places).problem, PortProblem::StaleLock);
}

TEST(F34_NoLockFolder, IsToldAsSuch) {
    FakeSystem machine;
    machine.removeLockFolder();
    const PortError error = whyBusy(kUsb0, machine.places);
    EXPECT_EQ(error.problem, PortProblem::NoLockFolder);
    EXPECT_EQ(error.lockFile, machine.places.lockFolders[0].toStdString());
}

TEST(F36_ModemManager, IsNamed) {
    FakeSystem machine;
    machine.process(800, QStringLiteral("ModemManager"), {QStringLiteral("/dev/null")});
    EXPECT_EQ(whyBusy(QStringLiteral("/dev/null"), machine.places).program, "ModemManager");
}

TEST(F32_NobodyKnown, IsInUseWithoutAName) {
    FakeSystem machine;
    const PortError error = whyBusy(kUsb0, machine.places);
    EXPECT_EQ(error.problem, PortProblem::InUse);
    EXPECT_EQ(error.pid, 0);
    EXPECT_TRUE(error.program.empty());
}

// ---- the adapter's latency ----

TEST(LatencyTimer, IsReadBesideTheDriverAlsoThroughALink) {
    QTemporaryDir sysfs;
    const QString folder = QStringLiteral("bus/usb-serial/devices/null");
    ASSERT_TRUE(QDir(sysfs.path()).mkpath(folder));
    const auto set = [&](const char* text) {
        QFile file(sysfs.filePath(folder + QStringLiteral("/latency_timer")));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    EXPECT_EQ(latencyTimerOf(QStringLiteral("/dev/null"), sysfs.path()), std::nullopt)
        << "the file does not exist";
    set("16\n");
    EXPECT_EQ(latencyTimerOf(QStringLiteral("/dev/null"), sysfs.path()), 16ms);
    const QString link = sysfs.filePath(QStringLiteral("by-id"));
    ASSERT_TRUE(QFile::link(QStringLiteral("/dev/null"), link));
    EXPECT_EQ(latencyTimerOf(link, sysfs.path()), 16ms);
    for (const char* nonsense : {"", "soon", "-1", "256", "99999999999"}) {
        set(nonsense);
        EXPECT_EQ(latencyTimerOf(QStringLiteral("/dev/null"), sysfs.path()), std::nullopt) << nonsense;
    }
    EXPECT_EQ(latencyTimerOf(QStringLiteral("/dev/zero"), sysfs.path()), std::nullopt);
}

// ---- F-25: rates ----

TEST(F25_Rate, IsGoodEnoughWithinTwoPercent) {
    EXPECT_TRUE(rateIsGoodEnough(115'200, 115'385)) << "48 MHz / 416";
    EXPECT_TRUE(rateIsGoodEnough(57'600, 57'692));
    EXPECT_FALSE(rateIsGoodEnough(57'600, 59'524)) << "3.3 %";
    EXPECT_FALSE(rateIsGoodEnough(115'200, 9'600));
    EXPECT_TRUE(rateIsGoodEnough(10'000, 9'800));
    EXPECT_FALSE(rateIsGoodEnough(10'000, 9'799));
}

}  // namespace
}  // namespace nmc
