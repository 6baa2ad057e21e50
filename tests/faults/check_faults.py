#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that every fault of the catalogue has its test, or a reason why not yet.

usage: check_faults.py PROGRAM...

Reads catalogue.md beside this script and asks the test programs for their tests. A fault whose program is not
among those given (there is none without Qt, say) is counted and not checked.
"""
import argparse
import os
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

# How many faults each section has: none can be dropped silently.
SECTIONS = {"F": 48, "M": 27, "H": 20}

ROW = re.compile(r"^\| *([A-Z]\d\d) *\|(.*)\|([^|]*)\|$")
DEFERRED = re.compile(r"^(issue \d+|other): *\S")
PROGRAMS = re.compile(r"^\w+(, *\w+)*$")
SUITE = re.compile(r"^([A-Z]\d\d)_\w")


def read_catalogue(path, complain):
    """Id -> the programs one of which tests it; empty for a fault that is put off."""
    rows = {}
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not line.startswith("|") or re.match(r"^\| *(Id *\||-+)", line):
            continue
        row = ROW.match(line)
        where = row[3].strip() if row else ""
        if row is None or not row[2].strip():
            complain(f"{path.name}:{number}: not a row: {line}")
        elif row[1] in rows:
            complain(f"{path.name}:{number}: {row[1]} is there twice")
        elif DEFERRED.match(where):
            rows[row[1]] = []
        elif PROGRAMS.match(where) and not where.startswith(("issue", "other")):
            rows[row[1]] = re.split(r", *", where)
        else:
            complain(f"{path.name}:{number}: neither programs nor a reason: {where!r}")
            rows[row[1]] = []
    wanted = {f"{section}{n:02}" for section, last in SECTIONS.items() for n in range(1, last + 1)}
    for fault in sorted(wanted - rows.keys()):
        complain(f"{path.name}: {fault} has no row")
    for fault in sorted(rows.keys() - wanted):
        complain(f"{path.name}: there is no fault {fault}")
    return rows


def read_suites(program):
    """The suites that have at least one test, without the names of instantiations."""
    listing = subprocess.run([program, "--gtest_list_tests"], check=True, capture_output=True, text=True,
                             env={"QT_QPA_PLATFORM": "offscreen", **os.environ}).stdout
    suites = set()
    suite = ""
    for line in listing.splitlines():
        if line.startswith(" "):
            suites.add(suite)
        else:
            parts = line.split("#")[0].strip().removesuffix(".").split("/")
            suite = next((part for part in parts if SUITE.match(part)), parts[0])
    return suites


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", nargs="+", help="test executables")
    arguments = parser.parse_args()

    complaints = []
    complain = complaints.append
    catalogue = read_catalogue(Path(__file__).with_name("catalogue.md"), complain)
    given = {Path(program).name: program for program in arguments.programs}
    tested = defaultdict(set)
    for name, program in given.items():
        for suite in sorted(read_suites(program)):
            match = SUITE.match(suite)
            if match is None:
                continue
            tested[match[1]].add(name)
            if match[1] not in catalogue:
                complain(f"{name}: {suite} names a fault that does not exist")
            elif not catalogue[match[1]]:
                complain(f"{name}: {suite} tests what the catalogue puts off")
    unchecked = 0
    for fault, programs in catalogue.items():
        if not programs or tested[fault].intersection(programs):
            continue
        if all(name in given for name in programs):
            complain(f"{fault} has no test in {' or '.join(programs)}")
        else:
            unchecked += 1

    for complaint in complaints:
        print(f"check_faults: {complaint}", file=sys.stderr)
    put_off = sum(not programs for programs in catalogue.values())
    print(f"{len(catalogue)} faults, {put_off} put off, {unchecked} in programs that were not given, "
          f"{len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
