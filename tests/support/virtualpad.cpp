// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/virtualpad.h"

#define SDL_MAIN_HANDLED
#include <SDL.h>

namespace nmc::testing_support {

namespace {

SDL_GameControllerButton numberOf(VirtualPad::Button button) {
    switch (button) {
        case VirtualPad::Button::LeftShoulder:
            return SDL_CONTROLLER_BUTTON_LEFTSHOULDER;
        case VirtualPad::Button::RightShoulder:
            return SDL_CONTROLLER_BUTTON_RIGHTSHOULDER;
        case VirtualPad::Button::CrossLeft:
            return SDL_CONTROLLER_BUTTON_DPAD_LEFT;
        case VirtualPad::Button::CrossRight:
            return SDL_CONTROLLER_BUTTON_DPAD_RIGHT;
        case VirtualPad::Button::B:
            return SDL_CONTROLLER_BUTTON_B;
    }
    return SDL_CONTROLLER_BUTTON_INVALID;
}

}  // namespace

VirtualPad::VirtualPad() {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
    SDL_VirtualJoystickDesc desc{};
    desc.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    desc.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
    desc.naxes = SDL_CONTROLLER_AXIS_MAX;
    desc.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
    m_device = SDL_JoystickAttachVirtualEx(&desc);
    m_pad = SDL_JoystickOpen(m_device);
}

VirtualPad::~VirtualPad() {
    unplug();
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void VirtualPad::push(double way) {
    SDL_JoystickSetVirtualAxis(m_pad, SDL_CONTROLLER_AXIS_LEFTX,
                               static_cast<Sint16>(way * SDL_JOYSTICK_AXIS_MAX));
}

void VirtualPad::unplug() {
    if (m_pad == nullptr)
        return;
    SDL_JoystickClose(m_pad);
    m_pad = nullptr;
    SDL_JoystickDetachVirtual(m_device);
}

void VirtualPad::set(Button button, bool down) {
    SDL_JoystickSetVirtualButton(m_pad, numberOf(button), down ? SDL_PRESSED : SDL_RELEASED);
}

}  // namespace nmc::testing_support
