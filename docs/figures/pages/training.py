# SPDX-License-Identifier: Apache-2.0
"""Tables of docs/training.md: those of its parts."""
from pages import layers

MEASURED = [*layers.MEASURED]
