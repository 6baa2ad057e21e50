// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gamepad/gamepad.h"

#define SDL_MAIN_HANDLED  // main() is ours
#include <SDL.h>

#include <utility>

namespace nmc {

namespace {

constexpr int kReadInterval = 10;     // ms; what a hand does between two is the same to a motor
constexpr int kFindInterval = 1'000;  // ms
/// Half of the stick's way begins, a quarter ends: a hand that trembles does not stop and start a motor.
constexpr int kPushed = 16'384;
constexpr int kLetGo = 8'192;

/// Without its window SDL would have no focus and hide what a pad does; the pendant minds the focus itself.
/// Its own drivers, which talk to pads over USB, could make the window wait; the kernel's do.
bool openSdl() {
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");
    if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0)
        return false;
    // Asked, not told: nobody empties its queue here.
    SDL_JoystickEventState(SDL_IGNORE);
    SDL_GameControllerEventState(SDL_IGNORE);
    return true;
}

}  // namespace

void Gamepad::Closer::operator()(_SDL_GameController* pad) const {
    SDL_GameControllerClose(pad);
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
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    m_open = false;
}

void Gamepad::look() {
    SDL_JoystickUpdate();
    if (m_pad == nullptr) {
        find();
        return;
    }
    if (SDL_GameControllerGetAttached(m_pad.get()) == SDL_TRUE) {
        follow(read());
        return;
    }
    m_pad.reset();
    m_timer.start(kFindInterval);
    release();
    emit changed();
}

void Gamepad::find() {
    for (int i = 0; i < SDL_NumJoysticks() && m_pad == nullptr; ++i)
        if (SDL_IsGameController(i) == SDL_TRUE)
            m_pad.reset(SDL_GameControllerOpen(i));
    m_timer.start(isThere() ? kReadInterval : kFindInterval);
    if (!isThere())
        return;
    SDL_JoystickUpdate();
    m_hands = {};
    m_hands = read();
    emit changed();
}

void Gamepad::follow(const Hands& now) {
    const Hands before = std::exchange(m_hands, now);
    if (now.stops && !before.stops)
        emit stopPressed();
    if (!now.enables || now.way != before.way)
        release();
    if (now.enables && now.way != Way::None && before.way == Way::None) {
        m_moves = true;
        emit pressed(now.way == Way::Reverse);
    }
}

void Gamepad::release() {
    if (std::exchange(m_moves, false))
        emit released();
}

Gamepad::Hands Gamepad::read() const {
    const auto down = [this](SDL_GameControllerButton button) {
        return SDL_GameControllerGetButton(m_pad.get(), button) != 0;
    };
    const bool stops = down(SDL_CONTROLLER_BUTTON_B);
    const bool shoulder =
        down(SDL_CONTROLLER_BUTTON_LEFTSHOULDER) || down(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
    return {shoulder && !stops, way(), stops};
}

Gamepad::Way Gamepad::way() const {
    const int stick = SDL_GameControllerGetAxis(m_pad.get(), SDL_CONTROLLER_AXIS_LEFTX);
    const auto to = [this, stick](Way way, SDL_GameControllerButton button, int sign) {
        return stick * sign > (m_hands.way == way ? kLetGo : kPushed) ||
               SDL_GameControllerGetButton(m_pad.get(), button) != 0;
    };
    const bool forward = to(Way::Forward, SDL_CONTROLLER_BUTTON_DPAD_RIGHT, 1);
    const bool reverse = to(Way::Reverse, SDL_CONTROLLER_BUTTON_DPAD_LEFT, -1);
    return forward == reverse ? Way::None : forward ? Way::Forward : Way::Reverse;
}

}  // namespace nmc
