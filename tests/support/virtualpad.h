// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

struct _SDL_Joystick;

namespace nmc::testing_support {

/// A gamepad without hardware, plugged in while this object exists. SDL treats it like a real one.
class VirtualPad {
public:
    enum class Button { LeftShoulder, RightShoulder, CrossLeft, CrossRight, B };

    VirtualPad();
    ~VirtualPad();
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;

    [[nodiscard]] bool works() const { return m_pad != nullptr; }
    void press(Button button) { set(button, true); }
    void release(Button button) { set(button, false); }
    /// Moves the left stick: -1 is left, 0 the middle, 1 right.
    void push(double way);
    void unplug();

private:
    void set(Button button, bool down);

    int m_device = -1;
    _SDL_Joystick* m_pad = nullptr;
};

}  // namespace nmc::testing_support
