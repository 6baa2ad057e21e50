// SPDX-License-Identifier: GPL-3.0-or-later
// Square waves and frequency responses in the window: what is requested, why it is not possible, and what is
// shown.
#include <complex>
#include <numbers>

#include "responserecords.h"
#include "tests/support/choosefile.h"
#include "widgets/looptests/frequencypage.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/looptests/looptestwords.h"
#include "widgets/looptests/squareplot.h"
#include "widgets/looptests/squarewavepage.h"
#include "widgets/response/responsedock.h"

namespace nmc {
namespace {

class LoopTestsInTheWindow : public WindowTest {
protected:
    void openWith(Servo servo = {}) {
        servo.held = servo.on;
        showServo(servo);
        QTest::keyClick(window.get(), Qt::Key_F9, Qt::ControlModifier);
        ASSERT_TRUE(eventually([this] {
            return window->findChild<QWidget*>(u"squareWavePage"_s) != nullptr &&
                   find(u"squareWavePage"_s)->isVisible();
        }));
    }
    QString reason(const QString& control) {
        EXPECT_FALSE(button(control)->isEnabled()) << control.toStdString();
        return button(control)->toolTip();
    }
    QString label(const QString& name) { return find<QLabel>(name)->text(); }
    template <typename Kind>
    Kind wanted() {
        EXPECT_EQ(intents.size(), 1);
        return std::get<Kind>(intents.takeFirst().at(1).value<Intent>());
    }
    void show(const ProcedureReport& measured) {
        window->loopTests().frequency().showReport(measured, u"simulator"_s, true);
    }
    void select(int module) {
        auto* chain = find<QAbstractItemView>(u"chainList"_s);
        chain->setCurrentIndex(chain->model()->index(module, 0));
    }
    void report(ProcedureKind kind, ProcedureStage stage, std::vector<FrequencyPoint> points = {},
                unsigned rounds = 0, double speed = 0.0) {
        ProcedureReport r;
        r.gains = someGains();
        r.speed = speed;
        r.kind = kind;
        r.stage = stage;
        r.frequencies = std::move(points);
        r.round = static_cast<unsigned>(r.frequencies.size());
        r.rounds = rounds;
        window->showProcedure(r);
        show(r);
    }
    /// A first-order loop with its corner at 5 Hz.
    [[nodiscard]] static std::vector<FrequencyPoint> firstOrder(double to) {
        std::vector<FrequencyPoint> points;
        for (double hertz = 1; hertz <= to; hertz *= 1.2)
            points.push_back({hertz, 1.0 / std::complex(1.0, hertz / 5), 0.01});
        return points;
    }
    QSignalSpy intents{&window->requests(), &Requests::intent};
};

TEST_F(LoopTestsInTheWindow, AskForWhatStandsInTheFields) {
    openWith();
    click(u"squareWaveStartButton"_s);
    const auto first = wanted<intent::SquareWave>();
    EXPECT_EQ(first.counts, 100);
    EXPECT_EQ(first.period, 0.6);
    EXPECT_EQ(first.rounds, 20U);
    EXPECT_EQ(first.excursion, 200);
    EXPECT_EQ(first.method, ResponseMethod::StopHere);
    type(u"squareWaveDistanceField"_s, u"60"_s);
    type(u"squareWavePeriodField"_s, u"1,5"_s);
    find<QComboBox>(u"squareWaveMethodBox"_s)->setCurrentIndex(1);
    click(u"squareWaveStartButton"_s);
    const auto second = wanted<intent::SquareWave>();
    EXPECT_EQ(second.counts, 60);
    EXPECT_EQ(second.period, 1.5);
    EXPECT_EQ(second.method, ResponseMethod::Profile);
    click(u"frequencyStartButton"_s);
    const auto sines = wanted<intent::FrequencyResponse>();
    EXPECT_EQ(sines.amplitude, 20);
    EXPECT_EQ(sines.from, 1.0);
    EXPECT_EQ(sines.to, 40.0);
    EXPECT_EQ(sines.speed, 0.0);
    type(u"frequencySpeedField"_s, u"-3"_s);
    click(u"frequencyStartButton"_s);
    EXPECT_EQ(wanted<intent::FrequencyResponse>().speed, -3.0);
    type(u"frequencySpeedField"_s, u"1"_s);
    EXPECT_TRUE(reason(u"frequencyStartButton"_s).contains(u"would reverse"_s));
    // 50 counts/tick are 97 656 counts/s, which a motor may lag by a tenth of a second; EL is 4000.
    type(u"frequencySpeedField"_s, u"50"_s);
    EXPECT_TRUE(reason(u"frequencyStartButton"_s).contains(u"or the speed smaller"_s))
        << reason(u"frequencyStartButton"_s).toStdString();
}

/// 3 counts/tick are 5859.375 counts/s; with 100 counts in 1 mm and forward counting down, they are
/// -58.594 mm/s. 60 mm/s are 6000 counts/s down, which are 3.072 counts in each tick of 0.512 ms.
TEST_F(LoopTestsInTheWindow, ANewUnitKeepsTheDirectionInWhichTheMotorMoves) {
    openWith();
    type(u"frequencySpeedField"_s, u"3"_s);
    machine.axes.resize(1);
    machine.axes[0].unit = {UnitKind::Millimetres, -100.0, ""};
    window->showMachine(machine);
    EXPECT_EQ(field(u"frequencySpeedField"_s)->text(), u"-58.594"_s);
    click(u"frequencyStartButton"_s);
    EXPECT_EQ(wanted<intent::FrequencyResponse>().speed, 3.0);
    type(u"frequencySpeedField"_s, u"60"_s);
    click(u"frequencyStartButton"_s);
    EXPECT_NEAR(wanted<intent::FrequencyResponse>().speed, -3.072, 1e-9);
}

TEST_F(LoopTestsInTheWindow, SayWhyTheyAreNotPossible) {
    openWith(Servo{.on = false});
    EXPECT_TRUE(reason(u"squareWaveStartButton"_s).contains(u"nable"_s))
        << reason(u"squareWaveStartButton"_s).toStdString();
    EXPECT_EQ(label(u"squareWaveState"_s), reason(u"squareWaveStartButton"_s));
    EXPECT_TRUE(button(u"tuningReportButton"_s)->isEnabled()) << "what is known can still be saved";
}

TEST_F(LoopTestsInTheWindow, ABadNumberIsNotSent) {
    openWith();
    type(u"squareWavePeriodField"_s, u"9"_s);
    EXPECT_TRUE(reason(u"squareWaveStartButton"_s).contains(u"0.1 to 5"_s))
        << reason(u"squareWaveStartButton"_s).toStdString();
    type(u"frequencyToField"_s, u"0.7"_s);
    EXPECT_FALSE(reason(u"frequencyStartButton"_s).isEmpty()) << "it is below the lowest frequency";
    EXPECT_EQ(intents.size(), 0);
}

TEST_F(LoopTestsInTheWindow, WhileOneRunsItCanBeEnded) {
    openWith();
    EXPECT_FALSE(button(u"squareWaveEndButton"_s)->isEnabled());
    report(ProcedureKind::SquareWave, ProcedureStage::Moving);
    EXPECT_FALSE(button(u"squareWaveStartButton"_s)->isEnabled());
    click(u"squareWaveEndButton"_s);
    (void)wanted<intent::CancelProcedure>();
    report(ProcedureKind::SquareWave, ProcedureStage::Cancelled);
    EXPECT_TRUE(button(u"squareWaveStartButton"_s)->isEnabled());
}

TEST_F(LoopTestsInTheWindow, TheFiguresOfAFirstOrderLoopAreThere) {
    openWith();
    EXPECT_FALSE(button(u"frequencyExportButton"_s)->isEnabled());
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(20));
    const QString figures = label(u"frequencyFigures"_s);
    EXPECT_TRUE(figures.contains(u"Bandwidth (-3 dB) 4.9"_s) || figures.contains(u"Bandwidth (-3 dB) 5"_s))
        << figures.toStdString();
    EXPECT_TRUE(figures.contains(u"Phase margin 90°"_s)) << figures.toStdString();
    EXPECT_FALSE(figures.contains(u"too low"_s));
    EXPECT_TRUE(button(u"frequencyExportButton"_s)->isEnabled());
}

/// This has happened: a ramp kept the filter at OL, and a phase margin of its cut-off loop was shown like any
/// other.
TEST_F(LoopTestsInTheWindow, AMeasurementWithACutOffOutputSaysSo) {
    openWith();
    std::vector<FrequencyPoint> points = firstOrder(20);
    points[3].limited = true;
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, points);
    EXPECT_TRUE(label(u"frequencyFigures"_s).contains(u"Use a smaller amplitude or a lower speed"_s))
        << label(u"frequencyFigures"_s).toStdString();
}

/// With Kp alone, L = w0 / s, and twice the gain is twice the bandwidth.
TEST_F(LoopTestsInTheWindow, EditedGainsShowWhatTheLoopWouldDo) {
    openWith();
    EXPECT_TRUE(label(u"frequencyWouldDo"_s).isEmpty());
    ProcedureReport r;
    r.kind = ProcedureKind::FrequencyResponse;
    r.stage = ProcedureStage::Done;
    r.frequencies = firstOrder(35);
    r.gains = someGains();
    r.gains->kd = 0;
    r.gains->ki = 0;
    show(r);
    emit window->requests().stageGains(*r.gains);
    EXPECT_TRUE(label(u"frequencyWouldDo"_s).startsWith(u"Edit the gains"_s))
        << label(u"frequencyWouldDo"_s).toStdString();
    const QImage one = find(u"bodePlot"_s)->grab().toImage();
    type(u"kpField"_s, QString::number(2 * r.gains->kp));
    const QString would = label(u"frequencyWouldDo"_s);
    EXPECT_TRUE(would.contains(u"Bandwidth (-3 dB) 9.9"_s) || would.contains(u"Bandwidth (-3 dB) 10"_s))
        << would.toStdString();
    EXPECT_NE(find(u"bodePlot"_s)->grab().toImage(), one);
    type(u"kpField"_s, u"0"_s);  // nothing responds, and the plot ends at kFaintest
    EXPECT_NE(find(u"bodePlot"_s)->grab().toImage(), one);
    type(u"srField"_s, u"7"_s);
    EXPECT_TRUE(label(u"frequencyWouldDo"_s).contains(u"SR"_s));
    EXPECT_EQ(find(u"bodePlot"_s)->grab().toImage(), one);
}

TEST_F(LoopTestsInTheWindow, ResponsesAtRestAndInMotionStayWhileTheGainsAreTheSame) {
    openWith();
    const auto picture = [this] { return find(u"bodePlot"_s)->grab().toImage(); };
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(20));
    const QImage atRest = picture();
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(20), 0, 5'000);
    const QImage both = picture();
    EXPECT_NE(both, atRest) << "they are named";
    EXPECT_EQ(window->loopTests().frequency().last()->report.speed, 5'000);
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(20));
    EXPECT_NE(picture(), atRest);
    ProcedureReport other;
    other.kind = ProcedureKind::FrequencyResponse;
    other.stage = ProcedureStage::Done;
    other.frequencies = firstOrder(20);
    other.gains = someGains();
    other.gains->el += 1;
    show(other);
    EXPECT_NE(picture(), atRest) << "the position error limit is no part of the loop";
    other.gains->kp += 1;
    show(other);
    EXPECT_EQ(picture(), atRest);
    EXPECT_EQ(window->loopTests().frequency().last()->report.speed, 0.0);
}

/// 1.2 to the power of 16 is 18.5, and to the power of 18 it is 26.6.
TEST_F(LoopTestsInTheWindow, AMeasurementThatEndsEarlyReplacesNoneWithMoreFrequencies) {
    openWith();
    const auto figures = [this] { return label(u"frequencyFigures"_s); };
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(20));
    ASSERT_TRUE(figures().startsWith(u"17 "_s)) << figures().toStdString();
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Moving, firstOrder(1));
    EXPECT_TRUE(figures().startsWith(u"1 "_s)) << "it is shown while it goes on";
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Cancelled, firstOrder(1));
    EXPECT_TRUE(figures().startsWith(u"17 "_s)) << figures().toStdString();
    EXPECT_TRUE(figures().endsWith(u"The one before it is still shown."_s)) << figures().toStdString();
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Cancelled, firstOrder(1), 0, 5'000);
    EXPECT_TRUE(figures().startsWith(u"1 "_s)) << "the one at rest stays beside it";
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Failed, firstOrder(30));
    EXPECT_TRUE(figures().startsWith(u"19 "_s)) << figures().toStdString();
    EXPECT_FALSE(figures().contains(u"still shown"_s));
}

TEST_F(LoopTestsInTheWindow, AFileOfFrequenciesSaysWhatItIs) {
    openWith();
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(20));
    QSignalSpy saves(&window->requests(), &Requests::save);
    click(u"frequencyExportButton"_s);
    auto* dialog = find<QFileDialog>(u"frequencyFileDialog"_s);
    testing_support::chooseFile(*dialog, u"/home/anna/loop.csv"_s);
    ASSERT_EQ(saves.size(), 1);
    const std::string text = saves[0][1].value<FileContent>()();
    for (const char* const line : {"# NMC Panel frequency response 1\n", "\n# started: 2",
                                   "\n# port: simulator\n", "\n# simulated: yes (no real motor moved)\n",
                                   "\n# module: Module 1\n", " kp 100 kd 1000 ", "\nfrequency_hz,"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

/// The dialog that asks for the file blocks nothing.
TEST_F(LoopTestsInTheWindow, AFileHasTheFrequenciesThatWereShownWhenItWasAskedFor) {
    openWith();
    showServos({{.held = true}, {.held = true}});
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(20));
    QSignalSpy saves(&window->requests(), &Requests::save);
    click(u"frequencyExportButton"_s);
    select(1);
    EXPECT_FALSE(button(u"frequencyExportButton"_s)->isEnabled());
    testing_support::chooseFile(*find<QFileDialog>(u"frequencyFileDialog"_s), u"/home/anna/loop.csv"_s);
    ASSERT_EQ(saves.size(), 1);
    const std::string text = saves[0][1].value<FileContent>()();
    for (const char* const line : {"\n# port: simulator\n", "\n# module: Module 1\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

/// The gains in force are others meanwhile, and the run was made by the simulator.
TEST_F(LoopTestsInTheWindow, AReportSaysWithWhichGainsAndWhereEachPartWasMeasured) {
    openWith();
    KeptResponse run = ramp();
    run.run.taken.gains.kp = 77;
    run.startedAt = "2026-11-21T21:21:02.123+01:00";
    window->stepResponses().showRun(run);
    ProcedureReport r;
    r.kind = ProcedureKind::FrequencyResponse;
    r.stage = ProcedureStage::Done;
    r.frequencies = firstOrder(20);
    r.gains = someGains();
    r.gains->kp = 55;
    r.speed = 5'000;
    show(r);
    LinkState link = connectedTo({Servo{.held = true}.state()});
    link.port = "/dev/ttyUSB0";
    link.simulated = false;
    window->showLink(link);
    QSignalSpy saves(&window->requests(), &Requests::save);
    click(u"tuningReportButton"_s);
    auto* dialog = find<QFileDialog>(u"reportFileDialog"_s);
    testing_support::chooseFile(*dialog, u"/home/anna/tuning.html"_s);
    ASSERT_EQ(saves.size(), 1);
    const QString page = QString::fromStdString(saves[0][1].value<FileContent>()());
    const QString step = page.section(u"<h3>"_s, 2, 2);
    const QString when = QLocale().toString(QDateTime({2026, 11, 21}, {21, 21, 2}), QLocale::ShortFormat);
    for (const QString& part : {u"Kp 77,"_s, when + u" · Simulator · simulated; no real motor moved"_s})
        EXPECT_TRUE(step.contains(part)) << part.toStdString() << step.right(500).toStdString();
    const QString sines = page.section(u"<h3>"_s, 3, 3);
    for (const QString& part : {u"Kp 55,"_s, u"Speed while measuring 5\u202F000 counts/s"_s})
        EXPECT_TRUE(sines.contains(part)) << part.toStdString() << sines.right(500).toStdString();
    EXPECT_FALSE(page.section(u"<h3>"_s, 0, 1).contains(u"simulated"_s));
}

/// Hidden, the step responses do not follow the selection.
TEST_F(LoopTestsInTheWindow, AReportHasNoMotorOfAnotherModule) {
    openWith();
    showServos({{.held = true}, {.held = true}});
    ResponseDock& responses = window->stepResponses();
    responses.open();
    ASSERT_TRUE(eventually([&] { return responses.seen(); }));
    responses.showRun(ramp());
    ModelBox& model = responses.page().model();
    model.find(ModuleIndex(0));
    Identified motor;
    motor.motor.gain = {788, 8};
    motor.motor.timeConstant = {0.0129, 0.0002};
    motor.runs.push_back({{0.0, 500.0}, {0.01, 590.0}});
    model.showMotor(ModuleIndex(0), motor);
    EXPECT_TRUE(model.motorWords(ModuleIndex(0)).join(u'\n').contains(u"Gain 788"_s));
    responses.close();
    ASSERT_TRUE(eventually([&] { return !responses.seen(); }));
    select(1);
    QSignalSpy saves(&window->requests(), &Requests::save);
    click(u"tuningReportButton"_s);
    testing_support::chooseFile(*find<QFileDialog>(u"reportFileDialog"_s), u"/home/anna/tuning.html"_s);
    ASSERT_EQ(saves.size(), 1);
    const QString page = QString::fromStdString(saves[0][1].value<FileContent>()());
    EXPECT_TRUE(page.contains(u"Module 2"_s));
    EXPECT_FALSE(page.contains(u"Gain 788"_s));
}

TEST_F(LoopTestsInTheWindow, ALineThatIsTooSlowIsNamed) {
    openWith();
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(8), 20);
    EXPECT_TRUE(label(u"frequencyFigures"_s).contains(u"The baud rate is too low"_s));
}

TEST_F(LoopTestsInTheWindow, EdgesWithTheSameGainsAreLaidOverOneAnotherAndKept) {
    openWith();
    SquareWavePage& page = window->loopTests().squareWave();
    EXPECT_FALSE(button(u"squareWaveKeepButton"_s)->isEnabled());
    for (int i = 0; i < 3; ++i)
        page.showEdge(ramp());
    KeptResponse other = ramp();
    other.run.taken.gains.kp = 77;
    page.showEdge(other);
    EXPECT_TRUE(label(u"squareWaveResults"_s).startsWith(u"Edges with these gains: 1\n"_s));
    KeptResponse back = ramp();
    std::swap(back.run.taken.from, back.run.taken.goal);
    back.run.taken.gains.kp = 55;
    page.showEdge(back);
    EXPECT_TRUE(label(u"squareWaveResults"_s).isEmpty()) << "no rising edge has these gains";
    EXPECT_FALSE(button(u"squareWaveKeepButton"_s)->isEnabled());
    other.run.taken.gains.kp = 55;
    page.showEdge(other);
    EXPECT_TRUE(label(u"squareWaveResults"_s).startsWith(u"Edges with these gains: 2\n"_s));
    click(u"squareWaveKeepButton"_s);
    window->findChild<QAction*>(u"responseDockAction"_s)->trigger();
    ASSERT_TRUE(eventually([this] { return find(u"responsePage"_s)->isVisible(); }));
    EXPECT_EQ(find<QTableWidget>(u"responseRunTable"_s)->rowCount(), 1);
    page.clear(ModuleIndex(0));
    EXPECT_TRUE(label(u"squareWaveResults"_s).isEmpty());
}

/// Two waves run at the same time.
TEST_F(LoopTestsInTheWindow, EdgesOfTwoModulesAreNotLaidOverOneAnother) {
    openWith();
    showServos({{.held = true}, {.held = true}});
    SquareWavePage& page = window->loopTests().squareWave();
    page.clear(ModuleIndex(0));
    page.showEdge(ramp());
    page.clear(ModuleIndex(1));
    page.showEdge(ramp(80, 1));
    page.showEdge(ramp());
    EXPECT_TRUE(label(u"squareWaveResults"_s).startsWith(u"Edges with these gains: 2\n"_s));
    select(1);
    EXPECT_TRUE(label(u"squareWaveResults"_s).startsWith(u"Edges with these gains: 1\n"_s));
    click(u"squareWaveKeepButton"_s);
    ASSERT_EQ(window->stepResponses().runs().size(), 1U);
    EXPECT_TRUE(window->stepResponses().runs().front().run.module == ModuleIndex(1));
}

/// As a run, they would count as steps of the module that has its number now.
TEST_F(LoopTestsInTheWindow, EdgesOfAnEarlierConnectionAreNotKept) {
    openWith();
    window->loopTests().squareWave().showEdge(ramp());
    EXPECT_TRUE(button(u"squareWaveKeepButton"_s)->isEnabled());
    window->showLink({});
    showServo();
    EXPECT_FALSE(button(u"squareWaveKeepButton"_s)->isEnabled());
    EXPECT_TRUE(label(u"squareWaveResults"_s).isEmpty());
}

/// A connection that is opened as soon as the last one has closed is not seen disconnected in between.
TEST_F(LoopTestsInTheWindow, ThoseOfAnotherConnectionAreForgotten) {
    openWith();
    LinkState link = connectedTo({Servo{.held = true}.state()});
    link.connection = 1;
    window->showLink(link);
    report(ProcedureKind::FrequencyResponse, ProcedureStage::Done, firstOrder(20));
    window->loopTests().squareWave().showEdge(ramp());
    EXPECT_TRUE(button(u"frequencyExportButton"_s)->isEnabled());
    EXPECT_TRUE(button(u"squareWaveKeepButton"_s)->isEnabled());
    LinkState connecting = link;
    connecting.connection = link.connection = 2;
    connecting.phase = LinkPhase::Connecting;
    connecting.modules.clear();
    window->showLink(connecting);
    window->showLink(link);
    EXPECT_FALSE(button(u"frequencyExportButton"_s)->isEnabled());
    EXPECT_FALSE(button(u"squareWaveKeepButton"_s)->isEnabled());
    EXPECT_TRUE(label(u"frequencyFigures"_s).isEmpty()) << label(u"frequencyFigures"_s).toStdString();
    EXPECT_TRUE(label(u"squareWaveResults"_s).isEmpty());
}

TEST(LoopTestWords, OneFrequencyIsNoRange) {
    const std::vector<FrequencyPoint> measured{
        {2.0, {0.9, -0.1}, 0.01}, {3.0, {0.8, -0.2}, 0.01}, {4.0, {0.7, -0.3}, 0.01}};
    const auto words = [&measured](std::size_t known) {
        return texts::wouldDo(measured, std::span(measured).first(known), LoopChange::Filter);
    };
    EXPECT_TRUE(words(1).contains(u"only at 2"_s)) << words(1).toStdString();
    EXPECT_FALSE(words(1).contains(u"from 2"_s)) << words(1).toStdString();
    EXPECT_TRUE(words(2).contains(u"from 2"_s)) << words(2).toStdString();
    EXPECT_FALSE(words(3).contains(u"elsewhere"_s)) << words(3).toStdString();
}

/// 10 counts there and back, half a period of 0.1 s.
TEST(SquarePlotHands, KeysAndADoubleClickZoomAndFit) {
    SquarePlot plot;
    plot.resize(600, 300);
    plot.show();
    SquarePlot::Fold fold;
    fold.counts = 10;
    fold.half = 0.1;
    for (int i = 0; i <= 100; ++i)
        fold.forward.push_back(
            {.seconds = i * 0.001, .position = i * 0.1, .low = i * 0.1, .high = i * 0.1, .samples = 1});
    plot.showFold(fold, {}, AxisScale());
    const PlotGeometry all = plot.geometryShown();
    EXPECT_NEAR(all.right, 0.2, 1e-9);
    QTest::keyClick(&plot, Qt::Key_Plus);
    EXPECT_NEAR(plot.geometryShown().right - plot.geometryShown().left, (all.right - all.left) / 1.5, 1e-9);
    QTest::keyClick(&plot, Qt::Key_Plus, Qt::ControlModifier);
    EXPECT_NEAR(plot.geometryShown().top - plot.geometryShown().bottom, (all.top - all.bottom) / 1.5, 1e-9);
    QTest::mouseDClick(&plot, Qt::LeftButton);
    EXPECT_EQ(plot.geometryShown().right, all.right);
    EXPECT_EQ(plot.geometryShown().top, all.top);
}

}  // namespace
}  // namespace nmc
