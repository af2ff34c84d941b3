# SPDX-License-Identifier: Apache-2.0
"""What several of them need."""


def pick(*keys):
    """Those keys of an object; a.b of an object in it becomes b."""

    def keep(found):
        result = {}
        for key in keys:
            value = found
            for part in key.split("."):
                value = value[part]
            result[key.split(".")[-1]] = value
        return result

    return keep


def total_bytes(row):
    return sum(stream["read"] + stream["written"] for stream in row.values())


def alpha_bytes(streams):
    """Alphas that go to memory and come back; what the stream raster writes are pixels."""
    return total_bytes({"alphas": streams["alpha_overflow_write"]}) + streams["raster"]["read"]
