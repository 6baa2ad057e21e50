// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about what happened are kept, with their causes, and outlive the session.
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

QString logIn(const QTemporaryDir& folder) {
    const QDir dir(folder.filePath(u"log"_s));
    QString text;
    for (const QString& name : dir.entryList({u"messages-*.log"_s})) {
        QFile file(dir.filePath(name));
        if (file.open(QIODevice::ReadOnly))
            text += QString::fromUtf8(file.readAll());
    }
    return text;
}

class HistoryKept : public testing::Test {
protected:
    /// Runs the stepper; a limit or the E-stop input switches it off.
    void run(VirtualPanel& panel) {
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().activity() != Activity::Unknown; }));
        ASSERT_TRUE(panel.answersFor(0.3));
        stepper::SetParameters parameters;
        parameters.speedMode = stepper::SpeedMode::X1;
        parameters.minimumProfileSpeed = 4;
        parameters.runCurrent = 100;
        parameters.holdCurrent = 50;
        parameters.thermalLimit = 80;
        parameters.motorOffOnLimitOrEstop = true;
        panel.ask(stepperintent::SetParameters{parameters});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().stepper.parameters.has_value(); }));
        panel.ask(intent::Enable{});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().stepper.amplifierOn(); }));
        panel.ask(intent::Move{steppermotion::VelocityProfile{40, 4, false}});
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().activity() == Activity::AtSpeed; }));
    }
    void offBy(VirtualPanel& panel, const QString& line, const QString& back, const QString& words) {
        ASSERT_NO_FATAL_FAILURE(run(panel));
        (void)sim.control(line);
        ASSERT_TRUE(panel.waitFor([&] { return panel.standing(words) != nullptr; }))
            << panel.headlines().join(u" | "_s).toStdString();
        (void)sim.control(back);
    }
    VirtualChain sim{u"step"_s};
};

TEST_F(HistoryKept, HeatLimitAndEstopAreThreeEntriesThatEndAndTheLogHasThem) {
    const QTemporaryDir folder;
    const QStringList causes{u"is too hot"_s, u"because a limit switch is active"_s,
                             u"because its E-stop input is active"_s};
    {
        VirtualPanel panel({}, {}, folder.path());
        panel.start();
        ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
        ASSERT_NO_FATAL_FAILURE(offBy(panel, u"set 1 analog 70"_s, u"set 1 analog 200"_s, causes[0]));
        ASSERT_NO_FATAL_FAILURE(offBy(panel, u"set 1 limit1 1"_s, u"set 1 limit1 0"_s, causes[1]));
        ASSERT_NO_FATAL_FAILURE(offBy(panel, u"set 1 estop 1"_s, u"set 1 estop 0"_s, causes[2]));
        panel.ask(intent::MotorOff{});
        for (const QString& cause : causes) {
            EXPECT_EQ(panel.count(cause), 1) << cause.toStdString();
            EXPECT_TRUE(panel.waitFor([&] { return panel.standing(cause) == nullptr; }))
                << cause.toStdString();
        }
        const QString place = panel.window().findChild<QLabel*>(u"messageLogLabel"_s)->text();
        EXPECT_TRUE(place.contains(folder.path())) << place.toStdString();
    }
    const QString log = logIn(folder);
    for (const QString& cause : causes)
        EXPECT_EQ(log.count(cause), 2) << "reported, and ended: " << log.toStdString();
    VirtualPanel later({}, {}, folder.path());
    later.start();
    ASSERT_NO_FATAL_FAILURE(later.connectTo(sim.terminal()));
    EXPECT_TRUE(later.waitFor([&] { return logIn(folder).size() > log.size(); }));
    EXPECT_TRUE(logIn(folder).startsWith(log)) << "a later session continues the log";
}

TEST_F(HistoryKept, ALogThatCannotBeWrittenIsSaidOnceAndEverythingElseWorks) {
    const QTemporaryDir folder;
    QFile inTheWay(folder.filePath(u"log"_s));
    ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
    VirtualPanel panel({}, {}, folder.path());
    panel.start();
    ASSERT_NO_FATAL_FAILURE(panel.connectTo(sim.terminal()));
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(u"lost when this session ends"_s) == 1; }));
    ASSERT_NO_FATAL_FAILURE(run(panel));
    panel.pressStopAll();
    EXPECT_TRUE(panel.waitFor([&] { return !panel.module().moving(); }));
    EXPECT_EQ(panel.count(u"lost when this session ends"_s), 1);
    EXPECT_EQ(panel.window().findChild<QLabel*>(u"messageLogLabel"_s)->text(),
              u"Kept for this session only."_s);
}

}  // namespace
}  // namespace nmc
