# SPDX-License-Identifier: Apache-2.0
"""The figures under docs/data as one tree: data.ladder.own.exact.cycles is docs/data/ladder/own.json, exact, cycles."""
import json

from sources import ROOT

FOLDER = ROOT / "docs/data"


class Figures(dict):
    """A dict whose keys are attributes too. A key that no attribute can name is reached by [...]."""

    def __getattr__(self, key):
        if key not in self:
            raise AttributeError(f"no figure '{key}'; there are {', '.join(map(str, self)) or 'none'}")
        return self[key]


def wrap(value):
    if isinstance(value, dict):
        return Figures({key: wrap(one) for key, one in value.items()})
    return [wrap(one) for one in value] if isinstance(value, list) else value


def load():
    tree = Figures()
    for file in sorted(FOLDER.rglob("*.json")):
        place = tree
        *folders, name = file.relative_to(FOLDER).with_suffix("").parts
        for folder in folders:
            place = place.setdefault(folder, Figures())
        place[name] = wrap(json.loads(file.read_text())["figures"])
    return tree


data = load()


def stored():
    """Each measurement's name and what its file says of it."""
    for file in sorted(FOLDER.rglob("*.json")):
        yield file.relative_to(FOLDER).with_suffix("").as_posix(), json.loads(file.read_text())


def store(name, content):
    file = FOLDER / (name + ".json")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(content, indent=1) + "\n")
