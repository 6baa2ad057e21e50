#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exchanges per second of the whole panel against the wire's limit, and beside it those of a host that does nothing else;
the counts are nmcsim's.

An exchange cannot be shorter than its bytes at the modules' real rate plus the mean wait for a servo tick. What is lost
beyond that are the moments in which the machine wakes simulator and host, which the simplest host loses as well."""
import json
import os
import subprocess
import sys
import time

from host import Host, packet

SECONDS = 4.0
TICK_WAIT = 0.256e-3
REAL_RATE = {19200: 1.25e6 / 64, 115200: 1.25e6 / 11}  # bits/s; 19 200 is the power-up divisor, nobody sends another


class Simulator:
    def __init__(self, programs, modules):
        self.process = subprocess.Popen([programs + "/nmcsim", "--chain", ",".join(["servo"] * modules)],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
        self.terminal = self.process.stdout.readline().split()[1]

    def ask(self, line):
        self.process.stdin.write(line + "\n")
        return json.loads(self.process.stdout.readline())

    def quit(self):
        self.ask("quit")
        self.process.wait()


def measure(programs, baud, modules, options=(), meanwhile=lambda panel: time.sleep(SECONDS)):
    """Exchanges per second, their share of the wire, and violations, while the panel's process and `meanwhile` run."""
    simulator = Simulator(programs, modules)
    panel = subprocess.Popen([programs + "/nmcpanel", "--port", simulator.terminal, "--baud", str(baud), *options],
                             stderr=subprocess.DEVNULL)
    try:
        # Every module has been polled ten times: enumeration and start-up are over.
        while min(m["replies"] for m in simulator.ask("stats")["modules"]) < 14:
            time.sleep(0.1)
        before = simulator.ask("stats")
        meanwhile(panel)
        after = simulator.ask("stats")
    finally:
        panel.terminate()
        panel.wait()
    violations = simulator.ask("stats")["violations"]
    simulator.quit()
    return *shares(before, after, baud), violations


def shares(before, after, baud):
    """Exchanges per second, and their share of the wire, between two answers to `stats`."""
    difference = {key: after[key] - before[key] for key in ("time", "exchanges", "bytes_in", "bytes_out")}
    wire_bytes = difference["bytes_in"] + difference["bytes_out"]
    shortest = wire_bytes * 10 / REAL_RATE[baud] + difference["exchanges"] * TICK_WAIT
    return difference["exchanges"] / difference["time"], shortest / difference["time"]


def simplest(programs, baud, modules):
    """As measure(), of a host that polls, with replies about as long as the panel's, and does nothing else."""
    simulator = Simulator(programs, modules)
    host = Host(simulator.terminal, modules, baud)
    before = simulator.ask("stats")
    exchanges = 0
    end = time.monotonic() + SECONDS
    while time.monotonic() < end:
        host.ask(packet(1 + exchanges % modules, 0x13, 0x1F), 14)
        exchanges += 1
    after = simulator.ask("stats")
    simulator.quit()
    return shares(before, after, baud)


def main():
    programs = sys.argv[1]
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    os.environ["XDG_CONFIG_HOME"] = os.environ.get("TMPDIR", "/tmp") + "/nmc-bench"
    for baud in (19200, 115200):
        for modules in (1, 8, 32):
            rate, share, violations = measure(programs, baud, modules)
            print(f"bus: {baud} Bd, {modules:2} modules: {rate:6.1f} exchanges/s, {share:.3f} of the wire's limit, "
                  f"the simplest host {simplest(programs, baud, modules)[1]:.3f}"
                  + (f", {len(violations)} VIOLATIONS" if violations else ""))


if __name__ == "__main__":
    main()
