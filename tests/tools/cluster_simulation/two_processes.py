#!/usr/bin/env python3
"""The simulated cluster beside a real run of two processes, each of one core:

    two_processes.py EDVO REPOSITORY SCRATCH

What a task costs (its start, a scene, a frame) is measured in tasks of 0, 1 and 2 parts, one on each core at a time. The
simulation of all parts on two nodes of one processor predicts the time from the first task's start to the last one's
end, which is measured then. Skipped (77) where the machine has less than two cores, or other work: a task that is alone
on its core and waits for it anyway.
"""

import concurrent.futures
import functools
import json
import os
import pathlib
import queue
import shutil
import subprocess
import sys
import threading
import time

TOLERANCE = 0.15  # of the predicted time
ATTEMPTS = 3
LEAST_SHARE = 0.9  # of its core that a task has where there is no other work
PARTS = 12  # of alike.toml: whole sequences, those of one scene after the other
FRAMES = 120  # of a part
FIRST_SHARES = (1, PARTS // 2 + 1)  # of each scene
ROUNDS = 2  # in which the costs are measured

EDVO, REPOSITORY, SCRATCH = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
SPEC = REPOSITORY / "tests/tools/cluster_simulation/alike.toml"


def edvo(*words, core=None):
    """Runs `edvo dataset` and returns what it printed, its wall time and its processor time, s."""
    begin = time.monotonic()
    process = subprocess.Popen([EDVO, "dataset", *words], stdout=subprocess.PIPE, text=True,
                               preexec_fn=None if core is None else lambda: os.sched_setaffinity(0, {core}))
    printed = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError(f"edvo dataset {' '.join(map(str, words))}: exit code {process.returncode}")
    return printed, time.monotonic() - begin, usage.ru_utime + usage.ru_stime


def at_once(actions):
    """Calls all at the same time and returns what they return, in order."""
    with concurrent.futures.ThreadPoolExecutor(len(actions)) as pool:
        return [future.result() for future in [pool.submit(action) for action in actions]]


class Costs:
    """Costs of tasks of a scene on each core, as they are with the other core busy, too: means over scenes and rounds, s."""

    def __init__(self, cores):
        self.wall = self.busy = self.none = self.one = self.two = 0
        self.lock = threading.Lock()
        for core in cores:
            edvo("plan", SPEC, "--out", SCRATCH / f"single{core}", "--quiet")
        for turn in range(ROUNDS):
            shares = FIRST_SHARES[turn % 2:] + FIRST_SHARES[:turn % 2]
            at_once([functools.partial(self.measure, core, share) for core, share in zip(cores, shares, strict=True)])
        count = len(FIRST_SHARES) * ROUNDS
        self.start = self.none / count
        self.frame = (self.two - self.one) / count / FRAMES
        self.scene = max(0, self.one / count - self.start - FRAMES * self.frame)

    def measure(self, core, share):
        """Tasks of one part, of none (it is there) and of two parts."""
        out = SCRATCH / f"single{core}"
        one, none = (self.task(out, core, f"{share}/{PARTS}") for _ in range(2))
        shutil.rmtree(pathlib.Path(f"{out}.part") / "parts")
        two = self.task(out, core, f"{(share + 1) // 2}/{PARTS // 2}")
        shutil.rmtree(pathlib.Path(f"{out}.part") / "parts")
        with self.lock:
            self.one, self.none, self.two = self.one + one, self.none + none, self.two + two

    def task(self, out, core, shard):
        _, wall, busy = edvo("render", SPEC, "--out", out, "--shard", shard, "--threads", "1", "--quiet",
                             "--no-sync", core=core)
        with self.lock:
            self.wall += wall
            self.busy += busy
        return wall

    def predicted(self):
        cluster = {"nodes": 2, "processors": 1, "mtbf_h": 0, "scheduler_per_s": 0, "start_s": self.start,
                   "scene_s": self.scene, "scene_mb": 0, "frame_s": self.frame, "write_s": 0, "bandwidth_mb_s": 0,
                   "files_per_s": 0, "merge_files_per_s": 0}
        text = ",".join(f"{key}={value:.6g}" for key, value in cluster.items())
        printed, _, _ = edvo("plan", SPEC, "--simulate", text, "--json", "--quiet")
        simulation = json.loads(printed)["simulation"]
        return text, simulation["wall_s"], simulation["efficiency"]


def measured(cores):
    """Two processes take the shares from a queue; returns wall time, s, and the share of their cores that they had."""
    out = SCRATCH / "two"
    edvo("plan", SPEC, "--out", out, "--quiet")
    shares = queue.SimpleQueue()
    for share in range(1, PARTS + 1):
        shares.put(share)

    def work(core):
        busy = 0
        while True:
            try:
                share = shares.get_nowait()
            except queue.Empty:
                return busy
            busy += edvo("render", SPEC, "--out", out, "--shard", f"{share}/{PARTS}", "--threads", "1", "--quiet",
                         "--no-sync", core=core)[2]

    begin = time.monotonic()
    busy = sum(at_once([functools.partial(work, core) for core in cores]))
    wall = time.monotonic() - begin
    return wall, busy / len(cores) / wall


def compare(cores):
    """Returns whether there was no other work, and measured over predicted time."""
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    costs = Costs(cores)
    text, predicted, efficiency = costs.predicted()
    wall, share = measured(cores)
    print(f"start {costs.start:.3f} s, scene {costs.scene:.3f} s, frame {costs.frame:.4f} s\n--simulate {text}\n"
          f"predicted {predicted:.2f} s (efficiency {efficiency:.3f}), measured {wall:.2f} s, "
          f"{100 * (wall / predicted - 1):+.1f} %; processes had {100 * costs.busy / costs.wall:.0f} % of their cores for the "
          f"costs, {100 * share:.0f} % in the run", flush=True)
    return costs.busy / costs.wall >= LEAST_SHARE and share >= LEAST_SHARE, wall / predicted


def main():
    cores = sorted(os.sched_getaffinity(0))[:2]
    if len(cores) < 2:
        print("skipped: needs two cores")
        return 77
    is_alone = False
    for _ in range(ATTEMPTS):
        is_quiet, ratio = compare(cores)
        is_alone = is_alone or is_quiet
        if abs(ratio - 1) <= TOLERANCE:
            return 0
    if not is_alone:
        print("skipped: other work takes the cores, no time can be compared")
        return 77
    return 1


if __name__ == "__main__":
    sys.exit(main())
