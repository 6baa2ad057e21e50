// SPDX-License-Identifier: GPL-3.0-or-later
// nmcsim: a simulated chain of NMC modules on a pseudo-terminal.
#include <sys/signalfd.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/longoptions.h"
#include "base/numbertext.h"
#include "link/terminal/ptyserver.h"
#include "link/terminal/simserver.h"
#include "link/threadpriority.h"
#include "sim/chain.h"
#include "sim/chainspec.h"
#include "sim/control.h"

namespace {

constexpr int kBadArguments = 2;

struct Options {
    std::string chain{nmc::sim::kDefaultChain};
    std::string link;
    nmc::Pacing pacing;
    nmc::sim::ChainOptions simulation;
};

[[noreturn]] void refuse(const std::string& sentence) {
    std::fprintf(stderr, "nmcsim: %s\n", sentence.c_str());
    std::exit(kBadArguments);
}

void printHelp() {
    std::printf(
        "Usage: nmcsim [OPTION]...\n"
        "Simulates a chain of NMC motor modules behind a pseudo-terminal, which any host program can\n"
        "open as a serial port. The first line of output is \"ready\" and the terminal's path.\n"
        "\n"
        "Options:\n"
        "  --chain CHAIN          modules, farthest from the host first: a comma list of\n"
        "                         servo[@VERSION], version 1 to 4, 5 (CMC) or 10 (SC), step[@VERSION]\n"
        "                         and io[@VERSION], version 1; default %s\n"
        "  --link PATH            also make a symbolic link PATH to the terminal\n"
        "  --speed X              simulated seconds per real second\n"
        "  --stepped              time stands still but for the control line: advance SECONDS\n"
        "  --unpaced              replies take no wire time\n"
        "  --reset-dead-time MS   how long a module is deaf after a reset; default 8\n"
        "  --deaf-when-addr-in-rises  a module that was awake goes deaf when its ADDR_IN rises again;\n"
        "                         the data sheets are silent on it, and without this it stays awake\n"
        "  --line-margin PERCENT  how far off a rate may be before bytes are garbled; default 3.9,\n"
        "                         a clean line; less: slow edges or noise\n"
        "  --seed N               seed of everything random\n"
        "  --enable-faults        take fault lines\n"
        "  --help                 show this help\n"
        "  --version              show the version\n"
        "\n"
        "%s"
        "\n"
        "Besides these:\n"
        "  advance SECONDS        with --stepped: time passes\n"
        "  quit                   the end\n"
        "\n"
        "Faults, with --enable-faults:\n"
        "  fault bus|module K[,K...] KIND [cmd|status] [on=COMMAND] [p=PROB] [n=COUNT] [t=A..B]\n"
        "        [at=TIME] [for=DURATION] [bit=B]\n"
        "\n"
        "Kinds of faults:\n"
        "  of packets             drop dup flip collide truncate garbage overrun delay silent cksum\n"
        "                         ignore=COMMAND stuck\n"
        "  of the line            noise break mute rx|tx echo foreign\n"
        "  of the module          powercycle stall reverse sameaddr definestat\n"
        "\n"
        "Examples:\n"
        "  nmcsim --chain servo,servo@1,step --link /tmp/nmc\n"
        "      three modules; programs open /tmp/nmc as their serial port, at 19200 Bd to begin with\n"
        "  nmcpanel --port /tmp/nmc --baud 115200\n"
        "      the panel on it, meanwhile\n"
        "  (sleep 5; echo set 1 limit1 1; sleep 1; echo state 1; echo quit) | nmcsim --chain servo\n"
        "      after 5 s limit switch 1 closes; the truth about the module a second later; the end\n"
        "  nmcsim --stepped --chain servo --link /tmp/nmc\n"
        "      for tests: what a program has written leaves, and time passes, at: advance 0.02\n",
        std::string(nmc::sim::kDefaultChain).c_str(), nmc::sim::controlHelp().c_str());
}

template <typename T>
T number(const char* option, const char* text, T min, T max, const char* range) {
    const auto value = nmc::numberIn<T>(text);
    if (!value || !(*value >= min && *value <= max))
        refuse(std::string(option) + " takes a number " + range + ", not \"" + text + "\".");
    return *value;
}

Options readOptions(int argc, char** argv) {
    Options options;
    nmc::sim::ChainOptions& simulation = options.simulation;
    const std::vector<nmc::LongOption> all{
        {"chain", required_argument, [&](const char* value) { options.chain = value; }},
        {"link", required_argument, [&](const char* value) { options.link = value; }},
        {"speed", required_argument,
         [&](const char* value) {
             options.pacing.speed = number("--speed", value, 0.001, 1000.0, "from 0.001 to 1000");
         }},
        {"stepped", no_argument, [&](const char*) { options.pacing.stepped = true; }},
        {"unpaced", no_argument, [&](const char*) { simulation.unpaced = true; }},
        {"reset-dead-time", required_argument,
         [&](const char* value) {
             simulation.resetDeadTime = nmc::fromSeconds(
                 1e-3 * number("--reset-dead-time", value, 0.0, 10'000.0, "of milliseconds from 0 to 10000"));
         }},
        {"deaf-when-addr-in-rises", no_argument,
         [&](const char*) { simulation.deafWhenAddressInputRises = true; }},
        {"line-margin", required_argument,
         [&](const char* value) {
             simulation.lineMargin =
                 1e-2 * number("--line-margin", value, 0.0, 5.0, "of percent from 0 to 5");
         }},
        {"seed", required_argument,
         [&](const char* value) {
             simulation.seed =
                 number<std::uint64_t>("--seed", value, 0, UINT64_MAX, "from 0 to 18446744073709551615");
         }},
        {"enable-faults", no_argument, [&](const char*) { simulation.enableFaults = true; }},
    };
    if (!nmc::takeLongOptions(argc, argv, "", all, &printHelp, "nmcsim " NMC_VERSION)) {
        std::fprintf(stderr, "Try nmcsim --help.\n");
        std::exit(kBadArguments);
    }
    if (optind < argc)
        refuse("\"" + std::string(argv[optind]) + "\" is not an option. Try nmcsim --help.");
    return options;
}

/// Provides SIGTERM and SIGINT as a readable descriptor, so that the server ends its loop and removes its
/// link.
int catchSignals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGINT);
    sigprocmask(SIG_BLOCK, &signals, nullptr);
    std::signal(SIGPIPE, SIG_IGN);  // the reader of the output may go away; the chain stays
    return ::signalfd(-1, &signals, SFD_CLOEXEC);
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = readOptions(argc, argv);
    const auto modules = nmc::sim::parseChain(options.chain);
    if (!modules)
        refuse(modules.error());
    auto terminal = nmc::PtyServer::create(options.link);
    if (!terminal)
        refuse(terminal.error() + ".");

    const int stop = catchSignals();
    // The simulated chips do not wait for other work on this computer, and neither does a host's bus thread.
    nmc::preferThisThread();
    // "ready" means able to receive the first byte: the chain was switched on one dead time ago.
    nmc::sim::ChainOptions simulation = options.simulation;
    simulation.hostHasOwnClock = !options.pacing.stepped;
    nmc::sim::Chain chain(*modules, simulation);
    chain.advanceTo(nmc::TimePoint{} + options.simulation.resetDeadTime);
    const std::string path = terminal->path();
    nmc::SimServer server(std::move(chain), std::move(*terminal), options.pacing, STDIN_FILENO,
                          STDOUT_FILENO);
    std::printf("ready %s\n", path.c_str());
    std::fflush(stdout);
    server.run(stop);
    return 0;
}
