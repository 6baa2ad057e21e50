#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How late nmcsim's replies leave while a host polls three modules behind its terminal at 115 200 Bd."""
import sys
import time

import bus
from host import Host, packet

SECONDS = 10.0
MODULES = 3


def main():
    simulator = bus.Simulator(sys.argv[1], MODULES)
    host = Host(simulator.terminal, MODULES, 115200)
    simulator.ask("time")  # forgets what was before
    exchanges = lost = 0
    end = time.monotonic() + SECONDS
    while time.monotonic() < end:
        lost += not host.ask(packet(1 + exchanges % MODULES, 0x13, 0x0D), 9)
        exchanges += 1
    pace = simulator.ask("time")
    simulator.quit()
    print(f"latency: {exchanges / SECONDS:.0f} exchanges/s, {lost} lost; replies at most "
          f"{1e3 * pace['late_p99']:.2f} ms late for 99 of 100 (aim: 0.3 ms), {1e3 * pace['lag']:.2f} ms for all")


main()
