// SPDX-License-Identifier: GPL-3.0-or-later
// A field counts in the chip's numbers, whatever unit it shows.
#include "widgets/common/quantityfield.h"

#include "model/module/servodefaults.h"
#include "widgets/common/words.h"
#include "windowtest.h"

namespace nmc {
namespace {

using Problem = NumberField::Problem;

class Quantities : public testing::Test {
protected:
    QuantityField& shown(QuantityField::Kind kind, const AxisScale& scale) {
        parent = std::make_unique<QWidget>();
        auto* field = new QuantityField(kind, parent.get());
        field->setAccessibleName(u"Speed"_s);
        field->setScale(scale);
        parent->show();
        parent->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(parent.get(), testing_support::kPatienceMs));
        field->setFocus();
        return *field;
    }
    std::unique_ptr<QWidget> parent;
};

/// Lines of common encoders times 4, and steps per millimetre, with common servo rates.
TEST_F(Quantities, NoUnitRefusesALimitThatTheFieldItselfWrites) {
    for (const double counts : {80.0, 400.0, 2'000.0, 2'048.0, 4'000.0, 4'096.0, 8'192.0, 10'000.0})
        for (const int rate : {1, 2, 3, 5, 10, 255}) {
            QuantityField& field =
                shown(QuantityField::Kind::Velocity, AxisScale::servo({UnitKind::Turns, counts}, rate));
            field.setNativeRange(servodefaults::kSmallest, servodefaults::kHoldCap);
            for (const double limit : {servodefaults::kSmallest, servodefaults::kHoldCap}) {
                field.showNative(limit);
                EXPECT_EQ(field.native(), limit) << counts << ' ' << rate << field.text().toStdString();
                const QString written = field.text();
                field.selectAll();
                QTest::keyClicks(&field, written);
                if (field.problem() == Problem::Ambiguous)  // 148.828 may be a group of thousands
                    QTest::keyClick(&field, Qt::Key_Return);
                ASSERT_EQ(field.problem(), Problem::None)
                    << counts << ' ' << rate << field.text().toStdString();
                EXPECT_GE(*field.native(), servodefaults::kSmallest);
                EXPECT_LE(*field.native(), servodefaults::kHoldCap);
            }
        }
}

TEST_F(Quantities, AnArrowKeyIsAsMuchInEveryUnit) {
    const auto up = [this](const AxisScale& scale) {
        QuantityField& field = shown(QuantityField::Kind::Position, scale);
        field.setNativeRange(-1e9, 1e9);
        field.setNativeStep(100);
        field.showNative(0);
        QTest::keyClick(&field, Qt::Key_Up);
        return field.native();
    };
    EXPECT_EQ(up(AxisScale::servo({}, 1)), 100);
    EXPECT_EQ(up(AxisScale::servo({UnitKind::Turns, 2'000}, 1)), 100) << "0.05 turns";
    EXPECT_EQ(up(AxisScale::step({UnitKind::Millimetres, 80})), 80)
        << "1.25 mm is not a round number, 1 mm is";
    EXPECT_EQ(up(AxisScale::servo({UnitKind::Degrees, 10}, 1)), 100) << "10 degrees";
}

/// 10 mm/s cannot be converted to counts per tick while the length of a tick is unknown.
TEST_F(Quantities, NothingPerSecondIsShownOrTakenWhileTheServoRateIsUnknown) {
    QuantityField& field =
        shown(QuantityField::Kind::Velocity, AxisScale::servo({UnitKind::Millimetres, 100}, 1));
    field.setNativeRange(servodefaults::kSmallest, 100);
    field.showNative(0.512);
    EXPECT_EQ(field.text(), QLocale().toString(10)) << "0.512 / 0.000512 s / 100";
    field.setScale(AxisScale::servo({UnitKind::Millimetres, 100}, std::nullopt));
    EXPECT_EQ(field.text(), QString());
    EXPECT_EQ(field.placeholderText(), u"–"_s);
    EXPECT_EQ(field.otherView()->text(), u"= 0.512 counts/tick"_s);
    QTest::keyClicks(&field, u"20"_s);
    QTest::keyClick(&field, Qt::Key_Up);
    EXPECT_EQ(field.text(), QString());
    EXPECT_FALSE(field.native());
    EXPECT_EQ(field.problemText(), texts::refusal(Refusal::ServoRateUnknown));
    EXPECT_EQ(field.accessibleDescription(), field.problemText());
    field.setScale(AxisScale::servo({UnitKind::Millimetres, 100}, 5));
    EXPECT_EQ(field.text(), QLocale().toString(2)) << "SR 5 makes it a fifth";
    EXPECT_EQ(field.native(), 0.512);
    // In the chip's own unit only the other view is unknown.
    field.setScale(AxisScale::servo({}, std::nullopt));
    EXPECT_EQ(field.native(), 0.512);
    EXPECT_EQ(field.otherView()->text(), u"= – counts/s"_s);
}

TEST_F(Quantities, ARangeThatBeginsAboveZeroDoesNotSayZero) {
    QuantityField& field = shown(QuantityField::Kind::Velocity, AxisScale::servo({}, 1));
    field.setQuantity(u"The speed"_s);
    field.setNativeRange(1.0 / 65'536, 32'767);
    QTest::keyClicks(&field, u"0"_s);
    EXPECT_EQ(field.problem(), Problem::OutOfRange);
    // 1/65536 = 0.0000153
    EXPECT_TRUE(field.problemText().contains(u"must be 0.000015 to 32767"_s))
        << field.problemText().toStdString();
}

TEST_F(Quantities, ANumberThatAnotherRangeOrUnitAllowsIsTheValue) {
    QuantityField& speed = shown(QuantityField::Kind::Velocity, AxisScale::servo({}, 1));
    speed.setNativeRange(1, 10);
    speed.showNative(5);
    speed.selectAll();
    QTest::keyClicks(&speed, u"20"_s);
    EXPECT_FALSE(speed.native());
    speed.setNativeRange(1, 100);
    EXPECT_EQ(speed.problem(), Problem::None);
    EXPECT_EQ(speed.native(), 20);
    EXPECT_NE(speed.otherView()->text(), u"–"_s);
    QuantityField& distance =
        shown(QuantityField::Kind::Distance, AxisScale::servo({UnitKind::Turns, 2'000}, 1));
    distance.setNativeRange(1, 2'000);
    distance.showNative(1'000);
    distance.selectAll();
    QTest::keyClicks(&distance, u"5"_s);
    EXPECT_FALSE(distance.native());
    distance.setScale(AxisScale::servo({}, 1));
    EXPECT_EQ(distance.text(), u"5"_s);
    EXPECT_EQ(distance.native(), 5) << "counts, as its label says now";
}

/// 100 counts per mm; the zero is at 1000 counts.
TEST_F(Quantities, APositionCountsFromItsZeroAndStaysTheSamePlace) {
    QuantityField& field =
        shown(QuantityField::Kind::Position, AxisScale::servo({UnitKind::Millimetres, 100}, 1));
    field.setName(u"goalField"_s, u"Goal"_s);
    field.setNativeRange(-5'000, 5'000);
    const WorkZero fixture{{"A", 400}, 1'000};
    field.showNative(2'500);
    field.setZero(fixture);
    EXPECT_EQ(field.text(), u"15"_s);
    EXPECT_EQ(field.native(), 2'500);
    EXPECT_EQ(field.otherView()->text(), u"from \"A\""_s);
    EXPECT_EQ(field.accessibleName(), u"Goal, from \"A\""_s);
    field.selectAll();
    QTest::keyClicks(&field, u"-2"_s);
    EXPECT_EQ(field.native(), 800);
    QTest::keyClicks(&field, u"000"_s);
    EXPECT_TRUE(field.problemText().endsWith(u"-60 to 40 mm from \"A\"."_s))
        << field.problemText().toStdString();
    field.setZero({});
    EXPECT_EQ(field.text(), QString()) << "-2000 would be allowed from elsewhere";
    EXPECT_EQ(field.otherView()->text(), u"–"_s);
    field.showNative(800);
    field.setZero(fixture, true);
    EXPECT_EQ(field.text(), u"8"_s) << "the number stays";
    EXPECT_EQ(field.native(), 1'800);
    // The counter was set 700 lower: 8 mm from A is where it was.
    field.setZero(WorkZero{{"A", 400}, 300});
    EXPECT_EQ(field.text(), u"8"_s);
    EXPECT_EQ(field.native(), 1'100);
    // What is called A is 2 mm farther now: the place stays.
    field.setZero(WorkZero{{"A", 600}, 500});
    EXPECT_EQ(field.text(), u"6"_s);
    EXPECT_EQ(field.native(), 1'100);
}

TEST_F(Quantities, WithoutAKnownZeroThereIsNoPosition) {
    QuantityField& field = shown(QuantityField::Kind::Position, AxisScale::servo({}, 1));
    field.setNativeRange(-5'000, 5'000);
    field.showNative(2'500);
    field.setZero(WorkZero{{"A", 0}, std::nullopt});
    QTest::keyClicks(&field, u"7"_s);
    EXPECT_EQ(field.text(), QString());
    EXPECT_FALSE(field.native());
    EXPECT_TRUE(field.problemText().startsWith(u"It is not known any more where \"A\" is."_s));
    field.setZero(WorkZero{{"A", 0}, 1'000});
    EXPECT_EQ(field.text(), QString()) << "it is not the place of before";
    QTest::keyClicks(&field, u"7"_s);
    EXPECT_EQ(field.native(), 1'007);
}

}  // namespace
}  // namespace nmc
