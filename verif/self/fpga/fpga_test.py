#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""fpga_test.py BUILD: synth/fpga/fpga.py on small modules: memories become RAM blocks or cells, nothing a latch."""
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../synth/fpga"))
import fpga  # noqa: E402
import synth  # noqa: E402
from jobs import Failed, Jobs  # noqa: E402

BUILD = os.path.abspath(sys.argv.pop(1))
PACKAGE_SV = f"{BUILD}/cpp_model/package_sv"


def mapped(jobs, module, family, settings=("clock_gates=0",)):
    """{kind of resource: how many} of a module with all below it."""
    modules = synth.elaborate(jobs, synth.package_of(PACKAGE_SV, settings), module)
    return fpga.measure(jobs, modules, module, family)["total"]


class Fpga(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.jobs = Jobs(scratch.name, 2)

    def memory(self, family, width, depth):
        """What a memory of this size takes, alone."""
        last = (depth - 1).bit_length() - 1
        text = f"module memory (input c, w, r, input [{last}:0] a, b, input [{width - 1}:0] d,\n"
        text += f"  output [{width - 1}:0] q);\n"
        text += f"  pipegs_sram #(.DataW({width}), .Depth({depth})) u_sram (.clk_i(c), .write_i(w),\n"
        text += "    .waddr_i(a), .wdata_i(d), .read_i(r), .raddr_i(b), .rdata_o(q));\nendmodule\n"
        package = synth.package_of(PACKAGE_SV, ["clock_gates=0"]) + text
        modules = synth.elaborate(self.jobs, package, "memory")
        return fpga.measure(self.jobs, modules, "memory", family)["total"]

    def test_large_memories_are_block_ram_and_nothing_else(self):
        for family in fpga.FLOWS:
            found = self.memory(family, 72, 512)
            self.assertEqual(found["blocks"], 2, family)
            self.assertEqual((found["luts"], found["flipflops"]), (0, 0), family)

    def test_small_memories_are_distributed_ram_and_the_register_of_its_output(self):
        for family in fpga.FLOWS:
            found = self.memory(family, 100, 16)
            self.assertEqual((found["blocks"], found["flipflops"]), (0, 100), family)
            self.assertEqual(found["luts"], found["distributed"], family)
            self.assertGreater(found["distributed"], 0, family)

    def test_a_clock_that_never_stops_is_a_wire(self):
        self.assertEqual(set(mapped(self.jobs, "pipegs_clock_gate", "xcup").values()), {0, 1})  # its own count

    def test_a_gate_is_refused(self):
        with self.assertRaisesRegex(Failed, "latch"):
            mapped(self.jobs, "pipegs_clock_gate", "xcup", ["clock_gates=1"])

    def test_what_cells_take(self):
        found = fpga.counts_of({"LUT6": 3, "RAM32M16": 1, "FDRE": 5, "RAMB36E2": 1, "RAMB18E2": 1, "DSP48E2": 2})
        self.assertEqual(
            found, {"luts": 11, "distributed": 8, "flipflops": 5, "multipliers": 2, "blocks": 3}
        )  # 18 Kb each
        with self.assertRaisesRegex(Failed, "unknown cell"):
            fpga.counts_of({"LUT7": 1})

    def test_the_scarcest_resource_decides(self):
        total = {"luts": 23040, "flipflops": 0, "multipliers": 864, "blocks": 0}
        self.assertAlmostEqual(fpga.fits(total)["ZU7EV"], 0.5)

    def test_an_unknown_family_is_named(self):
        run = subprocess.run(
            [fpga.__file__, "--families", "ice40", "pipegs_clock_gate"], capture_output=True, text=True, check=False
        )
        self.assertEqual(run.returncode, 1)
        self.assertIn("unknown family 'ice40'", run.stderr)


if __name__ == "__main__":
    unittest.main()
