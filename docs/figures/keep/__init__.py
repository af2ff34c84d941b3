# SPDX-License-Identifier: Apache-2.0
"""What is kept of a command's JSON, or of its text where it prints none: one function for each kind of measurement."""
