# SPDX-License-Identifier: Apache-2.0
"""A JSON value whose keys are attributes too, and that remembers what was read of it.

Read is a value that is got by its key, its place, or in a loop. Whoever asks for the keys of a dict or for its length
has read that they are there, so they stay; a list that is touched keeps its length. `pruned` gives all that was read.
"""
from collections.abc import Mapping, Sequence

entries_read = set()  # names of entries that were read since somebody cleared it


def blank(value):
    """What stays of a value of which only that it is there was read."""
    return type(value)() if isinstance(value, (dict, list)) else value


class Node:
    """What dicts and lists have in common: `raw` of the entry `entry`, and what was read of it."""

    def __init__(self, raw, entry=None):
        self.raw, self.entry, self.children, self.read, self.counted = raw, entry, {}, set(), False

    def child(self, key):
        if self.entry:
            entries_read.add(self.entry)
        if key not in self.children:
            value = self.raw[key]
            if not isinstance(value, (dict, list, Node)):
                self.read.add(key)
                return value
            self.children[key] = value if isinstance(value, Node) else wrap(value, self.entry)
        return self.children[key]

    def kept(self, key):
        return self.children[key].pruned() if key in self.children else blank(self.raw[key])

    def __len__(self):
        self.counted = True
        return len(self.raw)


class Figures(Node, Mapping):
    """A dict. A key that no attribute can name is reached by [...]."""

    def __getattr__(self, key):
        if key.startswith("__"):
            raise AttributeError(key)
        if key not in self.raw:
            raise AttributeError(f"no figure '{key}'; there are {', '.join(map(str, self.raw)) or 'none'}")
        return self.child(key)

    def __getitem__(self, key):
        return self.child(key)

    def __contains__(self, key):
        if key in self.raw:
            self.read.add(key)
        return key in self.raw

    def __iter__(self):
        self.counted = True
        return iter(self.raw)

    def __or__(self, other):
        return Figures({**self, **other}, self.entry)

    def pruned(self):
        return {key: self.kept(key) for key in self.raw if self.counted or key in self.read or key in self.children}


class List(Node, Sequence):
    def __getitem__(self, place):
        if isinstance(place, slice):
            return [self.child(one) for one in range(*place.indices(len(self.raw)))]
        return self.child(range(len(self.raw))[place])

    def __eq__(self, other):
        return list(self) == list(other)

    def __add__(self, other):
        return list(self) + list(other)

    def pruned(self):
        return [self.kept(place) for place in range(len(self.raw))]


def wrap(value, entry=None):
    return Figures(value, entry) if isinstance(value, dict) else List(value, entry)
