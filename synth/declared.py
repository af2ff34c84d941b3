#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""declared.py FILE ...: names of SystemVerilog files that are used before their declaration (IEEE 1800-2017, 6.5)

Idea    Verilator, Yosys and Icarus take a name that is declared further down; conforming tools refuse the file. The
        text is cut into tokens, and declarations of signals, ports, parameters, types, members of enums, functions,
        genvars and loop variables are noted with their scope: file, module or package, function, begin to end. A name
        that some enclosing scope declares must be declared before its use, in one of these scopes.
Rule    Members of structs, names behind `package::`, ports named in a connection, and labels are no uses.
Output  One line for each name, at its first use: file, line, name and the line of the declaration. Exits 1 when there
        is any.
"""
import re
import sys

TOKEN = re.compile(
    r"//[^\n]*|/\*.*?\*/|\(\*\s.*?\*\)|\"(?:\\.|[^\"\\])*\"|`define(?:[^\n]*\\\n)*[^\n]*"
    r"|`(?:ifn?def|elsif|undef|timescale|include)[^\n]*|`\w+|\$\w+|\d*'s?[bodhBODH][0-9a-fA-FxXzZ_?]+|'[01xz]\b"
    r"|\d[\w.]*|[A-Za-z_]\w*|::|\S",
    re.DOTALL,
)
TYPES = set("logic bit byte int integer shortint longint reg wire real string genvar tri".split())
BESIDE = set("signed unsigned automatic var".split())  # words of a type
KEYWORDS = (
    TYPES
    | BESIDE
    | set(
        "module endmodule package endpackage function endfunction task endtask begin end generate endgenerate if else "
        "for case casez unique priority default endcase always always_comb always_ff always_latch assign initial final "
        "posedge negedge or typedef struct packed enum union input output inout parameter localparam assert assume "
        "cover property return bind while repeat forever foreach do import export void static const inside iff".split()
    )
)
OPEN = set("module package function task begin".split())
CLOSE = {"end", *(f"end{word}" for word in OPEN)}


def is_name(token):
    return bool(re.match(r"[A-Za-z_]\w*$", token)) and token not in KEYWORDS


class Text:
    """Tokens of a file, the scope of each, and its declarations."""

    def __init__(self, text):
        self.tokens, self.lines = [], []
        for match in TOKEN.finditer(text):
            if not match[0].startswith(("//", "/*", "(* ", '"', "`")):
                self.tokens.append(match[0])
                self.lines.append(text.count("\n", 0, match.start()) + 1)
        self.parents, self.scopes = [None], []  # of each scope the one around it; of each token its scope
        self.declared = {}  # (scope, name): first token that declares it
        self.no_use = set()  # tokens that name something else: labels, members, ports
        self._find_scopes()
        self._find_declarations()

    def at(self, i):
        return self.tokens[i] if 0 <= i < len(self.tokens) else ""

    def behind(self, i):
        """The token behind the bracket that opens at i."""
        depth = 0
        while i < len(self.tokens):
            depth += (self.tokens[i] in "([{") - (self.tokens[i] in ")]}")
            i += 1
            if depth == 0:
                return i
        return i

    def _find_scopes(self):
        scope = 0
        for i, token in enumerate(self.tokens):
            if token in CLOSE and self.parents[scope] is not None:
                scope = self.parents[scope]
            self.scopes.append(scope)
            if token in OPEN:
                self.parents.append(scope)
                scope = len(self.parents) - 1

    def _declare(self, i, scope=None):
        self.declared.setdefault((self.scopes[i] if scope is None else scope, self.tokens[i]), i)

    def _declarators(self, i):
        """Names from token i on: `a [4], b = 1;` Ends at what is no further name."""
        while is_name(self.at(i)):
            self._declare(i)
            i += 1
            while self.at(i) == "[":
                i = self.behind(i)
            while self.at(i) and self.at(i) not in ",;)]}":  # a value
                i = self.behind(i) if self.at(i) in "([{" else i + 1
            if self.at(i) != "," or self.at(i + 2) not in "[,;=)}":
                return
            i += 1

    def _behind_type(self, i):
        """The token behind the type that begins at i: its words and packed dimensions."""
        while self.at(i) in TYPES | BESIDE or self.at(i) == "[":
            i = self.behind(i) if self.at(i) == "[" else i + 1
        return i

    def _find_declarations(self):
        for i, token in enumerate(self.tokens):
            before = self.at(i - 1)
            if token in ("function", "task"):
                name = self._behind_type(i + 1)
                while self.at(name + 1) not in ("(", ";") and name < len(self.tokens):
                    name += 1  # a type with a name
                self._declare(name, self.scopes[i])
                self._declare(name)  # as a variable inside
            elif token in ("struct", "enum", "union"):
                inner = i
                while self.at(inner) != "{":
                    inner += 1
                end = self.behind(inner)
                if token == "enum":
                    self._declarators(inner + 1)
                else:
                    self.no_use.update(j for j in range(inner, end) if self.at(j + 1) in (";", ","))
                self._declarators(end)
            elif token in TYPES and before not in TYPES:
                self._declarators(self._behind_type(i))
            elif token in ("parameter", "localparam", "input", "output", "inout"):
                self._declarators(self._behind_type(i + 1))
            elif is_name(token) and is_name(self.at(i + 1)) and before != "." and self.at(i + 2) in "[,;=)":
                self._declarators(i + 1)  # a type with a name
            elif (
                is_name(token)
                and self.at(i + 1) == "["
                and before in (";", "begin", "end", "endfunction", ")", "input")
            ):
                name = self._behind_type(i + 1)  # the same with dimensions
                if is_name(self.at(name)):
                    self._declarators(name)

    def _is_use(self, i):
        before = self.at(i - 1)
        if i in self.no_use or self.at(i + 1) == "::" or before == "::":
            return False
        if before == ".":  # a member, a port; `.name` alone connects the signal of that name
            return self.at(i - 2) in ("(", ",") and self.at(i + 1) in (",", ")")
        return not (before == ":" and self.at(i - 2) in ("begin", *CLOSE))  # a label

    def early(self):
        """[(line, name, line of the declaration)] of each name used too early, at its first use."""
        found = {}
        for i, token in enumerate(self.tokens):
            if not is_name(token) or not self._is_use(i):
                continue
            scope, places = self.scopes[i], []
            while scope is not None:
                if (scope, token) in self.declared:
                    places.append(self.declared[scope, token])
                scope = self.parents[scope]
            if places and i < min(places):
                found.setdefault(min(places), (self.lines[i], token, self.lines[min(places)]))
        return sorted(found.values())


def main():
    found = 0
    for path in sys.argv[1:]:
        with open(path, encoding="utf-8") as file:
            for line, name, place in Text(file.read()).early():
                print(f"{path}:{line}: {name} is used before its declaration in line {place}")
                found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
