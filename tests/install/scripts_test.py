#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/build.sh does to a build folder."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts/build.sh"
RULES = """
rule precompile
  command = cp $in $out && echo $out: {header} > $out.d
  depfile = $out.d
  deps = gcc
build part/cmake_pch.hxx.pch: precompile all.hxx
"""


class PrecompiledHeaders(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name) / "build"
        self.folder.mkdir()
        self.header = Path(self.scratch.name) / "header.h"
        self.header.write_text("older")
        (self.folder / "all.hxx").write_text("")
        (self.folder / "build.ninja").write_text(RULES.format(header=self.header))
        self.precompiled = self.folder / "part/cmake_pch.hxx.pch"
        self.build()

    def build(self):
        subprocess.run(["ninja", "-C", self.folder], check=True, stdout=subprocess.DEVNULL)

    def drop_outdated(self):
        subprocess.run(["bash", "-euo", "pipefail", "-c", f'. "{SCRIPT}"; drop_outdated_headers "{self.folder}"'],
                       check=True)

    def test_are_made_anew_after_an_upgrade_that_keeps_the_date_of_a_header(self):
        # As dpkg replaces a file.
        upgrade = self.header.with_suffix(".new")
        upgrade.write_text("newer")
        os.utime(upgrade, (1_000_000_000, 1_000_000_000))
        upgrade.rename(self.header)
        self.drop_outdated()
        self.assertFalse(self.precompiled.exists())
        self.build()
        self.assertTrue(self.precompiled.exists())

    def test_stay_otherwise(self):
        self.drop_outdated()
        self.assertTrue(self.precompiled.exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
