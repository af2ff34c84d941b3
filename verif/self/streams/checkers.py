#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""checkers.py [ROOT]: every stream of ROOT/rtl has a pipegs_stream_check (docs/architecture.md).

Giver   a module with the ports X_valid_o and X_ready_i. It has a pipegs_stream_check of X_valid_o, unless it only
        hands on what an instance in it gives.
Taker   an instance with the ports X_valid_i and X_ready_o. What is connected to X_valid_i comes from a giver beside it
        or from the ports of the module in which it stands; else that is logic, and a pipegs_stream_check looks at just
        that, or no_streams.txt names the port.
Prints what lacks one and what the list names in vain; exits 1 when there is anything, or hardly any stream is found.
"""
import re
import sys
from pathlib import Path


def closing(text, at):
    """The place behind the bracket that closes the one before `at`."""
    depth = 1
    while depth:
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        at += 1
    return at


class Module:
    def __init__(self, path):
        self.text = re.sub(r"//[^\n]*", "", path.read_text())
        self.name = path.stem
        self.ports = set(re.findall(r"\b(?:input|output)\b[^,;()]*?(\w+)\s*(?=[,)\n])", self.text))
        self.instances = []

    def pairs(self, valid, ready):
        """The X of all X_valid, X_ready; "" where the ports are called valid and ready."""
        found = [p[: -len(valid)] for p in self.ports if re.search(rf"(^|_){valid}$", p)]
        return sorted(x for x in found if x + ready in self.ports)

    def clocked(self):
        """One without a clock is logic of the module around it, which watches what it makes."""
        return re.search(r"\bclk_i\b", self.text)

    def find_instances(self, modules):
        start = r"\b(\w+)\s*(?:#\s*\((?:[^()]|\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\))*\))?\s+u_\w+\s*\("
        for match in re.finditer(start, self.text):
            if match[1] not in modules:
                continue
            body = self.text[match.end() : closing(self.text, match.end()) - 1]
            connected = {}
            for port in re.finditer(r"\.(\w+)\s*(\()?", body):
                inside = body[port.end() : closing(body, port.end()) - 1] if port[2] else port[1]
                connected.setdefault(port[1], " ".join(inside.split()))
            self.instances.append((modules[match[1]], connected))


def unsliced(wire):
    return re.sub(r"\[[^\]]*\]$", "", wire)


def check(module, listed, used):
    """Yields what lacks a pipegs_stream_check."""
    watched = {c.get("valid_i") for kind, c in module.instances if kind.name == "pipegs_stream_check"}
    given = set()
    for kind, connected in filter(lambda instance: instance[0].clocked(), module.instances):
        given |= {unsliced(connected.get(x + "valid_o", "")) for x in kind.pairs("valid_o", "ready_i")}
    for x in module.pairs("valid_o", "ready_i") if module.clocked() else ():
        if x + "valid_o" not in given | watched:
            yield f"{module.name}: {x}valid_o has no pipegs_stream_check"
    passed = {x + "valid_i" for x in module.pairs("valid_i", "ready_o")}
    for kind, connected in module.instances:
        if kind.name == "pipegs_stream_check":
            continue
        for x in kind.pairs("valid_i", "ready_o"):
            wire = connected.get(x + "valid_i", "")
            if unsliced(wire) in given | passed or wire in watched:
                continue
            names = [(place, kind.name, x.rstrip("_")) for place in (module.name, "*")]
            hits = [name for name in names if name in listed]
            used.update(hits)
            if not hits:
                yield f"{module.name}: {x}valid_i of {kind.name} is fed by {wire}, which has no pipegs_stream_check"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[3])
    lines = Path(__file__).with_name("no_streams.txt").read_text().splitlines()
    listed = {tuple(line.split()) for line in lines if line and not line.startswith("#")}
    paths = [path for path in root.glob("rtl/**/*.sv") if path.stem != "pipegs_pkg"]
    modules = {module.name: module for module in map(Module, paths)}
    for module in modules.values():
        module.find_instances(modules)
    used = set()
    wrong = [line for name in sorted(modules) for line in check(modules[name], listed, used)]
    wrong += [f"no_streams.txt: {' '.join(line)} names nothing" for line in sorted(listed - used)]
    checks = sum(kind.name == "pipegs_stream_check" for module in modules.values() for kind, _ in module.instances)
    print(*wrong, f"{len(modules)} modules, {checks} checkers", sep="\n")
    return 1 if wrong or checks < 80 else 0


sys.exit(main())
