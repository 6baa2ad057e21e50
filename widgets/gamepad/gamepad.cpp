// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gamepad/gamepad.h"

#define SDL_MAIN_HANDLED  // this program has its own main()
#include <SDL.h>

#include <QLibrary>
#include <type_traits>
#include <utility>

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kReadInterval = 10;     // ms; a hand cannot do anything in between that matters to a motor
constexpr int kFindInterval = 1'000;  // ms
/// A push begins at half of the stick's travel and ends at a quarter, so that a trembling hand does not stop
/// and start the motor.
constexpr int kPushed = 16'384;
constexpr int kLetGo = 8'192;

/// SDL, loaded when a pendant is first switched on: with all its dependencies, loading it would take a tenth
/// of the time until the window appears.
struct Sdl {
    decltype(&SDL_SetMainReady) setMainReady = nullptr;
    decltype(&SDL_SetHint) setHint = nullptr;
    decltype(&SDL_InitSubSystem) initSubSystem = nullptr;
    decltype(&SDL_QuitSubSystem) quitSubSystem = nullptr;
    decltype(&SDL_JoystickEventState) joystickEventState = nullptr;
    decltype(&SDL_JoystickUpdate) joystickUpdate = nullptr;
    decltype(&SDL_NumJoysticks) numJoysticks = nullptr;
    decltype(&SDL_IsGameController) isGameController = nullptr;
    decltype(&SDL_GameControllerEventState) eventState = nullptr;
    decltype(&SDL_GameControllerOpen) open = nullptr;
    decltype(&SDL_GameControllerClose) close = nullptr;
    decltype(&SDL_GameControllerGetAttached) attached = nullptr;
    decltype(&SDL_GameControllerGetButton) button = nullptr;
    decltype(&SDL_GameControllerGetAxis) axis = nullptr;

    /// Returns false if SDL is not installed or too old.
    [[nodiscard]] bool load() {
        QLibrary library(u"SDL2-2.0"_s, 0);
        bool all = library.load();
        const auto take = [&](auto& function, const char* name) {
            function = reinterpret_cast<std::decay_t<decltype(function)>>(library.resolve(name));
            all = all && function != nullptr;
        };
        take(setMainReady, "SDL_SetMainReady");
        take(setHint, "SDL_SetHint");
        take(initSubSystem, "SDL_InitSubSystem");
        take(quitSubSystem, "SDL_QuitSubSystem");
        take(joystickEventState, "SDL_JoystickEventState");
        take(joystickUpdate, "SDL_JoystickUpdate");
        take(numJoysticks, "SDL_NumJoysticks");
        take(isGameController, "SDL_IsGameController");
        take(eventState, "SDL_GameControllerEventState");
        take(open, "SDL_GameControllerOpen");
        take(close, "SDL_GameControllerClose");
        take(attached, "SDL_GameControllerGetAttached");
        take(button, "SDL_GameControllerGetButton");
        take(axis, "SDL_GameControllerGetAxis");
        return all;
    }
};

Sdl& sdl() {
    static Sdl loaded;
    return loaded;
}

/// Without a window of its own, SDL has no focus and would ignore the pad; the pendant checks the focus
/// itself. SDL's own drivers, which talk to pads over USB, could block the window; the kernel's drivers are
/// enough.
bool openSdl() {
    static const bool kLoaded = sdl().load();
    if (!kLoaded)
        return false;
    sdl().setMainReady();
    sdl().setHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    sdl().setHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    sdl().setHint(SDL_HINT_JOYSTICK_HIDAPI, "0");
    if (sdl().initSubSystem(SDL_INIT_GAMECONTROLLER) != 0)
        return false;
    // The state is polled: events would fill a queue that nothing here empties.
    sdl().joystickEventState(SDL_IGNORE);
    sdl().eventState(SDL_IGNORE);
    return true;
}

}  // namespace

void Gamepad::Closer::operator()(_SDL_GameController* pad) const {
    sdl().close(pad);
}

Gamepad::Gamepad(QObject* parent) : QObject(parent) {
    connect(&m_timer, &QTimer::timeout, this, &Gamepad::look);
}

Gamepad::~Gamepad() {
    setOn(false);
}

void Gamepad::setOn(bool on) {
    if (on == m_open)
        return;
    if (on) {
        m_open = openSdl();
        if (m_open)
            find();
        return;
    }
    m_timer.stop();
    m_pad.reset();
    release();
    sdl().quitSubSystem(SDL_INIT_GAMECONTROLLER);
    m_open = false;
}

void Gamepad::look() {
    sdl().joystickUpdate();
    if (m_pad == nullptr) {
        find();
        return;
    }
    if (sdl().attached(m_pad.get()) == SDL_TRUE) {
        follow(read());
        return;
    }
    m_pad.reset();
    m_timer.start(kFindInterval);
    release();
    emit changed();
}

void Gamepad::find() {
    for (int i = 0; i < sdl().numJoysticks() && m_pad == nullptr; ++i)
        if (sdl().isGameController(i) == SDL_TRUE)
            m_pad.reset(sdl().open(i));
    m_timer.start(isThere() ? kReadInterval : kFindInterval);
    if (!isThere())
        return;
    sdl().joystickUpdate();
    m_hands = {};
    m_hands = read();
    emit changed();
}

void Gamepad::follow(const Hands& now) {
    const Hands before = std::exchange(m_hands, now);
    if (now.stops && !before.stops)
        emit stopPressed();
    if (!now.enables || now.direction != before.direction)
        release();
    if (now.enables && now.direction != Direction::None && before.direction == Direction::None) {
        m_moves = true;
        emit pressed(now.direction == Direction::Reverse);
    }
}

void Gamepad::release() {
    if (std::exchange(m_moves, false))
        emit released();
}

Gamepad::Hands Gamepad::read() const {
    const auto down = [this](SDL_GameControllerButton button) {
        return sdl().button(m_pad.get(), button) != 0;
    };
    const bool stops = down(SDL_CONTROLLER_BUTTON_B);
    const bool shoulder =
        down(SDL_CONTROLLER_BUTTON_LEFTSHOULDER) || down(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
    return {shoulder && !stops, direction(), stops};
}

Gamepad::Direction Gamepad::direction() const {
    const int stick = sdl().axis(m_pad.get(), SDL_CONTROLLER_AXIS_LEFTX);
    const auto to = [this, stick](Direction direction, SDL_GameControllerButton button, int sign) {
        return stick * sign > (m_hands.direction == direction ? kLetGo : kPushed) ||
               sdl().button(m_pad.get(), button) != 0;
    };
    const bool forward = to(Direction::Forward, SDL_CONTROLLER_BUTTON_DPAD_RIGHT, 1);
    const bool reverse = to(Direction::Reverse, SDL_CONTROLLER_BUTTON_DPAD_LEFT, -1);
    return forward == reverse ? Direction::None : forward ? Direction::Forward : Direction::Reverse;
}

}  // namespace nmc
