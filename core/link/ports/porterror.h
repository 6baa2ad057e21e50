// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/strong.h"

namespace nmc {

/// Why a port cannot be used, or is no longer.
enum class PortProblem : std::uint8_t {
    NotFound,
    NoPermission,
    InUse,
    StaleLock,     ///< a program that is gone has left its lock file, and it is another user's
    NoLockFolder,  ///< no lock file can be made, and the serial port library insists on one
    NotASerialPort,
    RateNotPossible,
    TooManyFiles,  ///< this program has no file descriptor left
    Gone,          ///< it was open: unplugged, or the other end closed
    Other,         ///< detail holds the system's own words
};

/// A value without Qt, since the bus thread has none; its texts are UTF-8.
struct PortError {
    PortProblem problem = PortProblem::Other;
    std::string port;
    std::string group;   ///< NoPermission: the group that may use the port, where it is known
    std::string user;    ///< NoPermission: the present user; StaleLock: the owner of the lock file
    std::string detail;  ///< the system's own words
    std::vector<ModuleIndex> moving{};  ///< Gone: those that were moving at the last word
    std::string program{};              ///< InUse: who uses it, where that can be known
    std::int64_t pid = 0;               ///< InUse: the same; 0 where it cannot be known
    std::string lockFile{};  ///< StaleLock: to be removed; NoLockFolder: the folder it should be in
};

}  // namespace nmc
