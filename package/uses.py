# SPDX-License-Identifier: Apache-2.0
"""uses.py: which modules of rtl/ a machine instantiates, from the text of its package and of the modules.

A branch of `if (...) begin : gen_...` counts unless its condition is known to be false: a condition is known when it
speaks of constants of the package, and of `localparam`s that do. What depends on a parameter may be either, so both
branches count. Verilator finds the same modules in every design point (tests `package`, `front_ends`).
"""
import re

WORD = re.compile(r"pipegs_pkg::\w+|\w+'\w+|[$\w]+|&&|\|\||[=!<>]=|<<|>>|\S")
LITERAL = re.compile(r"\d*'b?d?([01]+)$")


def value_of(words, known):
    """Of an expression; None when it says more than is known."""
    python = {"!": " not ", "&&": " and ", "||": " or ", "/": "//"}
    text = ""
    for word in words:
        literal = LITERAL.match(word)
        word = str(int(literal.group(1), 2)) if literal else word.removeprefix("pipegs_pkg::")
        if re.match(r"[A-Za-z_$]", word) and known.get(word) is None:
            return None
        text += python.get(word, f" {known.get(word, word)} ")
    try:
        return eval(text, {"__builtins__": {}})  # pylint: disable=eval-used
    except SyntaxError:
        return None


def constants(package):
    """{name: value} of the scalars of a package that are known."""
    known = {}
    for name, value in re.findall(r"localparam (?:bit|int unsigned) (\w+) *= ([^;]+);", package):
        known[name] = value_of(WORD.findall(value), known)
    return known


class Text:
    """One module's words: its `localparam`s as far as they are known, and what it instantiates."""

    def __init__(self, text, known, modules):
        self.words = WORD.findall(re.sub(r"//.*|/\*.*?\*/|`.*|\"[^\"]*\"", "", text))
        self.known, self.modules, self.found = dict(known), modules, set()
        for at, word in enumerate(self.words):
            if word == "localparam" and "=" in self.words[at : at + 12]:
                equals = self.words.index("=", at)
                self.known[self.words[equals - 1]] = value_of(self.words[equals + 1 : self.close(equals)], self.known)
        self.block(0, True)

    def close(self, at):
        """Where the expression behind `at` ends: at a comma, a semicolon, a bracket that it did not open."""
        depth = 0
        while depth > 0 or self.words[at + 1] not in (",", ";", ")"):
            at += 1
            depth += {"(": 1, ")": -1}.get(self.words[at], 0)
        return at + 1

    def block(self, at, counts):
        """Reads from `at` to behind the block's `end`, and gives that place."""
        while at < len(self.words) and self.words[at] != "end":
            if self.words[at] == "if" and self.words[at + 1] == "(":
                begin = self.close(at + 1) + 1
                if self.words[begin] == "begin" and self.words[begin + 2].startswith("gen_"):
                    at = self.branches(at, counts)
                    continue
            if self.words[at] == "begin":
                at = self.block(at + 1, counts)
                continue
            if counts and self.words[at] in self.modules and re.match(r"#|[a-z]", self.words[at + 1]):
                self.found.add(self.words[at])
            at += 1
        return at + 1

    def branches(self, at, counts):
        """An `if` that generates, with all its branches; gives the place behind them."""
        while self.words[at] == "if":
            end = self.close(at + 1)
            value = value_of(self.words[at + 2 : end], self.known)
            at = self.block(end + 2, counts and (value is None or bool(value)))
            counts = counts and not value
            if self.words[at] != "else":
                return at
            at += 1
        return self.block(at + 1, counts)


def used(package, texts, top):
    """The names of the modules of a machine; `texts` is {module: its text}."""
    known, found, new = constants(package), set(), {top}
    while new:
        found |= new
        new = {name for module in new for name in Text(texts[module], known, texts).found} - found
    return found
