// SPDX-License-Identifier: GPL-3.0-or-later
#include "module/profiledload.h"
#include "tests/support/motionof.h"
#include "widgets/common/words.h"
#include "windowtest.h"

namespace nmc {
namespace {

class IoPage : public WindowTest {
protected:
    void showPage(const QString& page) {
        auto* pages = find<QTabWidget>(u"servoPages"_s);
        for (int i = 0; i < pages->count(); ++i)
            if (pages->tabText(i).remove(u'&') == page)
                pages->setCurrentIndex(i);
    }
    template <typename Asked>
    Asked only() {
        EXPECT_EQ(intents.size(), 1);
        return std::get<Asked>(intents.takeFirst().at(1).template value<Intent>());
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(IoPage, ALimitPinBecomesAnOutputAtOnce) {
    showServo();
    showPage(u"Limits  I/O"_s);
    auto* use = find<QComboBox>(u"limit1UseBox"_s);
    EXPECT_EQ(use->currentText(), u"input"_s);
    use->setFocus();
    QTest::keyClick(use, Qt::Key_End);
    const auto io = only<intent::ControlIo>().io;
    EXPECT_FALSE(io.limit1IsInput);
    EXPECT_TRUE(io.limit1Output);
    EXPECT_TRUE(io.limit2IsInput);
}

/// One command sets both pins, so a pin that was not chosen would become an input.
TEST_F(IoPage, OfAChainThatWasFoundRunningNoPinChangesUnasked) {
    ModuleState module = Servo{}.state();
    module.attached();
    window->showLink(connectedTo({module}));
    showPage(u"Limits  I/O"_s);
    auto* first = find<QComboBox>(u"limit1UseBox"_s);
    auto* second = find<QComboBox>(u"limit2UseBox"_s);
    EXPECT_EQ(first->currentIndex(), -1);
    EXPECT_TRUE(text(u"limitRemark"_s).contains(u"unknown"_s));
    first->setFocus();
    QTest::keyClick(first, Qt::Key_End);
    EXPECT_EQ(intents.size(), 0);
    window->showLink(connectedTo({module}));
    EXPECT_EQ(first->currentText(), u"output, high"_s) << "the choice stays until it is complete";
    EXPECT_EQ(second->currentIndex(), -1);
    second->setFocus();
    QTest::keyClick(second, Qt::Key_Home);
    const auto io = only<intent::ControlIo>().io;
    EXPECT_FALSE(io.limit1IsInput);
    EXPECT_TRUE(io.limit1Output);
    EXPECT_TRUE(io.limit2IsInput);
    EXPECT_EQ(first->currentIndex(), -1) << "the module has not confirmed it";
    module.apply(bus::CommandExecuted{ModuleIndex(0), module.latestTime, ServoCommand(io)});
    window->showLink(connectedTo({module}));
    EXPECT_EQ(first->currentText(), u"output, high"_s);
    EXPECT_EQ(second->currentText(), u"input"_s);
    EXPECT_FALSE(text(u"limitRemark"_s).contains(u"unknown"_s));
}

TEST_F(IoPage, SaysThatALimitDoesNotStopTheMotor) {
    showServo();
    EXPECT_TRUE(text(u"limitRemark"_s).contains(u"does not stop the motor"_s));
}

TEST_F(IoPage, TheAmplifiersBoxFollowsTheModuleAndNotTheClick) {
    showServo();
    showPage(u"Limits  I/O"_s);
    auto* box = button(u"amplifierBox"_s);
    QTest::mouseClick(box, Qt::LeftButton, {}, {box->height() / 2, box->height() / 2});
    EXPECT_TRUE(only<intent::SetAmplifier>().enable);
    EXPECT_FALSE(box->isChecked());
    ModuleState module = Servo{.millisecond = 20}.state();
    module.amplifierEnabled = true;
    window->showLink(connectedTo({module}));
    EXPECT_TRUE(box->isChecked());
}

TEST_F(IoPage, TheAmplifierOfAChainThatWasFoundRunningIsUnknown) {
    ModuleState module = Servo{}.state();
    module.attached();
    window->showLink(connectedTo({module}));
    showPage(u"Limits  I/O"_s);
    auto* box = find<QCheckBox>(u"amplifierBox"_s);
    EXPECT_EQ(box->checkState(), Qt::PartiallyChecked);
    QTest::mouseClick(box, Qt::LeftButton, {}, {box->height() / 2, box->height() / 2});
    EXPECT_TRUE(only<intent::SetAmplifier>().enable);
    EXPECT_EQ(box->checkState(), Qt::PartiallyChecked) << "the module has not confirmed it";
}

TEST_F(IoPage, PwmIsSetApartAndOnlyForAServoThatIsOff) {
    showServo();
    showPage(u"PWM"_s);
    EXPECT_TRUE(text(u"pwmWarning"_s).contains(u"No position, position error or output limit"_s));
    EXPECT_EQ(button(u"pwmForwardButton"_s)->toolTip(), texts::refusal(Refusal::ServoOn));
    showServo({.on = false, .millisecond = 10});
    type(u"pwmField"_s, u"51"_s);
    click(u"pwmReverseButton"_s);
    const auto drive = only<intent::DrivePwm>();
    EXPECT_EQ(drive.pwm, 51);
    EXPECT_TRUE(drive.reverse);
    type(u"pwmField"_s, u"256"_s);
    showServo({.on = false, .millisecond = 20});
    EXPECT_FALSE(button(u"pwmForwardButton"_s)->isEnabled());
}

TEST_F(IoPage, MovesSayBeforehandHowLongTheyTake) {
    showServo();
    type(u"goalField"_s, u"20000"_s);
    type(u"velocityField"_s, u"8"_s);
    type(u"accelerationField"_s, u"0.02"_s);
    // 2900 ticks of 0.512 ms.
    EXPECT_EQ(text(u"forecastLabel"_s), u"Takes 1.48 s, peak 8 counts/tick"_s);
    type(u"goalField"_s, u"800"_s);
    // 400 ticks are 0.2048 s; peak sqrt(800 x 0.02).
    EXPECT_EQ(text(u"forecastLabel"_s),
              u"Takes 0.2 s, peak 4 counts/tick: too short to reach its velocity"_s);
    showServo({.moveDone = false, .position = 300, .millisecond = 10});
    EXPECT_EQ(text(u"forecastLabel"_s), QString()) << "it is not known where the motor will be by then";
}

/// Without SR, the length of a tick is unknown (DS-V 4.3), but not the peak: 20000 counts are more than the
/// v^2/a = 3200 counts of both ramps, and 800 are not; their peak is sqrt(800 x 0.02).
TEST_F(IoPage, MovesDoNotSayHowLongTheyTakeIfTheServoRateIsUnknown) {
    ModuleState module = Servo{}.state();
    module.servoRate.reset();
    window->showLink(connectedTo({module}));
    type(u"goalField"_s, u"20000"_s);
    type(u"velocityField"_s, u"8"_s);
    type(u"accelerationField"_s, u"0.02"_s);
    EXPECT_EQ(text(u"forecastLabel"_s), u"Peak 8 counts/tick"_s);
    type(u"goalField"_s, u"800"_s);
    EXPECT_EQ(text(u"forecastLabel"_s), u"Peak 4 counts/tick: too short to reach its velocity"_s);
}

TEST_F(IoPage, ADistanceIsFromWhereTheMotorIs) {
    showServo({.position = 1000});
    auto* kind = find<QComboBox>(u"goalKindBox"_s);
    kind->setCurrentIndex(1);
    type(u"goalField"_s, u"-250"_s);
    click(u"loadButton"_s);
    EXPECT_EQ(test::motionOf<servomotion::Trapezoid>(only<intent::LoadMove>()).position.value(), 750);
    EXPECT_FALSE(button(u"startButton"_s)->isEnabled());
    ModuleState module = Servo{.position = 1000, .millisecond = 10}.state();
    module.apply(bus::CommandExecuted{
        module.info.index, module.latestTime,
        ServoCommand(profiledLoad(CountsPerTick(65'536), CountsPerTickSquared(131), 750))});
    window->showLink(connectedTo({module}));
    click(u"startButton"_s);
    only<intent::StartLoaded>();
}

TEST_F(IoPage, NothingThatWasTypedOutlivesTheConnection) {
    showServo({.on = false});
    const QString speed = field(u"pwmField"_s)->text();
    type(u"pwmField"_s, u"51"_s);
    type(u"kpField"_s, u"4321"_s);  // kept by the axis, but not the value before it
    ASSERT_TRUE(button(u"undoGainsButton"_s)->isEnabled());
    type(u"goalField"_s, u"1234"_s);
    window->showLink({});
    showServo({.on = false, .gains = false, .millisecond = 10});
    EXPECT_EQ(field(u"pwmField"_s)->text(), speed);
    EXPECT_FALSE(button(u"undoGainsButton"_s)->isEnabled());
    EXPECT_NE(field(u"goalField"_s)->text(), u"1234"_s);
}

TEST_F(IoPage, GoesHomeAndStopsHere) {
    ModuleState module = Servo{.position = 10}.state();
    module.home.found(4321, module.latestTime);
    window->showLink(connectedTo({module}));
    click(u"goHomeButton"_s);
    only<intent::GoHome>();
    showServo({.moveDone = false, .position = 77, .millisecond = 10});
    click(u"stopHereButton"_s);
    only<intent::StopHere>();
    showServo({.version = 1, .millisecond = 20});
    EXPECT_EQ(button(u"stopHereButton"_s)->toolTip(), texts::refusal(Refusal::VersionLacksIt));
}

TEST_F(IoPage, AVersionWithoutADataSheetIsOnlyLookedAt) {
    for (const ModuleIdentity& identity :
         {ModuleIdentity{ModuleType::Servo, 6}, ModuleIdentity{ModuleType::Stepper, 2},
          ModuleIdentity{ModuleType::Io, 2}, ModuleIdentity{ModuleType::Adc, 1}}) {
        ModuleState module;
        module.info.identity = identity;
        module.info.address = BusAddress(1);
        bus::Sample sample;
        sample.report.status = 0xA5;
        module.apply(sample);
        window->showLink(connectedTo({module}));
        EXPECT_TRUE(find(u"genericPanel"_s)->isVisible());
        EXPECT_TRUE(text(u"genericStatus"_s).contains(u"a5"_s));
        const auto steps = plan(intent::Enable{}, module);
        ASSERT_FALSE(steps.has_value());
        EXPECT_EQ(steps.error(), Refusal::NotAServo);
        click(u"askAnewButton"_s);
        only<intent::AskAnew>();
    }
}

TEST_F(IoPage, TheDetailsKeepThePresentPositionAsHome) {
    showServo();
    showPage(u"Details"_s);
    click(u"saveHomeButton"_s);
    only<intent::SaveAsHome>();
}

}  // namespace
}  // namespace nmc
