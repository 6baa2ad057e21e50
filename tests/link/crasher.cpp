// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a motor through the real worker and the real serial port, says "moving", waits for a line on standard
// input, and then dies in the way and in the thread that the arguments name:
//   crasher TERMINAL gui|bus segv|abort|overflow|kill
#include <QCoreApplication>
#include <QThread>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "link/connection/crashburst.h"
#include "tests/link/connection.h"

namespace {

using namespace nmc;

/// Deeper than any stack.
int overflow(volatile int* depth) {
    volatile int here[1'024];
    here[*depth % 1'024] = *depth;
    *depth = *depth + 1;
    return *depth > 0 ? overflow(depth) + here[0] : 0;
}

void die(const char* how) {
    if (std::strcmp(how, "segv") == 0) {
        // Not null, which a sanitizer would catch before the hardware does; but never mapped.
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

/// A serial port in whose bus thread something goes wrong.
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

}  // namespace

int main(int argc, char** argv) {
    using namespace nmc::testing_support;
    const QCoreApplication application(argc, argv);
    if (argc != 4)
        return 2;
    const crashburst::HandlerStack stack;
    crashburst::installHandlers();
    Connection connection;
    connection.open([argv] { return std::make_unique<Mine>(QString::fromLocal8Bit(argv[1]), argv[3]); });
    if (!connection.waitFor<bus::ChainFound>() ||
        connection.carryOut(gainsAndEnable(1)) != bus::Outcome::Done ||
        connection.carryOut(move(1, 100'000'000)) != bus::Outcome::Done ||
        !connection.waitUntil([&] { return connection.module(1).activity() == Activity::AtSpeed; }))
        return 3;
    std::puts("moving");
    std::fflush(stdout);
    std::getchar();
    if (std::strcmp(argv[2], "gui") == 0)
        die(argv[3]);
    Mine::s_lit = true;
    QThread::sleep(20);  // the other thread ends this
    return 4;
}
