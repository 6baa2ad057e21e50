// SPDX-License-Identifier: GPL-3.0-or-later
// Square waves, frequency responses and the report, in the whole program, by its buttons, with the simulator.
#include "tests/support/choosefile.h"
#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class TestsOfTheLoop : public testing::Test {
protected:
    void SetUp() override {
        panel.window().resize(1500, 1100);
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        panel.window().findChild<QAction*>(u"tuneLayoutAction"_s)->trigger();
        ASSERT_NO_FATAL_FAILURE(panel.click("fillGainsButton"));
        ASSERT_NO_FATAL_FAILURE(panel.click("applyGainsButton"));
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains.has_value(); }));
        ASSERT_NO_FATAL_FAILURE(panel.click("enableButton"));
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().servoOn() && panel.module().goal(); }));
        QTest::keyClick(&panel.window(), Qt::Key_F9, Qt::ControlModifier);
        ASSERT_TRUE(panel.waitFor(
            [&] { return panel.window().findChild<QWidget*>(u"squareWavePage"_s) != nullptr; }));
    }
    void TearDown() override { texts::setModuleNames({}); }
    [[nodiscard]] QString text(const char* name) {
        return panel.window().findChild<QLabel*>(QLatin1String(name))->text();
    }
    /// `test`: the prefix of the names of its controls.
    [[nodiscard]] bool ended(const char* test) {
        const QString name = QLatin1String(test) + u"EndButton"_s;
        auto* end = panel.window().findChild<QAbstractButton*>(name);
        return panel.waitFor([&] { return !end->isEnabled(); });
    }
    [[nodiscard]] int position() { return sim.state(1)[u"position"_s].toInt(); }
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
};

TEST_F(TestsOfTheLoop, ASquareWaveTakesNewGainsAndItsFoldIsKept) {
    panel.type("squareWavePeriodField", u"0.3"_s);
    panel.type("squareWaveRoundsField", u"12"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("squareWaveStartButton"));
    ASSERT_TRUE(panel.waitFor(
        [&] { return text("squareWaveResults").startsWith(u"Edges with these gains: 4\n"_s); }));
    panel.type("kdField", u"2000"_s);
    auto* field = panel.window().findChild<QLineEdit*>(u"kdField"_s);
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(panel.waitFor([&] { return panel.module().gains->kd == 2'000; }));
    EXPECT_EQ(text("squareWaveState").left(6), u"Moving"_s) << "the test goes on";
    ASSERT_TRUE(ended("squareWave")) << text("squareWaveState").toStdString();
    EXPECT_TRUE(text("squareWaveResults").contains(u"Rise"_s));
    EXPECT_NEAR(position(), 0, 5);
    EXPECT_TRUE(panel.module().servoOn());
    ASSERT_NO_FATAL_FAILURE(panel.click("squareWaveKeepButton"));
    EXPECT_EQ(panel.window().findChild<QTableWidget*>(u"responseRunTable"_s)->rowCount(), 1);
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(TestsOfTheLoop, SinesGiveABandwidthAndAReport) {
    panel.type("frequencyFromField", u"12"_s);
    panel.type("frequencyToField", u"25"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("frequencyStartButton"));
    ASSERT_TRUE(panel.waitFor([&] { return text("frequencyFigures").startsWith(u"2 "_s); }));
    ASSERT_TRUE(ended("frequency")) << text("frequencyState").toStdString();
    EXPECT_TRUE(text("frequencyFigures").contains(u"Resonance"_s)) << text("frequencyFigures").toStdString();
    EXPECT_TRUE(panel.module().servoOn());
    EXPECT_NEAR(position(), 0, 5);
    QTemporaryDir directory;
    for (const QString& name : {u"report.html"_s, u"report.pdf"_s}) {
        ASSERT_NO_FATAL_FAILURE(panel.click("tuningReportButton"));
        auto* dialog = panel.window().findChild<QFileDialog*>(u"reportFileDialog"_s);
        ASSERT_NE(dialog, nullptr);
        testing_support::chooseFile(*dialog, directory.filePath(name));
        ASSERT_TRUE(panel.waitFor([&] { return QFile::exists(directory.filePath(name)); }));
    }
    QFile html(directory.filePath(u"report.html"_s));
    ASSERT_TRUE(html.open(QIODevice::ReadOnly));
    const QString page = QString::fromUtf8(html.readAll());
    for (const QString& part : {u"Tuning of Module 1"_s, u"PIC-SERVO, version 4, address 1"_s, u">1000<"_s,
                                u"Resonance"_s, u"data:image/png"_s})
        EXPECT_TRUE(page.contains(part)) << part.toStdString();
    QFile pdf(directory.filePath(u"report.pdf"_s));
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    const QByteArray bytes = pdf.readAll();
    EXPECT_TRUE(bytes.startsWith("%PDF"));
    EXPECT_TRUE(bytes.contains("/Count 1\n")) << "it has one page";
    EXPECT_EQ(sim.violations(), "");
}

TEST_F(TestsOfTheLoop, EscEndsSinesForGood) {
    panel.type("frequencyFromField", u"0.5"_s);
    panel.type("frequencyToField", u"1"_s);
    panel.type("frequencyAmplitudeField", u"200"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("frequencyStartButton"));
    ASSERT_TRUE(panel.waitFor([&] { return std::abs(position()) > 100; }));
    QTest::keyClick(&panel.window(), Qt::Key_Escape);
    ASSERT_TRUE(ended("frequency"));
    ASSERT_TRUE(panel.answersFor(0.5))
        << "a stop is sent twice, and each time the servo holds where the motor is";
    const int command = sim.state(1)[u"command_position"_s].toInt();
    ASSERT_TRUE(panel.answersFor(1.0));
    EXPECT_EQ(sim.state(1)[u"command_position"_s].toInt(), command);
    EXPECT_TRUE(panel.module().servoOn()) << "a stop keeps holding";
    // It can be started again from where it was stopped.
    auto* start = panel.window().findChild<QAbstractButton*>(u"frequencyStartButton"_s);
    if (!start->isEnabled()) {
        ASSERT_NO_FATAL_FAILURE(panel.click("frequencyHoldButton"));
    }
    EXPECT_TRUE(panel.waitFor([&] { return start->isEnabled(); }));
}

TEST_F(TestsOfTheLoop, EndItHoldsTheMotor) {
    ASSERT_NO_FATAL_FAILURE(panel.click("squareWaveStartButton"));
    ASSERT_TRUE(panel.waitFor(
        [&] { return panel.window().findChild<QAbstractButton*>(u"squareWaveEndButton"_s)->isEnabled(); }));
    ASSERT_NO_FATAL_FAILURE(panel.click("squareWaveEndButton"));
    ASSERT_TRUE(ended("squareWave"));
    EXPECT_TRUE(panel.module().servoOn());
    ASSERT_TRUE(panel.answersFor(0.8));
    EXPECT_FALSE(panel.module().moving());
}

/// The third edge is the first rising one that is recorded.
TEST_F(TestsOfTheLoop, AnEdgeThatIsCutOffIsNotMeasured) {
    panel.type("squareWavePeriodField", u"3"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("squareWaveStartButton"));
    const auto command = [this] { return sim.state(1)[u"command_position"_s].toInt(); };
    ASSERT_TRUE(panel.waitFor([&] { return command() < -40; }));
    ASSERT_TRUE(panel.waitFor([&] { return command() > 40; }));
    ASSERT_TRUE(panel.answersFor(0.3));
    ASSERT_NO_FATAL_FAILURE(panel.click("squareWaveEndButton"));
    ASSERT_TRUE(ended("squareWave"));
    EXPECT_TRUE(text("squareWaveResults").isEmpty()) << text("squareWaveResults").toStdString();
    EXPECT_FALSE(panel.window().findChild<QAbstractButton*>(u"squareWaveKeepButton"_s)->isEnabled());
}

/// The stop that ends a sine replaces a command of the test's own, which nobody misses.
TEST_F(TestsOfTheLoop, EndingASineIsNoNews) {
    panel.type("frequencyFromField", u"0.5"_s);
    panel.type("frequencyToField", u"1"_s);
    panel.type("frequencyAmplitudeField", u"200"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("frequencyStartButton"));
    ASSERT_TRUE(panel.waitFor([&] { return std::abs(position()) > 100; }));
    ASSERT_NO_FATAL_FAILURE(panel.click("frequencyEndButton"));
    ASSERT_TRUE(ended("frequency"));
    ASSERT_TRUE(panel.answersFor(0.8));
    EXPECT_TRUE(panel.module().servoOn());
    EXPECT_FALSE(panel.module().moving());
    EXPECT_EQ(panel.count(u"The command for module"_s), 0) << panel.headlines().join(u'\n').toStdString();
}

}  // namespace
}  // namespace nmc
