#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""jobs_test.py: results of synth/jobs.py: made once, whole or not there, whoever asks for them at the same time."""
import os
import shutil
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../synth"))
import jobs  # noqa: E402


class Results(unittest.TestCase):
    def test_two_that_want_the_same_result_make_it_once(self):
        with tempfile.TemporaryDirectory() as cache:
            made, store = [], jobs.Jobs(cache, 2)
            both = threading.Barrier(2)

            def make(folder):
                made.append(folder)
                time.sleep(0.2)  # the other one asks meanwhile
                with open(f"{folder}/log", "w", encoding="utf-8") as log:
                    log.write("whole")

            def want():
                both.wait()
                return store.result("unit", ["source"], make)

            found = store.each("make", [(name, 1, want) for name in ("first", "second")])
            self.assertEqual(found["first"], found["second"])
            self.assertEqual(len(made), 1)
            self.assertEqual(os.listdir(cache), [os.path.basename(found["first"])])

    def test_two_programs_that_make_the_same_result_share_it(self):
        with tempfile.TemporaryDirectory() as cache:
            one, other = jobs.Jobs(cache, 1), jobs.Jobs(cache, 1)

            def make(folder):
                with open(f"{folder}/log", "w", encoding="utf-8") as log:
                    log.write("whole")

            def overtaken(folder):
                make(folder)
                shutil.copytree(folder, folder.rsplit(".", 1)[0])  # the other program was faster

            found = one.result("unit", ["source"], overtaken)
            self.assertEqual(found, other.result("unit", ["source"], make))
            self.assertEqual(os.listdir(cache), [os.path.basename(found)])

    def test_a_failure_leaves_its_log_and_no_result(self):
        with tempfile.TemporaryDirectory() as cache:
            store = jobs.Jobs(cache, 2)

            def fail(folder):
                store.run([sys.executable, "-c", "print('why'); raise SystemExit(1)"], f"{folder}/log")

            with self.assertRaisesRegex(jobs.Failed, r"make first: .* failed; log .*first\..*\.failed/log"):
                store.each("make", [("first", 1, lambda: store.result("first", ["source"], fail))])
            (left,) = os.listdir(cache)
            with open(f"{cache}/{left}/log", encoding="utf-8") as log:
                self.assertEqual(log.read(), "why\n")


if __name__ == "__main__":
    unittest.main()
