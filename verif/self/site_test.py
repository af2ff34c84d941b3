#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""site_test.py BUILD: the site builds strictly, its search knows its words, it loads nothing from the network, and what
a page may do wrong (a dead link, a heading that is gone, a page that no navigation names) ends the build.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
failures = []


def expect(condition, what):
    if not condition:
        failures.append(what)


def build(root, folder):
    return subprocess.run([sys.executable, "-B", root / "docs/site.py", folder], capture_output=True, text=True)


def refused(planted, texts):
    """A copy of the pages with a text behind each of these: its build must fail and name all that is wrong."""
    with tempfile.TemporaryDirectory() as folder:
        for path in [ROOT / name for name in ("README.md", "CHANGELOG.md", "mkdocs.yml")]:
            shutil.copy(path, folder)
        shutil.copytree(ROOT / "docs", Path(folder) / "docs", ignore=shutil.ignore_patterns("data", "__pycache__"))
        for path in ROOT.glob("sim/studies/*/*.md"):
            to = Path(folder) / path.relative_to(ROOT)
            to.parent.mkdir(parents=True)
            shutil.copy(path, to)
        for page, text in texts.items():
            with open(Path(folder) / page, "a") as file:
                file.write(text)
        run = build(Path(folder), Path(folder) / "build")
        for what in planted:
            expect(run.returncode == 1 and what in run.stderr, f"not refused: {what}")


if not shutil.which("mkdocs"):
    print("not run: mkdocs is not installed; `make site` installs it")
    sys.exit(77)


site = Path(sys.argv[1]) / "site"
run = build(ROOT, site)
expect(run.returncode == 0, f"the site does not build:\n{run.stderr}")
if run.returncode == 0:
    index = json.loads((site / "html/search/search_index.json").read_text())["docs"]
    found = {entry["location"].partition("#")[0] for entry in index if "transmittance" in entry["text"].lower()}
    expect("docs/glossary.html" in found, f"the search finds transmittance in {sorted(found)} only")
    for page in (site / "html").rglob("*.html"):
        loaded = re.findall(r'<(?:script|img|link rel="stylesheet")[^>]*(?:src|href)="(https?:[^"]*)', page.read_text())
        expect(not loaded, f"{page.name} loads {loaded}")
refused(
    ["link to 'docs/gone.md'", "docs/lost.md"],
    {"docs/glossary.md": "\n[a page](gone.md)\n", "docs/lost.md": "# A page\n"},
)
refused(["index.html#gone"], {"docs/glossary.md": "\n[a heading](figures/README.md#gone)\n"})

print("\n".join(failures) or "site: as it should be")
sys.exit(1 if failures else 0)
