// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "bus/engineprivate.h"
#include "bus/gate.h"
#include "protocol/baud.h"

namespace nmc::bus {

/// Drops what is in flight. Whether its command was carried out stays open, and the belief has that already.
void Engine::Private::interrupt(TimePoint now) {
    recordAbandoned(now);
    line.abandon();
    m_works.clear();
    m_resyncing = m_goingBack = false;
}

/// Stops without waiting for answers: an answer may still be coming in, and could be taken for that of the
/// stop.
void Engine::Private::sendBlindStops(TimePoint now) {
    Line::Script script{Line::Gap{}};
    m_blindStopsHeard = !m_suspect;
    if (std::exchange(m_suspect, false)) {
        m_hurried = true;
        script.insert(script.end(), {Line::Nulls{}, Line::Pause{kAfterNulls}});
    }
    m_blindStops = m_stop->blindStops();
    const Line::Script packets = stopScript(m_blindStops);
    script.insert(script.end(), packets.begin(), packets.end());
    const std::size_t underWay = kMaxReply;
    script.insert(script.end(), {Line::Lag{line.timing().bytes(underWay)}, DiscardInput{}});
    line.run(std::move(script), now);
}

Line::Script Engine::Private::stopScript(const std::vector<Step>& stops) const {
    Line::Script script;
    if (stops.empty())
        return script;
    const auto same = [&](const Step& s) { return payloadOf(s.command) == payloadOf(stops.front().command); };
    // Only where the groups are known: those that another host left behind may have a leader, or be others.
    const auto everybody = [&](const Step& s) { return belief(s.module).info().group == GroupPlace{}; };
    const bool all = stops.size() > 1 && stops.size() == m_modules.size() &&
                     std::all_of(stops.begin(), stops.end(), same) &&
                     std::all_of(stops.begin(), stops.end(), everybody);
    for (const Step& step : stops) {
        const Payload payload = payloadOf(step.command);
        if (all) {
            // Every module is a member of group FF, which has no leader: nobody answers.
            script.insert(script.end(), {Line::Packet{toPacket({kEverybody, payload})}, Line::Gap{}});
            break;
        }
        const std::size_t reply = layoutOf(belief(step.module), payload).length();
        script.insert(script.end(),
                      {Line::Packet{toPacket({belief(step.module).info().address, payload}), reply},
                       Line::Pause{kTurnaround + line.timing().bytes(reply)}});
    }
    return script;
}

/// The blind stops are out: what they may have done is believed from now on.
void Engine::Private::noteBlindStops() {
    const std::vector<Step> steps = std::exchange(m_blindStops, {});
    const std::vector<TimePoint>& latches = line.scriptLatches();
    for (std::size_t i = 0; i < steps.size() && !latches.empty(); ++i) {
        const TimePoint latched = latches[std::min(i, latches.size() - 1)];
        tell(steps[i].module, steps[i].command, latched);
        m_stop->onBlindSent(steps[i].module, m_blindStopsHeard ? std::optional(latched) : std::nullopt);
    }
}

void Engine::Private::finishStop(TimePoint now) {
    if (m_stop) {
        events.emplace_back(m_stop->finished(now));
        m_stop.reset();
    }
    if (!m_stopDuringDiscovery)
        return;
    // Reset modules have their motors off (DS-V 4.1).
    StopFinished event;
    if (m_discovery)
        for (const ModuleInfo& info : m_discovery->modules())
            event.stopped.push_back(info.index);
    event.took = now - *std::exchange(m_stopDuringDiscovery, std::nullopt);
    events.emplace_back(std::move(event));
}

/// What would have to be told to whom for nothing to move any more.
std::vector<Step> Engine::Private::stopsOwed() const {
    std::vector<Step> stops;
    for (const Module& module : m_modules)
        if (const auto stop = stopFor(module.belief))
            stops.push_back({module.belief.info().index, *stop});
    return stops;
}

std::vector<std::uint8_t> Engine::Private::stopBurst() const {
    std::vector<std::uint8_t> burst;
    for (const Step& stop : stopsOwed()) {
        if (burst.empty())
            burst.assign(kNullCount, 0);
        const PacketBytes packet = toPacket({belief(stop.module).info().address, payloadOf(stop.command)});
        burst.insert(burst.end(), packet.begin(), packet.end());
        // Nobody waits between the packets any more, so nulls must: a packet that comes before the one before
        // it was carried out takes its place (DS-V 4.1).
        burst.insert(burst.end(), static_cast<std::size_t>(kTurnaround / byteTimeAtBaud(m_baud)) + 1, 0);
    }
    return burst;
}

bool Engine::Private::stopBurstChanged() {
    bool changed = std::exchange(m_burstBaud, m_baud) != m_baud && !m_modules.empty();
    changed = changed || m_burstStops.size() != m_modules.size();
    m_burstStops.resize(m_modules.size());
    for (std::size_t i = 0; i < m_modules.size(); ++i) {
        const auto stop = stopFor(m_modules[i].belief);
        changed = changed || m_burstStops[i] != stop;
        m_burstStops[i] = stop;
    }
    return changed;
}

void Engine::Private::stopForHold(TimePoint now) {
    const Step stop = *m_hold.stop();
    // Off by itself, a tripped servo say: the stop must not switch it on again.
    if (belief(stop.module).fresh() && !belief(stop.module).on())
        return m_hold.onStopEnded();
    if (std::exchange(m_suspect, false))
        return flushBuffers(now);
    begin(commandWork(Lane::HoldStop, stop), now);
}

}  // namespace nmc::bus
