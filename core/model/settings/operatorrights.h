// SPDX-License-Identifier: MIT
#pragma once

namespace nmc {

/// The groups of commands available to an operator while the panel is locked. Stops and switching off are not
/// among them, because they are never locked. This prevents operating errors; it is not a security feature.
struct OperatorRights {
    bool enable = true;    ///< switch motors on, and acknowledge what switched them off
    bool jog = true;       ///< hold to move
    bool points = true;    ///< taught points and sequences
    bool moves = false;    ///< go to, run, step by, start the loaded motion
    bool homing = false;   ///< search for home, save it, set the position to 0
    bool outputs = false;  ///< pins

    bool operator==(const OperatorRights&) const = default;
};

}  // namespace nmc
