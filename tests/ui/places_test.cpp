// SPDX-License-Identifier: GPL-3.0-or-later
// Controls that can start a motor stay where they are under the pointer: no message, state or typing moves
// them.
#include "inlanguage.h"
#include "widgets/panels/command.h"
#include "widgets/panels/modulepage.h"
#include "windowtest.h"

namespace nmc {
namespace {

using Setting = std::tuple<std::string, QSize>;

class Places : public testing::WithParamInterface<Setting>, public InLanguage, public WindowTest {
protected:
    Places() : InLanguage(std::get<0>(GetParam())) {
        window->resize(std::get<1>(GetParam()));
        showServo();
        settle();
    }
    /// The docks make room for the first page.
    static void settle() {
        for (int i = 0; i < 5; ++i)
            QApplication::processEvents();
    }

    /// The places on the screen of all controls of the page that can start a motor.
    QMap<QString, QRect> places() {
        QApplication::processEvents();
        QMap<QString, QRect> found;
        for (const QString& name : {u"enableButton"_s,
                                    u"goalField"_s,
                                    u"goHomeButton"_s,
                                    u"startButton"_s,
                                    u"goButton"_s,
                                    u"runReverseButton"_s,
                                    u"runForwardButton"_s,
                                    u"holdReverseButton"_s,
                                    u"holdForwardButton"_s,
                                    u"moveByReverseButton"_s,
                                    u"moveByForwardButton"_s,
                                    u"pwmReverseButton"_s,
                                    u"pwmForwardButton"_s,
                                    u"homeButton"_s,
                                    u"responseButton"_s,
                                    u"stepperEnableButton"_s,
                                    u"stepperGoalField"_s,
                                    u"stepperGoButton"_s,
                                    u"stepperStartLoadedButton"_s,
                                    u"stepperRunReverseButton"_s,
                                    u"stepperRunForwardButton"_s,
                                    u"stepperHoldReverseButton"_s,
                                    u"stepperHoldForwardButton"_s,
                                    u"stepperHomeButton"_s})
            if (const auto* control = window->findChild<QWidget*>(name); control && control->isVisible())
                found.insert(name, {control->mapToGlobal(QPoint(0, 0)), control->size()});
        return found;
    }
    void showStepper(std::uint8_t status, std::int32_t position) {
        ModuleState module;
        module.info.identity = {ModuleType::Stepper, 1};
        module.info.address = BusAddress(1);
        bus::Sample sample;
        sample.report.status = status;
        sample.report.position = position;
        sample.report.aux = std::uint8_t(0);
        sample.report.analog = std::uint8_t(200);
        module.apply(sample);
        window->showLink(connectedTo({module}));
    }
    /// Checks each page: the controls of the motions are visible on all of them, and some have their own.
    void onEachPage(const QString& pages, const std::function<void()>& check) {
        auto* tabs = find<QTabWidget>(pages);
        for (int i = 0; i < tabs->count(); ++i) {
            QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(i).center());
            SCOPED_TRACE(tabs->tabText(i).toStdString());
            check();
        }
    }
    /// Expects that each button of the banner has the room that it needs, within the banner.
    void expectBannerWhole() {
        QApplication::processEvents();
        const auto* banner = find(u"banner"_s);
        for (const auto* button : banner->findChildren<QAbstractButton*>()) {
            if (!button->isVisible())
                continue;
            EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->text().toStdString();
            EXPECT_LE(button->mapTo(banner, button->rect().bottomRight()).x(), banner->width())
                << button->text().toStdString();
            EXPECT_LE(button->mapTo(banner, button->rect().bottomRight()).y(), banner->height())
                << button->text().toStdString();
        }
    }
};

QList<Message> messages() {
    const QString words = u"The motor of the third axis was told to stop, since nobody knows where it is. "_s;
    QList<Message> list;
    for (const Severity severity : {Severity::Fault, Severity::Attention, Severity::Normal})
        for (const int length : {0, 1, 12})
            for (const int actions : {0, 1, 3}) {
                Message message{.key = u"key%1"_s.arg(list.size() % 5), .severity = severity};
                message.headline = words.repeated(qMax(1, length / 3)).trimmed();
                message.body = words.repeated(length) + (length > 1 ? u"\nAnd so on.\nAnd on."_s : QString());
                for (int i = 0; i < actions; ++i)
                    message.actions.append({static_cast<MessageAction>(i), u"Do this"_s});
                list.append(message);
            }
    return list;
}

TEST_P(Places, OfWhatStartsAMotorStayWhateverIsTold) {
    onEachPage(u"servoPages"_s, [this] {
        const auto before = places();
        ASSERT_TRUE(before.contains(u"enableButton"_s));
        for (const Message& message : messages()) {
            window->showMessage(message);
            EXPECT_EQ(places(), before) << message.headline.size() << ' ' << message.actions.size();
        }
        for (int key = 0; key < 5; ++key) {
            window->endMessage(u"key%1"_s.arg(key));
            EXPECT_EQ(places(), before) << key;
        }
        EXPECT_FALSE(find(u"banner"_s)->isVisible());
    });
}

TEST_P(Places, StayWhateverBecameOfAStop) {
    const auto before = places();
    bus::StopFinished finished;
    for (std::uint8_t i = 0; i < 10; ++i)
        (i % 2 == 0 ? finished.unreached : finished.unconfirmed).push_back(ModuleIndex(i));
    window->showStopResult(finished);
    EXPECT_EQ(places(), before);
    expectBannerWhole();
}

TEST_P(Places, StayWhereAFieldSaysWhatItTakes) {
    for (const QString& name :
         {u"goalField"_s, u"velocityField"_s, u"runVelocityField"_s, u"holdVelocityField"_s}) {
        find(name);  // scrolls to it
        const auto before = places();
        type(name, u"99999999999"_s);
        EXPECT_EQ(places(), before) << name.toStdString();
    }
}

TEST_P(Places, StayWhateverIsForeseen) {
    find(u"goalField"_s);
    const auto before = places();
    for (const QString& goal : {u"0"_s, u"1"_s, u"100"_s, u"-2000000000"_s}) {
        type(u"goalField"_s, goal);
        settle();
        EXPECT_EQ(places(), before) << goal.toStdString();
    }
}

TEST_P(Places, StayWhateverTheModuleSays) {
    const auto before = places();
    for (const Servo& servo : {Servo{.on = false}, Servo{.power = false}, Servo{.moveDone = false},
                               Servo{.position = -2'147'483'647}, Servo{.position = 2'147'483'647}}) {
        showServo(servo);
        EXPECT_EQ(places(), before) << servo.on << servo.power << servo.moveDone << servo.position;
    }
    ModuleState silent = Servo{}.state();
    silent.silent = true;
    window->showLink(connectedTo({silent}));
    EXPECT_EQ(places(), before);
}

TEST_P(Places, OfTheStepperStayToo) {
    showStepper(0x0C, 1'234);  // amplifier enabled, power
    settle();
    for (const QString& mode :
         {u"stepperModeTrapezoidal"_s, u"stepperModeProfile"_s, u"stepperModeTimedRun"_s}) {
        click(mode);
        settle();
        const auto before = places();
        EXPECT_TRUE(before.contains(u"stepperHoldForwardButton"_s));
        for (const Message& message : messages()) {
            window->showMessage(message);
            EXPECT_EQ(places(), before);
        }
        for (const int status : {0x08, 0x2D, 0x4D, 0x04, 0x00, 0x0C}) {
            showStepper(static_cast<std::uint8_t>(status), 1'234);
            EXPECT_EQ(places(), before) << mode.toStdString() << ' ' << status;
        }
        showStepper(0x0C, -2'147'483'647);
        EXPECT_EQ(places(), before);
    }
}

TEST_P(Places, OfWhatActsCanBeScrolledIntoSight) {
    for (const QString& page : {u"servoPanel"_s, u"stepperPanel"_s}) {
        if (page == u"stepperPanel"_s)
            showStepper(0x0C, 1'234);
        for (const Command* command : find<ModulePage>(page)->commands()) {
            QAbstractButton* button = command->button();
            testing_support::turnTo(*button);
            settle();
            testing_support::turnTo(*button);
            EXPECT_TRUE(!button->isVisible() || button->visibleRegion().boundingRect() == button->rect())
                << button->objectName().toStdString();
            EXPECT_TRUE(!button->isVisible() || button->width() >= button->sizeHint().width())
                << button->objectName().toStdString() << ": its words are cut";
        }
    }
}

TEST_P(Places, OfTheActionsOfAMessageAreWithinTheWindow) {
    for (const Message& message :
         {texts::safety(), texts::tripped(ModuleIndex(0), 4000), texts::unaddressed(),
          texts::chainNotAccepted(), texts::fewerThanExpected(2, 3), texts::moduleMissing(ModuleIndex(1), 2),
          texts::linkLost(u"/dev/ttyUSB0"_s, {ModuleIndex(0), ModuleIndex(1)}),
          texts::adapterBack(u"/dev/ttyUSB0"_s, true)}) {
        window->showMessage(message);
        EXPECT_EQ(text(u"bannerHeadline"_s), message.headline);
        expectBannerWhole();
        window->endMessage(message.key);
    }
}

INSTANTIATE_TEST_SUITE_P(Screens, Places,
                         testing::Combine(testing::ValuesIn(allLanguages()),
                                          testing::Values(QSize(1280, 800), QSize(800, 600))),
                         [](const testing::TestParamInfo<Setting>& setting) {
                             return std::get<0>(setting.param) +
                                    std::to_string(std::get<1>(setting.param).width());
                         });

}  // namespace
}  // namespace nmc
