// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sessions/stopoath.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "protocol/baud.h"
#include "tests/sessions/rig.h"

namespace nmc::test {

using namespace std::chrono_literals;

namespace {

/// A stop may cut a reply short, and follows the packet before it within this time (issue 13, "Figures").
constexpr Duration kAtOnce = 2ms;
/// Time for a port to run empty, and for a line to become quiet, before the rate changes.
constexpr Duration kChangeOfRate = 50ms;
constexpr std::size_t kNullBytes = 16;
constexpr std::size_t kLongestExchange = 19 + 17;  // a packet and a reply, in bytes
/// A packet that was sent so shortly before the stop was requested may already have been one.
constexpr Duration kJustBefore = 10ms;
/// Late replies come no later than this after the end of a fault.
constexpr Duration kSettled = 300ms;
constexpr double kDrift = 100;  // counts: a servo that is commanded to hold settles

[[nodiscard]] std::string named(std::size_t index, std::uint8_t place) {
    return "module " + std::to_string(index) + " (place " + std::to_string(place) + ")";
}

[[nodiscard]] std::string milliseconds(Duration time) {
    return std::to_string(time / 1ms) + " ms";
}

}  // namespace

void StopOath::asked() {
    const TimePoint now = m_rig->bus.now;
    m_forbidden = true;
    m_rateWasChanging = m_rateWasChanging || m_rig->rateChanging();
    if (m_run) {
        m_run->asked = now;
        m_restDue = now + kStopBound;
        return;
    }
    Run run;
    run.began = run.asked = now;
    run.inFlight = std::max(now, m_rig->lineFree);
    run.wireFrom = m_rig->wire.size();
    run.reset = restarting();
    run.calm = now >= m_rig->faultsUntil + kSettled;
    run.hostBaud = m_rig->bus.hostBaud;
    for (std::uint8_t place = 0; place < m_rig->size(); ++place)
        run.replies.push_back(m_rig->replies(place));
    if (const auto& known = m_rig->known) {
        run.chainKnown = true;
        run.baud = known->baud;
        run.well = !m_rig->searching() && !m_rig->lost && run.hostBaud == run.baud;
        run.judgeWire = !m_rig->rateChanging() && m_ownStops == 0;
        for (const auto& m : known->modules) {
            const bool there = m.place != KnownChain::kNowhere;
            run.modules.push_back({m.place, m.address,
                                   there && m_rig->isOn(m.place) && !m_rig->resetOnTheWay(m.place),
                                   there && m_rig->hears(m.place, m.address, known->baud)});
        }
        m_resting = run;
        m_restDue = now + kStopBound;
    }
    m_run = std::move(run);
    m_overdue = false;
}

bool StopOath::restarting() const {
    return m_rig->restartAsked && m_rig->searching();
}

void StopOath::onChainFound() {
    if (!m_run || m_run->chainKnown)
        return;
    // Until now there was no module to which the stop could be sent.
    m_run->modules.clear();
    for (const auto& m : m_rig->known->modules)
        if (m.place != KnownChain::kNowhere)
            m_run->modules.push_back(
                {m.place, m.address, false, m_rig->hears(m.place, m.address, m_rig->known->baud)});
    m_resting = m_run;
    m_restDue = m_rig->bus.now + kStopBound;
}

void StopOath::onTime() {
    const TimePoint now = m_rig->bus.now;
    if (m_run)
        checkEnd(*m_run);
    if (m_resting && now >= m_restDue) {
        checkRest(*m_resting);
        m_resting.reset();
    }
    if (now >= m_nextLook) {
        m_nextLook = now + kLookEvery;
        checkWatched();
    }
}

void StopOath::checkEnd(const Run& run) {
    const Duration bound = run.chainKnown ? Duration(kStopBound) : Duration(kSearchBound);
    if (m_overdue || m_rig->bus.now <= run.asked + bound)
        return;
    m_overdue = true;
    m_rig->complain("ends: no StopFinished within " + milliseconds(bound));
    checkTold(run);
}

void StopOath::stopsByItself() {
    if (!m_run)
        m_ownStops = 1;
}

void StopOath::onFinished(const bus::StopFinished& event) {
    const std::optional<Run> run = std::exchange(m_run, std::nullopt);
    if (!run && m_ownStops == 0)
        m_rig->complain("ends: a StopFinished that nobody asked for");
    m_ownStops = 0;
    checkLists(event);
    checkStopped(event, run);
    if (run)
        checkTold(*run);
}

void StopOath::checkLists(const bus::StopFinished& event) {
    std::map<std::size_t, unsigned> times;
    for (const auto* list : {&event.stopped, &event.unreached, &event.unconfirmed})
        for (const ModuleIndex module : *list)
            ++times[module.value()];
    const std::size_t modules = m_rig->known ? m_rig->known->modules.size() : 0;
    for (std::size_t i = 0; i < modules; ++i)
        if (times[i] != 1)
            m_rig->complain("lists: module " + std::to_string(i) + " is in " + std::to_string(times[i]));
    // Before any chain is known, the modules that the search has seen may be reported.
    for (const auto& [module, n] : times)
        if (module >= modules && (modules > 0 || n > 1))
            m_rig->complain("lists: module " + std::to_string(module) + " is in " + std::to_string(n) +
                            ", of a chain of " + std::to_string(modules));
}

void StopOath::checkStopped(const bus::StopFinished& event, const std::optional<Run>& run) {
    if (!m_rig->known)
        return;
    const auto& modules = m_rig->known->modules;
    for (std::size_t i = 0; i < modules.size(); ++i) {
        const std::uint8_t place = modules[i].place;
        if (place == KnownChain::kNowhere)
            continue;
        const bool said = std::ranges::count(event.stopped, ModuleIndex(static_cast<std::uint8_t>(i))) > 0;
        if (!said) {
            if (run && run->calm && !run->reset && !restarting() && !m_rig->isDriven(place) &&
                m_rig->hears(place, modules[i].address, m_rig->known->baud))
                m_rig->complain("heard: " + named(i, place) + " hears and answers, and is not confirmed");
            continue;
        }
        if (!m_rig->atRest(place))
            m_rig->complain("rest: " + named(i, place) + " is called stopped and moves");
        m_watched.push_back({place, m_rig->shaft(place), m_rig->bus.now + kWatched});
        if (run && m_rig->replies(place) < run->replies[place] + 2)
            m_rig->complain("answered: " + named(i, place) + " is called stopped after " +
                            std::to_string(m_rig->replies(place) - run->replies[place]) + " answers");
    }
}

TimePoint StopOath::firstDue(const Run& run) const {
    const TimePoint due = run.inFlight + kAtOnce;
    return run.hostBaud == run.baud ? due : due + kChangeOfRate + 2 * m_rig->world.latency;
}

/// The first stop for the module at the rate of the chain.
const WireItem* StopOath::stopTo(const Run& run, const Module& module) const {
    const auto& wire = m_rig->wire;
    std::size_t i = run.wireFrom;
    while (i > 0 && wire[i - 1].time >= run.began - kJustBefore)
        --i;
    for (; i < wire.size(); ++i)
        if (wire[i].isStopFor(module.place) && wire[i].baud == run.baud)
            return &wire[i];
    return nullptr;
}

bool StopOath::nullsBefore(const Run& run, const WireItem& stop) const {
    const auto& wire = m_rig->wire;
    for (std::size_t i = run.wireFrom; i < wire.size() && &wire[i] != &stop; ++i)
        if (wire[i].isFlush() && wire[i].baud == run.baud)
            return true;
    return false;
}

void StopOath::checkTold(const Run& run) {
    if (!run.judgeWire)
        return;
    const TimePoint first = firstDue(run);
    const Duration byte = byteTimeAtBaud(run.baud);
    const auto modules = static_cast<Duration::rep>(run.modules.size());
    // If the stop is requested again, it may begin again. A module is queried first if it is not known what
    // it was sent, or if an answer was late.
    const TimePoint last = first + (run.asked - run.began) + 5ms +
                           static_cast<Duration::rep>(kNullBytes) * byte +
                           2 * modules * (static_cast<Duration::rep>(kLongestExchange) * byte + 2ms) +
                           modules * (m_rig->world.latency + 10ms);
    for (std::size_t i = 0; i < run.modules.size(); ++i) {
        const Module& module = run.modules[i];
        if (!module.on || !module.hears)
            continue;
        const WireItem* stop = stopTo(run, module);
        if (stop == nullptr)
            m_rig->complain("told: no stop was sent to " + named(i, module.place));
        else if (stop->time > last)
            m_rig->complain("told: " + named(i, module.place) + " only after " +
                            milliseconds(stop->time - run.began) + " of " + milliseconds(last - run.began));
        else if (!run.well && stop->time >= run.began && !nullsBefore(run, *stop))
            m_rig->complain("told: " + named(i, module.place) + " without nulls on a line in doubt");
    }
    const bool anybody = std::ranges::any_of(run.modules, [](const Module& m) { return m.on && m.hears; });
    const auto& wire = m_rig->wire;
    const auto next = std::find_if(wire.begin() + static_cast<std::ptrdiff_t>(run.wireFrom), wire.end(),
                                   [&](const WireItem& item) { return item.baud == run.baud; });
    if (!anybody || next == wire.end())
        return;
    if (next->time > first)
        m_rig->complain("told: nothing for " + milliseconds(next->time - run.began));
    else if (!next->isFlush() && !next->isStop())
        m_rig->complain("told: first of all " + toHex(next->packet) + " went out");
}

void StopOath::checkRest(const Run& run) {
    for (std::size_t i = 0; i < run.modules.size(); ++i) {
        const Module& module = run.modules[i];
        if (module.hears && !m_rig->isDriven(module.place) && !m_rig->atRest(module.place))
            m_rig->complain("rest: " + named(i, module.place) + " hears, and still moves");
    }
}

void StopOath::checkWatched() {
    const TimePoint now = m_rig->bus.now;
    for (Watched& watched : m_watched) {
        if (now > watched.until || std::abs(m_rig->shaft(watched.place) - watched.shaft) <= kDrift)
            continue;
        watched.until = now;
        m_rig->complain("rest: place " + std::to_string(watched.place) + " was called stopped and moves on");
    }
    std::erase_if(m_watched, [&](const Watched& w) { return now >= w.until; });
}

void StopOath::onSent(const WireItem& item) {
    const auto code = item.code();
    if (!m_forbidden || !code)
        return;
    bool wrong = false;
    switch (*code) {
        case CommandCode::Nop:
        case CommandCode::ReadStatus:
        case CommandCode::DefineStatus:
            break;
        case CommandCode::StopMotor: {
            constexpr unsigned kSwitchesOn = 0x1D;  // the amplifier; abruptly, smoothly, here (DS-V 5.2)
            for (std::uint8_t place = 0; place < m_rig->size(); ++place)
                wrong = wrong || ((item.control() & kSwitchesOn) != 0 && item.isStopFor(place) &&
                                  !m_rig->everOn[place]);
            break;
        }
        case CommandCode::HardReset:
            wrong = !restarting();
            break;
        case CommandCode::SetAddress:
            wrong = item.address() != 0 || !m_rig->searching();
            break;
        case CommandCode::SetBaud:
            wrong = !m_rig->searching() && !m_rig->rateChanging() && !m_rateWasChanging;
            break;
        case CommandCode::ResetPosition:
        case CommandCode::LoadTrajectory:
        case CommandCode::StartMotion:
        case CommandCode::SetGain:
        case CommandCode::IoControl:
        case CommandCode::SetHoming:
        case CommandCode::ClearStickyBits:
        case CommandCode::SaveAsHome:
        case CommandCode::AddPathPoints:
            wrong = true;
            break;
    }
    if (wrong)
        m_rig->complain("N1: " + toHex(item.packet) + " went out after the stop");
}

void StopOath::forget() {
    m_forbidden = m_rateWasChanging = false;
    m_watched.clear();
    m_resting.reset();
}

}  // namespace nmc::test
