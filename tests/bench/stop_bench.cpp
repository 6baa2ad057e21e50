// SPDX-License-Identifier: GPL-3.0-or-later
// The time from the request to the last byte of the stop on the wire, with 32 modules moving and the whole
// window in use: by the Esc key in a dialog, by another program, and from another thread while the GUI thread
// is blocked.
//   stop_bench [TRIALS]    of each way, at two rates; 100 take half an hour, most of it to start 32 motors
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QInputDevice>
#include <QKeyEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <set>
#include <string_view>
#include <thread>

#include "app/composition.h"
#include "link/clock.h"
#include "tests/support/gains.h"
#include "timedchain.h"
#include "widgets/common/look.h"

namespace {

using namespace nmc;
using namespace std::chrono_literals;
using bench::TimedChain;
using bench::WirePacket;

constexpr std::size_t kModules = 32;
constexpr std::uint8_t kAllModules = 0xFF;
constexpr int kPatienceMs = 60'000;
constexpr double kAllowedMs = 2.0;  // on top of the packet that is being sent (issue 4, point 3)

double ms(Duration time) {
    return toSeconds(time) * 1e3;
}

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "stop_bench: %s\n", what);
    std::exit(1);
}

bool becomesTrue(const std::function<bool()>& condition, int patienceMs) {
    // A real event loop, because QTest::qWaitFor sleeps 10 ms at a time.
    QEventLoop loop;
    QElapsedTimer patience;
    patience.start();
    QTimer check;
    check.setInterval(5);
    QObject::connect(&check, &QTimer::timeout, &loop, [&] {
        if (condition() || patience.elapsed() > patienceMs)
            loop.quit();
    });
    check.start();
    loop.exec();
    return condition();
}

void waitFor(const char* what, const std::function<bool()>& condition) {
    if (!becomesTrue(condition, kPatienceMs))
        fail(what);
}

bus::Order step(std::uint8_t module, ServoCommand command) {
    return {ModuleIndex(module), std::move(command)};
}

struct Trial {
    double first = 0;         ///< ms from the request to the first byte of the stop
    double last = 0;          ///< ms to the last byte of the packet that stops the last module
    double bound = 0;         ///< for `last`: rest of the packet being sent + 2 ms + the stop's own bytes
    std::size_t packets = 0;  ///< of the stop: one to the group of all, or one per module
    bool begun = false;       ///< another packet began between the request and the stop
};

class Bench {
public:
    explicit Bench(std::uint32_t baud)
        : m_chain(kModules),
          m_settings(m_directory.filePath(QStringLiteral("panel.ini")), QSettings::IniFormat),
          m_composition(m_settings) {
        QObject::connect(&m_composition.store(), &BusStore::happened, [this](const StoreEvent& event) {
            m_stops += std::holds_alternative<bus::StopFinished>(event) ? 1 : 0;
        });
        const QString terminal = QString::fromStdString(m_chain.terminal());
        m_composition.show({.port = terminal, .baud = baud, .programs = Start::Programs::LetIn});
        waitFor("no chain", [&] { return link().phase == LinkPhase::Connected; });
        sockaddr_un place{.sun_family = AF_UNIX, .sun_path = {}};
        ApiServer::pathFor(terminal).toLocal8Bit().toStdString().copy(place.sun_path,
                                                                      sizeof place.sun_path - 1);
        if (::connect(m_program, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0)
            fail("programs are not let in");
        if (link().modules.size() != kModules)
            fail("not 32 modules");
        m_dialog.show();
        const servo::StopMotor hold{true, servo::StopManner::Abruptly, {}};
        for (std::uint8_t i = 0; i < kModules; ++i)
            submit({step(i, testing_support::kGains), step(i, hold)});
        waitFor("not enabled", [&] { return all(&ModuleState::servoOn); });
    }

    Trial byKey() {
        startAll();
        QObject* target = &m_dialog;
        return trial([target] {
            QCoreApplication::postEvent(target,
                                        new QKeyEvent(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier));
        });
    }

    Trial byProgram() {
        startAll();
        return trial([this] {
            constexpr std::string_view line = "{\"jsonrpc\":\"2.0\",\"method\":\"stop\"}\n";
            if (::write(m_program, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
                fail("the panel does not read");
        });
    }

    Trial whileBlocked() {
        startAll();
        std::atomic<bool> asked{false};
        const int before = m_stops;
        std::thread other([&] {
            requested([this] { m_composition.worker().stopAll(); });
            asked = true;
            asked.notify_one();
        });
        asked.wait(false);  // no event is handled here in the meantime
        other.join();
        waitFor("stop not finished", [&] { return m_stops > before; });
        return evaluate();
    }

private:
    [[nodiscard]] const LinkState& link() const { return m_composition.store().link(); }
    [[nodiscard]] bool all(bool (ModuleState::*is)() const) const {
        return std::all_of(link().modules.begin(), link().modules.end(),
                           [is](const ModuleState& module) { return (module.*is)(); });
    }
    void submit(std::vector<bus::Order> steps) {
        m_composition.worker().ask(
            bus::Operation{bus::OperationId(1'000'000 + ++m_operation), std::move(steps)});
    }

    void startAll() {
        servo::LoadTrajectory load;
        load.velocity = CountsPerTick(4 << 16);
        load.acceleration = CountsPerTickSquared(6'554);  // 0.1 counts/tick^2
        load.profile = servo::ProfileMode::Velocity;
        // On a machine that is busy with something else, a start may end in doubt; the engine does not repeat
        // it.
        for (int attempt = 0; attempt < 5; ++attempt) {
            for (std::uint8_t i = 0; i < kModules; ++i)
                if (!link().modules[i].moving())
                    submit({step(i, load), step(i, StartMotion{})});
            if (becomesTrue([&] { return all(&ModuleState::moving); }, kPatienceMs / 6))
                return;
        }
        fail("not moving");
    }

    /// Called in a thread other than the GUI's, at a random moment.
    void requested(const std::function<void()>& request) {
        std::this_thread::sleep_for(std::chrono::microseconds(m_phase(m_random)));
        m_requested = monotonicNow();
        request();
    }

    Trial trial(const std::function<void()>& request) {
        const int before = m_stops;
        std::thread other([&] { requested(request); });
        waitFor("stop not finished", [&] { return m_stops > before; });
        other.join();
        m_dialog.show();
        return evaluate();
    }

    Trial evaluate() {
        Trial trial;
        std::optional<TimePoint> first;
        TimePoint last;
        Duration own{};
        std::set<std::uint8_t> told;
        Duration beingSent{};
        bool begun = false;
        for (const WirePacket& packet : m_chain.takePackets()) {
            if (packet.begins <= m_requested && packet.ends > m_requested)
                beingSent = packet.ends - m_requested;
            begun = begun || (!first && packet.begins > m_requested && packet.code != CommandCode::StopMotor);
            // Those after that are repetitions, to be confirmed by each module.
            if (packet.code != CommandCode::StopMotor || packet.ends <= m_requested ||
                told.size() == kModules)
                continue;
            if (packet.address == kAllModules)
                for (std::uint8_t i = 1; i <= kModules; ++i)
                    told.insert(i);
            else
                told.insert(packet.address);
            first = first.value_or(packet.begins);
            last = packet.ends;
            own += packet.ends - packet.begins;
            ++trial.packets;
        }
        if (told.size() < kModules)
            fail("a module was not told to stop");
        trial.begun = begun;
        trial.first = ms(*first - m_requested);
        trial.last = ms(last - m_requested);
        trial.bound = ms(beingSent + own) + kAllowedMs;
        return trial;
    }

    TimedChain m_chain;
    QTemporaryDir m_directory;
    QSettings m_settings;
    Composition m_composition;
    QDialog m_dialog{&m_composition.window()};
    const int m_program = ::socket(AF_UNIX, SOCK_STREAM, 0);
    std::mt19937 m_random{1};
    std::uniform_int_distribution<int> m_phase{0, 60'000};  // us: some polls long
    TimePoint m_requested;
    int m_stops = 0;
    std::uint32_t m_operation = 0;
};

double percentile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(rank, 1) - 1];
}

void report(const char* way, std::uint32_t baud, const std::vector<Trial>& trials) {
    std::vector<double> first;
    std::vector<double> last;
    std::vector<double> over;
    std::size_t packets = 0;
    for (const Trial& trial : trials) {
        first.push_back(trial.first);
        last.push_back(trial.last);
        over.push_back(trial.last - trial.bound);
        packets = std::max(packets, trial.packets);
    }
    const auto late = std::count_if(over.begin(), over.end(), [](double ms) { return ms > 0; });
    // Until the key has passed through the GUI thread, the bus does not know of it.
    const auto begun = std::count_if(trials.begin(), trials.end(), [](const Trial& trial) {
        return trial.begun && trial.last > trial.bound;
    });
    std::printf(
        "stop: %6u Bd, %s: first byte p50 %.2f p99 %.2f ms, last byte p50 %.2f p99 %.2f ms; over the bound "
        "(packet being sent + %.0f ms + the stop's own bytes) by p50 %.2f p99 %.2f ms, %lld of %zu late, "
        "%lld of them behind a packet that began meanwhile; at most %zu packets\n",
        baud, way, percentile(first, 0.5), percentile(first, 0.99), percentile(last, 0.5),
        percentile(last, 0.99), kAllowedMs, percentile(over, 0.5), percentile(over, 0.99),
        static_cast<long long>(late), trials.size(), static_cast<long long>(begun), packets);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    look::setUp(application);
    QApplication::setQuitOnLastWindowClosed(false);
    // Messages of the platform do not matter here.
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    (void)QInputDevice::primaryKeyboard();  // belongs to this thread
    const int trials = argc > 1 ? std::atoi(argv[1]) : 100;
    const QTemporaryDir runtime;
    qputenv("XDG_RUNTIME_DIR", runtime.path().toUtf8());
    for (const std::uint32_t baud : {19'200U, 115'200U}) {
        Bench bench(baud);
        const auto measure = [&](const char* way, Trial (Bench::*trial)()) {
            std::vector<Trial> measured;
            for (int i = 0; i < trials; ++i)
                measured.push_back((bench.*trial)());
            report(way, baud, measured);
        };
        measure("Esc in a dialog            ", &Bench::byKey);
        measure("another program            ", &Bench::byProgram);
        measure("other thread, GUI blocked  ", &Bench::whileBlocked);
    }
}
