// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/monkey/oath.h"

#include <QApplication>
#include <QWidget>

#include "base/bytes.h"
#include "model/procedure/procedures.h"
#include "tests/monkey/controls.h"
#include "tests/support/virtualtime.h"
#include "widgets/common/requests.h"

namespace nmc::monkey {

using namespace std::chrono_literals;
using namespace Qt::StringLiterals;

namespace {

/// A motor that has not moved for this long is not merely in a pause of its motion.
constexpr Duration kPauseAtMost = 5s;
/// Time for what was on its way to a module when it was stopped.
constexpr Duration kOnTheWay = 500ms;
/// Late replies arrive no later than this after the end of a fault, and the link is trusted again by then.
constexpr Duration kSettled = 3s;
/// Time for a packet that is being sent, and for the module's tick.
constexpr Duration kAtOnce = 40ms;

/// The widget that has the focus, except the menu bar, which gives it back after a while.
const QWidget* placeOfFocus() {
    const QWidget* focus = QApplication::focusWidget();
    return focus != nullptr && focus->inherits("QMenuBar") ? nullptr : focus;
}

std::string named(std::size_t place) {
    return "module " + std::to_string(place + 1);
}

}  // namespace

Oath::Oath(VirtualChain& chain, Composition& program)
    : m_chain(chain), m_program(program), m_motors(chain.size()) {
    MainWindow& window = program.window();
    QObject::connect(&window.requests(), &Requests::intent, &m_context,
                     [this](ModuleIndex module, const Intent& intent) { checkIntent(module, intent); });
    QObject::connect(&window.requests(), &Requests::hold, &m_context, [this](const bus::HoldToMove& hold) {
        if (hold.press != m_press && !m_acting)
            complain("visible: a hold begins by itself");
        m_press = hold.press;
    });
    QObject::connect(&window, &MainWindow::stopAllRequested, &m_context, [this] {
        ++m_stops;
        m_askedRead = true;
    });
    QObject::connect(&window, &MainWindow::restartNetworkRequested, &m_context, [this] {
        if (!m_acting)
            complain("visible: the network is restarted by itself");
    });
}

void Oath::complain(const std::string& what) {
    m_complaints.push_back(what);
}

std::optional<std::size_t> Oath::placeOf(ModuleIndex module) {
    const ModuleState* state = m_program.store().module(module);
    for (std::size_t place = 0; state != nullptr && place < m_chain.size(); ++place)
        if (m_chain.address(place) == state->info.address.value())
            return place;
    return std::nullopt;
}

std::optional<std::size_t> Oath::selected() {
    const auto module = m_program.window().selectedModule();
    return module ? placeOf(*module) : std::nullopt;
}

void Oath::mayStart(const Motors& motors) {
    const auto one = motors.module ? placeOf(*motors.module) : selected();
    for (std::size_t place = 0; motors.any && place < m_motors.size(); ++place)
        if (motors.all || place == one) {
            Motor& motor = m_motors[place];
            motor = {true, motor.moves, virtualtime::now(), std::nullopt, std::nullopt};
        }
}

void Oath::stopsOne() {
    if (const auto place = selected())
        m_motors[*place].stopAsked = virtualtime::now();
}

bool Oath::calm() const {
    return virtualtime::now() >= m_faultsUntil + kSettled &&
           std::none_of(link().modules.begin(), link().modules.end(),
                        [](const ModuleState& module) { return module.silent; });
}

void Oath::aboutToStopAll() {
    const bool open = link().phase != LinkPhase::Disconnected;
    m_stop = Stop{virtualtime::now(), m_stops, open, link().phase == LinkPhase::Connected && calm()};
    for (std::size_t place = 0; place < m_motors.size(); ++place)
        m_stopsInMotion += open && m_chain.driven(place) ? 1U : 0U;
}

void Oath::stoppedAll() {
    if (!m_stop || !m_stop->open)
        return m_stop.reset();
    if (m_stops == m_stop->before)
        complain("stop: STOP ALL was pressed, and nothing was asked for");
    for (std::size_t place = 0; place < m_motors.size(); ++place) {
        m_motors[place].stopAsked = virtualtime::now();
        if (link().phase == LinkPhase::Connected)
            m_motors[place].restDue = virtualtime::now() + kAtRestWithin;
    }
}

void Oath::movedFocus() {
    if (const QWidget* focus = placeOfFocus())
        m_focus[focus->window()] = focus;
}

void Oath::fault(TimePoint until) {
    m_chain.disturb();
    m_faultsUntil = std::max(m_faultsUntil, until);
}

void Oath::look() {
    if (link().phase == LinkPhase::Disconnected || m_wasDisconnected)
        m_askedRead = m_askedRead && link().phase != LinkPhase::Disconnected;
    m_wasDisconnected = link().phase == LinkPhase::Disconnected;
    checkPackets();
    checkMotors();
    checkWindow();
}

void Oath::checkIntent(ModuleIndex module, const Intent& intent) {
    const std::string what = "of " + named(module.value()) + ", intent " + std::to_string(intent.index());
    if (!m_acting)
        complain("visible: the window asks by itself " + what);
    const ModuleState* state = m_program.store().module(module);
    if (state == nullptr)
        return complain("visible: the window asks something of a module that is not there");
    if (std::holds_alternative<intent::CancelProcedure>(intent) || procedureFor(intent, *state) != nullptr)
        return;
    if (const auto steps = plan(intent, *state); !steps)
        complain("visible: the window asks for what is refused " + what + ", refusal " +
                 std::to_string(static_cast<int>(steps.error())));
}

void Oath::checkPackets() {
    const std::vector<Packet> packets = m_chain.takePackets();
    for (const Packet& packet : packets) {
        if (link().readOnly && packet.code() != CommandCode::Nop &&
            packet.code() != CommandCode::ReadStatus &&
            !(packet.code() == CommandCode::StopMotor && m_askedRead))
            complain("read: " + toHex(packet.bytes) + " goes out");
        for (std::size_t place = 0; packet.starts() && place < m_motors.size(); ++place)
            if (!m_motors[place].mayMove &&
                (packet.address() == m_chain.address(place) || packet.address() == m_chain.group(place)))
                complain("asked: " + toHex(packet.bytes) + " goes out to " + named(place));
    }
    checkStopPackets(packets);
}

void Oath::checkStopPackets(const std::vector<Packet>& packets) {
    if (!m_stop)
        return;
    const bool anyOn = [this] {
        for (std::size_t place = 0; place < m_motors.size(); ++place)
            if (m_chain.isOn(place))
                return true;
        return false;
    }();
    if (m_stop->open && m_stop->judged && anyOn && link().phase == LinkPhase::Connected) {
        // What began at the very moment of the press is already on its way.
        const auto first = std::find_if(packets.begin(), packets.end(), [this](const Packet& packet) {
            return packet.time > m_stop->at ||
                   (packet.time == m_stop->at && packet.code() == CommandCode::StopMotor);
        });
        if (first == packets.end() || first->code() != CommandCode::StopMotor)
            complain("stop: first of all goes out " +
                     (first == packets.end() ? std::string("nothing") : toHex(first->bytes)));
        else if (first->time > m_stop->at + kAtOnce)
            complain("stop: only after " + std::to_string((first->time - m_stop->at) / 1ms) + " ms");
    }
    m_stop.reset();
}

void Oath::checkMotors() {
    const TimePoint now = virtualtime::now();
    for (std::size_t place = 0; place < m_motors.size(); ++place) {
        Motor& motor = m_motors[place];
        const bool moves = m_chain.driven(place);
        if (moves) {
            m_motions += motor.moves ? 0U : 1U;
            motor.lastMoved = now;
            if (!motor.mayMove)
                complain("asked: " + named(place) + " moves");
        }
        motor.moves = moves;
        const bool stopped =
            motor.stopAsked && now > *motor.stopAsked + kOnTheWay && now > m_faultsUntil + kSettled;
        if (!moves && (stopped || now > motor.lastMoved + kPauseAtMost))
            motor.mayMove = false;
        if (link().phase != LinkPhase::Connected || m_chain.address(place) == 0)
            motor.restDue.reset();  // the link itself reports this
        if (motor.restDue && now > std::max(*motor.restDue, m_faultsUntil + kAtRestWithin)) {
            motor.restDue.reset();
            if (moves)
                complain("stop: " + named(place) + " hears, and still moves");
        }
    }
    if (const std::string violation = m_chain.violations(); !m_chain.disturbed() && !violation.empty())
        complain("chip: " + violation);
}

void Oath::checkWindow() {
    const auto* stop = m_program.window().findChild<QWidget*>(u"stopAllButton"_s);
    if (stop == nullptr || (m_program.window().isVisible() && !stop->isVisible()))
        complain("stop: the button is not there");
    else if (stop->isEnabled() != (link().phase != LinkPhase::Disconnected || link().unplugged))
        complain("stop: the button is " + std::string(stop->isEnabled() ? "" : "not ") + "enabled");
    if (const QWidget* focus = placeOfFocus()) {
        const QWidget*& before = m_focus[focus->window()];
        if (focus != before && startedBy(focus).any)
            complain("focus: is handed to " + focus->objectName().toStdString());
        before = focus;
    }
}

}  // namespace nmc::monkey
