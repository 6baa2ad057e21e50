#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Start-up to the first paint: the panel against a bare QMainWindow with one chart, in turn, as a ratio of medians."""
import os
import statistics
import subprocess
import sys
import time

RUNS = 15


def seconds(command):
    started = time.monotonic()
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    return time.monotonic() - started


def main():
    programs = sys.argv[1]
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    os.environ["XDG_CONFIG_HOME"] = os.environ.get("TMPDIR", "/tmp") + "/nmc-bench"
    panel, bare = [], []
    for _ in range(RUNS):
        panel.append(seconds([programs + "/nmcpanel", "--quit-after-first-paint"]))
        bare.append(seconds([programs + "/barewindow"]))
    ratio = statistics.median(panel) / statistics.median(bare)
    print(f"start: panel {1e3 * statistics.median(panel):.0f} ms, bare window {1e3 * statistics.median(bare):.0f} ms, "
          f"ratio {ratio:.2f} (aim: at most 2)")


main()
