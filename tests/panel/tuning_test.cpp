// SPDX-License-Identifier: GPL-3.0-or-later
// From gains of zero to a settled loop, in the whole program, by its buttons, with the simulator.
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/support/virtualpanel.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;
using testing_support::VirtualChain;
using testing_support::VirtualPanel;

class Tuning : public testing::Test {
protected:
    void SetUp() override {
        panel.window().resize(1500, 1100);
        ASSERT_NO_FATAL_FAILURE(panel.startAt(sim.terminal()));
        panel.window().findChild<QAction*>(u"tuneLayoutAction"_s)->trigger();
    }
    void TearDown() override { texts::setModuleNames({}); }
    [[nodiscard]] QString text(const char* name) {
        return panel.window().findChild<QLabel*>(QLatin1String(name))->text();
    }
    /// Changes the simulated motor, of which the program knows nothing.
    void setMotor(const std::vector<const char*>& settings) {
        for (const char* setting : settings)
            ASSERT_TRUE(sim.control(u"set 1 "_s + QLatin1String(setting))[u"ok"_s].toBool()) << setting;
    }
    /// Enables the servo with the starting values, at a known position.
    void hold() {
        ASSERT_NO_FATAL_FAILURE(click("fillGainsButton"));
        ASSERT_NO_FATAL_FAILURE(click("applyGainsButton"));
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains.has_value(); }));
        ASSERT_NO_FATAL_FAILURE(click("enableButton"));
        ASSERT_TRUE(panel.waitFor([&] { return panel.module().servoOn() && panel.module().goal(); }));
    }
    void step() {
        panel.step([this] { click("responseButton"); });
    }
    void stepWithNewGains() {
        panel.step([this] {
            click("responseButton");
            click("applyAndStepButton");
        });
    }
    void click(const char* name) {
        ++clicks;
        panel.click(name);
    }
    /// Types over the contents of the fields, as a user does.
    void fill(std::initializer_list<std::pair<const char*, const char*>> fields) {
        for (const auto& [name, value] : fields)
            panel.type(name, QLatin1String(value));
    }
    /// The numbers after a word of the model: the value found, and its standard deviation.
    [[nodiscard]] std::pair<double, double> found(const QString& word) {
        static const QRegularExpression numbers(u"([\u2212\u202F0-9.]+) ± ([\u202F0-9.]+)"_s);
        const QString model = text("motorModel");
        const auto match = numbers.match(model, model.indexOf(word));
        const auto number = [&match](int which) {
            return match.captured(which).replace(QChar(0x2212), u'-').remove(QChar(0x202F)).toDouble();
        };
        return {number(1), number(2)};
    }
    /// Within this part of the truth, or four standard deviations: one run in twenty is off by more than two.
    void expectFound(const QString& word, double truth, double part) {
        const auto [value, doubt] = found(word);
        EXPECT_LE(std::abs(value - truth), std::max(part * truth, 4 * doubt))
            << word.toStdString() << ' ' << value << " ± " << doubt << ", truly " << truth;
    }
    /// Expects that there is no run from which to find a motor, and that nothing is suggested.
    void expectNothingFound() {
        EXPECT_EQ(panel.window().findChild<QTableWidget*>(u"responseRunTable"_s)->rowCount(), 0);
        EXPECT_FALSE(panel.window().findChild<QAbstractButton*>(u"identifyButton"_s)->isEnabled());
        EXPECT_TRUE(text("suggestedGains").isEmpty());
    }
    // The simulator's motor: V per PWM count, N m / A, ohm.
    static constexpr double kVolts = 24.0 / 255, kConstant = 0.038, kResistance = 1.1;
    /// K = U / 255 / k, in counts.
    [[nodiscard]] static double gain() { return kVolts / kConstant * 2'000 / (2 * std::numbers::pi); }
    /// tau = J R / k^2, ms.
    [[nodiscard]] static double timeConstant() {
        return 1e3 * 1.7e-5 * kResistance / (kConstant * kConstant);
    }

    int clicks = 0;
    VirtualChain sim{u"servo"_s};
    VirtualPanel panel;
};

TEST_F(Tuning, FindsTheMotorAndSettlesItInEightClicks) {
    ASSERT_NO_FATAL_FAILURE(hold());
    ASSERT_NO_FATAL_FAILURE(step());
    ASSERT_NO_FATAL_FAILURE(click("identifyButton"));
    ASSERT_TRUE(panel.waitFor([&] { return text("motorModel").contains(u"Time constant"_s); }))
        << text("motorModel").toStdString();
    expectFound(u"Gain"_s, gain(), 0.1);
    expectFound(u"Time constant"_s, timeConstant(), 0.1);
    expectFound(u"Friction"_s, 0.004 * kResistance / kConstant / kVolts, 0.25);  // M R / k
    ASSERT_TRUE(panel.waitFor([&] { return text("suggestedGains").contains(u"Kp"_s); }));
    ASSERT_NO_FATAL_FAILURE(click("fillSuggestedButton"));
    EXPECT_EQ(panel.module().gains->kp, 100) << "nothing is sent";
    ASSERT_NO_FATAL_FAILURE(stepWithNewGains());
    EXPECT_LE(clicks, 8);
    const auto* table = panel.window().findChild<QTableWidget*>(u"responseResults"_s);
    EXPECT_TRUE(table->item(3, 0)->text().contains(u"ms"_s)) << table->item(3, 0)->text().toStdString();
    EXPECT_TRUE(panel.module().servoOn());
    EXPECT_EQ(sim.violations(), "");
}

/// Motors of which the program knows nothing, and a move that must settle within 10 counts.
class TuningMoves : public Tuning, public testing::WithParamInterface<std::vector<const char*>> {};

TEST_P(TuningMoves, SettleInsideTheirWindowAfterTenClicks) {
    ASSERT_NO_FATAL_FAILURE(setMotor(GetParam()));
    ++clicks;  // View, Tune
    ASSERT_NO_FATAL_FAILURE(hold());
    ASSERT_NO_FATAL_FAILURE(click("stepAndFindButton"));
    ASSERT_TRUE(panel.waitFor([&] { return text("suggestedGains").contains(u"Kp"_s); }))
        << text("motorModel").toStdString();
    ASSERT_NO_FATAL_FAILURE(click("fillSuggestedButton"));
    clicks += 2;  // which opens the list, and its third line
    panel.window().findChild<QComboBox*>(u"responseMethodBox"_s)->setCurrentIndex(2);
    fill({{"responseWindowField", "10"}});
    ASSERT_NO_FATAL_FAILURE(stepWithNewGains());
    EXPECT_LE(clicks, 10);
    const auto* results = panel.window().findChild<QTableWidget*>(u"responseResults"_s);
    const auto figure = [results](const QString& row) {
        for (int i = 0; i < results->rowCount(); ++i)
            if (results->verticalHeaderItem(i)->text() == row)
                return results->item(i, 0)->text();
        return QString();
    };
    EXPECT_TRUE(figure(u"Settling after the move"_s).contains(u"ms"_s))
        << figure(u"Settling after the move"_s).toStdString();
    const QJsonObject state = sim.state(1);
    EXPECT_LE(std::abs(state[u"position"_s].toInt() - state[u"command_position"_s].toDouble()), 10);
    EXPECT_TRUE(panel.module().servoOn());
    EXPECT_EQ(sim.violations(), "");
}
INSTANTIATE_TEST_SUITE_P(Motors, TuningMoves,
                         testing::Values(std::vector<const char*>{},
                                         std::vector{"inertia 1e-4", "friction 0.01"},
                                         std::vector{"inertia 4e-5", "load 0.003", "gain 10000"}));

/// One PWM count more turns this motor 20 000 counts/s faster, so that with any quiet Kp an error of less
/// than some 20 counts alone gives no output: whether a move settles within 10 is a matter of chance.
TEST_F(Tuning, SaysThatAMotorIsTooStrongForItsPwm) {
    ASSERT_NO_FATAL_FAILURE(setMotor({"inertia 4e-5", "load 0.003", "gain 20000"}));
    ASSERT_NO_FATAL_FAILURE(hold());
    ASSERT_NO_FATAL_FAILURE(click("stepAndFindButton"));
    ASSERT_TRUE(panel.waitFor([&] {
        const QString words = text("suggestedGains");
        return !words.isEmpty() && !words.startsWith(u"Calculating"_s);
    }));
    EXPECT_TRUE(text("suggestedGains").contains(u"stops too far from its goal"_s) ||
                text("suggestedGains").contains(u"No gains keep this motor stable and quiet"_s))
        << text("suggestedGains").toStdString();
}

/// One click, after which the motor is back where it was, and is known.
TEST_F(Tuning, OneClickStepsFourTimesAndFindsTheMotor) {
    ASSERT_NO_FATAL_FAILURE(hold());
    const int from = sim.state(1)[u"position"_s].toInt();
    ASSERT_NO_FATAL_FAILURE(panel.click("stepAndFindButton"));
    EXPECT_TRUE(panel.waitFor([&] { return text("responseState").contains(u"2 of 4"_s); }))
        << text("responseState").toStdString();
    EXPECT_FALSE(panel.window().findChild<QAbstractButton*>(u"stepAndFindButton"_s)->isEnabled());
    ASSERT_TRUE(panel.waitFor([&] { return text("suggestedGains").contains(u"Kp"_s); }))
        << text("motorModel").toStdString();
    EXPECT_EQ(panel.window().findChild<QTableWidget*>(u"responseRunTable"_s)->rowCount(), 4);
    EXPECT_NEAR(sim.state(1)[u"position"_s].toInt(), from, 3);
    expectFound(u"Gain"_s, gain(), 0.1);
    expectFound(u"Time constant"_s, timeConstant(), 0.1);
    EXPECT_FALSE(text("motorModel").contains(u"Uncertain"_s)) << text("motorModel").toStdString();
    EXPECT_EQ(panel.module().gains->kp, 100) << "nothing else was sent";
    EXPECT_EQ(sim.violations(), "");
}

/// Kp turns K / tau into the requested stiffness, so it is as uncertain as these are together; the ladder of
/// stiffnesses has steps of 4 %, which are 8 % of Kp.
TEST_F(Tuning, ThreeTriesSuggestTheSameKpWithinTheDoubt) {
    static const QRegularExpression kp(u"Kp (\\d+)"_s);
    ASSERT_NO_FATAL_FAILURE(hold());
    double least = 1e9, most = 0, doubt = 0;
    for (int i = 1; i <= 3; ++i) {
        ASSERT_NO_FATAL_FAILURE(panel.click("stepAndFindButton"));
        const auto* runs = panel.window().findChild<QTableWidget*>(u"responseRunTable"_s);
        ASSERT_TRUE(panel.waitFor([&] { return runs->rowCount() == 4 * i; }));
        ASSERT_TRUE(panel.waitFor([&] { return text("suggestedGains").contains(u"Kp"_s); }));
        const double suggested = kp.match(text("suggestedGains")).captured(1).toDouble();
        least = std::min(least, suggested);
        most = std::max(most, suggested);
        const auto part = [this](const QString& word) { return found(word).second / found(word).first; };
        doubt = std::max(doubt, std::hypot(part(u"Gain"_s), part(u"Time constant"_s)));
    }
    EXPECT_LE(most / least, 1.08 * (1 + 2 * doubt)) << least << " to " << most << ", doubt " << doubt;
    EXPECT_LE(doubt, 0.15);
}

class TuningStops : public Tuning, public testing::WithParamInterface<const char*> {};

TEST_P(TuningStops, EndTheFourStepsAndNothingIsFound) {
    ASSERT_NO_FATAL_FAILURE(hold());
    ASSERT_NO_FATAL_FAILURE(panel.click("stepAndFindButton"));
    ASSERT_TRUE(panel.waitFor([&] { return text("responseState").contains(u"2 of 4"_s); }));
    ASSERT_NO_FATAL_FAILURE(panel.click(GetParam()));
    ASSERT_TRUE(panel.answersFor(0.5));
    const double command = sim.state(1)[u"command_position"_s].toDouble();
    ASSERT_TRUE(panel.answersFor(3.0));
    EXPECT_EQ(sim.state(1)[u"command_position"_s].toDouble(), command);
    EXPECT_FALSE(testing_support::moves(sim));
    EXPECT_EQ(panel.window().findChild<QTableWidget*>(u"responseRunTable"_s)->rowCount(), 1)
        << "the one that was recorded";
    EXPECT_TRUE(text("motorModel").isEmpty());
    EXPECT_EQ(sim.violations(), "");
}
INSTANTIATE_TEST_SUITE_P(All, TuningStops,
                         testing::Values("stopAllButton", "stopHereButton", "stopSmoothlyButton",
                                         "motorOffButton"));

TEST_F(Tuning, UnstableGainsThatAreTriedAreTakenBack) {
    ASSERT_NO_FATAL_FAILURE(hold());
    fill({{"kpField", "5000"}, {"kdField", "0"}, {"kiField", "0"}});
    ASSERT_NO_FATAL_FAILURE(panel.click("tryGainsButton"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains->kp == 5'000; }));
    (void)sim.control(u"set 1 load 0.05"_s);  // N*m, for a moment
    ASSERT_TRUE(panel.answersFor(0.02));
    (void)sim.control(u"set 1 load 0"_s);
    EXPECT_TRUE(panel.waitFor([&] { return panel.module().gains->kp == 100; }));
    // The reason is not that the time has ended.
    EXPECT_TRUE(panel.waitFor([&] {
        return panel.count(u"it began to oscillate"_s) + panel.count(u"its output reached the limit OL"_s) ==
               1;
    }));
    EXPECT_TRUE(panel.module().servoOn());
    EXPECT_EQ(sim.violations(), "");
    // What is reported about this trial ends with the next one.
    const auto standing = [&] {
        return panel.standing(u"it began to oscillate"_s) != nullptr ||
               panel.standing(u"its output reached the limit OL"_s) != nullptr;
    };
    EXPECT_TRUE(standing());
    fill({{"kpField", "120"}, {"kdField", "1000"}, {"kiField", "80"}});
    ASSERT_NO_FATAL_FAILURE(panel.click("tryGainsButton"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains->kp == 120; }));
    EXPECT_TRUE(panel.waitFor([&] { return !standing(); }));
}

TEST_F(Tuning, GainsThatAreKeptStay) {
    ASSERT_NO_FATAL_FAILURE(hold());
    fill({{"kpField", "120"}});
    ASSERT_NO_FATAL_FAILURE(panel.click("tryGainsButton"));
    ASSERT_TRUE(panel.waitFor([&] { return panel.module().gains->kp == 120; }));
    ASSERT_NO_FATAL_FAILURE(panel.click("keepGainsButton"));
    ASSERT_NO_FATAL_FAILURE(panel.click("stopHereButton"));
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_EQ(panel.module().gains->kp, 120);
}

TEST_F(Tuning, WithoutAStepItSaysWhatIsMissing) {
    auto* button = panel.window().findChild<QAbstractButton*>(u"identifyButton"_s);
    EXPECT_FALSE(button->isEnabled());
    EXPECT_TRUE(button->toolTip().contains(u"step"_s));
}

TEST_F(Tuning, AShaftThatIsHeldGivesNoModel) {
    ASSERT_NO_FATAL_FAILURE(hold());
    (void)sim.control(u"set 1 friction 5"_s);  // N m: no motor of its size can turn that
    // The step is not repeated if samples are missing: each step takes the command farther away from a shaft
    // that does not move.
    ASSERT_NO_FATAL_FAILURE(panel.click("responseButton"));
    const auto* runs = panel.window().findChild<QTableWidget*>(u"responseRunTable"_s);
    ASSERT_TRUE(panel.waitFor([&] { return runs->rowCount() == 1; })) << text("responseState").toStdString();
    ASSERT_NO_FATAL_FAILURE(panel.click("identifyButton"));
    EXPECT_TRUE(panel.waitFor([&] { return text("motorModel").startsWith(u"The shaft did not move."_s); }))
        << text("motorModel").toStdString();
    EXPECT_TRUE(text("suggestedGains").isEmpty());
}

TEST_F(Tuning, AHardStopInTheWayGivesNoModel) {
    ASSERT_NO_FATAL_FAILURE(hold());
    (void)sim.control(u"set 1 travel_max 30"_s);
    ASSERT_NO_FATAL_FAILURE(step());
    ASSERT_NO_FATAL_FAILURE(panel.click("identifyButton"));
    EXPECT_TRUE(panel.waitFor([&] {
        return text("motorModel").startsWith(u"The motor stopped abruptly short of its goal."_s);
    })) << text("motorModel").toStdString();
    EXPECT_TRUE(text("suggestedGains").isEmpty());
}

/// It is a matter of milliseconds whether the chip, the bus or the test sees it first.
TEST_F(Tuning, AReversedEncoderEndsWithTheMotorOffAndNoModel) {
    ASSERT_NO_FATAL_FAILURE(hold());
    (void)sim.control(u"fault module 1 reverse"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("responseButton"));
    ASSERT_TRUE(panel.waitFor([&] { return !panel.module().servoOn(); }));
    EXPECT_TRUE(panel.waitFor([&] { return panel.count(u"Module 1"_s) > 0; })) << "it is reported as well";
    ASSERT_TRUE(panel.answersFor(1.0));
    EXPECT_FALSE(sim.state(1)[u"servo_on"_s].toBool());
    expectNothingFound();
}

TEST_F(Tuning, MotorPowerThatIsLostEndsTheStepWithoutAModel) {
    ASSERT_NO_FATAL_FAILURE(hold());
    panel.type("responseRecordField", u"3"_s);
    ASSERT_NO_FATAL_FAILURE(panel.click("responseButton"));
    ASSERT_TRUE(panel.waitFor([&] { return sim.state(1)[u"position"_s].toInt() > 50; }));
    (void)sim.control(u"set 1 power 0"_s);
    EXPECT_TRUE(panel.waitFor(
        [&] { return panel.count(u"did not complete its step: its motor switched itself off"_s) == 1; }));
    (void)sim.control(u"set 1 power 1"_s);
    ASSERT_TRUE(panel.answersFor(0.5));
    EXPECT_FALSE(sim.state(1)[u"servo_on"_s].toBool());
    expectNothingFound();
}

}  // namespace
}  // namespace nmc
