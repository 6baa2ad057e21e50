// SPDX-License-Identifier: MIT
#pragma once

namespace nmc {

/// Which groups of commands are left to an operator while the panel is locked. Stops and switching off are
/// not among them: they are never locked. This keeps hands off what they should not touch by mistake; it is
/// no security.
struct OperatorRights {
    bool enable = true;    ///< switch motors on, and acknowledge what switched them off
    bool jog = true;       ///< hold to move
    bool points = true;    ///< taught points and sequences
    bool moves = false;    ///< go to, run, step by, start what is loaded
    bool homing = false;   ///< search for home, save it, set the position to 0
    bool outputs = false;  ///< pins

    bool operator==(const OperatorRights&) const = default;
};

}  // namespace nmc
