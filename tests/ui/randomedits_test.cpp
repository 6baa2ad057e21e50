// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is edited in whatever order, each module has what was typed into it and nothing else.
#include "ownsettings.h"

#include <random>

#include "model/intent/homingplan.h"
#include "model/module/modulescale.h"
#include "widgets/common/look.h"
#include "widgets/panels/gainsmeaning.h"

namespace nmc {
namespace {

/// Edits everything that can be edited, at random, and knows what the result should be.
class RandomEdits : public OwnSettings, public testing::WithParamInterface<unsigned> {
protected:
    RandomEdits() {
        for (std::size_t i = 0; i < 4; ++i) {
            gains.push_back(someGains());
            parameters.push_back(Stepper::parameters());
        }
        expected.axes.resize(4);
    }

    template <typename T>
    const T& any(const std::vector<T>& all) {
        return all[std::uniform_int_distribution<std::size_t>(0, all.size() - 1)(random)];
    }
    bool coin() { return std::uniform_int_distribution(0, 1)(random) == 1; }
    AxisSettings& axis() { return expected.axes.at(static_cast<std::size_t>(selected())); }
    const ModuleState& module() { return modules.at(static_cast<std::size_t>(selected())); }
    AxisScale scale() { return scaleOf(module(), axis()); }
    HomingRecipe& recipe() {
        if (!axis().homing)
            axis().homing = firstRecipe(module().info.identity);
        return *axis().homing;
    }
    QString named(const QString& name) { return look::nameFor(module().info.identity.type, name); }

    enum class Amount { Plain, Position, Velocity, Acceleration };
    double native(Amount amount, double typed) {
        switch (amount) {
            case Amount::Plain:
                return typed;
            case Amount::Position:
                return std::round(scale().counts(typed));
            case Amount::Velocity:
                return *scale().nativeVelocity(typed);
            case Amount::Acceleration:
                return *scale().nativeAcceleration(typed);
        }
        return typed;
    }
    /// Types one of the numbers; `keep` gets each value that the field has on the way.
    void number(const QString& name, Amount amount, const std::vector<QString>& numbers,
                const std::function<void(double)>& keep) {
        done = name;
        const auto* target = reach<NumberField>(name);
        if (!target->isEnabled())
            return;
        typeOver(name, any(numbers), [&] {
            if (const auto value = target->value())
                keep(native(amount, *value));
        });
    }
    void word(const QString& name, std::string& part) {
        done = name;
        typeOver(name, any(std::vector<QString>{u"X"_s, u"Z2"_s, u"kg"_s}),
                 [&] { part = find<QLineEdit>(name)->text().toStdString(); });
    }

    void editMotion() {
        MotionSettings& motion = axis().motion;
        const auto amount = any(std::vector<int>{0, 1, 2, 3, 4, 5});
        const std::vector<QString> speeds =
            servo() ? std::vector{u"2"_s, u"3.5"_s, u"1,25"_s} : std::vector{u"300"_s, u"45.5"_s, u"70"_s};
        if (!servo() && amount < 4) {
            press(any(std::vector{u"stepperModeTrapezoidal"_s, u"stepperModeProfile"_s,
                                  u"stepperModeTimedMove"_s}));
            const bool run = button(u"stepperModeProfile"_s)->isChecked();
            return number(u"stepperSpeedField"_s, Amount::Velocity, speeds,
                          [&](double speed) { (run ? motion.runVelocity : motion.velocity) = speed; });
        }
        switch (amount) {
            case 0:
                return number(u"velocityField"_s, Amount::Velocity, speeds,
                              [&](double v) { motion.velocity = v; });
            case 1:
                return number(u"accelerationField"_s, Amount::Acceleration, speeds,
                              [&](double a) { motion.acceleration = a; });
            case 2:
                return number(u"runVelocityField"_s, Amount::Velocity, speeds,
                              [&](double v) { motion.runVelocity = v; });
            case 3:
                return number(u"moveByDistanceField"_s, Amount::Position, {u"20"_s, u"7"_s},
                              [&](double d) { motion.stepSize = d; });
            default:  // only typed, and not kept
                return number(
                    any(servo() ? std::vector{u"goalField"_s, u"holdVelocityField"_s}
                                : std::vector{u"stepperGoalField"_s, u"stepperHoldVelocityField"_s}),
                    Amount::Plain, {u"12"_s, u"150"_s}, [](double) {});
        }
    }

    void editAxis() {
        openPage(u"Axis"_s);
        switch (any(std::vector<int>{0, 1, 2, 3, 4, 5, 6})) {
            case 0:
                return word(named(u"axisNameField"_s), axis().name);
            case 1:
                return word(named(u"analogUnitField"_s), axis().analog.unit);
            case 2:
                return number(named(u"analogPerCountField"_s), Amount::Plain, {u"0.02"_s, u"-3"_s},
                              [&](double n) { axis().analog.perCount = n; });
            case 3:
                return number(named(u"analogAtZeroField"_s), Amount::Plain, {u"1,5"_s, u"-2"_s},
                              [&](double n) { axis().analog.atZero = n; });
            case 4:
                return servo() ? number(u"holdCapField"_s, Amount::Velocity, {u"4"_s, u"2.75"_s},
                                        [&](double cap) { axis().motion.holdCap = cap; })
                               : editSymbol();
            case 5:
                return editSymbol();
            default:
                return editUnit();
        }
    }
    void editUnit() {
        static const std::vector<QString> units{u"native counts"_s, u"turns"_s, u"degrees"_s,
                                                u"millimetres"_s, u"custom unit"_s};
        done = u"unit"_s;
        const QString unit = any(units);
        choose(named(u"axisUnitBox"_s), unit);
        // The keys pass the first unit, which has no counts per unit.
        axis().unit.kind = static_cast<UnitKind>(units.size() - 1);
        for (std::size_t i = 0; i < units.size(); ++i)
            if (units[i] == unit)
                axis().unit.kind = static_cast<UnitKind>(i);
        axis().unit.countsPerUnit = 1.0;
        if (axis().unit.kind != UnitKind::Native)
            number(named(u"countsPerUnitField"_s), Amount::Plain, {u"2000"_s, u"80"_s, u"12.5"_s},
                   [&](double n) { axis().unit.countsPerUnit = n; });
    }
    void editSymbol() {
        if (axis().unit.kind == UnitKind::Own)
            word(named(u"axisSymbolField"_s), axis().unit.ownSymbol);
    }

    void editHoming() {
        openPage(u"Homing"_s);
        const int what = any(std::vector<int>{0, 1, 2, 3, 4, 5});
        if (what < 2)
            return editConditions();
        if (what == 2)
            return editDirection();
        const std::vector<QString> numbers{u"300"_s, u"45.5"_s, u"70"_s};
        const auto keep = [this](double HomingRecipe::*part) {
            return [this, part](double n) { recipe().*part = n; };
        };
        // A recipe is kept completely, as it is shown.
        recipe();
        if (what == 3)
            number(named(u"homingTravelField"_s), Amount::Position, numbers,
                   keep(&HomingRecipe::travelLimit));
        else if (what == 4)
            number(named(u"homingVelocityField"_s), Amount::Velocity, numbers, keep(&HomingRecipe::velocity));
        else if (coin())
            number(named(u"homingTimeField"_s), Amount::Plain, numbers, keep(&HomingRecipe::timeLimit));
        else
            number(named(u"homingAccelerationField"_s), Amount::Acceleration, numbers,
                   keep(&HomingRecipe::acceleration));
    }
    void editConditions() {
        using Flag = std::pair<QString, bool HomingRecipe::*>;
        std::vector<Flag> flags{{u"onLimit1Box"_s, &HomingRecipe::onLimit1},
                                {u"onLimit2Box"_s, &HomingRecipe::onLimit2},
                                {u"goToHomeBox"_s, &HomingRecipe::goToHome},
                                {u"makeZeroBox"_s, &HomingRecipe::makeZero}};
        if (servo())
            flags.insert(flags.end(), {{u"onIndexBox"_s, &HomingRecipe::onIndex},
                                       {u"onPositionErrorBox"_s, &HomingRecipe::onPositionError},
                                       {u"onCurrentLimitBox"_s, &HomingRecipe::onCurrentLimit},
                                       {u"thenIndexBox"_s, &HomingRecipe::thenIndex}});
        else
            flags.push_back({u"onHomeSwitchBox"_s, &HomingRecipe::onHomeSwitch});
        const auto& [name, flag] = any(flags);
        done = name;
        if (press(named(name)))
            recipe().*flag = !(recipe().*flag);
    }
    void editDirection() {
        using Choice = std::pair<QString, std::function<void(HomingRecipe&)>>;
        const std::vector<Choice> choices{
            {u"homingForwardButton"_s, [](HomingRecipe& r) { r.reverse = false; }},
            {u"homingReverseButton"_s, [](HomingRecipe& r) { r.reverse = true; }},
            {u"homingAbruptlyButton"_s, [](HomingRecipe& r) { r.stop = HomingRecipe::Stop::Abruptly; }},
            {u"homingSmoothlyButton"_s, [](HomingRecipe& r) { r.stop = HomingRecipe::Stop::Smoothly; }},
            {u"homingMotorOffButton"_s, [](HomingRecipe& r) { r.stop = HomingRecipe::Stop::Off; }}};
        const auto& [name, choose] = any(choices);
        done = name;
        if (!button(named(name))->isChecked() && press(named(name)))
            choose(recipe());
    }

    void editGains() {
        openPage(u"Gains"_s);
        servo::SetGain& mine = gains.at(static_cast<std::size_t>(selected()));
        const int what = any(std::vector<int>{0, 1, 2, 3, 4, 5});
        if (what > 0) {
            const Gain gain = any(std::vector<Gain>(kAllGains.begin(), kAllGains.end()));
            const QString name = gainLetters(gain).toLower() + u"Field"_s;
            QString before = field(name)->text();
            return number(name, Amount::Plain, {u"21"_s, u"7"_s, u"113"_s}, [&](double value) {
                setGain(mine, gain, static_cast<int>(value));
                // Typing the same number is not an edit.
                if (std::exchange(before, field(name)->text()) != field(name)->text())
                    axis().gains = mine;
            });
        }
        // What these buttons do to the gains is tested elsewhere; they do nothing to anything else.
        done = any(std::vector{u"fillGainsButton"_s, u"zeroGainsButton"_s, u"undoGainsButton"_s,
                               u"redoGainsButton"_s, u"revertGainsButton"_s});
        press(done);
        axis().gains = machine.axes.at(static_cast<std::size_t>(selected())).gains;
        mine = axis().gains.value_or(mine);
    }

    void editParameters() {
        openPage(u"Parameters"_s);
        stepper::SetParameters& mine = parameters.at(static_cast<std::size_t>(selected()));
        const auto tick = [&](const QString& name, bool stepper::SetParameters::*flag) {
            done = name;
            if (press(name))
                mine.*flag = !(mine.*flag);
        };
        switch (any(std::vector<int>{0, 1, 2, 3, 4, 5, 6})) {
            case 0:
                tick(u"stepperIgnoreLimitsField"_s, &stepper::SetParameters::ignoreLimits);
                break;
            case 1:
                tick(u"stepperMotorOffOnStopField"_s, &stepper::SetParameters::motorOffOnLimitOrEstop);
                break;
            case 2:
                return number(u"stepperAccelerationTimeField"_s, Amount::Plain, {u"30"_s, u"7"_s},
                              [&](double time) { axis().accelerationTime = time; });
            case 3:
                return number(u"stepperHoldCapField"_s, Amount::Velocity, {u"700"_s, u"45.5"_s},
                              [&](double cap) { axis().motion.holdCap = cap; });
            case 4:
                return number(u"stepperRunCurrentField"_s, Amount::Plain, {u"90"_s, u"7"_s}, [&](double n) {
                    mine.runCurrent = static_cast<std::uint8_t>(n);
                    axis().parameters = mine;
                });
            case 5:
                return number(u"stepperThermalLimitField"_s, Amount::Plain, {u"60"_s, u"8"_s}, [&](double n) {
                    mine.thermalLimit = static_cast<std::uint8_t>(n);
                    axis().parameters = mine;
                });
            default:
                return number(u"stepperHoldCurrentField"_s, Amount::Plain, {u"35"_s, u"5"_s}, [&](double n) {
                    mine.holdCurrent = static_cast<std::uint8_t>(n);
                    axis().parameters = mine;
                });
        }
        axis().parameters = mine;
    }

    void editNames() {
        openPage(u"I/O"_s);
        const std::size_t number = any(std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6});
        if (number < 5)
            word(u"stepperOutput%1Name"_s.arg(number + 1), axis().outputNames.at(number));
        else
            word(u"stepperInput%1Name"_s.arg(number - 4), axis().inputNames.at(number - 5));
    }

    void selectAnother() {
        if (coin()) {
            done = u"a click on another module"_s;
            clickModule(any(std::vector<int>{0, 1, 2, 3}));
            return;
        }
        done = u"a key in the list of modules"_s;
        list->setFocus(Qt::TabFocusReason);
        QTest::keyClick(list, any(std::vector{Qt::Key_Up, Qt::Key_Down, Qt::Key_Home}));
    }

    /// Shows new statuses of all modules.
    void hearNews() {
        done = u"a status"_s;
        for (ModuleState& module : modules)
            module.latestTime += std::chrono::milliseconds(20);
        window->showLink(connectedTo(modules));
    }

    void step() {
        switch (any(std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8})) {
            case 0:
                return editMotion();
            case 1:
            case 2:
                return editAxis();
            case 3:
            case 4:
                return editHoming();
            case 5:
                return servo() ? editGains() : editParameters();
            case 6:
                return servo() ? hearNews() : editNames();
            default:
                return selectAnother();
        }
    }

    std::mt19937 random{GetParam()};
    Machine expected;
    std::vector<servo::SetGain> gains;               ///< as shown in the fields, by module
    std::vector<stepper::SetParameters> parameters;  ///< as shown in the fields, by module
    QString done;
};

TEST_P(RandomEdits, EachModuleHasWhatWasTypedIntoItAndNothingElse) {
    for (int i = 0; i < 200; ++i) {
        const int module = selected();
        step();
        ASSERT_EQ(writeMachine(machine), writeMachine(expected))
            << "seed " << GetParam() << ", step " << i << ", module " << module + 1 << ": "
            << done.toStdString();
        ASSERT_FALSE(HasFatalFailure());
    }
    EXPECT_EQ(intents.size(), 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEdits, testing::Range(1U, 5U));

}  // namespace
}  // namespace nmc
