# SPDX-License-Identifier: Apache-2.0
"""Of other machines: `pipegs rivals`, `terms`."""
from keep.parts import pick


def terms(found):
    """Lead, our terms and the paper's, and what the search found; no list of its matches."""
    search = {key: value for key, value in found["search"].items() if key != "best"}
    return pick("lead", "ours", "paper")(found) | {"search": search}


def terms_and_closed(found):
    """With the closed form, the waterfall and the assumptions, which the pages show of one scene."""
    return pick("closed", "waterfall", "assumptions")(found) | terms(found)


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
