#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Moves two axes over a grid, back and forth, and records where they came to rest.

usage: raster_scan.py X Y SIZE STEPS FILE    X, Y: names or numbers of the axes; SIZE: in their unit
"""
import csv
import sys

from nmcpanel import Panel


def axis(text):
    return int(text) if text.isdecimal() else text


def main():
    x, y = axis(sys.argv[1]), axis(sys.argv[2])
    size, steps = float(sys.argv[3]), int(sys.argv[4])
    places = [size * i / (steps - 1) for i in range(steps)]
    with Panel(program="raster_scan.py") as panel, open(sys.argv[5], "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(("x", "y", "x_measured", "y_measured"))
        panel.request_control()
        for j, to_y in enumerate(places):
            panel.axis(y).move(to_y)
            for to_x in places if j % 2 == 0 else reversed(places):
                panel.axis(x).move(to_x)
                # Here is where the detector would be read.
                rows.writerow((to_x, to_y, panel.axis(x).position, panel.axis(y).position))


if __name__ == "__main__":
    main()
