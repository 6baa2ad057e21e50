#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Start-up to the first paint: the panel against a bare QMainWindow with one chart, in turn, as a ratio of medians. Once
for somebody who has never started it, with the safety message, and once for everybody else."""
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

RUNS = 25


def seconds(command):
    started = time.monotonic()
    process = subprocess.Popen(command, stderr=subprocess.PIPE)
    while b"painted" not in process.stderr.readline():
        assert process.poll() in (None, 0), "it ended before it had painted"
    painted = time.monotonic()
    process.communicate()
    return painted - started


def compare(programs, who):
    panel, bare = [], []
    for _ in range(RUNS):
        panel.append(seconds([programs + "/nmcpanel", "--quit-after-first-paint"]))
        bare.append(seconds([programs + "/barewindow"]))
    ratio = statistics.median(panel) / statistics.median(bare)
    print(f"start, {who}: panel {1e3 * statistics.median(panel):.0f} ms, bare window "
          f"{1e3 * statistics.median(bare):.0f} ms, ratio {ratio:.2f} (aim: at most 2)")


def main():
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    os.environ["QT_LOGGING_RULES"] = "nmc.start.debug=true"
    with tempfile.TemporaryDirectory() as folder:
        os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_DATA_HOME"] = os.environ["XDG_RUNTIME_DIR"] = folder
        compare(sys.argv[1], "first time")
        settings = pathlib.Path(folder, "nmcpanel", "NMC Panel.conf")
        settings.parent.mkdir(exist_ok=True)
        settings.write_text("[safety]\nunderstood=true\n")
        compare(sys.argv[1], "later")


main()
