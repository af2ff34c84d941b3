# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/trust/trust.md: those of its parts."""
from pages.trust import netlist

MEASURED = [*netlist.MEASURED]
