# SPDX-License-Identifier: Apache-2.0
"""Figures of docs/pages.md."""
from data import data

MEASURED = ["viewer/*"]
OWN = data.viewer.own
