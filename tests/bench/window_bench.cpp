// SPDX-License-Identifier: GPL-3.0-or-later
// What the window costs and how soon it reacts, with 32 modules moving at the wire's limit and four strips:
//   window_bench [SECONDS]   the GUI thread's share of a core; a keystroke to its repaint; switching modules
//   window_bench events      what holds the thread up: at rest, while typing, while switching modules
//   window_bench paints      which widgets are painted, and how often
#include <QApplication>
#include <QEventLoop>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QMainWindow>
#include <QScopedValueRollback>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <QVariant>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <optional>
#include <random>
#include <string_view>
#include <thread>

#include "app/composition.h"
#include "link/clock.h"
#include "tests/support/gains.h"
#include "timedchain.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/scope/scopesetup.h"

namespace {

using namespace nmc;
using bench::TimedChain;

constexpr std::size_t kModules = 32;
constexpr int kTrials = 200;

double percentile(std::vector<double> values, double share) {
    if (values.empty())
        return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double threadSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void turnFor(double seconds) {
    QEventLoop loop;
    QTimer::singleShot(static_cast<int>(seconds * 1e3), &loop, &QEventLoop::quit);
    loop.exec();
}

/// Waits until a widget is painted.
class NextPaint : public QObject {
public:
    /// When it was painted; empty if it was not within a second.
    std::optional<TimePoint> wait() {
        m_painted.reset();
        QTimer patience;
        patience.setSingleShot(true);
        connect(&patience, &QTimer::timeout, &m_loop, &QEventLoop::quit);
        patience.start(1'000);
        m_loop.exec();
        return m_painted;
    }

    std::function<bool()> counts;  ///< true once the awaited change is there

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint && m_loop.isRunning() && counts()) {
            // The end of the painting, of this widget and of whatever else is due.
            QTimer::singleShot(0, &m_loop, [this] {
                m_painted = monotonicNow();
                m_loop.quit();
            });
        }
        return QObject::eventFilter(watched, event);
    }

private:
    QEventLoop m_loop;
    std::optional<TimePoint> m_painted;
};

/// Presses keys at random moments. The effect of `key` is visible once `state` has changed and the widget has
/// been painted. Returns how long that took, in ms.
std::vector<double> trials(QWidget* painted, const std::function<QString()>& state,
                           const std::function<void(int)>& key) {
    std::mt19937 random{1};
    std::uniform_int_distribution<int> phase{5'000, 60'000};  // us
    std::vector<double> times;
    NextPaint paint;
    for (int i = 0; i < kTrials; ++i) {
        const QString before = state();
        paint.counts = [&] { return state() != before; };
        painted->installEventFilter(&paint);
        TimePoint since;
        std::thread other([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(phase(random)));
            since = monotonicNow();
            key(i);
        });
        const std::optional<TimePoint> seen = paint.wait();
        other.join();
        if (seen)
            times.push_back(toSeconds(*seen - since) * 1e3);
        painted->removeEventFilter(&paint);
    }
    return times;
}

/// Types into the field.
std::vector<double> keystrokes(QLineEdit* field) {
    field->setFocus();
    return trials(
        field, [field] { return field->text(); },
        [field](int i) {
            const bool digit = i % 2 == 0;
            QCoreApplication::postEvent(
                field, new QKeyEvent(QEvent::KeyPress, digit ? Qt::Key_7 : Qt::Key_Backspace, Qt::NoModifier,
                                     digit ? QStringLiteral("7") : QStringLiteral("\b")));
        });
}

/// The same in a window that has nothing else to do: what Qt and this machine take.
std::vector<double> keystrokesInBareWindow() {
    QMainWindow window;
    auto* field = new QLineEdit(&window);
    window.resize(1456, 952);
    window.show();
    turnFor(1);
    return keystrokes(field);
}

class Bench {
public:
    Bench() : m_settings(m_directory.filePath(QStringLiteral("panel.ini")), QSettings::IniFormat) {
        ScopeSetup setup;
        for (std::uint8_t strip = 0; strip < ScopeSetup::kStrips; ++strip)
            for (std::uint8_t i = 0; i < 2; ++i)
                setup.strips[strip].push_back(
                    {ModuleIndex(static_cast<std::uint8_t>(2 * strip + i)), ScopeSignal::Position});
        m_settings.setValue(QStringLiteral("scope"), setup.toText());
        m_composition.emplace(m_settings);
        window().resize(1456, 952);
        m_composition->show({QString::fromStdString(m_chain.terminal()), 115'200, false});
        turnFor(4);
        if (modules().size() != kModules) {
            std::fprintf(stderr, "window_bench: the chain was not found\n");
            std::exit(1);
        }
        // While no motor moves, the pages of all modules are built, one after another.
        turnFor(15);
        setGoing();
        turnFor(2);
    }

    MainWindow& window() { return m_composition->window(); }

    double share(double seconds) {
        const double before = threadSeconds();
        const TimePoint begin = monotonicNow();
        turnFor(seconds);
        return (threadSeconds() - before) / toSeconds(monotonicNow() - begin);
    }

    /// Types into the goal field.
    std::vector<double> keystrokes() {
        return ::keystrokes(window().findChild<NumberField*>(QStringLiteral("goalField")));
    }

    /// Moves up and down the list with the arrow keys.
    std::vector<double> switches() {
        auto* list = window().findChild<QListView*>(QStringLiteral("chainList"));
        list->setFocus();
        const auto selected = [this] { return QString::number(window().selectedModule()->value()); };
        return trials(&window(), selected, [list](int i) {
            const int key = i / 31 % 2 == 0 ? Qt::Key_Down : Qt::Key_Up;
            QCoreApplication::postEvent(list, new QKeyEvent(QEvent::KeyPress, key, Qt::NoModifier));
        });
    }

private:
    [[nodiscard]] const std::vector<ModuleState>& modules() const {
        return m_composition->store().link().modules;
    }

    void setGoing() {
        servo::LoadTrajectory load;
        load.velocity = CountsPerTick(4 << 16);
        load.acceleration = CountsPerTickSquared(6'554);  // 0.1 counts/tick^2
        load.profile = servo::ProfileMode::Velocity;
        for (std::uint8_t i = 0; i < kModules; ++i) {
            const auto step = [i](ServoCommand command) {
                return bus::Order{ModuleIndex(i), std::move(command)};
            };
            m_composition->worker().ask(bus::Operation{
                bus::OperationId(1'000'000U + i),
                {step(testing_support::kGains), step(servo::StopMotor{true, servo::StopManner::Abruptly, {}}),
                 step(load), step(StartMotion{})}});
        }
    }

    TimedChain m_chain{kModules};
    QTemporaryDir m_directory;
    QSettings m_settings;
    std::optional<Composition> m_composition;
};

class PaintCount : public QObject {
public:
    std::map<QString, int> counts;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint && watched->isWidgetType()) {
            const auto* parent = watched->parent();
            counts[QString::fromLatin1(watched->metaObject()->className()) + QLatin1Char(' ') +
                   watched->objectName() + QLatin1String(" in ") +
                   (parent != nullptr ? parent->objectName() : QString())]++;
        }
        return QObject::eventFilter(watched, event);
    }
};

/// Measures what holds the thread up: nothing else is handled in the middle of an event.
class EventTimes : public QApplication {
public:
    using QApplication::QApplication;

    bool watching = false;
    struct Sum {
        double seconds = 0;
        double longest = 0;
        double overTwo = 0;  ///< s in which Esc would be late: the part of each event before its last 2 ms
        int count = 0;
    };
    std::map<QString, Sum> sums;

    bool notify(QObject* receiver, QEvent* event) override {
        if (!watching || m_inside)
            return QApplication::notify(receiver, event);
        const QString name =
            QStringLiteral("%1 to %2 %3")
                .arg(QVariant::fromValue(event->type()).toString(),
                     QString::fromLatin1(receiver->metaObject()->className()), receiver->objectName());
        const QScopedValueRollback<bool> inside(m_inside, true);
        const TimePoint begin = monotonicNow();
        const bool result = QApplication::notify(receiver, event);
        const double seconds = toSeconds(monotonicNow() - begin);
        Sum& sum = sums[name];
        sum.seconds += seconds;
        sum.longest = std::max(sum.longest, seconds);
        sum.overTwo += std::max(0.0, seconds - 0.002);
        ++sum.count;
        return result;
    }

private:
    bool m_inside = false;
};

int events(EventTimes& application, Bench& bench) {
    constexpr double kSeconds = 20;
    application.watching = true;
    bench.share(kSeconds);
    const auto print = [&](const char* what) {
        application.watching = false;
        std::vector<std::pair<QString, EventTimes::Sum>> sorted(application.sums.begin(),
                                                                application.sums.end());
        std::sort(sorted.begin(), sorted.end(),
                  [](const auto& a, const auto& b) { return a.second.seconds > b.second.seconds; });
        std::printf("%s\n", what);
        for (const auto& [name, sum] : sorted)
            if (sum.seconds > 0.01)
                std::printf("%7d times, mean %6.2f, longest %6.2f ms, beyond 2 ms %5.2f %% of the time: %s\n",
                            sum.count, 1e3 * sum.seconds / sum.count, 1e3 * sum.longest,
                            100 * sum.overTwo / kSeconds, qPrintable(name));
        application.sums.clear();
        application.watching = true;
    };
    print("in 20 s at rest");
    bench.keystrokes();
    print("while digits are typed");
    bench.switches();
    print("while modules are switched");
    return 0;
}

int paints(Bench& bench) {
    PaintCount count;
    qApp->installEventFilter(&count);
    constexpr double kSeconds = 5;
    bench.share(kSeconds);
    std::vector<std::pair<int, QString>> sorted;
    for (const auto& [name, number] : count.counts)
        sorted.emplace_back(number, name);
    std::sort(sorted.rbegin(), sorted.rend());
    for (const auto& [number, name] : sorted)
        std::printf("%7.1f/s %s\n", number / kSeconds, qPrintable(name));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    EventTimes application(argc, argv);
    look::setUp(application);
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    const std::string_view mode = argc > 1 ? argv[1] : "20";
    if (mode == "paints" || mode == "events") {
        Bench bench;
        return mode == "paints" ? paints(bench) : events(application, bench);
    }
    const std::vector<double> bare = keystrokesInBareWindow();
    Bench bench;
    const double seconds = std::strtod(mode.data(), nullptr);
    std::printf(
        "window: 32 modules at 115200 Bd, four strips, %.0f s: GUI thread %.1f %% of a core (aim 7)\n",
        seconds, 100 * bench.share(seconds));
    const std::vector<double> keys = bench.keystrokes();
    std::printf(
        "window: keystroke to its repaint: p50 %.1f, p99 %.1f ms (aim 1.5), %zu of %d; bare: p50 %.1f, p99 %.1f ms\n",
        percentile(keys, 0.5), percentile(keys, 0.99), keys.size(), kTrials, percentile(bare, 0.5),
        percentile(bare, 0.99));
    const std::vector<double> switches = bench.switches();
    std::printf("window: switching modules: p50 %.1f, p99 %.1f ms (aim 16), %zu of %d\n",
                percentile(switches, 0.5), percentile(switches, 0.99), switches.size(), kTrials);
}
