# SPDX-License-Identifier: Apache-2.0
"""Of other machines: `pipegs rivals`."""


def rivals(found, parameters=False):
    """Machines, what is over what, and checks; timelines stay out, and but for one scene the parameters."""
    out = ("spans", "memory_cycles", "chip_joules", "dram_joules") + (() if parameters else ("parameters",))

    def lean(one):
        return {key: value for key, value in one.items() if key not in out}

    kept = {key: found[key] for key in ("width", "height", "memory", "printed", "ours", "against", "checks", "lego")}
    kept["rivals"] = {key: lean(one) for key, one in found["rivals"].items()}
    kept["variants"] = [lean(one) for one in found["variants"]]
    return kept


def rivals_and_parameters(found):
    return rivals(found, parameters=True)
