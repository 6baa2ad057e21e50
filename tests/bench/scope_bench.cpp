// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame of the scope costs, however much there is to draw, compared with the obvious way to use Qt
// Charts in the same run.
//   scope_bench draw            frames of 1200 x 500 px with two traces, and of eight such plots
//   scope_bench live [SECONDS]  the whole panel on nmcsim with 8 modules and four strips
#include <sys/resource.h>

#include <QApplication>
#include <QEventLoop>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <QtCharts/QChart>
#include <QtCharts/QChartView>
#include <QtCharts/QLineSeries>
#include <QtCharts/QValueAxis>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "app/composition.h"
#include "link/clock.h"
#include "tests/support/nmcsimprocess.h"
#include "widgets/scope/scopeplot.h"
#include "widgets/scope/scopesetup.h"

namespace {

using namespace nmc;

constexpr double kSeconds = 100;  // in view
constexpr int kModules = 8;

double percentile(std::vector<double> values, double share) {
    if (values.empty())
        return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Median of the milliseconds that `frame` takes.
template <typename Frame>
double median(int frames, Frame frame) {
    std::vector<double> times;
    for (int i = 0; i < frames; ++i) {
        const TimePoint before = monotonicNow();
        frame(i);
        times.push_back(toSeconds(monotonicNow() - before) * 1e3);
        QCoreApplication::processEvents();  // what Qt lays out in between does not count
    }
    return percentile(times, 0.5);
}

/// A motor that swings, with noise; a fifth more than is in view, so that panning finds something.
History swinging(int points) {
    History history(1);
    for (int i = 0; i < points * 6 / 5; ++i) {
        ScopeSample sample;
        const double t = i * kSeconds / points;
        sample.time = TimePoint(fromSeconds(t));
        sample.position = static_cast<std::int32_t>(5'000 * std::sin(t) + i * 7'919 % 100);
        sample.error = static_cast<float>(30 * std::cos(t));
        history.append(ModuleIndex(0), sample);
    }
    return history;
}

std::unique_ptr<ScopePlot> shownPlot(QWidget* parent = nullptr) {
    auto plot = std::make_unique<ScopePlot>(parent);
    plot->setTraces({{ModuleIndex(0), ScopeSignal::Position, {}, QStringLiteral("position"), {}, 0},
                     {ModuleIndex(0), ScopeSignal::Command, {}, QStringLiteral("command"), {}, 0}});
    plot->resize(1200, 500);
    plot->show();
    QCoreApplication::processEvents();
    return plot;
}

/// `moving`: the time axis moves in every frame, as when it is dragged; otherwise once per division.
double frameOf(const History& history, int frames, bool moving) {
    const auto plot = shownPlot();
    return median(frames, [&](int i) {
        const double left = moving ? i * 0.01 : std::floor(i * 0.02 / 10) * 10;
        plot->showFrame({*history.zero(), left, left + kSeconds, kSeconds / 10}, history, left);
        plot->repaint();
    });
}

/// The obvious way: in each frame, all points are put into a QLineSeries.
double frameOfSeries(int points, int frames) {
    QChartView view;
    auto* chart = view.chart();
    auto* time = new QValueAxis(chart);
    auto* value = new QValueAxis(chart);
    chart->addAxis(time, Qt::AlignBottom);
    chart->addAxis(value, Qt::AlignLeft);
    std::vector<QLineSeries*> series;
    QList<QPointF> data;
    for (int i = 0; i < points; ++i)
        data << QPointF(i * kSeconds / points, 5'000 * std::sin(i * kSeconds / points));
    for (int i = 0; i < 2; ++i) {
        series.push_back(new QLineSeries(chart));
        chart->addSeries(series.back());
        series.back()->attachAxis(time);
        series.back()->attachAxis(value);
    }
    time->setRange(0, kSeconds);
    value->setRange(-6'000, 6'000);
    view.resize(1200, 500);
    view.show();
    QCoreApplication::processEvents();
    return median(frames, [&](int /*frame*/) {
        for (QLineSeries* one : series)
            one->replace(data);
        view.repaint();
    });
}

int draw() {
    std::printf("%-44s %10s %10s %12s\n", "ms per frame, median", "rolling", "dragged", "QLineSeries");
    double first = 0;
    double last = 0;
    for (const int points : {1'000, 10'000, 100'000, 1'000'000}) {
        const History history = swinging(points);
        const double rolling = frameOf(history, 200, false);
        const double dragged = frameOf(history, 200, true);
        const double series = points <= 100'000 ? frameOfSeries(points, points <= 10'000 ? 20 : 5) : 0;
        std::printf("%8d points, 1200 x 500, 2 traces %9s %10.2f %10.2f", points, "", rolling, dragged);
        std::printf(series > 0 ? " %12.1f\n" : "            -\n", series);
        first = first > 0 ? first : rolling;
        last = rolling;
    }
    std::printf("a million points against a thousand: %.2f times (aim 1.5); a frame at most 2 ms\n",
                last / first);

    const History history = swinging(100'000);
    std::vector<std::unique_ptr<ScopePlot>> plots;
    for (int i = 0; i < 8; ++i)
        plots.push_back(shownPlot());
    const double eight = median(100, [&](int i) {
        for (const auto& plot : plots) {
            plot->showFrame({*history.zero(), 0, kSeconds, kSeconds / 10}, history, i * 0.02);
            plot->repaint();
        }
    });
    std::printf("eight plots of 100 000 points: %.2f ms (aim 10)\n", eight);
    return 0;
}

// ---- the whole panel ----

/// Records the times between paints of the scope.
class PaintWatch : public QObject {
public:
    std::vector<double> intervals;  ///< ms

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) {
            const TimePoint now = monotonicNow();
            if (m_last)
                intervals.push_back(toSeconds(now - *m_last) * 1e3);
            m_last = now;
        }
        return QObject::eventFilter(watched, event);
    }

private:
    std::optional<TimePoint> m_last;
};

double cpuSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double residentMiB() {
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return 0;
    return file.readAll().split(' ').value(1).toDouble() * 4096 / (1 << 20);
}

void turnFor(double seconds) {
    QEventLoop loop;
    QTimer::singleShot(static_cast<int>(seconds * 1e3), &loop, &QEventLoop::quit);
    loop.exec();
}

int live(double seconds) {
    QTemporaryDir folder;
    QSettings settings(folder.filePath(QStringLiteral("panel.ini")), QSettings::IniFormat);
    ScopeSetup setup;
    for (std::uint8_t strip = 0; strip < ScopeSetup::kStrips; ++strip)
        for (std::uint8_t i = 0; i < 2; ++i)
            setup.strips[strip].push_back(
                {ModuleIndex(static_cast<std::uint8_t>(2 * strip + i)), ScopeSignal::Position});
    settings.setValue(QStringLiteral("scope"), setup.toText());
    QStringList chain;
    for (int i = 0; i < kModules; ++i)
        chain << QStringLiteral("servo");
    testing_support::NmcsimProcess sim(chain.join(QLatin1Char(',')));
    Composition composition(settings);
    composition.show({sim.terminal(), 115'200, false});
    turnFor(3);
    if (composition.store().link().modules.size() != kModules) {
        std::fprintf(stderr, "scope_bench: the chain was not found\n");
        return 1;
    }
    auto* plot = composition.window().findChild<ScopePlot*>(QStringLiteral("scopePlot1"));
    PaintWatch watch;
    plot->installEventFilter(&watch);
    const double cpuBefore = cpuSeconds();
    const TimePoint begin = monotonicNow();
    // The history grows up to its own 64 MiB; nothing else may grow at all.
    const auto historyMiB = [&] {
        return static_cast<double>(composition.store().history().bytes()) / (1 << 20);
    };
    double afterMinute = 0;
    for (double done = 0; done < seconds; done += 10) {
        turnFor(std::min(10.0, seconds - done));
        if (done + 10 <= 60)
            afterMinute = residentMiB() - historyMiB();
    }
    const double wall = toSeconds(monotonicNow() - begin);
    const double cpu = (cpuSeconds() - cpuBefore) / wall;
    const auto frames = static_cast<double>(watch.intervals.size());
    std::printf("8 modules, four strips, %.0f s: CPU %.1f %% of a core (aim 35), %.1f frames/s (aim 60)\n",
                wall, 100 * cpu, frames / wall);
    std::printf("time between frames: median %.1f, 99.9th percentile %.1f ms (aim 50), longest %.1f ms\n",
                percentile(watch.intervals, 0.5), percentile(watch.intervals, 0.999),
                percentile(watch.intervals, 1));
    std::printf("resident memory less the history: %.1f MiB after a minute, %.1f MiB at the end\n",
                afterMinute, residentMiB() - historyMiB());
    std::printf(
        "history: %.1f MiB of 64, %zu samples/s\n", historyMiB(),
        static_cast<std::size_t>(static_cast<double>(composition.worker().statistics().answered) / wall));
    sim.quit();
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    const QString mode = QString::fromLocal8Bit(argc > 1 ? argv[1] : "draw");
    if (mode == QLatin1String("live"))
        return live(argc > 2 ? std::strtod(argv[2], nullptr) : 600);
    return draw();
}
