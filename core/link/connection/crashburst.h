// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/bytes.h"
#include "link/guardian/stopburst.h"

/// The last thing that a crashing panel does: it writes the stop of every motor to the port (link.md 2.6).
/// The modules have no watchdog, so without it a motor would run on behind a dead program.
///
/// A signal handler may not allocate, lock or ask an engine, so the bytes lie ready in static memory. It is
/// beyond SIGKILL and a process that stands still, which are for the guardian (link/guardian/guardian.h), and
/// beyond a power cut and a pulled cable. Without Qt; one port a process.
namespace nmc::crashburst {

/// From now on a crash sets `fd` to `baud`, the rate at which the chain hears it, and writes `bytes` to it;
/// nothing with fd -1 or without bytes. A burst longer than StopBurst::kCapacity is refused whole. Bus
/// thread, before the command that changes the burst leaves.
bool arm(int fd, ByteSpan bytes, std::uint32_t baud);
/// Nothing is left to stop, or the port is about to be closed. Bus thread.
void disarm();
/// A burst is being written, so nothing else may follow it on the wire: the caller must wait for the end of
/// the process. Bus thread, before it writes.
[[nodiscard]] bool underWay();

/// SIGSEGV, SIGABRT, SIGBUS and SIGFPE write the burst, wait for it to leave, and then take their usual
/// course, core dump included. Once, at the start of the program.
void installHandlers();

/// A stack for the handlers: a thread that has run out of its own must still be able to stop the motors. Of
/// the thread that makes it, as long as it lives.
class HandlerStack {
public:
    HandlerStack();
    ~HandlerStack();
    HandlerStack(const HandlerStack&) = delete;
    HandlerStack& operator=(const HandlerStack&) = delete;

private:
    struct Memory;
    Memory* m_memory;
};

}  // namespace nmc::crashburst
