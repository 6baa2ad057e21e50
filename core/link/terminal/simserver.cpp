// SPDX-License-Identifier: MIT
#include "link/terminal/simserver.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <utility>

#include "link/clock.h"
#include "protocol/baud.h"

namespace nmc {

namespace {

/// A line that never ends must not fill the memory; enough of a longer line is kept to recognize it as too
/// long.
constexpr std::size_t kMaxLine = 4'096;
/// Together with kLate, this is well below the time that any host waits for an answer: a host that gave up on
/// a simulator that was asleep does not count as hasty.
constexpr Duration kAtLeastEvery = std::chrono::milliseconds(5);
constexpr Duration kLate = std::chrono::milliseconds(2);
constexpr Duration kSlice = std::chrono::milliseconds(10);      // simulated
constexpr Duration kCatchUpFor = std::chrono::milliseconds(5);  // real

/// The words of a control line, with one blank between them.
std::string wordsOf(const std::string& line) {
    std::istringstream rest(line);
    std::string words;
    for (std::string word; rest >> word;)
        words += (words.empty() ? "" : " ") + word;
    return words;
}

}  // namespace

SimServer::SimServer(sim::Chain chain, PtyServer terminal, const Pacing& pacing, int controlIn,
                     int controlOut)
    : m_chain(std::move(chain)),
      m_terminal(std::move(terminal)),
      m_pacing(pacing),
      m_controlIn(controlIn),
      m_controlOut(controlOut),
      m_hostBaud(kPowerUpBaud),
      m_now(m_chain.statistics().time) {
    m_started = monotonicNow() - fromSeconds(toSeconds(m_now.time_since_epoch()) / m_pacing.speed);
}

void SimServer::run(int stopFd) {
    wantFineTimers();
    while (true) {
        std::array<pollfd, 4> fds{{{stopFd, POLLIN, 0},
                                   {m_terminal.fd(), POLLIN, 0},
                                   {m_terminal.actsFd(), POLLIN, 0},
                                   {m_controlOpen ? m_controlIn : -1, POLLIN, 0}}};
        const auto alarm = wakeUpAt();
        pollUntil(fds, alarm);
        if (fds[0].revents != 0)
            return;
        m_overslept = alarm && monotonicNow() > *alarm + kLate;
        if (!m_pacing.stepped)
            m_stalls.runs(monotonicNow());
        catchUp();
        serveHost();
        if (fds[3].revents != 0 && !serveControl())
            return;
    }
}

// ---- Time ----

TimePoint SimServer::wantedNow() const {
    if (m_pacing.stepped)
        return m_now;
    return TimePoint(fromSeconds(toSeconds(monotonicNow() - m_started) * m_pacing.speed));
}

TimePoint SimServer::realTimeOf(TimePoint simulated) const {
    return m_started + fromSeconds(toSeconds(simulated.time_since_epoch()) / m_pacing.speed);
}

/// Idle motors are also advanced regularly; otherwise the first query would have to wait for it.
std::optional<TimePoint> SimServer::wakeUpAt() const {
    if (m_pacing.stepped)
        return std::nullopt;
    const TimePoint latest = realTimeOf(m_now) + kAtLeastEvery;
    const auto event = m_chain.nextEvent();
    return event ? std::min(latest, realTimeOf(*event)) : latest;
}

/// Advances as far as a short real time allows: a simulation that cannot keep up still serves its host and
/// its control lines, at the simulated time that it has reached.
void SimServer::catchUp() {
    const TimePoint goal = wantedNow();
    const TimePoint enough = monotonicNow() + kCatchUpFor;
    do {
        m_now = std::min(goal, m_now + kSlice);
        m_chain.advanceTo(m_now);
    } while (m_now < goal && monotonicNow() < enough);
    deliver();
    const Duration behind = m_now < goal ? realTimeOf(goal) - realTimeOf(m_now) : Duration{};
    if (const auto sentence = m_lagReport.sentence(behind, monotonicNow()))
        std::fprintf(stderr, "nmcsim: %s\n", sentence->c_str());
}

// ---- The host ----

void SimServer::serveHost() {
    const HostActs acts = m_terminal.takeActs();
    const std::uint32_t baud = acts.baud.value_or(m_hostBaud);
    if (acts.bytes.empty() && baud == m_hostBaud && !acts.hungUp)
        return;
    m_received += acts.bytes.size();
    const bool late = m_overslept || wantedNow() > m_now + kLate;
    const std::size_t before = m_rateOrder.beforeNewRate(acts, m_hostBaud, m_chain.understands(m_hostBaud));
    m_chain.hostSends(ByteSpan(acts.bytes).first(before), m_now, late);
    m_hostBaud = baud;
    m_chain.setHostBaud(baud);
    m_chain.hostSends(ByteSpan(acts.bytes).subspan(before), m_now, late);
    if (acts.hungUp)
        drain();
}

/// Closing a real port waits until everything written has been sent, and bytes received until then are lost.
/// Closing a pseudo-terminal returns at once, so instead simulated time leaps to the point at which the line
/// is empty.
void SimServer::drain() {
    const TimePoint closed = m_now;
    m_now = std::max(m_now, m_chain.hostLineFreeAt());
    m_chain.advanceTo(m_now);
    static_cast<void>(m_chain.takeHostBytes());
    m_started -= fromSeconds(toSeconds(m_now - closed) / m_pacing.speed);
}

void SimServer::deliver() {
    const std::vector<sim::HostByte> bytes = m_chain.takeHostBytes();
    if (bytes.empty())
        return;
    std::vector<std::uint8_t> values;
    values.reserve(bytes.size());
    for (const sim::HostByte& byte : bytes)
        values.push_back(byte.value);
    m_terminal.write(values);
    m_sent += values.size();
    if (m_pacing.stepped)
        return;  // without pacing, nothing can be late
    const TimePoint written = monotonicNow();
    for (const sim::HostByte& byte : bytes)
        m_lateness.add(written - realTimeOf(byte.due));
}

// ---- Control lines ----

bool SimServer::serveControl() {
    std::array<char, 1024> buffer{};
    const auto got = ::read(m_controlIn, buffer.data(), buffer.size());
    if (got <= 0) {
        m_controlOpen = false;  // the end of standard input does not end the simulator
        return true;
    }
    m_pendingLine.append(buffer.data(), static_cast<std::size_t>(got));
    for (std::size_t end = 0; (end = m_pendingLine.find('\n')) != std::string::npos;) {
        const std::string line = m_pendingLine.substr(0, end);
        m_pendingLine.erase(0, end + 1);
        if (!answer(line))
            return false;
    }
    m_pendingLine.resize(std::min(m_pendingLine.size(), kMaxLine + 1));
    return true;
}

bool SimServer::answer(const std::string& line) {
    const std::string words = wordsOf(line);
    const bool last = words == "quit";
    const std::string reply =
        (last                     ? R"({"quit":true})"
         : line.size() > kMaxLine ? R"({"error":"too long a line; allowed are 4096 bytes"})"
                                  : answerTo(words)) +
        '\n';
    [[maybe_unused]] const auto written = ::write(m_controlOut, reply.data(), reply.size());
    return !last;
}

std::string SimServer::answerTo(const std::string& words) {
    if (words.rfind("advance", 0) == 0)
        return advance(words);
    const std::string answer = sim::handleControlLine(m_chain, words, m_now, pace());
    // Only `time` reports how late bytes were, so only `time` restarts that measurement.
    if (words == "time")
        m_lateness = {};
    if (words == "stats clear")
        m_stalls = {};
    return answer;
}

std::string SimServer::advance(const std::string& line) {
    constexpr double kLongest = 100'000.0;
    if (!m_pacing.stepped)
        return R"({"error":"advance is for nmcsim --stepped; here time passes by itself"})";
    std::istringstream words(line);
    std::string verb;
    double seconds = 0.0;
    if (!(words >> verb >> seconds) || verb != "advance" || !(words >> std::ws).eof() ||
        !(seconds >= 0.0 && seconds <= kLongest))
        return R"({"error":"allowed is advance SECONDS, from 0 to 100000"})";
    serveHost();
    m_now += fromSeconds(seconds);
    m_chain.advanceTo(m_now);
    deliver();
    return answerTo("time");
}

sim::Pace SimServer::pace() const {
    return {toSeconds(m_lateness.largest()),
            toSeconds(m_lateness.percentile99()),
            m_received,
            m_sent,
            m_stalls.count(),
            toSeconds(m_stalls.longest())};
}

}  // namespace nmc
