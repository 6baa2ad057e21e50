// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/monkey/monkey.h"

#include <gtest/gtest.h>

#include <QAbstractEventDispatcher>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QLineEdit>
#include <QTabBar>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>
#include <array>
#include <utility>

#include "tests/support/virtualtime.h"

namespace nmc::monkey {

using namespace std::chrono_literals;
using namespace Qt::StringLiterals;

namespace {

/// Time that passes between two turns of the window's event loop: the pace of a slow machine.
constexpr Duration kFrame = 20ms;
constexpr std::size_t kRemembered = 40;
/// The simulator keeps faults that have ended, and not many more than this.
constexpr unsigned kFaultsAtOnce = 90;

const std::vector<ModuleIdentity> kChain{
    {ModuleType::Servo, 4}, {ModuleType::Stepper, 1}, {ModuleType::Servo, 1}};

PortController::Places places(const QString& folder) {
    PortController::Places places;
    places.list = [] { return QList<PortEntry>{{u"/dev/ttyUSB0"_s, u"USB Serial"_s}}; };
    places.devices = folder;
    places.sysfs = folder;
    return places;
}

/// A line for the simulator, and the line that ends it; empty if the first one limits its own time.
struct Strike {
    const char* line;
    const char* end;
};
/// "%1" is a module, "%2" a duration. No line reverses a shaft or an encoder: that would be a motion that the
/// user did not cause.
constexpr std::array kStrikes{
    Strike{"fault bus drop status p=.1 for=%2", ""},
    Strike{"fault bus drop cmd p=.1 for=%2", ""},
    Strike{"fault bus flip status p=.2 for=%2", ""},
    Strike{"fault bus noise status t=1ms..30ms for=%2", ""},
    Strike{"fault bus delay p=.3 t=5ms..80ms for=%2", ""},
    Strike{"fault bus mute rx for=%2", ""},
    Strike{"fault bus mute tx for=%2", ""},
    Strike{"fault bus echo for=%2", ""},
    Strike{"fault module %1 silent for=%2", ""},
    Strike{"fault module %1 mute tx for=%2", ""},
    Strike{"fault module %1 cksum p=.5 for=%2", ""},
    Strike{"power-cycle %1", ""},
    Strike{"power-cycle all", ""},
    Strike{"set %1 limit1 1", "set %1 limit1 0"},
    Strike{"set %1 limit2 1", "set %1 limit2 0"},
    Strike{"set %1 power 0", "set %1 power 1"},
    Strike{"set 1 load 0.3", "set 1 load 0"},
    Strike{"fault module 1 stall for=%2", ""},
    Strike{"set 2 estop 1", "set 2 estop 0"},
};

/// Sends a key to whatever has the keyboard at that moment: a press may close a window, or open one.
void sendKey(bool press, QKeyCombination key) {
    QWindow* window = QGuiApplication::focusWindow();
    if (window == nullptr)
        return;
    const bool writes = (key.keyboardModifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
    const char letter = writes ? QTest::keyToAscii(key.key()) : '\0';
    QTest::simulateEvent(window, press, key.key(), key.keyboardModifiers(),
                         letter != '\0' ? QString(QLatin1Char(letter)) : QString(), false);
}

void strike(QKeyCombination key) {
    sendKey(true, key);
    sendKey(false, key);
}

QPoint center(const QWidget* widget) {
    return widget->mapToGlobal(widget->rect().center());
}

}  // namespace

Monkey::Monkey(std::uint64_t seed)
    : m_random(seed * 0x9E37'79B9U + 1),
      m_settings(m_directory.filePath(u"panel.ini"_s), QSettings::IniFormat),
      m_chain(kChain, seed),
      m_faultFree(seed % 4 == 0) {
    QDir::setCurrent(m_directory.path());
    qputenv("HOME", m_directory.path().toLocal8Bit());
    connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::aboutToBlock, this, [this] {
        if (m_delivering > 0)
            inNestedLoop();
    });
    startProgram();
}

Monkey::~Monkey() {
    endProgram();
}

void Monkey::startProgram() {
    m_program = std::make_unique<Composition>(m_settings, places(m_directory.path()), m_directory.path());
    m_program->connection().setTransports(
        [this](const ConnectTarget& /*target*/) { return m_chain.transport(); });
    m_oath = std::make_unique<Oath>(m_chain, *m_program);
    // Every second user gives the port on the command line.
    Start start;
    if (below(2) == 0)
        start.port = u"/dev/ttyUSB0"_s;
    m_program->show(start);
    m_program->window().resize(1'500, 1'100);
    m_program->window().activateWindow();
    wait(100ms);
}

void Monkey::endProgram() {
    m_motions += m_oath->motions();
    m_stopsInMotion += m_oath->stopsInMotion();
    m_oath.reset();
    // Otherwise it would wait for the bus thread, for which no time passes.
    m_program->worker().close();
    while (m_chain.open())
        m_chain.run(kFrame);
    m_program.reset();
}

void Monkey::note(const std::string& what) {
    m_story.push_back(std::to_string(m_acts) + " " + state() + ": " + what);
    if (qEnvironmentVariableIsSet("NMC_MONKEY_SEED"))
        std::printf("%s\n", m_story.back().c_str());
    if (m_story.size() > kRemembered)
        m_story.pop_front();
}

std::string Monkey::story() const {
    std::string story;
    for (const std::string& line : m_story)
        story += "  " + line + "\n";
    return story;
}

std::string Monkey::state() {
    constexpr std::array kPhases{"disconnected", "connecting", "connected", "lost"};
    const LinkState& link = m_program->store().link();
    std::string text = kPhases.at(static_cast<std::size_t>(link.phase));
    text += link.readOnly ? " read-only" : "";
    if (const auto module = m_program->window().selectedModule())
        text += ", module " + std::to_string(module->value() + 1);
    for (std::size_t place = 0; place < m_chain.size(); ++place)
        text += m_chain.driven(place) ? ", " + std::to_string(place + 1) + " moves" : "";
    if (const QWidget* focus = QApplication::focusWidget())
        text += ", at " + focus->objectName().toStdString();
    return text;
}

Duration Monkey::milliseconds(std::size_t from, std::size_t to) {
    return static_cast<Duration::rep>(from + below(to - from)) * 1ms;
}

void Monkey::wait(Duration time) {
    for (Duration passed{}; passed < time; passed += kFrame) {
        m_chain.run(kFrame);
        QApplication::processEvents();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        m_oath->look();
    }
}

template <typename Deliver>
void Monkey::deliver(Deliver deliver) {
    ++m_delivering;
    m_oath->userActs(true);
    deliver();
    m_oath->userActs(false);
    --m_delivering;
}

bool Monkey::act() {
    ++m_acts;
    actOnce();
    wait(milliseconds(1, 150));
    if (!m_program->window().isVisible()) {
        note("the program has ended, and is started again");
        endProgram();
        m_pressedIn = nullptr;
        m_keyDown.reset();
        startProgram();
    }
    return m_oath->complaints().empty() && !testing::Test::HasFailure();
}

void Monkey::actOnce() {
    const std::size_t lot = below(100);
    if (m_pressedIn != nullptr && lot < 30)
        return releaseMouse(below(3) == 0);
    if (m_keyDown && lot < 50)
        return strikeKey(*m_keyDown);
    if (lot < 30)
        return pressWhatMatters();
    if (lot < 52)
        return pressAnything();
    if (lot < 62)
        return strikeAnyKey();
    if (lot < 68)
        return strikeShortcut();
    if (lot < 76)
        return type();
    if (lot < 80)
        return turnWheel();
    if (lot < 81)
        return resizeWindow();
    if (lot < 88)
        return stopAll();
    if (lot < 89)
        return freeze();
    if (lot < 95)
        return befall();
    note("waits");
    wait(milliseconds(100, 2'500));
}

void Monkey::press(const Spot& spot, Qt::MouseButton button, bool hold) {
    if (m_pressedIn != nullptr)
        releaseMouse(false);
    if (spot.window == nullptr || !spot.window->isVisible())
        return;  // the release has closed it
    const QWidget* hit = QApplication::widgetAt(spot.at);
    if (hit == nullptr || hit->window() != spot.window)
        return;  // or something lies over it now
    QWindow* window = spot.window->windowHandle();
    note((hold                       ? "holds "
          : button == Qt::LeftButton ? "clicks "
                                     : "right-clicks ") +
         spot.name.toStdString());
    const Motors starts = startedBy(hit);
    const bool isTab = qobject_cast<const QTabBar*>(hit) != nullptr;
    m_oath->mayStart(starts);
    if (spot.name.startsWith(u"sim"_s))
        m_oath->fault(virtualtime::now());  // the simulator's own page can make anything happen
    const QPoint at = window->mapFromGlobal(spot.at);
    deliver([&] {
        if (spot.window->windowType() != Qt::Popup)
            spot.window->activateWindow();  // as the window system does
        const QPointer<QWindow> still(window);
        QTest::mousePress(window, button, {}, at);
        // The control that is pressed has the focus, and may lose it because of what it does.
        if (starts.any)
            m_oath->movedFocus();
        if (hold) {
            m_pressedIn = still;
            m_pressedTab = isTab;
            m_pressedAt = at;
        } else if (still != nullptr) {
            QTest::mouseRelease(window, button, {}, at);
        }
    });
}

void Monkey::releaseMouse(bool elsewhere) {
    if (m_pressedIn == nullptr)
        return;
    QWindow* window = std::exchange(m_pressedIn, nullptr);
    // A tab is not dragged: Qt paints it even if its page has gone in the meantime, and complains. Also, the
    // window may have become smaller.
    const bool there = (!elsewhere || m_pressedTab) && QRect({}, window->size()).contains(m_pressedAt);
    const QPoint at = there ? m_pressedAt : QPoint(3, 3);
    note(there ? "releases" : "moves away and releases");
    m_oath->mayStart(startedBy(QApplication::widgetAt(window->mapToGlobal(at))));
    deliver([&] {
        const QPointer<QWindow> still(window);
        if (!there)
            QTest::mouseMove(window, at);
        if (still != nullptr)
            QTest::mouseRelease(window, Qt::LeftButton, {}, at);
    });
}

bool Monkey::pressNamed(const QStringList& words) {
    QList<Spot> named;
    for (const Spot& spot : spots())
        if (std::any_of(words.begin(), words.end(),
                        [&spot](const QString& word) { return spot.name.contains(word); }))
            named << spot;
    if (named.isEmpty())
        return false;
    const Spot spot = named.at(static_cast<qsizetype>(below(static_cast<std::size_t>(named.size()))));
    press(spot, Qt::LeftButton, spot.name.contains(u"hold"_s, Qt::CaseInsensitive));
    return true;
}

/// Presses what makes up a session; otherwise there would hardly ever be a motion.
void Monkey::pressWhatMatters() {
    const LinkState& link = m_program->store().link();
    if (QApplication::activePopupWidget() != nullptr)
        return pressAnything();
    if (below(3) == 0 && closeSomething())
        return;
    if (link.phase == LinkPhase::Disconnected && below(2) == 0 && pressNamed({u"connectButton"_s}))
        return;
    if (link.phase == LinkPhase::Lost && below(2) == 0)
        return below(2) == 0 ? strikeKey(Qt::Key_F5)
                             : void(pressNamed({u"disconnectButton"_s, u"bannerAction"_s}));
    const auto module = m_program->window().selectedModule();
    const ModuleState* state = module ? m_program->store().module(*module) : nullptr;
    if (link.phase == LinkPhase::Connected && !link.readOnly && below(3) == 0 &&
        (state == nullptr || !state->driveOn()))
        return makeReady();
    if (link.phase == LinkPhase::Connected && below(10) == 0)
        return workPendant();
    if (!pressNamed({u"Forward"_s, u"Reverse"_s, u"goButton"_s, u"GoButton"_s, u"homeButton"_s,
                     u"HomeButton"_s, u"startButton"_s, u"StartLoaded"_s, u"loadButton"_s, u"PagesBar"_s,
                     u"chainList"_s, u"responseButton"_s, u"enableButton"_s, u"EnableButton"_s,
                     u"StartButton"_s}))
        pressAnything();
}

void Monkey::workPendant() {
    if (pendantIsOn())
        strikeKey(Qt::SHIFT | (below(2) == 0 ? Qt::Key_Left : Qt::Key_Right), true);
    else
        strikeKey(Qt::Key_F12);
}

bool Monkey::pendantIsOn() const {
    return m_program->window().findChild<QAction*>(u"pendantAction"_s)->isChecked();
}

/// Acts like a user who wants to work: gains or parameters, the current on, and then a motion.
void Monkey::makeReady() {
    note("makes a motor ready");
    pressNamed({u"chainList"_s});
    wait(100ms);
    pressNamed({u"PagesBar Gains"_s, u"PagesBar Parameters"_s});
    wait(40ms);
    for (const QStringList& word : {QStringList{u"fill"_s, u"Fill"_s},
                                    {u"applyGains"_s, u"ApplyParameters"_s},
                                    {u"enableButton"_s, u"EnableButton"_s}}) {
        pressNamed(word);
        wait(200ms);
    }
    pressNamed({u"runForward"_s, u"runReverse"_s, u"RunForward"_s, u"RunReverse"_s, u"hold"_s, u"Hold"_s});
}

/// Closes a window beside the main one, as its frame would.
bool Monkey::closeSomething() {
    for (QWidget* window : windows())
        if (window->windowType() == Qt::Dialog) {
            note("closes " + window->objectName().toStdString());
            deliver([window] { window->windowHandle()->close(); });
            return true;
        }
    return false;
}

void Monkey::pressAnything() {
    const QList<Spot> all = spots();
    if (all.isEmpty())
        return;
    const Spot& spot = all.at(static_cast<qsizetype>(below(static_cast<std::size_t>(all.size()))));
    const std::size_t lot = below(20);
    const bool right = lot == 0 && !inFileDialog(spot.window);
    press(spot, right ? Qt::RightButton : Qt::LeftButton, !right && lot < 5);
}

/// Sends a key to the window that has the keyboard. `hold`: the key stays down; a key that is down is
/// released.
void Monkey::strikeKey(QKeyCombination key, bool hold) {
    if (QGuiApplication::focusWindow() == nullptr)
        return;
    const Qt::Key bare = key.key();
    const QKeySequence sequence(key);
    const bool up = m_keyDown == bare;
    note((up ? "lets go of " : hold ? "holds " : "strikes ") + sequence.toString().toStdString());
    const QWidget* focus = QApplication::focusWidget();
    const bool enter = bare == Qt::Key_Return || bare == Qt::Key_Enter;
    m_oath->mayStart(startedBy(sequence));
    if (bare == Qt::Key_Space || enter)
        m_oath->mayStart(enter ? startedByEnter(focus) : startedBy(focus));
    if ((bare == Qt::Key_Left || bare == Qt::Key_Right) && pendantIsOn())
        m_oath->mayStart({true});
    deliver([&] {
        if (up) {
            m_keyDown.reset();
            sendKey(false, bare);
        } else if (hold) {
            m_keyDown = bare;
            sendKey(true, key);
        } else {
            strike(key);
        }
    });
    if (bare == Qt::Key_Tab || bare == Qt::Key_Backtab || key.keyboardModifiers() != Qt::NoModifier ||
        (bare >= Qt::Key_Left && bare <= Qt::Key_Down))
        m_oath->movedFocus();
}

void Monkey::strikeAnyKey() {
    constexpr std::array kKeys{Qt::Key_Tab,    Qt::Key_Tab,       Qt::Key_Tab,    Qt::Key_Backtab,
                               Qt::Key_Space,  Qt::Key_Space,     Qt::Key_Return, Qt::Key_Enter,
                               Qt::Key_Up,     Qt::Key_Down,      Qt::Key_Left,   Qt::Key_Right,
                               Qt::Key_Home,   Qt::Key_End,       Qt::Key_PageUp, Qt::Key_PageDown,
                               Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_Alt};
    if (inFileDialog(QApplication::focusWidget()))
        return stopAll();
    const Qt::Key key = kKeys[below(kKeys.size())];
    strikeKey(key, key == Qt::Key_Space && !m_keyDown && below(2) == 0);
}

void Monkey::strikeShortcut() {
    const QList<QKeySequence> all = shortcuts();
    if (all.isEmpty() || inFileDialog(QApplication::focusWidget()))
        return stopAll();
    strikeKey(all.at(static_cast<qsizetype>(below(static_cast<std::size_t>(all.size()))))[0]);
}

void Monkey::type() {
    static const QStringList kNumbers{u"0"_s,     u"1"_s,           u"7"_s,    u"25"_s,  u"1000"_s,
                                      u"-3000"_s, u"0.5"_s,         u"2,75"_s, u"1e9"_s, u"--"_s,
                                      u"1.2.3"_s, u"99999999999"_s, u"x"_s,    u" "_s};
    static const QStringList kNames{u"mill"_s, u"b.csv"_s, u"c.json"_s};
    const auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    if (field == nullptr)
        return pressAnything();
    const QStringList& words = inFileDialog(field) ? kNames : kNumbers;
    const QString text = words.at(static_cast<qsizetype>(below(static_cast<std::size_t>(words.size()))));
    const bool paste = !inFileDialog(field) && below(5) == 0;
    note((paste ? "pastes " : "types ") + text.toStdString());
    deliver([&] {
        strike(Qt::CTRL | Qt::Key_A);
        if (paste) {
            QGuiApplication::clipboard()->setText(below(3) == 0 ? text.repeated(5'000) : text);
            strike(Qt::CTRL | Qt::Key_V);
            return;
        }
        for (const QChar c : text)
            if (QApplication::focusWidget() == field)
                strike(QTest::asciiToKey(c.toLatin1()));
    });
}

void Monkey::turnWheel() {
    const QList<Spot> all = spots();
    if (all.isEmpty())
        return;
    const Spot& spot = all.at(static_cast<qsizetype>(below(static_cast<std::size_t>(all.size()))));
    QWidget* over = QApplication::widgetAt(spot.at);
    if (over == nullptr)
        return;
    note("turns the wheel over " + spot.name.toStdString());
    deliver([&] {
        const QPoint local = over->mapFromGlobal(spot.at);
        QWheelEvent event(local, spot.at, {}, {0, below(2) == 0 ? 120 : -120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(over, &event);
    });
}

void Monkey::resizeWindow() {
    const QSize size{static_cast<int>(600 + below(1'300)), static_cast<int>(500 + below(700))};
    note("resizes the window");
    deliver([&] { m_program->window().resize(size); });
}

/// By mouse, at the place of the button whatever is open, or by Esc, wherever the keyboard focus is.
void Monkey::stopAll() {
    auto* button = m_program->window().findChild<QWidget*>(u"stopAllButton"_s);
    const bool byKey = below(2) == 0 && QGuiApplication::focusWindow() != nullptr;
    const QPoint at = center(button);
    const QWidget* there = QApplication::widgetAt(at);
    QWidget* popup = QApplication::activePopupWidget();
    // The user has moved a window over it, or made the window too low for it, and so knows.
    const bool covered = popup == nullptr && there != button;
    if (!byKey && covered)
        return;
    if (m_pressedIn != nullptr && !byKey)
        releaseMouse(true);
    popup = QApplication::activePopupWidget();
    note(byKey ? "STOP ALL by Esc" : "STOP ALL by mouse");
    m_oath->aboutToStopAll();
    deliver([&] {
        if (byKey) {
            strike(Qt::Key_Escape);
            return;
        }
        QWindow* window = (popup != nullptr ? popup : &m_program->window())->windowHandle();
        const QPointer<QWindow> still(window);
        const QPoint local = window->mapFromGlobal(at);
        // A popup grabs the pointer wherever it is.
        QMouseEvent press(QEvent::MouseButtonPress, local, local, at, Qt::LeftButton, Qt::LeftButton, {});
        QApplication::sendEvent(window, &press);
        if (still == nullptr || popup != nullptr)
            return;
        QMouseEvent release(QEvent::MouseButtonRelease, local, local, at, Qt::LeftButton, Qt::NoButton, {});
        QApplication::sendEvent(window, &release);
    });
    m_oath->stoppedAll();
}

void Monkey::freeze() {
    note("the window hangs");
    m_chain.run(milliseconds(500, 3'500));
    if (m_program->store().link().phase != LinkPhase::Disconnected)
        m_oath->fault(virtualtime::now());
}

void Monkey::befall() {
    if (m_faultFree)
        return pressAnything();
    ++m_strikes;
    if (below(12) == 0 || !m_chain.plugged()) {
        note(m_chain.plugged() ? "the adapter is pulled out" : "the adapter is back");
        m_chain.plugged() ? m_chain.unplug() : m_chain.plugIn();
        return m_oath->fault(virtualtime::now());
    }
    const Strike& strike = kStrikes[below(kStrikes.size())];
    const Duration lasts = milliseconds(20, 2'500);
    const auto inWords = [lasts, module = below(kChain.size()) + 1](const char* line) {
        return QString::fromLatin1(line)
            .replace(u"%1"_s, QString::number(module))
            .replace(u"%2"_s, QString::number(lasts / 1ms) + u"ms"_s)
            .toStdString();
    };
    note(inWords(strike.line));
    m_oath->fault(virtualtime::now() + lasts);
    if (++m_faults == kFaultsAtOnce) {
        m_chain.tell("fault clear");
        m_faults = 0;
    }
    // On the simulator's page, they may have been set to follow the travel.
    if (QLatin1StringView(strike.line).contains("limit"_L1))
        m_chain.tell(inWords("set %1 limits manual"));
    m_chain.tell(inWords(strike.line));
    if (*strike.end != '\0') {
        wait(lasts);
        m_chain.tell(inWords(strike.end));
    }
}

void Monkey::inNestedLoop() {
    m_oath->userActs(false);
    m_chain.run(kFrame);
    m_oath->look();
    m_oath->userActs(true);
    // Runs in the loop itself, which then has something to do.
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (below(4) == 0)
                stopAll();
        },
        Qt::QueuedConnection);
}

}  // namespace nmc::monkey
