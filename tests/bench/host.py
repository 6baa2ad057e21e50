# SPDX-License-Identifier: GPL-3.0-or-later
"""The simplest host: it sends a packet, waits for the reply, and does nothing else. What this machine allows, the panel
cannot exceed by much."""
import os
import select
import termios
import time

TIMEOUT = 0.1


def packet(*body):
    return bytes((0xAA, *body, sum(body) & 0xFF))


class Host:
    """Behind the terminal of a simulator of servos that have just been switched on, to which it gives the addresses 1, 2,
    3 and so on. `baud`: 19200 or 115200."""

    def __init__(self, terminal, modules, baud):
        self.port = os.open(terminal, os.O_RDWR | os.O_NOCTTY)
        time.sleep(0.05)
        for address in range(1, modules + 1):
            self.ask(packet(0, 0x21, address, 0xFF), 2)
        if baud == 115200:
            os.write(self.port, packet(0xFF, 0x1A, 10))
            settings = termios.tcgetattr(self.port)
            settings[4] = settings[5] = termios.B115200
            termios.tcsetattr(self.port, termios.TCSADRAIN, settings)
            time.sleep(0.05)

    def ask(self, command, length):
        """The reply, or nothing if it did not come in time."""
        os.write(self.port, command)
        reply = b""
        while len(reply) < length:
            if not select.select([self.port], [], [], TIMEOUT)[0]:
                return b""
            reply += os.read(self.port, length - len(reply))
        return reply
