# SPDX-License-Identifier: Apache-2.0
"""timing.py: the longest paths of an assembled module, and the power of a unit, by OpenSTA.

Idea    One session links the module with all below it. Memories and clock gates are cells of liberty.models, so a path
        ends at their inputs and begins at a memory's output; none passes through the latch of a clock gate.
        Paths between registers, from inputs and to outputs are groups of their own; ports have a delay of zero.
        Power is asked for at several activities, the same at all nets: toggles of a net in a cycle. Without activity
        what is left beside leakage is what flip-flops take for their clock.
Rule    A path is as long as the shortest clock that it allows: arrival plus setup. Clock and reset are ideal.
"""
import re

PERIOD = 1000  # ns; anything longer than a path
ACTIVITIES = (0, 0.1, 0.2)
CLOCK = f"""read_liberty {{library}}/power.lib
read_verilog {{folder}}/clock.v
link_design {{module}}
set_cmd_units -time ns
create_clock -name clk -period {PERIOD} [get_ports clk_i]
set_power_activity -global -activity 0 -duty 0.5
report_power -digits 8
exit
"""


def fo4(jobs, library, folder):
    """Delay of an inverter that drives four, ns: mean of a rising and a falling one."""
    (source,), (sink,) = library.inverter.inputs, library.inverter.outputs
    inverter = library.inverter.name
    stages = [f"{inverter} s{i} (.{source}({'a' if i == 0 else f'n{i}'}), .{sink}(n{i + 1}));" for i in range(8)]
    loads = [f"{inverter} l{i}_{k} (.{source}(n{i}), .{sink}());" for i in range(1, 9) for k in range(3)]
    wires = " ".join(f"wire n{i};" for i in range(1, 9))
    with open(f"{folder}/chain.v", "w", encoding="utf-8") as file:
        file.write(
            "\n".join(
                [f"module chain (a, z); input a; output z; {wires} assign z = n8;"] + stages + loads + ["endmodule", ""]
            )
        )
    with open(f"{folder}/chain.tcl", "w", encoding="utf-8") as file:
        file.write(
            f"read_liberty {folder}/cells.lib\nread_verilog {folder}/chain.v\nlink_design chain\n"
            f"create_clock -name clk -period {PERIOD}\nset_input_delay 0 -clock clk a\n"
            "set_output_delay 0 -clock clk z\n"
            "set_cmd_units -time ns\nreport_checks -path_delay max -digits 5\nexit\n"
        )
    jobs.run(["sta", "-no_splash", "-exit", f"{folder}/chain.tcl"], f"{folder}/log")
    with open(f"{folder}/log", encoding="utf-8") as file:
        delays = [float(delay) for delay in re.findall(r"^\s*([\d.]+)\s+[\d.]+ [\^v] s\d/", file.read(), re.MULTILINE)]
    return (delays[4] + delays[5]) / 2


def clock_energy(jobs, library, library_folder, folder, verilog, module, gates):
    """J of a cycle that a module takes for its clock clk_i while no data changes, the pins on that net included.

    OpenSTA leaves out what drives a clock net; gates: the module's Netlist."""
    with open(f"{folder}/clock.v", "w", encoding="utf-8") as file:
        file.write(verilog)
    with open(f"{folder}/clock.tcl", "w", encoding="utf-8") as file:
        file.write(CLOCK.format(library=library_folder, folder=folder, module=module))
    jobs.run(["sta", "-no_splash", "-exit", f"{folder}/clock.tcl"], f"{folder}/log")
    with open(f"{folder}/log", encoding="utf-8") as file:
        internal, switching = [float(watts) for watts in re.search(r"^Total +(\S+) +(\S+)", file.read(), re.M).groups()]
    pins = gates.load_of("clk_i", library) * library.femto * 1e-15 * library.volts**2
    return (internal + switching) * PERIOD * 1e-9 + pins


def script(library, library_folder, folder, module, has_clock, many, power):
    """Tcl; many: how many ends of paths are listed; power: whether it is asked for."""
    asked = "".join(
        f"set_power_activity -global -activity {activity} -duty 0.5\nreport_power -digits 8\n"
        for activity in ACTIVITIES
    )
    clock = "[get_ports clk_i]" if has_clock else ""
    return f"""read_liberty {library_folder}/{'power' if power else 'cells'}.lib
read_liberty {folder}/models.lib
read_verilog {folder}/netlist.v
link_design {module}
set_cmd_units -time ns -capacitance pF
create_clock -name clk -period {PERIOD} {clock}
set inputs {{}}
foreach port [all_inputs] {{
  switch [get_full_name $port] {{
    clk_i {{}}
    rst_ni {{set_false_path -from $port}}
    default {{lappend inputs $port}}
  }}
}}
set_input_delay 0 -clock clk $inputs
set_output_delay 0 -clock clk [all_outputs]
set_load {library.load * library.femto / 1000:.6f} [all_outputs]
group_path -name in -from $inputs
group_path -name out -to [all_outputs]
puts @full
report_checks -path_delay max -digits 4
puts @many
{f"report_checks -path_delay max -format summary -group_count {many} -digits 4" if many else ""}
puts @power
{asked if power else ""}
puts @end
exit
"""


class Path:
    """ns, from, to as hierarchical names, and delays [(pin, ns)]."""

    def __init__(self, text):
        self.ns = PERIOD - float(re.search(r"([-\d.]+)\s+slack", text)[1])
        steps = re.findall(
            r"^\s*([-\d.]+)\s+([-\d.]+) [\^v] (\S+) \((.*)\)$", text.split("data arrival time")[0], re.MULTILINE
        )
        self.delays = [(pin, float(delay)) for delay, _, pin, _ in steps]
        first = next((i for i, (pin, _) in enumerate(self.delays) if not pin.endswith(("/CLK", "/clk_i"))), 0)
        self.start, self.end = _name(self.delays[first][0]), _name(self.delays[-1][0])


def _name(pin):
    """A flip-flop by its name, a port or a pin of a memory as it is."""
    parts = pin.split("/")
    return "/".join(parts[:-1]) if len(parts) > 1 and parts[-1].isupper() else pin


def read(path):
    """{"registers": Path or None, "ports": Path or None, "many": [(from, to, ns)],
    "power": (leakage W, dynamic J of a cycle at each activity)}"""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    full, rest = text.split("@full\n")[1].split("@end")[0].split("@many\n")
    many, power = rest.split("@power\n")
    paths = {"clk": None, "in": None, "out": None}
    for body in full.split("Startpoint:")[1:]:
        paths[re.search(r"Path Group: (\w+)", body)[1]] = Path(body)
    rows = [
        line.split() for line in many.splitlines() if re.search(r"\) +[\d.]+$", line)
    ]  # from (cell) to (cell) slack
    many = [
        (_name(row[0]), _name(row[2]), PERIOD - float(row[4]))
        for row in rows
        if row[1] != "(input)" and row[3] != "(output)"
    ]
    ports = [path for path in (paths["in"], paths["out"]) if path]
    totals = [[float(watts) for watts in line.split()[1:4]] for line in power.splitlines() if line.startswith("Total")]
    power = (
        (totals[0][2], [(internal + switching) * PERIOD * 1e-9 for internal, switching, _ in totals])
        if totals
        else None
    )
    return {
        "registers": paths["clk"],
        "ports": max(ports, key=lambda path: path.ns, default=None),
        "many": many,
        "power": power,
    }
