# SPDX-License-Identifier: GPL-3.0-or-later
"""What a deliberate breakage is."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Edit:
    """`old` is in `file` exactly once and becomes `new`."""
    file: str
    old: str
    new: str


@dataclass(frozen=True)
class Mutant:
    name: str
    breaks: str  # the rule, and where it is written
    edits: tuple[Edit, ...]
    suite: str = "engine"  # whose tests must notice it, of run_mutants.py
