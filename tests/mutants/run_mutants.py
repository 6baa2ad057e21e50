#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks the bus engine and the port on purpose, one way after the other, and says whether a test notices.

usage: run_mutants.py [--check | --list] [-j JOBS] [NAME...]

The tree is copied to build/mutants and stays as it is. A mutant is killed by a test that passes without it and
fails with it, by a crash, or by a program that does not end. With --check the edits are only tried: each must
fit its file exactly once.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from mutants import MUTANTS

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / "build" / "mutants"
TREE = WORK / "tree"
LONGEST = 3600  # seconds for a test program without any mutant


@dataclass(frozen=True)
class Suite:
    """The tests that a mutant is tried on."""
    folder: str
    gui: str  # whether they need the Qt parts
    programs: tuple[str, ...]
    helpers: tuple[str, ...] = ()  # programs that they start
    filter: str = "*"

    @property
    def build(self):
        return WORK / self.folder


SUITES = {
    "engine": Suite("build", "OFF", ("bus_tests", "fault_tests", "session_tests")),
    "link": Suite("build-link", "ON", ("link_tests",), ("nmcsim",), "F27*"),
}


def misfits(mutant):
    """Why its edits cannot be made."""
    for edit in mutant.edits:
        path = ROOT / edit.file
        times = path.read_text(encoding="utf-8").count(edit.old) if path.exists() else 0
        if times != 1:
            yield f"{mutant.name}: {edit.file} has {times} times: {edit.old.strip()}"


def copy_tree():
    """Copies the working tree as it is now. Unchanged files keep their times, so that little is rebuilt."""
    listing = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                             capture_output=True, text=True).stdout
    names = {name for name in listing.split("\0") if name and (ROOT / name).is_file()}
    for name in names:
        source, target = ROOT / name, TREE / name
        if not target.exists() or target.read_bytes() != source.read_bytes():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)
            shutil.copymode(source, target)
    for old in [path for path in TREE.rglob("*") if path.is_file()]:
        if str(old.relative_to(TREE)) not in names:
            old.unlink()


def configure(suite):
    # No build type: most of a mutant's time is compiling and linking, and nobody debugs it. What a mutant leaves
    # unused is no error.
    subprocess.run(["cmake", "-S", TREE, "-B", suite.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=",
                    f"-DNMC_BUILD_GUI={suite.gui}", "-DCMAKE_CXX_FLAGS=-O1 -w"], check=True, capture_output=True)


def compiles(suite, jobs, *programs):
    command = ["cmake", "--build", suite.build, "-j", str(jobs), "--target", *programs, *suite.helpers]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        print(done.stdout[-3000:], file=sys.stderr)
    return done.returncode == 0


def failures(suite, program, longest, *options):
    """The names of the tests that fail, and one for the program if it does not end in `longest` seconds."""
    report = suite.build / f"{program}.json"
    report.unlink(missing_ok=True)
    command = [suite.build / "bin" / program, f"--gtest_output=json:{report}", *options]
    try:
        subprocess.run(command, timeout=longest, capture_output=True, env={**os.environ, "RC_PARAMS": "seed=1"})
    except subprocess.TimeoutExpired:
        return {f"{program} does not end"}
    if not report.exists():
        return {f"{program} crashes"}
    found = json.loads(report.read_text(encoding="utf-8"))["testsuites"]
    return {f"{group['name']}.{test['name']}" for group in found for test in group["testsuite"]
            if test.get("failures")}


def noticed_by(suite, jobs, before, longest):
    """A test that newly fails; empty if none does, None if the mutant does not compile."""
    for program in suite.programs:
        if not compiles(suite, jobs, program):
            return None
        others = f"--gtest_filter={suite.filter}-{':'.join(sorted(before))}"
        if new := failures(suite, program, longest[program], others, "--gtest_fail_fast"):
            return min(new)
    return ""


def run(mutant, suite, jobs, before, longest):
    """A test that noticed the mutant; empty if none did, None if it does not compile."""
    originals = {edit.file: (TREE / edit.file).read_text(encoding="utf-8") for edit in mutant.edits}
    try:
        for edit in mutant.edits:
            path = TREE / edit.file
            path.write_text(path.read_text(encoding="utf-8").replace(edit.old, edit.new), encoding="utf-8")
        return noticed_by(suite, jobs, before, longest)
    finally:
        for name, text in originals.items():
            (TREE / name).write_text(text, encoding="utf-8")


def run_all(suite, mutants, jobs):
    """How many mutants survive; None if the tree does not build without any."""
    configure(suite)
    if not compiles(suite, jobs, *suite.programs):
        print("run_mutants: the tree does not build", file=sys.stderr)
        return None
    everything = f"--gtest_filter={suite.filter}"
    before = set()
    longest = {}
    for program in suite.programs:
        start = time.monotonic()
        before |= failures(suite, program, LONGEST, everything)
        # The machine may be busier later.
        longest[program] = 60 + 10 * (time.monotonic() - start)
    if before:
        print(f"{len(before)} tests fail without any mutant; they count for nothing", flush=True)
    survived = 0
    # By file, so that undoing one mutant and making the next compiles that file once.
    for mutant in sorted(mutants, key=lambda each: [edit.file for edit in each.edits]):
        noticed = run(mutant, suite, jobs, before, longest)
        if noticed:
            print(f"killed    {mutant.name}: {noticed}", flush=True)
        else:
            survived += 1
            print(f"{'BROKEN  ' if noticed is None else 'SURVIVED'}  {mutant.name}: {mutant.breaks}", flush=True)
    return survived


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="only see whether every edit fits")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("names", nargs="*", metavar="NAME")
    arguments = parser.parse_args()
    unknown = set(arguments.names) - {mutant.name for mutant in MUTANTS}
    if unknown:
        parser.error(f"no mutant {', '.join(sorted(unknown))}")
    chosen = [mutant for mutant in MUTANTS if not arguments.names or mutant.name in arguments.names]
    if arguments.list:
        for mutant in chosen:
            print(f"{mutant.name}: {mutant.breaks}")
        return 0
    wrong = [why for mutant in chosen for why in misfits(mutant)]
    for why in wrong:
        print(f"run_mutants: {why}", file=sys.stderr)
    if wrong or arguments.check:
        print(f"{len(chosen)} mutants, {len(wrong)} edits do not fit")
        return 1 if wrong else 0

    copy_tree()
    survived = 0
    for name, suite in SUITES.items():
        mutants = [mutant for mutant in chosen if mutant.suite == name]
        if mutants:
            alive = run_all(suite, mutants, arguments.jobs)
            if alive is None:
                return 1
            survived += alive
    print(f"{len(chosen)} mutants, {survived} survived")
    return 1 if survived else 0


if __name__ == "__main__":
    sys.exit(main())
