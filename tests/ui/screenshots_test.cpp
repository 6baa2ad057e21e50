// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the panels and dialogs, light and dark, in every language with a translation, kept as artefacts
// of the run; nothing in them is cut off. Runs once for each scale (tests/ui/CMakeLists.txt).
#include "inlanguage.h"
#include "widgets/common/look.h"
#include "windowtest.h"

namespace nmc {
namespace {

struct Shown {
    std::string language;
    bool dark;
};
void PrintTo(const Shown& shown, std::ostream* out) {
    *out << shown.language << (shown.dark ? ", dark" : ", light");
}

class Screenshots : public testing::WithParamInterface<Shown>, public InLanguage, public WindowTest {
protected:
    Screenshots() : InLanguage(GetParam().language) {
        if (GetParam().dark)
            QApplication::setPalette(darkPalette());
        window->resize(1600, 1200);
    }
    ~Screenshots() override { QApplication::setPalette(QPalette()); }

    void showStepper() {
        ModuleState module;
        module.info.identity = {ModuleType::Stepper, 1};
        module.info.address = BusAddress(1);
        bus::Sample sample;
        sample.report.status = 0x0C;  // amplifier enabled, power
        sample.report.position = 1'234;
        sample.report.aux = std::uint8_t(0);
        sample.report.analog = std::uint8_t(200);
        module.apply(sample);
        window->showLink(connectedTo({module}));
    }
    /// Saves a picture of each page of the panel, and expects that nothing is cut off.
    void keep(const QString& panel, const QString& pages) {
        auto* tabs = find<QTabWidget>(pages);
        for (int i = 0; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            QApplication::processEvents();
            save(*window, u"%1-%2"_s.arg(panel).arg(i));
            expectNothingCut(tabs->tabText(i));
        }
    }
    void save(QWidget& widget, const QString& what) {
        // Encoding them as PNG takes longer than everything else that these tests do.
        const QString file = u"%1-%2-%3-%4.jpg"_s
                                 .arg(what, GetParam().dark ? u"dark"_s : u"light"_s,
                                      QString::fromStdString(GetParam().language))
                                 .arg(window->devicePixelRatioF());
        ASSERT_TRUE(QDir().mkpath(QStringLiteral(SCREENSHOT_DIR)));
        EXPECT_TRUE(widget.grab().save(QStringLiteral(SCREENSHOT_DIR "/") + file));
    }
    void expectNothingCut(const QString& page) {
        for (const QPushButton* button : window->findChildren<QPushButton*>()) {
            if (!button->isVisible() || button->text().isEmpty())
                continue;
            EXPECT_GE(button->width(), button->minimumSizeHint().width())
                << page.toStdString() << ": " << button->objectName().toStdString();
        }
        for (const QLabel* label : window->findChildren<QLabel*>()) {
            if (!label->isVisible() || label->wordWrap())
                continue;
            EXPECT_GE(label->width(), label->minimumSizeHint().width())
                << page.toStdString() << ": " << label->text().toStdString();
        }
    }
};

TEST_P(Screenshots, OfTheServoPanel) {
    showServo({.position = 12'345});
    keep(u"servo"_s, u"servoPages"_s);
}

TEST_P(Screenshots, OfTheStepperPanel) {
    showStepper();
    keep(u"step"_s, u"stepperPages"_s);
}

TEST_P(Screenshots, OfASimulatedReadOnlySession) {
    ModuleState module = Servo{.position = 12'345}.state();
    module.readOnly = true;
    LinkState link = connectedTo({module});
    link.simulated = link.readOnly = true;
    window->showLink(link);
    keep(u"readonly"_s, u"servoPages"_s);
}

TEST_P(Screenshots, OfTheStepResponse) {
    showServo({.on = false});
    click(u"openStepResponseButton"_s);
    ASSERT_TRUE(eventually([this] { return find(u"responsePage"_s)->isVisible(); }));
    keep(u"stepresponse"_s, u"servoPages"_s);
}

TEST_P(Screenshots, OfTheIoPanel) {
    ModuleState module = Servo{}.state();
    module.info.identity = {ModuleType::Io, 1};
    window->showLink(connectedTo({module}));
    QApplication::processEvents();
    save(*window, u"io"_s);
    expectNothingCut(u"ioPanel"_s);
}

TEST_P(Screenshots, OfTheDialogs) {
    showServo();
    for (const QString& action : {u"chainDoctorAction"_s, u"groupsAction"_s, u"copyAxisAction"_s,
                                  u"operatorAction"_s, u"scopeSignalsAction"_s, u"manualAction"_s,
                                  u"reportProblemAction"_s, u"restartNetworkAction"_s, u"aboutAction"_s}) {
        window->findChild<QAction*>(action)->trigger();
        QApplication::processEvents();
        QWidget* dialog = QApplication::activeWindow();
        ASSERT_NE(dialog, nullptr);
        save(*dialog, dialog->objectName() + u'-' + action);
        expectNothingCut(action);
    }
}

std::vector<Shown> allShown() {
    std::vector<Shown> all{{"en", true}};
    for (const std::string& language : allLanguages())
        all.push_back({language, false});
    return all;
}
INSTANTIATE_TEST_SUITE_P(As, Screenshots, testing::ValuesIn(allShown()), [](const auto& shown) {
    return shown.param.language + (shown.param.dark ? "Dark" : "Light");
});

/// They differ by their grey alone, in print or for users who cannot distinguish the colours.
TEST(Greyscale, TheSeveritiesDifferWithoutTheirColours) {
    for (const QPalette& palette : {QPalette(), darkPalette()}) {
        const int attention = qGray(look::severityFill(Severity::Attention, palette).rgb());
        const int fault = qGray(look::severityFill(Severity::Fault, palette).rgb());
        EXPECT_GT(std::abs(attention - fault), 20) << attention << " " << fault;
    }
}

}  // namespace
}  // namespace nmc
