// SPDX-License-Identifier: GPL-3.0-or-later
// What the store tells, as messages for the window.
#include <algorithm>

#include "app/composition.h"
#include "link/clock.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

/// Whatever was held is not held any more, whether the panel asked for that or not.
bool endsHold(const StoreEvent& event) {
    const auto* health = std::get_if<bus::HealthChanged>(&event);
    const auto* group = std::get_if<bus::GroupFinished>(&event);
    return std::holds_alternative<bus::HoldExpired>(event) ||
           std::holds_alternative<bus::StopFinished>(event) ||
           std::holds_alternative<bus::MotionSuspect>(event) ||
           std::holds_alternative<bus::ForeignTraffic>(event) ||
           std::holds_alternative<bus::LinkLost>(event) ||
           (health != nullptr && health->health == bus::LinkHealth::Lost) ||
           (group != nullptr && group->stopped);
}

}  // namespace

void Composition::tell(const StoreEvent& event) {
    if (m_linkTimer.isActive())
        showLink();  // what is told now is told of what can be seen
    if (endsHold(event))
        m_window.endHold();
    if (const auto* operation = std::get_if<bus::OperationFinished>(&event))
        m_motionMarker.ended(operation->id, monotonicNow());
    // What became of a procedure's operation is for the procedure to say.
    if (m_procedures.take(event) && std::holds_alternative<bus::OperationFinished>(event))
        return;
    std::visit([this](const auto& news) { told(news); }, event);
}

QString Composition::tellIncident(Message message, std::optional<ModuleIndex> module) {
    QString key = message.key;
    m_flight.note(message.key, message.headline, module, monotonicNow());
    m_recordings.note(message.headline);
    m_window.showMessage(texts::withRecord(std::move(message)));
    return key;
}

void Composition::endAll(const QStringList& keys) {
    for (const QString& key : keys)
        m_window.endMessage(key);
}

void Composition::tellOf(ModuleIndex module, const Message& message) {
    m_window.showMessage(message);
    m_standing.untilObeyed(message.key, module);
}

void Composition::tellOfChain(const Message& message) {
    m_window.showMessage(message);
    m_standing.whileConnected(message.key);
}

QString Composition::tellStop(const Message& message, bus::StopCause cause,
                              const std::vector<ModuleIndex>& modules) {
    for (const ModuleIndex module : modules)
        m_toldToStop[{cause, module}] = message.key;
    m_stopMessages[message.key] = texts::withRecord(message);
    return tellIncident(message, modules.size() == 1 ? std::optional(modules.front()) : std::nullopt);
}

void Composition::told(const bus::OwedStopConfirmed& confirmed) {
    endLeft(m_motionMarker.stopped({confirmed.module}));
    const auto told = m_toldToStop.find({confirmed.cause, confirmed.module});
    if (told == m_toldToStop.end())
        return;
    Message& message = m_stopMessages[told->second];
    message.headline += u' ' + texts::stopConfirmed(confirmed);
    m_window.amendMessage(message);
    m_toldToStop.erase(told);
}

void Composition::told(const CurrentLimited& current) {
    if (!current.limited)
        return;
    m_standing.whileTrue(tellIncident(texts::currentLimited(current.module), current.module), current.module,
                         [](const ModuleState& module) { return module.currentWasLimited(); });
}

void Composition::told(const bus::ChainFound& found) {
    m_toldToStop.clear();
    endAll(m_standing.chainFound());
    m_motionMarker.found(monotonicNow());
    if (m_troublePort == m_target->port) {
        m_troublePort.reset();
        m_window.endMessage(texts::key::gone());
        m_window.endMessage(texts::key::link());
    }
    noteChain(found);
    m_watched.clear();
    m_window.showMessage(texts::connected(found, m_target->port));
    m_window.endMessage(texts::key::badLink());
    // Where the module is known that has restarted, that is told of it.
    if (found.unaddressed && found.absent.empty())
        tellOfChain(texts::unaddressed());
}

void Composition::told(const bus::ConnectFailed& failed) {
    m_window.showMessage(texts::connectFailed(failed, m_target->port));
}

void Composition::told(const bus::OperationFinished& finished) {
    if (finished.outcome == bus::Outcome::Done)
        endAll(m_standing.obeyed(finished.module));
    else
        tellOf(finished.module, texts::operationFailed(finished));
}

void Composition::told(const bus::StopFinished& finished) {
    m_flight.note(texts::stopResult(finished, false).key, texts::stopOfAll(), {},
                  monotonicNow() - finished.took);
    m_recordings.note(texts::stopOfAll());
    endLeft(m_motionMarker.stopped(finished.stopped));
    m_window.showStopResult(finished);
}

void Composition::told(const bus::ModuleSilence& silence) {
    if (!silence.silent) {
        m_window.endMessage(texts::key::silent(silence.module));
        m_window.endMessage(texts::key::link());
        return;
    }
    const ModuleState* module = m_store.module(silence.module);
    if (module == nullptr)
        return;
    if (isMissing(*module)) {
        const std::vector<ModuleState>& chain = m_store.link().modules;
        const auto answering =
            std::count_if(chain.begin(), chain.end(), [](const ModuleState& other) { return !other.silent; });
        return tellOfChain(texts::moduleMissing(silence.module, static_cast<int>(answering)));
    }
    const double seconds = toSeconds(monotonicNow() - module->latestTime);
    m_standing.untilChainFound(
        tellIncident(texts::moduleSilent(silence.module, seconds, module->moving()), silence.module));
}

void Composition::told(const bus::CommandRefused& refused) {
    tellOf(refused.module, texts::refused(refused));
}

void Composition::told(const bus::LinkLost&) {
    m_troublePort = m_target->port;
    // One text for one cause: the modules' own silences are part of it.
    for (const ModuleState& module : m_store.link().modules)
        m_window.endMessage(texts::key::silent(module.info.index));
    tellIncident(texts::linkLost(m_target->port, m_store.movingModules()));
}

void Composition::told(const bus::EchoNoticed&) {
    tellOfChain(texts::echoNoticed(m_target->port));
}

void Composition::told(const bus::HoldExpired& expired) {
    m_standing.untilObeyed(
        tellStop(texts::holdExpired(expired.module), bus::StopCause::HoldExpired, {expired.module}),
        expired.module);
}

void Composition::told(const bus::HealthChanged& changed) {
    if (changed.health == bus::LinkHealth::Good)
        m_window.endMessage(texts::key::badLink());
    else if (changed.health == bus::LinkHealth::Lost && changed.module)
        tellStop(texts::badLink(changed), bus::StopCause::LinkGivenUp, {*changed.module});
    else
        tellIncident(texts::badLink(changed), changed.module);
}

void Composition::told(const bus::ModuleRestarted& restarted) {
    m_window.endMessage(texts::key::silent(restarted.module));
    const auto modules = static_cast<int>(m_store.link().modules.size());
    m_standing.whileConnected(tellIncident(texts::restarted(restarted, modules), restarted.module));
}

void Composition::told(const bus::Readdressed& readdressed) {
    m_window.endMessage(texts::key::restarted(readdressed.module.index));
    m_window.endMessage(texts::key::unaddressed());
    m_window.showMessage(texts::readdressed(readdressed));
}

void Composition::told(const bus::ReaddressFailed& failed) {
    tellOfChain(texts::notReaddressed(failed));
}

void Composition::told(const bus::MotionSuspect& suspect) {
    m_standing.untilObeyed(
        tellStop(texts::motionSuspect(suspect), bus::StopCause::MotionSuspect, {suspect.module}),
        suspect.module);
}

void Composition::told(const bus::ForeignTraffic& traffic) {
    m_standing.whileConnected(
        tellStop(texts::foreignTraffic(traffic), bus::StopCause::ForeignTraffic, traffic.toldToStop));
}

void Composition::told(const bus::ForeignMotion& motion) {
    m_standing.whileConnected(tellIncident(texts::foreignMotion(motion), motion.module));
}

void Composition::told(const bus::GroupFinished& finished) {
    m_motionMarker.ended(finished.id, monotonicNow());
    if (finished.outcome == bus::Outcome::Done)
        return;
    if (!finished.stopped)
        return tellOfChain(texts::groupFailed(finished));
    std::vector<ModuleIndex> members;
    for (const bus::GroupMember& member : finished.members)
        members.push_back(member.module);
    m_standing.whileConnected(
        tellStop(texts::groupFailed(finished), bus::StopCause::GroupHalfStarted, members));
}

void Composition::told(const bus::RateChanged& changed) {
    m_window.showMessage(texts::rateChanged(changed));
}

void Composition::told(const bus::RateChangeFailed& failed) {
    tellOfChain(texts::rateNotChanged(failed));
}

void Composition::told(const PortClosed& closed) {
    m_window.showPackets(m_worker.takeRecords());
    m_flight.keepAll();
    m_recordings.end();
    m_frameTimer.stop();
    // What was said last goes on growing old.
    if (!m_store.link().unplugged)
        m_figuresTimer.stop();
    m_window.showFigures({});
    endAll(m_standing.connectionEnded());
    m_scanWhenIdle = false;
    if (closed.error) {
        PortError error = *closed.error;
        error.port = m_target->port.toStdString();
        if (error.problem == PortProblem::Gone)
            m_troublePort = m_target->port;
        m_window.showMessage(texts::portProblem(error));
        m_ports.closed(error);
    } else
        m_window.showMessage(texts::disconnected(m_target->port));
    if (m_quitWhenClosed)
        quit();
    else if (m_openNext)
        openNow(*std::exchange(m_openNext, std::nullopt));
}

void Composition::told(const SimulatorAnswered& answer) {
    m_window.showSimulatorAnswer(QString::fromStdString(answer.line), QByteArray::fromStdString(answer.json));
}

void Composition::told(const PanelFroze& froze) {
    // The store still has what moved before.
    if (froze.stopped || m_store.movingMotors() > 0)
        m_window.showMessage(texts::panelFroze(toSeconds(froze.length), froze.stopped));
}

void Composition::told(const MachineSlept& slept) {
    m_window.showMessage(texts::machineSlept(toSeconds(slept.length), slept.stopped));
}

void Composition::told(const GuardianStopped&) {
    tellIncident(texts::guardianStopped());
}

void Composition::told(const GuardianMissing& missing) {
    if (!std::exchange(m_guardianMissed, true))
        m_window.showMessage(texts::guardianMissing(missing.problem));
}

void Composition::told(const ServoWentOff& off) {
    const ModuleState* module = m_store.module(off.module);
    const auto limit =
        module != nullptr && module->gains ? std::optional<int>(module->gains->el) : std::nullopt;
    const TripCause cause = module != nullptr ? module->tripCause : TripCause::Unknown;
    const Message message = module != nullptr && module->isStepper()
                                ? texts::amplifierWentOff(off.module, off.activity)
                            : off.activity == Activity::PowerLost ? texts::powerLost(off.module)
                                                                  : texts::tripped(off.module, limit, cause);
    m_standing.whileTrue(tellIncident(message, off.module), off.module,
                         [](const ModuleState& state) { return state.switchedItselfOff; });
}

}  // namespace nmc
