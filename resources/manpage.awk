# SPDX-License-Identifier: GPL-3.0-or-later
# A manual page of what a program says to --help: awk -v program=NAME -v version=N -v summary=TEXT -v also=PAGES.
# Knows the shape that our programs keep: "Usage:", sentences, and titles that end in a colon above rows of two blanks,
# a term, and behind two more blanks or on deeper lines what it means.

function escaped(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    sub(/^[.']/, "\\\\\\&&", text)
    return text
}

function say(text) { print escaped(text) }

# "Violations, in stats: what ..." is the section VIOLATIONS and the sentence "In stats: what ..."
function section(title,    rest) {
    sub(/:$/, "", title)
    rest = match(title, /[,;:]/) ? substr(title, RSTART + 2) : ""
    say_section(rest == "" ? title : substr(title, 1, RSTART - 1))
    if (rest != "")
        say(toupper(substr(rest, 1, 1)) substr(rest, 2) ".")
}

function say_section(title) { print ".SH \"" escaped(toupper(title)) "\"" }

# The last gap of a row divides it: rows of three columns have the first two as their term.
function row(text,    at, term) {
    columns = 1
    at = 0
    while (match(substr(text, at + 1), /[^ ]   */)) {
        term = at + RSTART
        at += RSTART + RLENGTH - 1
        ++columns
    }
    print ".TP"
    if (columns == 1)
        term = length(text)
    print ".B " escaped(named(substr(text, 1, term)))
    if (columns > 1)
        say(substr(text, at + 1))
    rows = 1
}

function named(term) {
    gsub(/  +/, " ", term)
    gsub(/[<>]/, "", term)
    return term
}

BEGIN {
    print ".TH \"" toupper(program) "\" 1 \"\" \"NMC Panel " version "\" \"User commands\""
    say_section("Name")
    print program " \\- " escaped(summary)
}
/^Usage: / {
    say_section("Synopsis")
    sub(/^Usage: [^ ]*/, "")
    print ".B " program
    say(substr($0, 2))
    say_section("Description")
    next
}
/^$/ { rows = 0; print ".PP"; next }
/^[^ ].*:$/ { section($0); next }
/^  [^ ]/ { row(substr($0, 3)); next }
/^ / {
    sub(/^ +/, "")
    if (rows == 1 && columns == 3)  # the second row of a table of three columns
        print ".br"
    ++rows
    say($0)
    next
}
{ say($0) }
END {
    say_section("See also")
    print also
}
