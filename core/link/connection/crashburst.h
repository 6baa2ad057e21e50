// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "base/bytes.h"
#include "link/guardian/stopburst.h"

/// The last action of a crashing panel: it writes the stop of every motor to the port (link.md 2.6). The
/// modules have no watchdog, so without it a motor would keep running after the program has died.
///
/// A signal handler may not allocate, lock or call the engine, so the bytes are kept ready in static memory.
/// It cannot handle SIGKILL or a process that hangs, which are the guardian's task
/// (link/guardian/guardian.h), nor a power cut or a pulled cable. Free of Qt; one port per process.
namespace nmc::crashburst {

/// From now on, a crash sets `fd` to `baud`, the rate at which the chain listens, and writes `bytes` to it;
/// with fd -1 or without bytes, it writes nothing. A burst longer than StopBurst::kCapacity is refused as a
/// whole. Bus thread, before the command that changes the burst is sent.
bool arm(int fd, ByteSpan bytes, std::uint32_t baud);
/// Called when nothing is left to stop, or the port is about to be closed. Bus thread.
void disarm();
/// True while a burst is being written. Nothing else may follow it on the line, so the caller must wait for
/// the end of the process. Bus thread, before it writes.
[[nodiscard]] bool underWay();

/// Installs handlers for SIGSEGV, SIGABRT, SIGBUS and SIGFPE that write the burst, wait until it has been
/// sent, and then let the signal take its usual course, including a core dump. Called once at the start of
/// the program.
void installHandlers();

/// An alternate stack for the handlers, because a thread that has overflowed its own stack must still be able
/// to stop the motors. It belongs to the thread that constructs it, for the object's lifetime.
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
