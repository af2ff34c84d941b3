#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""mutants_test.py: each module of rtl/ has a mutant that a test or a proof must notice, or wiring.txt says why it has
none: what no fault reaches may not be tested at all.

Rule    A mutant stands in verif/mutation/table.sh under its module's name, in synth/prove/table.sh behind a proof, of
        which it changes the first module.
"""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def mutated(tests, proofs):
    """The modules that have a mutant, by the texts of both tables."""
    found, top = set(re.findall(r"^mutant +(\w+) ", tests, re.MULTILINE)), None
    for word, module in re.findall(r'^(proof|mutant) +(?:\w+ +"(\w+))?', proofs.replace("\\\n", " "), re.MULTILINE):
        top = module if word == "proof" else top
        found |= {top} if word == "mutant" else set()
    return found


def complaints(modules, having, wiring):
    """What is wrong; `wiring` are lines "module  why"."""
    listed = dict((line.split(None, 1) + [""])[:2] for line in wiring if line and not line.startswith("#"))
    return [
        *[f"{name}: no mutant, and wiring.txt does not say why" for name in sorted(modules - having - set(listed))],
        *[f"wiring.txt: {name}: no module" for name in sorted(set(listed) - modules)],
        *[f"wiring.txt: {name}: has a mutant" for name in sorted(having & set(listed))],
        *[f"wiring.txt: {name}: no reason" for name, why in listed.items() if not why],
    ]


class Mutants(unittest.TestCase):
    def test_each_module_has_one(self):
        tests, proofs = (ROOT / "verif/mutation/table.sh").read_text(), (ROOT / "synth/prove/table.sh").read_text()
        modules = {file.stem for file in (ROOT / "rtl").rglob("*.sv")}
        wiring = (ROOT / "verif/mutation/wiring.txt").read_text().splitlines()
        self.assertGreater(len(modules), 100)
        self.assertEqual(complaints(modules, mutated(tests, proofs), wiring), [])

    def test_what_is_read_of_the_tables(self):
        proofs = 'proof  one "a+ b" "@default"\nproof two \\\n  "c+" ""\nmutant "w" \'s/x/y/\'\nproof  three "d+" ""\n'
        self.assertEqual(mutated('mutant e "w" \'s/x/y/\'\n# mutant f "w"\n', proofs), {"c", "e"})

    def test_finds(self):
        self.assertEqual(len(complaints({"a"}, set(), [])), 1)
        self.assertEqual(len(complaints({"a"}, {"a"}, ["a  wires"])), 1)
        self.assertEqual(len(complaints({"a"}, {"a"}, ["b  wires"])), 1)
        self.assertEqual(len(complaints({"a"}, set(), ["a"])), 1)
        self.assertEqual(complaints({"a", "b"}, {"a"}, ["# of wires", "b  wires"]), [])


if __name__ == "__main__":
    unittest.main()
