// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/look.h"

#include "widgets/common/elidedlabel.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/icons.h"
#include "widgets/common/palettes.h"
#include "windowtest.h"

namespace nmc {
namespace {

/// Colours of the program, or those of the desktop on which the tests run.
struct Named {
    const char* name;
    look::Colours colours;
};
void PrintTo(const Named& named, std::ostream* out) {
    *out << named.name;
}

class Look : public testing::TestWithParam<Named> {
protected:
    /// The palette as it is in a window.
    static QPalette inWindow(const QPalette& palette) {
        QWidget widget;
        widget.setPalette(palette);
        look::adoptReadable(&widget);
        return widget.palette();
    }
    [[nodiscard]] QColor of(QPalette::ColorRole role, QPalette::ColorGroup group = QPalette::Active) const {
        return palette.color(group, role);
    }
    QPalette palette =
        inWindow(GetParam().colours == look::Colours::System ? QApplication::palette()
                                                             : look::paletteOf(GetParam().colours));
    double least =
        GetParam().colours == look::Colours::HighContrast ? 7.0 : 4.5;  // WCAG 2.1, 1.4.6 and 1.4.3
};

/// The formula of WCAG 2.1 ("relative luminance", "contrast ratio"), calculated by hand for two greys and a
/// red.
TEST(LookOfContrast, IsThatOfWcag) {
    EXPECT_NEAR(look::contrast(Qt::white, Qt::black), 21.0, 1e-9);
    EXPECT_NEAR(look::contrast(QColor(0x77, 0x77, 0x77), Qt::white), 4.478, 0.001);
    EXPECT_NEAR(look::contrast(Qt::red, Qt::white), (1.0 + 0.05) / (0.2126 + 0.05), 1e-6);
}

TEST_P(Look, TextHasItsContrastOnWhateverItStands) {
    struct Pair {
        QPalette::ColorRole text, ground;
    };
    for (const auto group : {QPalette::Active, QPalette::Inactive})
        for (const Pair& pair : {Pair{QPalette::WindowText, QPalette::Window},
                                 {QPalette::WindowText, QPalette::Base},
                                 {QPalette::Text, QPalette::Base},
                                 {QPalette::Text, QPalette::AlternateBase},
                                 {QPalette::ButtonText, QPalette::Button},
                                 {QPalette::ToolTipText, QPalette::ToolTipBase},
                                 {QPalette::HighlightedText, QPalette::Highlight},
                                 {QPalette::PlaceholderText, QPalette::Base}})
            EXPECT_GE(look::contrast(of(pair.text, group), of(pair.ground, group)),
                      pair.text == QPalette::HighlightedText ? 4.5 : least)
                << group << ' ' << pair.text << ' ' << pair.ground;
}

/// Labels of plots and statuses are in Text or in the muted colour.
TEST_P(Look, QuietTextHasItToo) {
    for (const auto ground : {QPalette::Window, QPalette::Base})
        EXPECT_GE(look::contrast(look::mutedText(palette), of(ground)), least) << ground;
    EXPECT_GE(look::contrast(look::mutedText(palette), look::selectionTint(palette)), 4.5);
    EXPECT_GE(look::contrast(of(QPalette::Text), look::selectionTint(palette)), 4.5);
}

TEST_P(Look, KindsOfMessagesHaveItToo) {
    for (Severity severity : {Severity::Normal, Severity::Attention, Severity::Fault}) {
        EXPECT_GE(look::contrast(of(QPalette::WindowText), look::severityTint(severity, palette)), 4.5);
        EXPECT_GE(
            look::contrast(look::onSeverityFill(severity, palette), look::severityFill(severity, palette)),
            4.5);
    }
}

/// WCAG requires nothing of it; it is readable nevertheless, and can be distinguished from enabled text.
TEST_P(Look, DisabledTextIsQuieterAndStillThere) {
    if (GetParam().colours == look::Colours::System)
        return;  // this is up to the desktop
    for (const auto& [text, ground] :
         {std::pair{QPalette::WindowText, QPalette::Window}, std::pair{QPalette::Text, QPalette::Base},
          std::pair{QPalette::ButtonText, QPalette::Button}}) {
        const double disabled = look::contrast(of(text, QPalette::Disabled), of(ground, QPalette::Disabled));
        EXPECT_GE(disabled, 3.0);
        EXPECT_LT(disabled, look::contrast(of(text), of(ground)) * 0.75);
    }
}

TEST_P(Look, LinksHaveItToo) {
    if (GetParam().colours == look::Colours::System)
        return;  // this is up to the desktop, and the window has no links
    for (const auto role : {QPalette::Link, QPalette::LinkVisited})
        for (const auto ground : {QPalette::Window, QPalette::Base})
            EXPECT_GE(look::contrast(of(role), of(ground)), least) << role;
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
        // In grey, the shape alone must be sufficient.
        image = image.convertToFormat(QImage::Format_Grayscale8);
        for (const QImage& other : seen)
            EXPECT_NE(image, other) << a;
        seen << image;
    }
}

INSTANTIATE_TEST_SUITE_P(Palettes, Look,
                         testing::Values(Named{"System", look::Colours::System},
                                         Named{"Light", look::Colours::Light},
                                         Named{"Dark", look::Colours::Dark},
                                         Named{"HighContrast", look::Colours::HighContrast}),
                         [](const auto& named) { return std::string(named.param.name); });

TEST(LookOfPalettes, AreWhatTheyAreCalled) {
    EXPECT_FALSE(look::isDark(look::paletteOf(look::Colours::Light)));
    EXPECT_TRUE(look::isDark(look::paletteOf(look::Colours::Dark)));
    EXPECT_FALSE(look::isHighContrast(look::paletteOf(look::Colours::Light)));
    EXPECT_FALSE(look::isHighContrast(look::paletteOf(look::Colours::Dark)));
    EXPECT_TRUE(look::isHighContrast(look::paletteOf(look::Colours::HighContrast)));
}

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

class ColourMenu : public LookOfWindow {
protected:
    ~ColourMenu() override { look::useColours(look::Colours::System); }
    /// Selects in the menu, with the mouse.
    void choose(const QString& name) {
        auto* action = window->findChild<QAction*>(name + u"ColoursAction"_s);
        auto* menu = find<QMenu>(u"coloursMenu"_s);
        menu->popup(window->mapToGlobal(QPoint(50, 50)));
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
        QApplication::processEvents();
    }
    /// The colour on the screen in its corner.
    QColor ground(const QString& name) {
        QWidget* widget = find(name);
        return window->grab(QRect(widget->mapTo(window.get(), QPoint(2, 2)), QSize(1, 1)))
            .toImage()
            .pixelColor(0, 0);
    }
};

TEST_F(ColourMenu, ChangesEverythingWhileItRuns) {
    showServo();
    const QPalette before = window->palette();
    for (const auto& [name, colours] : {std::pair{u"dark"_s, look::Colours::Dark},
                                        std::pair{u"highContrast"_s, look::Colours::HighContrast},
                                        std::pair{u"light"_s, look::Colours::Light}}) {
        choose(name);
        const QPalette wanted = look::paletteOf(colours);
        EXPECT_EQ(ground(u"connectionBar"_s), wanted.color(QPalette::Window)) << name.toStdString();
        for (const QString& label : {u"stateLabel"_s, u"moduleType"_s, u"kpState"_s, u"linkLabel"_s})
            EXPECT_GE(look::contrast(find<QLabel>(label)->palette().color(QPalette::WindowText),
                                     wanted.color(QPalette::Window)),
                      4.5)
                << name.toStdString() << ' ' << label.toStdString();
        const QPalette fields = find(u"kpField"_s)->palette();
        for (const auto role : {QPalette::Text, QPalette::PlaceholderText})
            EXPECT_GE(look::contrast(fields.color(role), fields.color(QPalette::Base)), 4.5)
                << name.toStdString();
    }
    choose(u"system"_s);
    EXPECT_EQ(window->palette().color(QPalette::Window), before.color(QPalette::Window));
    EXPECT_EQ(window->palette().color(QPalette::Base), before.color(QPalette::Base));
}

TEST_F(ColourMenu, IsKeptForTheNextStart) {
    choose(u"dark"_s);
    window.reset();
    look::useColours(look::Colours::System);
    window = std::make_unique<MainWindow>(settings);
    EXPECT_TRUE(window->findChild<QAction*>(u"darkColoursAction"_s)->isChecked());
    EXPECT_TRUE(look::isDark(window->palette()));
}

/// WCAG 2.1, 1.4.11: what shows where a control is, and that it has the focus, has a contrast of 3:1 to what
/// is next to it.
class Frames : public testing::TestWithParam<look::Colours> {
protected:
    Frames() {
        look::useColours(GetParam());
        host.resize(300, 300);
        host.show();
        host.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&host, testing_support::kPatienceMs));
    }
    ~Frames() override { look::useColours(look::Colours::System); }
    template <typename Control>
    Control* add(Control* control, int y) {
        control->setParent(&host);
        control->setGeometry(20, y, 120, 24);
        control->show();
        return control;
    }
    /// The lower one of the contrasts of a pixel to these two colours, for the best of the first pixels of
    /// the left edge.
    [[nodiscard]] double edge(const QWidget* control, QRect frame, QPalette::ColorRole outside,
                              QPalette::ColorRole inside) {
        QCoreApplication::processEvents();
        frame.translate(control->mapTo(&host, QPoint()));
        const QImage picture = host.grab().toImage();
        double best = 1.0;
        for (int x = frame.left() - 1; x < frame.left() + 4; ++x) {
            const QColor pixel = picture.pixelColor(x, frame.center().y());
            best = std::max(best, std::min(look::contrast(pixel, host.palette().color(outside)),
                                           look::contrast(pixel, host.palette().color(inside))));
        }
        return best;
    }
    [[nodiscard]] double edge(const QWidget* control, QPalette::ColorRole inside = QPalette::Base) {
        return edge(control, control->rect(), QPalette::Window, inside);
    }
    QWidget host;
};

TEST_P(Frames, AreSeenWhereNothingIsInThem) {
    const auto indicator = [](const QAbstractButton* button, QStyle::SubElement element) {
        QStyleOptionButton option;
        option.initFrom(button);
        return button->style()->subElementRect(element, &option, button);
    };
    const auto* box = add(new QCheckBox(u"on"_s), 10);
    EXPECT_GE(edge(box, indicator(box, QStyle::SE_CheckBoxIndicator), QPalette::Window, QPalette::Base), 3.0);
    EXPECT_GE(edge(add(new QLineEdit, 70)), 3.0) << "field";
    EXPECT_GE(edge(add(new QListWidget, 100)), 3.0) << "list";
    EXPECT_GE(edge(add(new QComboBox, 130), QPalette::Window), 3.0) << "choice";
    EXPECT_GE(edge(add(new QPushButton(u"Go"_s), 160), QPalette::Window), 3.0) << "button";
    EXPECT_GE(edge(add(new QSpinBox, 190)), 3.0) << "spin box";
}

TEST_P(Frames, ShowTheFocus) {
    auto* field = add(new QLineEdit, 10);
    field->setFocus(Qt::TabFocusReason);
    EXPECT_GE(edge(field), 3.0);
    auto* other = add(new QComboBox, 40);
    other->setFocus(Qt::TabFocusReason);
    EXPECT_GE(edge(other, QPalette::Window), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Look, Frames,
                         testing::Values(look::Colours::Light, look::Colours::Dark,
                                         look::Colours::HighContrast));

TEST_F(LookOfWindow, EveryIconIsThere) {
    int seen = 0;
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
        ++seen;
    }
    EXPECT_GT(seen, 0);
}

TEST(LookOfElidedText, IsWholeInTheWidthThatItAsksFor) {
    const QString sentence = u"\"mill.json\" line 4: distance_counts is missing."_s;
    ElidedLabel label(1);
    for (const bool bold : {false, true})
        for (qsizetype length = 1; length <= sentence.size(); ++length) {
            QFont font = label.font();
            font.setBold(bold);
            label.setFont(font);
            label.setText(sentence.left(length));
            label.resize(label.sizeHint());
            const QImage asked = label.grab().toImage();
            label.resize(label.width() + 100, label.height());
            EXPECT_EQ(asked, label.grab().toImage().copy(asked.rect())) << length << (bold ? ", bold" : "");
        }
}

TEST(LookOfDigits, DoNotDance) {
    const QFontMetricsF metrics(look::tabular(QFont(u"DejaVu Serif"_s)));
    for (char16_t digit = u'0'; digit <= u'9'; ++digit)
        EXPECT_NEAR(metrics.horizontalAdvance(QChar(digit)), metrics.horizontalAdvance(u'0'), 0.01);
}

}  // namespace
}  // namespace nmc
