#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A laboratory centrifuge as a backend of the kind that PyLabRobot has: asynchronous, with setup, spin and stop.

usage: centrifuge.py AXIS RPM SECONDS    with an axis whose unit is turns, and whose max jog speed permits that
"""
import asyncio
import math
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

from nmcpanel import Panel

RADIUS = 0.1  # m
GRAVITY = 9.80665  # m/s2
JOG_EVERY = 0.03  # s


class Centrifuge:
    """The calls wait in a thread of their own, one at a time, so that other devices go on meanwhile."""

    def __init__(self, axis):
        self.name = axis
        self.thread = ThreadPoolExecutor(max_workers=1)
        self.stopping = threading.Event()

    async def do(self, call, *parameters):
        return await asyncio.get_running_loop().run_in_executor(self.thread, call, *parameters)

    async def setup(self):
        self.panel = await self.do(lambda: Panel(program="centrifuge.py"))
        await self.do(self.panel.request_control)
        self.axis = self.panel.axis(self.name)
        await self.do(self.axis.enable)

    def jog(self, velocity, seconds):
        until = time.monotonic() + seconds
        while time.monotonic() < until and not self.stopping.wait(JOG_EVERY):
            self.axis.call("jog", velocity=velocity)
        self.axis.stop()

    async def spin(self, rpm, seconds):
        """If this program ends meanwhile, the motor stops."""
        await self.do(self.jog, rpm / 60, seconds)

    async def spin_at(self, g, seconds):
        await self.spin(math.sqrt(g * GRAVITY / RADIUS) * 60 / (2 * math.pi), seconds)

    async def stop(self):
        """Ends a spin that is in progress, even if nobody waits for it any more."""
        self.stopping.set()
        await self.do(self.axis.stop)
        self.panel.close()


async def main():
    centrifuge = Centrifuge(int(sys.argv[1]) if sys.argv[1].isdecimal() else sys.argv[1])
    await centrifuge.setup()
    try:
        await centrifuge.spin(float(sys.argv[2]), float(sys.argv[3]))
        print(f"{centrifuge.axis.position:.2f} turns")
    finally:
        await centrifuge.stop()


if __name__ == "__main__":
    asyncio.run(main())
