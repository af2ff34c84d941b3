# SPDX-License-Identifier: Apache-2.0
"""What commands print, in docs/commands.md."""
from data import data
from formats import block

MEASURED = ["shown/profile"]


def profile():
    return block(data.shown.profile.lines)
