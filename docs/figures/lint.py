# SPDX-License-Identifier: Apache-2.0
"""No figure outside markers: a number of four digits or more, with a unit, or with a point in a row of a table is
filled from data or is allowed; so is a broken power of two (2^-13.5) and a number with an exponent (3.5e-5).

Code, links and sizes (1024x768) are no figures. What a sentence calls the paper's is the paper's. Constants and formats
stand in allowed.txt, one `page: text` a line; `*:` allows it on every page. A line there that its page no longer needs
is complained about, too.
"""
import re
from pathlib import Path

from markers import MARKER, name_of

NUMBER = r"(?<![\w.,^-])[+-]?\d+(?: \d{3})*(?:\.\d+)?(?!\.\d)"
UNIT = (
    r"(?: ?(?:%|dB|cycles|[KMG]i?B(?:/s)?|mm2|[munp]J|[munp]?s|[kMG]Hz|fps|[mu]?W|kGates|k?NAND2|seconds|minutes|"
    r"times as|[kM])|x)(?![\w^])"
)
FIGURE = re.compile(rf"(?P<error>2\^-?\d+\.\d+|\b\d+(?:\.\d+)?e-?\d+\b)|(?P<number>{NUMBER})(?P<unit>{UNIT})?(?!x\d)")
PAPERS = re.compile(r"\b(?:paper|Table \d|Fig\. \d|GSCore|Sec\. \d)", re.IGNORECASE)
SENTENCE = re.compile(r"(?<=[.!?:;])\s+(?=[A-Z*`(])")
LINK = re.compile(r"\]\([^)]*\)|<https?:[^>]*>")
PRINTED = re.compile(r"<!-- options -->.*?<!-- end -->", re.DOTALL)
ALLOWED = Path(__file__).parent / "allowed.txt"


def allowed():
    """[(page or *, text)]"""
    lines = [line.strip() for line in ALLOWED.read_text().splitlines()]
    return [tuple(line.split(": ", 1)) for line in lines if line and not line.startswith("#")]


def is_figure(match, in_table):
    """Capacities (powers of two) and the few cycles that a stage takes are constants of the design."""
    if match["error"]:
        return True
    number, unit = match["number"].replace(" ", ""), (match["unit"] or "").strip()
    if number.isdigit() and not unit and int(number).bit_count() == 1:
        return False
    if unit == "cycles" and number.isdigit() and int(number) < 100:
        return False
    return bool(unit) or sum(c.isdigit() for c in number) >= 4 or (in_table and "." in number)


def prose(content):
    """The page without markers, code, links and what docs/commands.py writes, line by line as it was."""
    content = PRINTED.sub(lambda match: "\n" * match[0].count("\n"), content)
    return LINK.sub("]", MARKER.sub(lambda match: "\n" * match[0].count("\n"), content)).split("\n")


def complaints(page, content):
    name, written, found = name_of(page), prose(content), []
    lines = written
    for number, line in enumerate(content.split("\n"), 1):
        if re.match(r"\s*(?:[-*] |\d+\. )?<!--fig .*?-->.*<!--/-->", line):
            found.append(f"{page}:{number}: a line that begins with a marker is raw HTML: begin it with a word")
        for marker in MARKER.finditer(line):
            if "--" in (marker["what"] or "") or line.startswith("|") and "|" in (marker["what"] or ""):
                found.append(f"{page}:{number}: {marker['what']}: no -- in an expression, and no | in a table's")
    for where, text in allowed():
        if where not in ("*", name):
            continue
        if where == name and not any(text in line for line in written):
            found.append(f"docs/figures/allowed.txt: '{text}' is no longer in {page}")
        lines = [line.replace(text, " ") for line in lines]
    for number, line in enumerate(lines, 1):
        for sentence in [line] if line.startswith("|") else SENTENCE.split(line):
            for match in FIGURE.finditer(sentence):
                cell = line.startswith("|") and match.start() > line.find("|", 1)  # the first one is the row's name
                if is_figure(match, cell) and not PAPERS.search(sentence):
                    found.append(f"{page}:{number}: '{match[0]}' is no figure of a measurement: ...{sentence.strip()}")
    return found
