# SPDX-License-Identifier: Apache-2.0
"""report.py: synth.json and the tables of a synthesised machine.

Rule    area and flip-flops of a module are its own, without submodules; of a unit, of one instance with all below it. A
        module that stands in several units has a row in each. A path counts for the module in which most of its time
        passes (path_in). Memories have no area here.
        kGE: thousands of NAND2 of the library. FO4: delays of an inverter that drives four.
        Power of one unit, in the library's own technology and voltage, without wires: leakage_w; clock_j, energy of a
        clocked cycle in which no data changes and no enable is high; gated_j, what it takes more when all enables are;
        switch_j, energy that a cycle takes more when each net toggles once on average.
        enables.json has the gates behind enables, module by module: program.json of gating.py, and for each gate
        [enable, bit, flip-flops, J of a clocked cycle]; always: flip-flops of a module without one, and their J;
        gate_j: J of a gate itself in a cycle.
"""
import collections
import hashlib
import json
import os
import re
import time

import rtlil
import timing

UNITS = {
    "pipegs_dopu": "dopu",
    "pipegs_pu": "pu",
    "pipegs_su": "su",
    "pipegs_ru": "ru",
    "pipegs_lists": "list",
    "pipegs_alpha_store": "buf",
}
now = time.time


def walk(module, unit="top", path=""):
    """(module, unit, hierarchical name) of every instance below, itself first."""
    yield module, unit, path
    for name, child in module.children + module.gates:
        below = UNITS.get(child.base, unit) if unit == "top" else unit
        yield from walk(child, below, f"{path}.{name}" if path else name)


def path_entry(path, module, prefix="path"):
    if path is None:
        return {f"{prefix}_ps": 0, f"{prefix}_from": "", f"{prefix}_to": "", f"{prefix}_in": ""}
    spent = collections.Counter()
    for pin, ns in path.delays:
        place, rest = module, pin
        while True:
            child = next(((name, child) for name, child in place.children if rest.startswith(name + "/")), None)
            if child is None:
                break
            place, rest = child[1], rest[len(child[0]) + 1 :]
        spent[place.name] += ns
    inside = spent.most_common(1)[0][0] if spent else module.name
    return {
        f"{prefix}_ps": round(path.ns * 1000),
        f"{prefix}_from": path.start,
        f"{prefix}_to": path.end,
        f"{prefix}_in": inside,
    }


def power_entry(machine, names, power):
    """names: the modules of all instances in the unit."""
    leakage, (low, mid, high) = power
    clocked = [(label, *item) for name in names for label, item in machine.clocked[name].items()]
    gates = sum(1 for label, _, _ in clocked if label)
    slope = (high - low) / (timing.ACTIVITIES[2] - timing.ACTIVITIES[0])
    bend = abs(2 * mid - low - high) / max(high - low, 1e-30)  # 0 when energy is linear in activity
    return {
        "leakage_w": leakage,
        "clock_j": sum(joules for label, _, joules in clocked if not label) + gates * machine.gate_energy,
        "gated_j": sum(joules for label, _, joules in clocked if label),
        "gated_flipflops": sum(count for label, count, _ in clocked if label),
        "clock_gates": gates,
        "switch_j": slope,
        "bend": round(bend, 4),
    }


def unit_entry(machine, module):
    """Area, paths and power of a unit with all that is in it."""
    below = [one.name for one, _, _ in walk(module) if one.base != rtlil.MEMORY]
    area = sum(machine.areas[name] for name in below)
    paths = machine.paths[module.name]
    return {
        "area_um2": round(area, 1),
        "nand2": round(area / machine.library.nand.area),
        "flipflops": sum(machine.flipflops[name] for name in below),
        **path_entry(paths["registers"], module),
        **path_entry(paths["ports"], module, "port_path"),
        **power_entry(machine, below, paths["power"]),
    }


def mean_entry(entries, counts):
    """Of units that differ in a parameter (PUs with and without a front): the mean, and the longest path of all."""
    result = dict(max(entries, key=lambda entry: entry["path_ps"]))
    longest = max(entries, key=lambda entry: entry["port_path_ps"])
    result |= {key: value for key, value in longest.items() if key.startswith("port_path")}
    for key, value in result.items():
        if len(entries) > 1 and not isinstance(value, str) and not key.endswith("path_ps"):
            mean = sum(entry[key] * count for entry, count in zip(entries, counts)) / sum(counts)
            result[key] = round(mean) if isinstance(value, int) else mean
    return result


def summary(machine, modules, configuration, library, seconds):
    nand2 = machine.library.nand.area
    instances = list(walk(modules["pipegs_top"]))
    counts = collections.Counter((module.name, unit) for module, unit, _ in instances if module.base != rtlil.MEMORY)
    rows = []
    for (name, unit), count in sorted(counts.items(), key=lambda item: (item[0][1], item[0][0])):
        module, paths = modules[name], machine.paths.get(name, {"registers": None, "ports": None})
        longest = max(
            (path for path in (paths["registers"], paths["ports"]) if path), key=lambda path: path.ns, default=None
        )
        rows.append(
            {
                "module": module.base,
                "unit": unit,
                "parameters": module.parameters,
                "instances": count,
                "area_um2": round(machine.areas[name], 1),
                "nand2": round(machine.areas[name] / nand2),
                "flipflops": machine.flipflops[name],
                **path_entry(longest, module),
            }
        )
    units = []
    for base, unit in [*UNITS.items(), ("pipegs_top", "top")]:
        found = [module for module in modules.values() if module.base == base]
        numbers = [counts[module.name, unit] for module in found]
        if found:
            entries = [unit_entry(machine, module) for module in found]
            units.append({"unit": unit, "instances": sum(numbers), **mean_entry(entries, numbers)})
    memories = collections.Counter(
        (
            re.sub(r"\[\d+\]", "[k]", path),
            unit,
            module.parameters["Depth"],
            module.parameters["DataW"],
            module.parameters["Ports"],
        )
        for module, unit, path in instances
        if module.base == rtlil.MEMORY
    )
    return {
        "configuration": configuration,
        "library": library,
        "nand2_um2": nand2,
        "nand2_ff": round(machine.library.nand_load * machine.library.femto, 3),
        "volts": machine.library.volts,
        "fo4_ps": round(machine.fo4 * 1000, 1),
        "sram_access_ps": round(machine.access * 1000),
        "modules": rows,
        "units": units,
        "memories": [
            {
                "instance": path,
                "unit": unit,
                "words": words,
                "width": width,
                "ports": "1RW" if ports == 1 else "1R1W",
                "instances": count,
            }
            for (path, unit, words, width, ports), count in sorted(
                memories.items(), key=lambda item: item[0][1:2] + item[0][:1]
            )
        ],
        "longest": longest_paths(machine.paths["pipegs_top"]["many"], machine.fo4)[:100],
        "seconds": round(seconds),
    }


def enables(machine, modules, configuration, library):
    """What sim/silicon/energy/enables.hpp reads."""
    entries = {}
    for module, _, _ in walk(modules["pipegs_top"]):
        if module.base in (rtlil.MEMORY, rtlil.GATE) or module.name in entries:
            continue
        program, clocked = machine.programs[module.name], machine.clocked[module.name]
        gates = [[*nodes, *clocked.get(f"gate_{number}", (0, 0.0))] for number, nodes in enumerate(program["gates"])]
        gates_here = sum(kind == rtlil.GATE for kind, _, _ in machine.mapped[module.name].cells)
        entries[module.name] = program | {"gates": gates, "clock_gates": gates_here, "always": clocked[""]}
    programs = json.dumps(machine.programs, sort_keys=True)
    return {
        "configuration": configuration,
        "library": library,
        "program": hashlib.sha256(programs.encode()).hexdigest()[:16],
        "gate_j": machine.gate_energy,
        "instances": {path: module.name for module, _, path in walk(modules["pipegs_top"]) if module.name in entries},
        "modules": entries,
    }


def longest_paths(many, fo4):
    """The longest paths between registers of the machine, one for each signal at which they end, equal units once."""
    found = {}
    for start, end, ns in sorted(many, key=lambda path: -path[2]):
        entry = {"path_ps": round(ns * 1000), "fo4": round(ns / fo4, 1), "path_from": start, "path_to": end}
        found.setdefault(re.sub(r"\[\d+\]", "", end), entry)
    return list(found.values())


def tables(result):
    fo4 = result["fo4_ps"]
    lines = [
        f"{result['configuration']} in {result['library']}: NAND2 {result['nand2_um2']} um2, FO4 {fo4} ps, "
        f"memories {result['sram_access_ps']} ps",
        "",
        f"{'unit':6} {'count':>5} {'kGE of one':>10} {'kGE of all':>10} {'flip-flops':>10} "
        f"{'path ps':>8} {'FO4':>5}  from -> to (most of it in)",
    ]
    for row in result["units"]:
        lines.append(
            f"{row['unit']:6} {row['instances']:5} {row['nand2'] / 1000:10.1f} "
            f"{row['nand2'] * row['instances'] / 1000:10.1f} {row['flipflops']:10} "
            f"{row['path_ps']:8} {row['path_ps'] / fo4:5.1f}  {row['path_from']} -> {row['path_to']} ({row['path_in']})"
        )
        lines.append(
            f"{'':6} {'':5} {'':10} {'':10} {'at its ports':>10} {row['port_path_ps']:6} "
            f"{row['port_path_ps'] / fo4:5.1f}  {row['port_path_from']} -> {row['port_path_to']} "
            f"({row['port_path_in']})"
        )
    lines += [
        "",
        f"{'unit':6} {'leakage uW':>10} {'clock pJ':>9} {'gated pJ':>9} {'gates':>6} {'gated flops':>11} "
        f"{'switch pJ':>10}  of one, {result['volts']} V, no wires; energy of a clocked cycle, more with all enables, "
        "and more for each toggle of a net",
    ]
    lines += [
        f"{row['unit']:6} {row['leakage_w'] * 1e6:10.3f} {row['clock_j'] * 1e12:9.1f} {row['gated_j'] * 1e12:9.1f} "
        f"{row['clock_gates']:6} {row['gated_flipflops']:11} {row['switch_j'] * 1e12:10.1f}"
        for row in result["units"]
    ]
    lines += ["", "longest paths between registers, one for each signal at which they end"]
    lines += [
        f"{row['path_ps']:6} ps {row['fo4']:5} FO4  {row['path_from']} -> {row['path_to']}"
        for row in result["longest"][:10]
    ]
    lines += [
        "",
        f"{'unit':5} {'module':44} {'count':>5} {'kGE':>7} {'all kGE':>8} {'flops':>6} {'path ps':>8} "
        f"{'FO4':>5}  from -> to (most of it in)",
    ]
    for row in sorted(result["modules"], key=lambda row: -row["nand2"] * row["instances"]):
        name = row["module"] + "".join(f" {key}={value}" for key, value in row["parameters"].items())
        lines.append(
            f"{row['unit']:5} {name:44} {row['instances']:5} {row['nand2'] / 1000:7.2f} "
            f"{row['nand2'] * row['instances'] / 1000:8.1f} {row['flipflops']:6} "
            f"{row['path_ps']:8} {row['path_ps'] / fo4:5.1f}  {row['path_from']} -> {row['path_to']} ({row['path_in']})"
        )
    return "\n".join(lines + ["", f"{result['seconds']} s", ""])


def write(machine, modules, configuration, library, folder, begin):
    result = summary(machine, modules, configuration, library, now() - begin)
    os.makedirs(folder, exist_ok=True)
    text = tables(result)
    gated = json.dumps(enables(machine, modules, configuration, library), separators=(",", ":")) + "\n"
    for name, body in (
        ("synth.json", json.dumps(result, indent=1) + "\n"),
        ("enables.json", gated),
        ("synth.txt", text),
    ):
        with open(f"{folder}/{name}.new", "w", encoding="utf-8") as file:
            file.write(body)
        os.replace(f"{folder}/{name}.new", f"{folder}/{name}")
    print(text + f"{folder}/synth.json")
