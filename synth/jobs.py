# SPDX-License-Identifier: Apache-2.0
"""jobs.py: programs run in parallel, each result kept under the hash of all that it was made from.

Idea    A result is a folder CACHE/NAME.HASH. It is filled under another name and renamed when it is whole, so what was
        interrupted or failed leaves nothing that a later run would take for a result.
Rule    The first failure stops the others and is one line that names the log. Progress goes to a terminal only.
"""
import concurrent.futures
import hashlib
import os
import shutil
import signal
import subprocess
import sys
import threading
import time


class Failed(Exception):
    """One line for the user."""


class Jobs:
    def __init__(self, cache, workers):
        self.cache, self.workers = cache, workers
        self._children, self._lock, self._stopped = set(), threading.Lock(), False
        self._making = {}  # folder of a result: the lock of who makes it
        os.makedirs(cache, exist_ok=True)

    def result(self, name, made_from, make):
        """The folder of this result; make(folder) fills it unless it is there."""
        key = hashlib.sha256("\0".join(made_from).encode()).hexdigest()[:16]
        folder = os.path.join(self.cache, f"{name}.{key}")
        with self._lock:
            making = self._making.setdefault(folder, threading.Lock())
        with making:
            if not os.path.isdir(folder):
                self._make(folder, make)
        return folder

    @staticmethod
    def _make(folder, make):
        scratch = f"{folder}.{os.getpid()}"
        shutil.rmtree(scratch, ignore_errors=True)
        os.makedirs(scratch)
        try:
            make(scratch)
            try:
                os.rename(scratch, folder)
            except OSError:
                if not os.path.isdir(folder):
                    raise
                shutil.rmtree(scratch)  # another program has made it meanwhile
        except Failed:
            failed = f"{folder}.failed"  # for its log
            shutil.rmtree(failed, ignore_errors=True)
            os.rename(scratch, failed)
            raise
        except BaseException:
            shutil.rmtree(scratch, ignore_errors=True)
            raise

    def run(self, command, log):
        """Runs a program; its output is the file log. A failure raises Failed."""
        with open(log, "w", encoding="utf-8") as output:
            with self._lock:
                if self._stopped:
                    raise KeyboardInterrupt
                child = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
                self._children.add(child)
            code = child.wait()
            with self._lock:
                self._children.discard(child)
        if self._stopped:
            raise KeyboardInterrupt
        if code != 0:
            raise Failed(f"{command[0]} failed")

    def each(self, what, tasks):
        """Calls tasks [(name, cost, function)] in parallel, dearest first -> {name: result}."""
        done, begin, results = 0, time.time(), {}
        total = sum(cost for _, cost, _ in tasks)
        with concurrent.futures.ThreadPoolExecutor(self.workers) as pool:
            waiting = {
                pool.submit(function): (name, cost) for name, cost, function in sorted(tasks, key=lambda task: -task[1])
            }
            try:
                for number, future in enumerate(concurrent.futures.as_completed(waiting), 1):
                    name, cost = waiting[future]
                    try:
                        results[name] = future.result()
                    except Failed as error:
                        log = next(
                            (
                                root
                                for root in os.listdir(self.cache)
                                if root.startswith(name + ".") and root.endswith(".failed")
                            ),
                            "",
                        )
                        raise Failed(f"{what} {name}: {error}; log {os.path.join(self.cache, log, 'log')}") from None
                    done += cost
                    self._progress(what, number, len(tasks), (time.time() - begin) * (total / done - 1))
            except BaseException:
                self._stop()
                pool.shutdown(wait=True, cancel_futures=True)
                raise
        return results

    def _stop(self):
        with self._lock:
            self._stopped = True
            for child in self._children:
                os.killpg(child.pid, signal.SIGTERM)

    def _progress(self, what, number, count, left):
        if sys.stderr.isatty():
            end = "\n" if number == count else ""
            sys.stderr.write(f"\r{what}: {number} of {count}, {int(left) // 60}:{int(left) % 60:02} left \033[K{end}")
            sys.stderr.flush()
