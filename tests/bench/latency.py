#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How late nmcsim's replies leave while a host polls three modules behind its terminal at 115 200 Bd."""
import json
import os
import select
import subprocess
import sys
import termios
import time

SECONDS = 10.0
MODULES = 3
TIMEOUT = 0.1


def packet(*body):
    return bytes((0xAA, *body, sum(body) & 0xFF))


class Host:
    def __init__(self, terminal):
        self.port = os.open(terminal, os.O_RDWR | os.O_NOCTTY)

    def set_rate(self, rate):
        settings = termios.tcgetattr(self.port)
        settings[4] = settings[5] = rate
        termios.tcsetattr(self.port, termios.TCSADRAIN, settings)

    def ask(self, command, length):
        os.write(self.port, command)
        reply = b""
        while len(reply) < length:
            if not select.select([self.port], [], [], TIMEOUT)[0]:
                return b""
            reply += os.read(self.port, length - len(reply))
        return reply


def main():
    simulator = subprocess.Popen([sys.argv[1] + "/nmcsim", "--chain", ",".join(["servo"] * MODULES)],
                                 stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

    def control(line):
        simulator.stdin.write(line + "\n")
        return json.loads(simulator.stdout.readline())

    host = Host(simulator.stdout.readline().split()[1])
    time.sleep(0.05)
    for address in range(1, MODULES + 1):
        host.ask(packet(0, 0x21, address, 0xFF), 2)
    os.write(host.port, packet(0xFF, 0x1A, 10))
    host.set_rate(termios.B115200)
    time.sleep(0.05)
    control("time")  # forgets what was before
    exchanges = lost = 0
    end = time.monotonic() + SECONDS
    while time.monotonic() < end:
        lost += not host.ask(packet(1 + exchanges % MODULES, 0x13, 0x0D), 9)
        exchanges += 1
    pace = control("time")
    control("quit")
    simulator.wait()
    print(f"latency: {exchanges / SECONDS:.0f} exchanges/s, {lost} lost; replies at most "
          f"{1e3 * pace['late_p99']:.2f} ms late for 99 of 100 (aim: 0.3 ms), {1e3 * pace['lag']:.2f} ms for all")


main()
