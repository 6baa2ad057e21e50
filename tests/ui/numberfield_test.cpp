// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/numberfield.h"

#include "inlanguage.h"
#include "tests/support/motionof.h"
#include "windowtest.h"

namespace nmc {
namespace {

using Problem = NumberField::Problem;

/// All rules hold in every locale of the user.
class NumberFieldIn : public testing::TestWithParam<const char*> {
protected:
    NumberFieldIn() { QLocale::setDefault(QLocale(QLatin1StringView(GetParam()))); }
    ~NumberFieldIn() override { QLocale::setDefault(QLocale::c()); }

    NumberField& shown(int decimals = 3) {
        field = std::make_unique<NumberField>(decimals);
        field->setRange(-1000, 1000);
        field->setAccessibleName(u"Speed"_s);
        field->setWords(u"The speed"_s, u"counts/tick"_s);
        field->show();
        field->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(field.get(), testing_support::kPatienceMs));
        field->setFocus();
        return *field;
    }
    std::optional<double> typed(const QString& text) {
        NumberField& target = shown();
        QTest::keyClicks(&target, text);
        return target.value();
    }
    std::unique_ptr<NumberField> field;
};

TEST_P(NumberFieldIn, U02_BothMarksAreTheDecimalMark) {
    EXPECT_EQ(typed(u"2.75"_s), 2.75);
    EXPECT_EQ(typed(u"2,75"_s), 2.75);
    EXPECT_EQ(typed(u"-0,5"_s), -0.5);
    EXPECT_EQ(typed(u"+3"_s), 3.0);
    EXPECT_EQ(typed(u",5"_s), 0.5);
}

TEST_P(NumberFieldIn, U02_TwoMarksAreRefusedNeverMultiplied) {
    for (const QString& text : {u"1.234,5"_s, u"1,234.5"_s, u"1.2.3"_s, u"1,,2"_s}) {
        EXPECT_EQ(typed(text), std::nullopt) << text.toStdString();
        EXPECT_EQ(field->problem(), Problem::TwoMarks);
        EXPECT_EQ(field->text(), text);
    }
}

TEST_P(NumberFieldIn, U02_AWholeNumberHasNoMark) {
    for (const QString& text : {u"10,000"_s, u"10.000"_s, u"1,200"_s, u"2.0"_s, u"3,"_s, u"1,000,000"_s}) {
        NumberField& target = shown(0);
        target.setRange(-1e9, 1e9);
        QTest::keyClicks(&target, text);
        EXPECT_EQ(target.value(), std::nullopt) << text.toStdString();
        EXPECT_EQ(target.problem(), Problem::NotWhole) << text.toStdString();
        EXPECT_EQ(target.text(), text) << "it stays as typed";
    }
}

TEST_P(NumberFieldIn, U02_WhatCanBeReadInTwoWaysHasNoValueUntilEnterHasShownIt) {
    for (const QString& text : {u"1,234"_s, u"1.234"_s, u"-12,500"_s, u"+999.000"_s}) {
        EXPECT_EQ(typed(text), std::nullopt) << text.toStdString();
        EXPECT_EQ(field->problem(), Problem::Ambiguous);
        EXPECT_TRUE(field->toolTip().startsWith(field->problemText()));
        QSignalSpy entered(field.get(), &QLineEdit::returnPressed);
        QTest::keyClick(field.get(), Qt::Key_Return);
        EXPECT_EQ(entered.size(), 0) << "what Enter starts must wait until the value was seen";
        EXPECT_TRUE(field->text().endsWith(u'0'));
        EXPECT_EQ(field->value(), text.startsWith(u'1') ? 1.234 : text.startsWith(u'-') ? -12.5 : 999.0);
        QTest::keyClick(field.get(), Qt::Key_Return);
        EXPECT_EQ(entered.size(), 1);
    }
}

TEST_P(NumberFieldIn, U02_SaysBothReadings) {
    typed(u"1,234"_s);
    const QString fraction = u"1"_s + (QLocale().decimalPoint() == u","_s ? u',' : u'.') + u"2340"_s;
    EXPECT_EQ(
        field->problemText(),
        u"The speed: 1,234 can be read in two ways. Press Enter in the field for %1, or type 1234."_s.arg(
            fraction));
    QTest::keyClick(field.get(), Qt::Key_Return);
    EXPECT_EQ(field->text(), fraction);
}

TEST_P(NumberFieldIn, U02_WhatCanBeReadInOneWayOnlyNeedsNoSecondEnter) {
    // No group begins with 0, has more than three digits, or is mixed with another mark.
    EXPECT_EQ(typed(u"0,125"_s), 0.125);
    EXPECT_EQ(typed(u"1.2340"_s), 1.234);
    EXPECT_EQ(typed(u"1,23"_s), 1.23);
    EXPECT_EQ(typed(u"1 000.000"_s), 1000.0);
    // A value that the field itself shows is not ambiguous.
    NumberField& target = shown();
    target.showValue(1.234);
    EXPECT_EQ(target.value(), 1.234);
}

TEST_P(NumberFieldIn, ReadsBackWhatItShows) {
    NumberField& target = shown();
    for (double value : {2.75, -0.125, 0.0, 999.5, 0.0005, 0.0002, -0.000031}) {
        target.showValue(value);
        EXPECT_EQ(target.value(), value);
    }
}

TEST_P(NumberFieldIn, U02_PastedTextFollowsTheSameRules) {
    NumberField& target = shown();
    QApplication::clipboard()->setText(u"2,75"_s);
    target.paste();
    EXPECT_EQ(target.value(), 2.75);
}

/// Whatever the panel writes can be copied from it.
TEST_P(NumberFieldIn, U02_ReadsTheGroupsAndTheMinusThatThePanelWrites) {
    for (const char16_t space : {u' ', u'\u00a0', u'\u2009', u'\u202f'}) {
        NumberField& target = shown();
        QApplication::clipboard()->setText(u"\u22121"_s + QChar(space) + u"000"_s);
        target.paste();
        EXPECT_EQ(target.value(), -1000) << target.text().toStdString();
    }
}

TEST_P(NumberFieldIn, U03_RefusesWhatIsNoNumber) {
    for (const QString& text : {u"abc"_s, u"1e3"_s, u"nan"_s, u"inf"_s, u"0x10"_s, u"1 00"_s, u"1 0000"_s,
                                u"1  000"_s, u"1 000 00"_s, u"1000 200"_s, u"250\t100"_s, u"250\n100"_s,
                                u"--1"_s, u"-"_s, u"."_s, u"٣"_s, u"1\u202e2"_s}) {
        Problem problem = Problem::None;
        EXPECT_EQ(NumberField::parse(text, false, &problem), std::nullopt) << text.toStdString();
        EXPECT_NE(problem, Problem::None);
    }
}

TEST_P(NumberFieldIn, U03_AHugePasteIsNoValue) {
    NumberField& target = shown();
    QApplication::clipboard()->setText(QString(5'000'000, u'9'));
    target.paste();
    EXPECT_EQ(target.value(), std::nullopt);
    EXPECT_LT(target.text().size(), 64);
}

TEST_P(NumberFieldIn, U01_OutOfRangeSaysTheRangeAndKeepsTheText) {
    EXPECT_EQ(typed(u"1000,5"_s), std::nullopt);
    EXPECT_EQ(field->problem(), Problem::OutOfRange);
    EXPECT_EQ(field->text(), u"1000,5"_s);
    EXPECT_TRUE(field->toolTip().contains(u"The speed must be -1000 to 1000 counts/tick."_s))
        << field->toolTip().toStdString();
    EXPECT_EQ(field->accessibleDescription(), field->problemText());
}

TEST_P(NumberFieldIn, WholeNumbersAreNotRounded) {
    NumberField& target = shown(0);
    QTest::keyClicks(&target, u"2.75"_s);
    EXPECT_EQ(target.value(), std::nullopt);
    EXPECT_EQ(target.problem(), Problem::NotWhole);
}

INSTANTIATE_TEST_SUITE_P(Locales, NumberFieldIn,
                         testing::Values("de_DE", "en_US", "fr_FR", "es_ES", "ja_JP", "de_CH", "ar_EG",
                                         "hi_IN"));

/// This has happened: with the servo on at 0, ten thousand was meant, and ten was sent.
class AmbiguousNumbers : public testing::WithParamInterface<std::string>,
                         public InLanguage,
                         public WindowTest {
protected:
    AmbiguousNumbers() : InLanguage(GetParam()) {}
    void enter(const QString& name, const QString& text) {
        type(name, text);
        QTest::keyClick(field(name), Qt::Key_Return);
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_P(AmbiguousNumbers, U02_TenThousandIsNeverTen) {
    showServo();
    for (const QString& text : {u"10,000"_s, u"10.000"_s}) {
        enter(u"goalField"_s, text);
        EXPECT_FALSE(button(u"goButton"_s)->isEnabled());
        EXPECT_EQ(button(u"goButton"_s)->toolTip(), field(u"goalField"_s)->problemText());
        EXPECT_EQ(this->text(u"motionHint"_s), field(u"goalField"_s)->problemText());
        for (const QString& gain : {u"kdField"_s, u"elField"_s, u"kpField"_s}) {
            enter(gain, u"1"_s + text.mid(2));
            EXPECT_FALSE(button(u"applyGainsButton"_s)->isEnabled()) << gain.toStdString();
            field(gain)->showValue(1);
        }
    }
    EXPECT_EQ(intents.size(), 0);
    enter(u"goalField"_s, u"10 000"_s);
    ASSERT_EQ(intents.size(), 1);
    EXPECT_EQ(test::motionOf<servomotion::Trapezoid>(intents.at(0).at(1).value<Intent>()).position.value(),
              10'000);
}

TEST_P(AmbiguousNumbers, U02_AFractionIsShownBeforeItIsSent) {
    int now = 0;
    for (const QString& text : {u"1,250"_s, u"1.250"_s}) {
        showServo({.millisecond = now += 20});
        intents.clear();
        type(u"velocityField"_s, text);
        EXPECT_FALSE(button(u"goButton"_s)->isEnabled());
        enter(u"goalField"_s, u"200"_s);
        enter(u"runVelocityField"_s, text);
        EXPECT_EQ(intents.size(), 0) << "neither by another field nor by its own";
        QTest::keyClick(field(u"velocityField"_s), Qt::Key_Return);
        EXPECT_TRUE(field(u"velocityField"_s)->text().endsWith(u"2500"_s));
        enter(u"goalField"_s, u"200"_s);
        ASSERT_EQ(intents.size(), 1);
        // 1.25 x 65536
        EXPECT_EQ(
            test::motionOf<servomotion::Trapezoid>(intents.at(0).at(1).value<Intent>()).velocity.value(),
            81'920U);
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, AmbiguousNumbers, testing::ValuesIn(allLanguages()),
                         [](const auto& language) { return language.param; });

class NumberFieldWheel : public WindowTest {
protected:
    static void turn(QWidget* widget, int notches) {
        const QPointF centre = QRectF(widget->rect()).center();
        QWheelEvent event(centre, widget->mapToGlobal(centre), {}, QPoint(0, 120 * notches), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &event);
    }
};

TEST_F(NumberFieldWheel, DoesNothingInAFieldWithoutFocus) {
    showServo();
    field(u"kpField"_s)->setFocus();
    const QString before = field(u"velocityField"_s)->text();
    turn(field(u"velocityField"_s), 3);
    EXPECT_EQ(field(u"velocityField"_s)->text(), before);
    EXPECT_FALSE(field(u"velocityField"_s)->hasFocus());
}

TEST_F(NumberFieldWheel, StepsTheFocusedFieldAndStopsAtItsRange) {
    showServo();
    NumberField* sr = field(u"srField"_s);
    type(u"srField"_s, u"2"_s);
    turn(sr, -1);
    EXPECT_EQ(sr->value(), 1);
    turn(sr, -1);
    EXPECT_EQ(sr->value(), 1);
    QTest::keyClick(sr, Qt::Key_Up);
    EXPECT_EQ(sr->value(), 2);
}

TEST_F(NumberFieldWheel, MarksABadFieldWithAShapeNotOnlyAColour) {
    showServo();
    const auto orange = [this] {
        const QImage image = field(u"goalField"_s)->grab().toImage();
        int count = 0;
        for (int x = 0; x < image.height(); ++x)
            for (int y = image.height() / 4; y < image.height() * 3 / 4; ++y)
                count += image.pixelColor(x, y) == QColor(0xE6, 0x9F, 0x00) ? 1 : 0;
        return count;
    };
    QApplication::processEvents();  // performs the layout
    EXPECT_EQ(orange(), 0);
    type(u"goalField"_s, u"99999999999"_s);
    EXPECT_GT(orange(), 20) << "the triangle at the left of the field";
    EXPECT_FALSE(text(u"motionHint"_s).isEmpty());
}

}  // namespace
}  // namespace nmc
