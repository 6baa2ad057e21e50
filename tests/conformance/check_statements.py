#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that every statement of the data sheets has its test and every test its statement.

usage: check_statements.py [--only servo|step|sc|io] CONFORMANCE_TESTS

Reads the tables statements-*.md beside this script and asks the test program for its tests.
"""
import argparse
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

PLACES = ("InProcess", "Terminal")

# The command references' commands (DS-V 5.2, DS-S 5.2) as the tables' headings, and the bytes whose bits are
# numbered from 0.
COMMON = ["ResetPosition", "SetAddress", "DefineStatus", "ReadStatus", "LoadTrajectory", "StartMotion",
          "StopMotor", "SetHomingMode", "SetBaudRate", "SaveCurrentPositionAsHome", "NoOperation", "HardReset"]
CHIPS = {
    "servo": {"suites": "PicServo", "commands": COMMON + ["SetGain", "IoControl", "ClearStickyBits"]},
    "step": {"suites": "PicStep", "commands": COMMON + ["SetParameters", "SetOutputs"]},
    # What PIC-SERVO SC and CMC have beyond the first sheet.
    "sc": {"suites": "ScServo",
           "commands": ["ResetPosition", "LoadTrajectory", "SetBaudRate", "DefineStatus", "StopMotor", "IoControl", "SetGain",
                        "ClearBits", "HardReset", "AddPathPoints"]},
    "io": {"suites": "PicIo",
           "commands": ["SetDirection", "SetAddress", "DefineStatus", "ReadStatus", "SetPwm", "SynchOutput",
                        "SetOutput", "SetSynchOutput", "SetTimerMode", "SetBaudRate", "SynchInput",
                        "NoOperation", "HardReset"]},
}
STATUS_BYTES = {"StatusByte": 8, "AuxByte": 6, "InputsByte": 6, "ScAuxByte": 7}

ROW = re.compile(r"^\| *([A-Za-z]+) (\d+) *\|(.*)\| *`?([A-Za-z]+\.[A-Za-z0-9_]+)`? *\|$")


def read_table(path, complain):
    """The rows as (heading, number, test)."""
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not line.startswith("|") or re.match(r"^\| *(statement *\||-+)", line):
            continue
        row = ROW.match(line)
        if row is None:
            complain(f"{path.name}:{number}: not a row: {line}")
        elif not row[3].strip():
            complain(f"{path.name}:{number}: {row[1]} {row[2]} does not say what the sheet says")
        else:
            rows.append((row[1], int(row[2]), row[4]))
    return rows


def read_tests(program):
    """Test name without its place -> the places it runs in."""
    listing = subprocess.run([program, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
    tests = defaultdict(set)
    suite = ""
    for line in listing.splitlines():
        name = line.split("#")[0].strip()
        if not line.startswith(" "):
            suite = name
        elif name:
            test, _, place = name.partition("/")
            tests[suite + test].add(place)
    return tests


def check_numbers(chip, rows, complain):
    numbers = defaultdict(list)
    for heading, number, _ in rows:
        numbers[heading].append(number)
    for heading, found in numbers.items():
        bits = STATUS_BYTES.get(heading)
        wanted = list(range(bits)) if bits else list(range(1, len(found) + 1))
        if sorted(found) != wanted:
            complain(f"{chip}: the numbers of {heading} are {sorted(found)} instead of {wanted}")
    for command in CHIPS[chip]["commands"]:
        if command not in numbers:
            complain(f"{chip}: {command} has no row")


def check_tests(chip, rows, tests, complain):
    for heading, number, test in rows:
        if not test.split(".")[1].startswith(f"{heading}{number}_"):
            complain(f"{chip}: the name of {test} does not begin with {heading}{number}_")
        for place in PLACES:
            if place not in tests.get(test, ()):
                complain(f"{chip}: {heading} {number} has no test {test}/{place}")
    listed = [test for _, _, test in rows]
    for test in sorted(set(listed)):
        if listed.count(test) > 1:
            complain(f"{chip}: {test} is in more than one row")
    for test in tests:
        if test.startswith(CHIPS[chip]["suites"]) and test not in listed:
            complain(f"{chip}: {test} is in no row")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", choices=CHIPS, help="the table of one chip")
    parser.add_argument("program", help="the conformance_tests executable")
    arguments = parser.parse_args()

    complaints = []
    complain = complaints.append
    tests = read_tests(arguments.program)
    chips = [arguments.only] if arguments.only else list(CHIPS)
    total = 0
    for chip in chips:
        path = Path(__file__).with_name(f"statements-{chip}.md")
        if not path.exists():
            complain(f"{path.name} is missing")
            continue
        rows = read_table(path, complain)
        total += len(rows)
        check_numbers(chip, rows, complain)
        check_tests(chip, rows, tests, complain)
    if not arguments.only:
        for test in tests:
            if not test.startswith(tuple(chip["suites"] for chip in CHIPS.values())):
                complain(f"{test} belongs to no chip")

    for complaint in complaints:
        print(f"check_statements: {complaint}", file=sys.stderr)
    print(f"{total} statements, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
