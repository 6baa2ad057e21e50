// SPDX-License-Identifier: GPL-3.0-or-later
// The time from the death of a panel until its motor slows down, over many kills at random moments; and
// whether the guardian ever stops a motor of a panel that is alive, on a machine that is far too busy.
//   guardian_bench [KILLS [MINUTES]]
//   guardian_bench panel TERMINAL BAUD REPORT      what is killed: the bus loop of the panel on a serial port
#include <sys/wait.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QTemporaryDir>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string_view>

#include "link/clock.h"
#include "link/connection/processguard.h"
#include "link/connection/serialtransport.h"
#include "link/guardian/guardreport.h"
#include "tests/link/looprig.h"
#include "tests/support/lineprocess.h"
#include "tests/support/simprocess.h"

namespace {

using namespace nmc;
using namespace std::chrono_literals;
using testing_support::LineProcess;
using testing_support::SimProcess;

constexpr double kAllowedMs = 250;
constexpr int kLoad = 8;

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "guardian_bench: %s\n", what);
    std::exit(1);
}

/// Sets motor 1 in motion and prints "moving"; prints "stopped" when its guardian has stopped it.
int panel(char** arguments) {
    testing_support::LoopRig rig;
    ProcessGuard guard({NMCGUARD_PATH, arguments[2]});
    rig.loop.addGuard(guard);
    bus::EngineConfig config;
    config.baud = static_cast<std::uint32_t>(std::atoi(arguments[1]));
    rig.openTransport<SerialTransport>(config, QString::fromLocal8Bit(arguments[0]));
    if (!rig.waitFor<bus::ChainFound>())
        return 1;
    rig.loop.ask(testing_support::runOn(1));
    if (!rig.waitFor<bus::OperationFinished>() || rig.count<GuardianMissing>() > 0)
        return 1;
    std::puts("moving");
    std::fflush(stdout);
    std::size_t told = 0;
    while (true)
        if (rig.waitUntil([&] { return rig.count<GuardianStopped>() > told; })) {
            ++told;
            std::puts("stopped");
            std::fflush(stdout);
        }
}

double velocity(SimProcess& sim) {
    return std::abs(sim.state(1)["velocity"].get<double>());
}

void pause(Duration time) {
    pollUntil({}, monotonicNow() + time);
}

/// A panel whose motor has reached its speed, and that speed.
std::pair<std::unique_ptr<LineProcess>, double> runningPanel(SimProcess& sim, int baud,
                                                             const std::string& report) {
    const std::string program = QCoreApplication::applicationFilePath().toStdString();
    auto process = std::make_unique<LineProcess>(
        std::vector<std::string>{program, "panel", sim.terminal(), std::to_string(baud), report});
    if (process->answer() != "moving")
        fail("the panel does not start");
    constexpr double kWanted = 4;  // counts/tick
    const TimePoint limit = monotonicNow() + 20s;
    while (velocity(sim) < 0.95 * kWanted)
        if (monotonicNow() > limit)
            fail("the motor does not come up to its speed");
    return {std::move(process), kWanted};
}

double killOnce(SimProcess& sim, int baud, const QTemporaryDir& folder, Duration phase) {
    const auto [process, speed] = runningPanel(sim, baud, guardReportFile(folder.path().toStdString()));
    pause(phase);
    ::kill(process->pid(), SIGKILL);
    const TimePoint died = monotonicNow();
    while (velocity(sim) > 0.9 * speed)
        if (monotonicNow() - died > 5s)
            fail("the motor runs on");
    const double took = toSeconds(monotonicNow() - died) * 1e3;
    while (takeGuardReports(folder.path().toStdString()).empty())
        pause(1ms);
    pause(100ms);  // the guardian ends, and the motor comes to rest
    return took;
}

void measureKills(int baud, int kills) {
    QTemporaryDir folder;
    SimProcess sim("servo,servo");
    std::mt19937 random(1);
    std::uniform_int_distribution<int> phase(0, 60'000);  // us: some polls long
    std::vector<double> times;
    for (int i = 0; i < kills; ++i)
        times.push_back(killOnce(sim, baud, folder, std::chrono::microseconds(phase(random))));
    std::sort(times.begin(), times.end());
    const auto late = std::count_if(times.begin(), times.end(), [](double ms) { return ms > kAllowedMs; });
    std::printf(
        "guardian: %6d Bd, %zu kills: death to the shaft slowing down p50 %.1f p99 %.1f max %.1f ms, "
        "%lld over %.0f ms\n",
        baud, times.size(), times[times.size() / 2], times[(times.size() * 99 - 1) / 100], times.back(),
        static_cast<long long>(late), kAllowedMs);
    std::fflush(stdout);
}

/// The only child of a process.
pid_t childOf(pid_t process) {
    for (const auto& task :
         std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
        std::ifstream children(task.path() / "children");
        if (pid_t child = -1; children >> child)
            return child;
    }
    fail("no guardian");
}

/// Processor time that a process has taken so far, in seconds.
double computed(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    std::istringstream fields(text.substr(text.rfind(')') + 2));
    std::string field;
    long user = 0;
    long system = 0;
    for (int i = 0; i < 11; ++i)
        fields >> field;
    fields >> user >> system;
    return static_cast<double>(user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

void measureFalseStops(double minutes) {
    QTemporaryDir folder;
    SimProcess sim("servo,servo");
    auto [process, speed] = runningPanel(sim, 115'200, guardReportFile(folder.path().toStdString()));
    std::vector<pid_t> load;
    for (int i = 0; i < kLoad; ++i) {
        load.push_back(::fork());
        if (load.back() == 0)
            for (std::atomic<unsigned> n{0};; ++n) {
            }
    }
    const pid_t guard = childOf(process->pid());
    const double before = computed(guard);
    const TimePoint began = monotonicNow();
    bool stopped = false;
    while (!stopped && toSeconds(monotonicNow() - began) < minutes * 60) {
        pause(100ms);
        stopped = velocity(sim) < 0.5 * speed;
    }
    const double took = toSeconds(monotonicNow() - began);
    std::printf("guardian: %.1f minutes at a load of %d: %s; it took %.3f %% of a core\n", took / 60, kLoad,
                stopped ? "A FALSE STOP" : "no false stop", 100 * (computed(guard) - before) / took);
    for (const pid_t one : load) {
        ::kill(one, SIGKILL);
        ::waitpid(one, nullptr, 0);
    }
    ::kill(process->pid(), SIGKILL);
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    if (argc == 5 && std::string_view(argv[1]) == "panel")
        return panel(argv + 2);
    const int kills = argc > 1 ? std::atoi(argv[1]) : 200;
    const double minutes = argc > 2 ? std::atof(argv[2]) : 10;
    for (const int baud : {19'200, 115'200})
        if (kills > 1)
            measureKills(baud, kills / 2);
    if (minutes > 0)
        measureFalseStops(minutes);
    return 0;
}
