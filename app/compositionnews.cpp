// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the store's events into messages for the window.
#include <algorithm>
#include <cmath>

#include "app/composition.h"
#include "app/knownchain.h"
#include "link/clock.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

[[nodiscard]] bool isGroupStop(const bus::GroupFinished& finished) {
    const auto* command = std::get_if<bus::GroupCommand>(&finished.what);
    return command != nullptr && isStop(command->action);
}

/// True for events after which nothing is held any more, whether the panel requested that or not.
bool endsHold(const StoreEvent& event) {
    const auto* health = std::get_if<bus::HealthChanged>(&event);
    const auto* group = std::get_if<bus::GroupFinished>(&event);
    return std::holds_alternative<bus::HoldExpired>(event) ||
           std::holds_alternative<bus::StopFinished>(event) ||
           std::holds_alternative<bus::MotionSuspect>(event) ||
           std::holds_alternative<bus::ForeignTraffic>(event) ||
           std::holds_alternative<bus::LinkLost>(event) ||
           (health != nullptr && health->health == bus::LinkHealth::Lost) ||
           (group != nullptr && (group->stopped || isGroupStop(*group)));
}

}  // namespace

void Composition::take(const StoreEvent& event) {
    m_messages.look();
    if (endsHold(event))
        m_window.endHold();
    if (const auto* operation = std::get_if<bus::OperationFinished>(&event))
        m_motionMarker.ended(operation->id, monotonicNow());
    if (!m_commander.take(event))
        std::visit([this](const auto& news) { on(news); }, event);
}

void Composition::on(const bus::OwedStopConfirmed& confirmed) {
    endLeft(m_motionMarker.stopped({confirmed.module}));
    m_messages.stopConfirmed(confirmed);
}

void Composition::on(const bus::ChainFound& found) {
    m_messages.chainFound();
    m_motionMarker.found(monotonicNow());
    m_positions.found(found);
    if (m_lostPort == m_target->port) {
        m_lostPort.reset();
        m_messages.end(texts::key::gone());
        m_messages.end(texts::key::link());
    }
    noteChain(found);
    m_watched.clear();
    m_stopOutputs.clear();
    sendStopOutputs();
    m_messages.report(texts::connected(found, m_target->port));
    m_messages.end(texts::key::badLink());
    if (found.replyGap > Duration{})
        m_messages.reportOfChain(texts::repliesInPieces(
            m_target->port, static_cast<int>(std::lround(1e3 * toSeconds(found.replyGap)))));
    // If the module that restarted is known, its own message reports it.
    if (found.unaddressed && found.absent.empty())
        m_messages.reportOfChain(texts::unaddressed());
}

void Composition::on(const bus::ConnectFailed& failed) {
    m_messages.report(texts::connectFailed(failed, m_target->port));
}

void Composition::on(const bus::OperationFinished& finished) {
    if (finished.outcome == bus::Outcome::Done)
        m_messages.obeyed(finished.module);
    else
        m_messages.reportOf(texts::operationFailed(finished));
}

void Composition::on(const bus::StopFinished& finished) {
    // For example, a port without modules was closed: no stop was requested, and none was needed.
    if (finished.unasked && finished.reachedNobody())
        return;
    m_flight.note(texts::stopResult(finished, {}).key, texts::stopOfAll(), {},
                  monotonicNow() - finished.took);
    m_recordings.note(texts::stopOfAll());
    endLeft(m_motionMarker.stopped(finished.stopped));
    m_positions.look();  // the port may be closed at once, after which nothing is known any more
    m_window.showStopResult(finished);
}

void Composition::on(const bus::ModuleUnresponsive& silence) {
    if (!silence.silent)
        m_messages.end(texts::key::link());
}

void Composition::on(const bus::CommandRefused& refused) {
    m_messages.reportOf(texts::refused(refused));
}

void Composition::on(const bus::LinkLost&) {
    m_lostPort = m_target->port;
    m_messages.report(texts::withRecord(texts::linkLost(m_target->port, m_store.movingModules())));
}

void Composition::on(const bus::EchoNoticed&) {
    m_messages.reportOfChain(texts::echoNoticed(m_target->port));
}

void Composition::on(const bus::HoldExpired& expired) {
    const Message message = texts::withRecord(texts::holdExpired(expired.module));
    m_messages.noteStop(message, bus::StopCause::HoldExpired, {expired.module});
    m_messages.reportOf(message);
}

void Composition::on(const bus::HealthChanged& changed) {
    if (changed.health == bus::LinkHealth::Good)
        return m_messages.end(texts::key::badLink());
    const Message message = texts::withRecord(texts::badLink(changed));
    if (changed.health == bus::LinkHealth::Lost && changed.module)
        m_messages.noteStop(message, bus::StopCause::LinkGivenUp, {*changed.module});
    m_messages.report(message);
}

void Composition::on(const bus::Readdressed& readdressed) {
    m_positions.restarted(readdressed.module.index);
    m_messages.end(texts::key::unaddressed());
    m_messages.report(texts::readdressed(readdressed));
}

void Composition::on(const bus::AddressChanged& changed) {
    m_messages.report(texts::addressChanged(changed));
    noteAddresses();
}

void Composition::on(const bus::ReaddressFailed& failed) {
    m_messages.reportOfChain(texts::notReaddressed(failed));
}

void Composition::on(const bus::MotionSuspect& suspect) {
    const Message message = texts::withRecord(texts::motionSuspect(suspect));
    m_messages.noteStop(message, bus::StopCause::MotionSuspect, {suspect.module});
    m_messages.reportOf(message);
}

void Composition::on(const bus::StoppedBeforeLimit& stopped) {
    const Message message = texts::stoppedBeforeLimit(stopped.module);
    m_messages.noteStop(message, bus::StopCause::TravelLimit, {stopped.module});
    m_messages.reportOf(message);
}

void Composition::on(const bus::ForeignTraffic& traffic) {
    const Message message = texts::withRecord(texts::foreignTraffic(traffic));
    m_messages.noteStop(message, bus::StopCause::ForeignTraffic, traffic.toldToStop);
    m_messages.reportOfChain(message);
}

void Composition::on(const bus::ForeignMotion& motion) {
    m_messages.reportOfChain(texts::withRecord(texts::foreignMotion(motion)));
}

void Composition::on(const bus::GroupFinished& finished) {
    m_motionMarker.ended(finished.id, monotonicNow());
    std::vector<ModuleIndex> members;
    for (const bus::GroupMember& member : finished.members)
        members.push_back(member.module);
    if (finished.outcome == bus::Outcome::Done) {
        if (!isGroupStop(finished))
            return;
        const Message news = texts::groupToldToStop(finished);
        m_messages.noteStop(news, bus::StopCause::GroupStop, members);
        return m_messages.report(news);
    }
    Message message = texts::groupFailed(finished);
    if (finished.stopped) {
        message = texts::withRecord(std::move(message));
        m_messages.noteStop(message, bus::StopCause::GroupHalfStarted, members);
    }
    m_messages.reportOfChain(message);
}

void Composition::on(const bus::RateChanged& changed) {
    if (!m_store.link().simulated)
        rememberRate(m_settings, m_target->port, changed.baud);
    m_messages.report(texts::rateChanged(changed));
}

void Composition::on(const bus::RateChangeFailed& failed) {
    m_messages.reportOfChain(texts::rateNotChanged(failed));
}

void Composition::on(const PortClosed& closed) {
    m_window.showPackets(m_worker.takeRecords());
    m_flight.keepAll();
    m_recordings.end();
    m_frameTimer.stop();
    // The last reported values continue to age.
    if (!m_store.link().unplugged)
        m_figuresTimer.stop();
    m_window.showFigures({});
    m_messages.connectionEnded();
    m_scanWhenIdle = false;
    if (closed.error) {
        PortError error = *closed.error;
        error.port = m_target->port.toStdString();
        if (error.problem == PortProblem::Gone)
            m_lostPort = m_target->port;
        m_messages.report(texts::portProblem(error));
        m_ports.closed(error);
    } else
        m_messages.report(texts::disconnected(m_target->port));
    if (m_quitWhenClosed)
        quit();
    else if (m_openNext)
        openNow(*std::exchange(m_openNext, std::nullopt));
}

void Composition::on(const SimulatorAnswered& answer) {
    m_window.showSimulatorAnswer(QString::fromStdString(answer.line), QByteArray::fromStdString(answer.json));
}

void Composition::on(const PanelFroze& froze) {
    // The store still holds what was moving before.
    if (froze.stopped || m_store.movingMotors() > 0)
        m_messages.report(texts::panelFroze(toSeconds(froze.length), froze.stopped));
}

void Composition::on(const ComputerSlept& slept) {
    m_messages.report(texts::machineSlept(toSeconds(slept.length), slept.stopped));
}

void Composition::on(const GuardianStopped&) {
    m_messages.report(texts::withRecord(texts::guardianStopped()));
}

void Composition::on(const GuardianMissing& missing) {
    if (!std::exchange(m_guardianMissed, true))
        m_messages.report(texts::guardianMissing(missing.problem));
}

}  // namespace nmc
