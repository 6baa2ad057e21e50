// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a motor through the real worker and the real serial port, says "moving", waits for a line on standard
// input, and then dies in the way and in the thread that the arguments name:
//   crasher TERMINAL gui|bus|close segv|abort|overflow|kill [BAUD trapezoid|velocity|hold|group|look
//   NMCGUARD REPORT]
// With "look" it moves nothing, and only watches what another program moves. With a guardian it says
// "stopped" when the guardian has stopped the motors while this program was alive, "moving" when it has
// started them again, and "unguarded" when it no longer has a guardian.
#include <unistd.h>
#include <QCoreApplication>
#include <QSocketNotifier>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "link/connection/crashburst.h"
#include "link/connection/processguard.h"
#include "tests/link/connection.h"

namespace {

using namespace nmc;

/// Recurses deeper than any stack allows.
int overflow(volatile int* depth) {
    volatile int here[1'024];
    here[*depth % 1'024] = *depth;
    *depth = *depth + 1;
    return *depth > 0 ? overflow(depth) + here[0] : 0;
}

void die(const char* how) {
    if (std::strcmp(how, "segv") == 0) {
        // Not null, which a sanitizer would catch before the hardware does, but an address that is never
        // mapped.
        auto* nowhere = reinterpret_cast<volatile int*>(std::uintptr_t{4'096});
        *nowhere = 1;
    }
    if (std::strcmp(how, "overflow") == 0) {
        volatile int depth = 0;
        overflow(&depth);
    }
    if (std::strcmp(how, "kill") == 0)
        std::raise(SIGKILL);
    std::abort();
}

/// A serial port that dies in its bus thread when told to.
class Mine : public SerialTransport {
public:
    Mine(const QString& port, const char* how) : SerialTransport(port), m_how(how) {}
    tl::expected<std::vector<std::uint8_t>, PortError> receive(std::optional<TimePoint> until,
                                                               int wakeFd) override {
        if (s_lit)
            die(m_how);
        return SerialTransport::receive(until, wakeFd);
    }
    inline static std::atomic<bool> s_lit{false};

private:
    const char* m_how;
};

void say(const char* word) {
    std::puts(word);
    std::fflush(stdout);
}

/// Runs motor 2 without an end in a motion of this kind; `hold` keeps a held one going.
bool setGoing(testing_support::Connection& connection, std::string_view motion, QTimer& hold) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(8 << 16);
    load.acceleration = CountsPerTickSquared(1'311);
    load.profile = servo::ProfileMode::Velocity;
    if (motion == "trapezoid")
        return connection.carryOut(testing_support::move(1, 100'000'000)) == bus::Outcome::Done;
    if (motion == "velocity")
        return connection.carryOut({testing_support::step(1, load),
                                    testing_support::step(1, StartMotion{})}) == bus::Outcome::Done;
    if (motion == "hold") {
        static std::uint32_t press = 0;
        bus::HoldToMove held{ModuleIndex(1), *load.velocity, *load.acceleration};
        held.press = ++press;
        QObject::connect(&hold, &QTimer::timeout, [&connection, held] { connection.worker().hold(held); });
        hold.start(50);
        return true;
    }
    const auto group = [&connection](std::uint32_t id, auto what) {
        connection.forgetNews();
        connection.worker().ask(bus::GroupOperation{bus::OperationId(id), what});
        return connection.waitFor<bus::GroupFinished>() &&
               connection.news<bus::GroupFinished>()->outcome == bus::Outcome::Done;
    };
    for (const std::uint8_t module : {std::uint8_t{0}, std::uint8_t{1}})
        if (!group(1'000U + module, bus::GroupChange{ModuleIndex(module), {0x81, module == 1}}) ||
            (module == 0 &&
             connection.carryOut(testing_support::gainsAndEnable(module)) != bus::Outcome::Done) ||
            connection.carryOut({testing_support::step(module, load)}) != bus::Outcome::Done)
            return false;
    return group(1'002, bus::GroupCommand{0x81, bus::GroupCommand::Action::StartMotion});
}

}  // namespace

int main(int argc, char** argv) {
    using namespace nmc::testing_support;
    const QCoreApplication application(argc, argv);
    if (argc != 4 && argc != 8)
        return 2;
    const bool guarded = argc == 8;
    const crashburst::HandlerStack stack;
    crashburst::installHandlers();
    QTimer hold;
    ProcessGuard guard(guarded ? GuardianPlace{argv[6], argv[7]} : GuardianPlace{});
    Connection connection;
    if (guarded)
        connection.worker().addGuard(guard);
    const std::string_view motion = guarded ? argv[5] : "trapezoid";
    bus::EngineConfig config;
    config.readOnly = motion == "look";
    if (guarded)
        config.baud = static_cast<std::uint32_t>(std::atoi(argv[4]));
    connection.open([argv] { return std::make_unique<Mine>(QString::fromLocal8Bit(argv[1]), argv[3]); },
                    config);
    if (!connection.waitFor<bus::ChainFound>())
        return 3;
    const auto goes = [&] {
        return connection.carryOut(gainsAndEnable(1)) == bus::Outcome::Done &&
               setGoing(connection, motion, hold) &&
               connection.waitUntil([&] { return connection.module(1).activity() == Activity::AtSpeed; });
    };
    if (config.readOnly ? !connection.waitUntil([&] { return connection.store().movingMotors() > 0; })
                        : !goes())
        return 3;
    connection.forgetNews();
    QTimer goesAgain;
    goesAgain.setSingleShot(true);
    QObject::connect(&goesAgain, &QTimer::timeout, [&] {
        hold.disconnect();
        if (connection.waitFor<bus::StopFinished>() && goes())
            say("moving");
    });
    QObject::connect(&connection.store(), &BusStore::happened, [&](const StoreEvent& event) {
        if (std::holds_alternative<GuardianStopped>(event)) {
            say("stopped");
            goesAgain.start(0);
        }
        if (std::holds_alternative<GuardianMissing>(event))
            say("unguarded");
    });
    QSocketNotifier told(STDIN_FILENO, QSocketNotifier::Read);
    QObject::connect(&told, &QSocketNotifier::activated, [&] {
        told.setEnabled(false);
        if (std::strcmp(argv[2], "gui") == 0)
            die(argv[3]);
        if (std::strcmp(argv[2], "close") == 0)
            return QCoreApplication::quit();
        Mine::s_lit = true;  // the bus thread ends the process
    });
    say("moving");
    return QCoreApplication::exec();
}
