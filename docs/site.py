#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""site.py FOLDER: the pages of the repository as a site with search, FOLDER/html; reading it needs no network.

README.md, docs and the pages of studies are copied to FOLDER/pages as they lie in the tree, so links between them hold;
a link to a source file becomes its path. MkDocs builds them by mkdocs.yml, which calls on_config here. Exits 1 on
MkDocs' first warning, a page that the navigation lacks, or a link in the HTML that leads nowhere.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote

ROOT = Path(__file__).resolve().parent.parent
PAGES = ["README.md", "CHANGELOG.md", "docs/**/*.md", "sim/studies/*/*.md"]
PICTURES = ["docs/images/**/*.*", "docs/site.css"]
LINK = re.compile(r"^(?: {4}|```).*$|!?\[(?P<text>[^][]*)\]\((?P<file>[^)#\s]+)(?:#[^)\s]*)?\)|`[^`\n]+`", re.MULTILINE)


def on_config(config):
    """Headings get the anchors of GitHub, which the links of the pages name; the pages of studies get their places."""
    slug = lambda text, _: re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")
    config["mdx_configs"]["toc"] = {"permalink": True, "slugify": slug}
    config["nav"][-1]["Evidence"] += [{"Studies": own}] if (own := studies(config["docs_dir"])) else []
    return config


def studies(folder):
    return [str(page.relative_to(folder)) for page in sorted(Path(folder).glob("sim/studies/*/*.md"))]


def page_text(path, copied):
    """The page without the markers of figures, and with links to what is copied only."""

    def link(match):
        target = (path.parent / (match["file"] or "")).resolve()
        if not match["file"] or target in copied or target.suffix == ".md" or re.match("[a-z]+:", match["file"]):
            return match[0]  # code, among others
        name = str(target.relative_to(ROOT))
        return f"`{name}`" if match["text"].strip("`") in name else f"{match['text']} (`{name}`)"

    return LINK.sub(link, re.sub(r"<!--(?:fig .*?|/)-->", "", path.read_text(), flags=re.DOTALL))


def gather(folder):
    shutil.rmtree(folder, ignore_errors=True)
    pages, pictures = ([file for one in what for file in sorted(ROOT.glob(one))] for what in (PAGES, PICTURES))
    for path in pages + pictures:
        to = folder / path.relative_to(ROOT)
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, to)
        if path in pages:
            to.write_text(page_text(path, {*pages, *pictures}))


def dead_links(html):
    texts = {path: path.read_text() for path in html.rglob("*.html") if path.name != "404.html"}
    anchors = {path: set(re.findall(r'\bid="([^"]+)"', text)) for path, text in texts.items()}
    for path, text in texts.items():
        for target in re.findall(r'\b(?:href|src)="((?![a-z]+:)[^"]*)"', text):
            file, _, anchor = unquote(target).partition("#")
            file = (path.parent / file).resolve() if file else path
            if not file.exists() or anchor and anchor not in anchors[file]:
                yield f"{path.relative_to(html)}: dead link: {target}"


def main(folder):
    gather(folder / "pages")
    places = {"PIPEGS_PAGES": str(folder / "pages"), "PIPEGS_HTML": str(folder / "html")}
    command = ["mkdocs", "build", "--strict", "--config-file", ROOT / "mkdocs.yml"]
    built = subprocess.run(command, env=os.environ | places, capture_output=True, text=True)
    failed = built.returncode or 'not included in the "nav"' in built.stderr
    finds = [built.stderr] if failed else list(dead_links(folder / "html"))
    print("\n".join(finds or [f"{folder}/html/index.html"]), file=sys.stderr if finds else sys.stdout)
    return 1 if finds else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
