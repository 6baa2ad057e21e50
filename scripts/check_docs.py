#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the documentation hangs together: what comments cite exists, and so does what pages link to.

In comments of the code and the tests: a page (link.md) is in docs/, docs/manual/, or beside the file; its sections (link.md 2.3;
simulator.md, Faults; interface.md, "Moving") are headings of that page; a fault (F-42, faults.md H-02, N7) has a row in
docs/faults.md; a section of a data sheet (DS-V 5.2) is in the key of docs/protocol.md. In all Markdown: every relative
link and its anchor. In docs/manual: an anchor that is no heading is the object name of a widget.
"""
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"

COMMENT = re.compile(r"^\s*(?:///?<?|#)\s?|(?<=\s)///?<?\s")
PAGE = re.compile(r"(?<![\w/.-])(?:docs/)?([a-z][a-z-]*\.md)\b")
SECTIONS = re.compile(r"\s*(?:section\s+)?(\d(?:\.\d)?)(?![\d.]*\d)(?:\s|[,;:.)]|$)")
NAMED = re.compile(r",\s+(?:\"([^\"]+)\"|([A-Z][a-z]+(?: [a-z]+)?)\b)")
FAULT = re.compile(r"\b([FMHU]-\d\d|N[1-8])\b")
SHEET = re.compile(r"\b(DS-[VS]) (\d(?:\.\d)?(?:(?:,| and| -) \d\.\d)*)(?!\d)")
LINK = re.compile(r"(?<!!)\[[^\]]*\]\(([^)\s]+)\)|!\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```", re.M | re.S)

complaints = []


def files(*patterns):
    listing = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", *patterns],
                             cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return [ROOT / name for name in listing.splitlines() if (ROOT / name).exists()]


def slug(heading):
    """The anchor that a heading gets."""
    heading = re.sub(r"<[^>]*>|[`*]|\]\([^)]*\)|\[", "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", heading).replace(" ", "-")


@cache
def headings(page):
    return re.findall(r"^#+\s+(.*)$", CODE.sub("", page.read_text(encoding="utf-8")), re.M)


@cache
def anchors(page):
    return {slug(h) for h in headings(page)} | set(own_anchors(page))


@cache
def own_anchors(page):
    return re.findall(r'<a id="([^"]+)"', page.read_text(encoding="utf-8"))


@cache
def faults():
    return {name.upper() for name in own_anchors(DOCS / "faults.md")}


@cache
def sheet_sections():
    """DS-V 4.3 and its like, from the key."""
    found = set()
    for row in re.findall(r"^\| (DS-[VS] [\d., ]+) \|", (DOCS / "protocol.md").read_text(encoding="utf-8"), re.M):
        sheet, numbers = row.split(" ", 1)
        found |= {f"{sheet} {number.strip()}" for number in numbers.split(",")}
    return found


def page_of(name, beside):
    places = (DOCS, DOCS / "manual", beside.parent, ROOT)
    return next((place / name for place in places if (place / name).exists()), None)


def check_citation(where, page, rest):
    """`rest`: what stands behind the page's name."""
    if number := SECTIONS.match(rest):
        if not any(re.match(re.escape(number[1]) + r"[.\s]", h) for h in headings(page)):
            complaints.append(f"{where}: {page.name} has no section {number[1]}")
    elif (named := NAMED.match(rest)) and page.parent == DOCS:
        title = named[1] or named[2]
        if title not in headings(page):
            complaints.append(f"{where}: {page.name} has no section {title!r}")


def check_comments(file):
    text = []
    starts = []  # of each line in what the comments come to
    for line in file.read_text(encoding="utf-8").splitlines():
        comment = COMMENT.search(line) if file.suffix != ".py" else re.match("", line)
        starts.append(sum(map(len, text)))
        text.append(line[comment.end():] + " " if comment else "\n")
    text = "".join(text)

    def where(position):
        number = sum(start <= position for start in starts)
        return f"{file.relative_to(ROOT)}:{number}"

    for cited in PAGE.finditer(text):
        page = page_of(cited[1], file)
        if page is None:
            complaints.append(f"{where(cited.start())}: there is no page {cited[1]}")
        else:
            check_citation(where(cited.start()), page, text[cited.end():cited.end() + 60])
    for fault in FAULT.finditer(text):
        if fault[1] not in faults():
            complaints.append(f"{where(fault.start())}: docs/faults.md has no {fault[1]}")
    for sheet in SHEET.finditer(text):
        for number in re.findall(r"\d(?:\.\d)?", sheet[2]):
            if f"{sheet[1]} {number}" not in sheet_sections():
                complaints.append(f"{where(sheet.start())}: the key in docs/protocol.md has no {sheet[1]} {number}")


def check_links(page):
    text = CODE.sub(lambda code: "\n" * code[0].count("\n"), page.read_text(encoding="utf-8"))
    for link in LINK.finditer(text):
        target = link[1] or link[2]
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        to = (page.parent / path).resolve() if path else page
        where = f"{page.relative_to(ROOT)}:{text.count(chr(10), 0, link.start()) + 1}"
        if not to.exists():
            complaints.append(f"{where}: there is no {path}")
        elif anchor and to.suffix == ".md" and anchor not in anchors(to):
            complaints.append(f"{where}: {to.name} has no anchor #{anchor}")


def check_manual():
    """Its own anchors are what F1 looks for: object names, each once."""
    names = "".join(file.read_text(encoding="utf-8") for file in files("widgets/**.cpp"))
    seen = {}
    for page in sorted((DOCS / "manual").glob("*.md")):
        for anchor in own_anchors(page):
            base = anchor[7].lower() + anchor[8:] if re.match("stepper[A-Z]", anchor) else anchor
            if f'u"{anchor}"' not in names and f'u"{base}"' not in names:
                complaints.append(f"docs/manual/{page.name}: nothing in the window is called {anchor}")
            if anchor in seen:
                complaints.append(f"docs/manual/{page.name}: {anchor} is on {seen[anchor]}, too")
            seen[anchor] = page.name


def main():
    for file in files("*.cpp", "*.h", "*.py", "*.cmake", "**CMakeLists.txt"):
        if file != Path(__file__).resolve():
            check_comments(file)
    for page in files("*.md"):
        check_links(page)
    check_manual()
    for complaint in complaints:
        print(f"scripts/check_docs.py: {complaint}", file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
