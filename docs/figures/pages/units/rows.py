# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/units/rows.md."""
from data import data

MEASURED = ["prints/*/pu_rows", "prints/*/exp2"]
(rows,) = data.prints.pu.pu_rows.lines
(exp2,) = data.prints.lib.exp2.lines
