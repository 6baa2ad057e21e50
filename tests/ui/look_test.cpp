// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/look.h"

#include <QApplication>
#include <QPainter>

#include "widgets/common/glyphs.h"
#include "widgets/common/icons.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Look : public testing::TestWithParam<bool> {
protected:
    QPalette palette = GetParam() ? darkPalette() : QApplication::palette();
};

TEST_P(Look, TextContrastIsFourAndAHalf) {
    const QColor window = palette.color(QPalette::Window);
    const QColor base = palette.color(QPalette::Base);
    EXPECT_GE(look::contrast(look::mutedText(palette), window), 4.5);
    EXPECT_GE(look::contrast(look::mutedText(palette), base), 4.5);
    for (Severity severity : {Severity::Normal, Severity::Attention, Severity::Fault}) {
        EXPECT_GE(look::contrast(palette.color(QPalette::WindowText), look::severityTint(severity, palette)),
                  4.5);
        EXPECT_GE(
            look::contrast(look::onSeverityFill(severity, palette), look::severityFill(severity, palette)),
            4.5);
    }
}

TEST_P(Look, TracesStandOutFromTheirBackground) {
    for (int trace = 0; trace < look::kTraceColours; ++trace)
        EXPECT_GE(look::contrast(look::traceColour(trace, palette), palette.color(QPalette::Base)), 3.0);
}

TEST_P(Look, EachStateHasAShapeOfItsOwn) {
    QList<QImage> seen;
    for (int a = 0; a <= static_cast<int>(Activity::Decelerating); ++a) {
        const auto activity = static_cast<Activity>(a);
        QImage image(48, 48, QImage::Format_ARGB32_Premultiplied);
        image.fill(palette.color(QPalette::Window));
        QPainter painter(&image);
        paintActivity(painter, QRectF(4, 4, 40, 40), activity, palette);
        painter.end();
        // In grey: the shape alone must do.
        image = image.convertToFormat(QImage::Format_Grayscale8);
        for (const QImage& other : seen)
            EXPECT_NE(image, other) << a;
        seen << image;
    }
}

INSTANTIATE_TEST_SUITE_P(Palettes, Look, testing::Bool(), [](const testing::TestParamInfo<bool>& dark) {
    return dark.param ? "Dark" : "Light";
});

class LookOfWindow : public WindowTest {};

TEST_F(LookOfWindow, QuietTextFollowsThePaletteOfTheMoment) {
    showServo();
    window->setPalette(darkPalette());
    QApplication::processEvents();
    for (const QString& name : {u"moduleType"_s, u"velocityFieldPerSecond"_s, u"kpState"_s}) {
        const QColor colour = find<QLabel>(name)->palette().color(QPalette::WindowText);
        EXPECT_GE(look::contrast(colour, darkPalette().color(QPalette::Window)), 4.5) << name.toStdString();
    }
}

TEST_F(LookOfWindow, WhatStandsInAnEmptyFieldIsReadable) {
    showServo({.gains = false});
    const NumberField* kp = field(u"kpField"_s);
    ASSERT_EQ(kp->placeholderText(), u"unknown"_s);
    for (const QPalette& palette : {QApplication::palette(), darkPalette()}) {
        window->setPalette(palette);
        QApplication::processEvents();
        for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
            EXPECT_GE(look::contrast(kp->palette().color(group, QPalette::PlaceholderText),
                                     kp->palette().color(group, QPalette::Base)),
                      4.5)
                << group;
    }
}

TEST_F(LookOfWindow, EveryIconIsThere) {
    for (const QAbstractButton* control : window->findChildren<QAbstractButton*>()) {
        if (control->icon().isNull() || control->objectName().isEmpty())
            continue;
        const QImage image = control->icon().pixmap(32, 32).toImage();
        ASSERT_FALSE(image.isNull()) << control->objectName().toStdString();
        bool painted = false;
        for (int x = 0; x < image.width(); ++x)
            for (int y = 0; y < image.height(); ++y)
                painted = painted || image.pixelColor(x, y).alpha() > 128;
        EXPECT_TRUE(painted) << control->objectName().toStdString();
    }
}

TEST(LookOfDigits, DoNotDance) {
    const QFontMetricsF metrics(look::tabular(QFont(u"DejaVu Serif"_s)));
    for (char16_t digit = u'0'; digit <= u'9'; ++digit)
        EXPECT_NEAR(metrics.horizontalAdvance(QChar(digit)), metrics.horizontalAdvance(u'0'), 0.01);
}

}  // namespace
}  // namespace nmc
