# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/trust/trust.md."""
from data import data

MEASURED = ["netlist/*"]
WINDOW = data.netlist.fast_3_3
