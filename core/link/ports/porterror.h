// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/strong.h"

namespace nmc {

/// Why a port cannot be used, or no longer can.
enum class PortProblem : std::uint8_t {
    NotFound,
    NoPermission,
    InUse,
    StaleLock,     ///< lock file of a program that has ended, owned by another user
    NoLockFolder,  ///< no lock file can be created, but the serial port library insists on one
    NotASerialPort,
    RateNotPossible,
    TooManyFiles,     ///< this program has no file descriptors left
    NotANetworkLine,  ///< the name begins like one, but is not tcp://HOST:PORT or rfc2217://HOST:PORT
    HostNotFound,
    NotReached,  ///< nothing accepts connections there
    NotRfc2217,  ///< something does, but does not let the port be controlled
    Gone,        ///< the port was open, but was unplugged or closed at the other end
    Other,       ///< detail holds the system's message
};

/// A value without Qt, because the bus thread has none; its texts are UTF-8.
struct PortError {
    PortProblem problem = PortProblem::Other;
    std::string port;
    std::string group;   ///< NoPermission: the group that may use the port, if known
    std::string user;    ///< NoPermission: the current user; StaleLock: the owner of the lock file
    std::string detail;  ///< the system's message
    std::vector<ModuleIndex> moving{};  ///< Gone: modules that were moving when they last answered
    std::string program{};              ///< InUse: the program that uses the port, if known
    std::int64_t pid = 0;               ///< InUse: its process number; 0 if unknown
    std::string lockFile{};  ///< StaleLock: the file to remove; NoLockFolder: the folder it should be in
};

}  // namespace nmc
