#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Approaches a position several times from either side, and prints how well it comes back.

usage: repeatability.py AXIS POSITION DISTANCE TIMES
"""
import statistics
import sys

from nmcpanel import Panel


def main():
    name, position, distance, times = sys.argv[1], *map(float, sys.argv[2:4]), int(sys.argv[4])
    with Panel(program="repeatability.py") as panel:
        panel.request_control()
        axis = panel.axis(int(name) if name.isdecimal() else name)
        unit = axis.state()["unit"]
        found = {}
        for side, offset in (("below", -distance), ("above", distance)):
            places = []
            for _ in range(times):
                axis.move(position + offset)
                axis.move(position)
                places.append(axis.position)
            found[side] = statistics.mean(places)
            print(f"from {side}: mean {found[side]:.6g} {unit}, spread {max(places) - min(places):.3g} {unit}")
        print(f"between the sides: {found['above'] - found['below']:.3g} {unit}")


if __name__ == "__main__":
    main()
