#!/usr/bin/env python3
"""Throughput of two cores against one, and a large data set, in time, files and memory.

    throughput.py SPEC OUT [--edvo PROGRAM] [--rounds N]   one process with a thread for each of two cores, and
                                                           two processes of a core, against one process of one
    throughput.py SPEC OUT --once                          two processes make the data set, one merges it

Efficiency is the mean time of one core, measured on each, over twice the time of both. Peak memory is that of
the largest process. Every data set of a round is compared with the first, byte for byte. OUT is made.
"""

import argparse
import concurrent.futures
import filecmp
import os
import pathlib
import shutil
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]


def run(words, cores=None):
    """Runs a command on some cores; returns its peak memory, MB."""
    process = subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL,
                               preexec_fn=lambda: cores and os.sched_setaffinity(0, cores))
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, words))}: exit code {process.returncode}")
    return usage.ru_maxrss / 1024


class DataSet:
    def __init__(self, arguments, cores):
        self.edvo, self.spec = arguments.edvo, arguments.spec
        self.out, self.cores = pathlib.Path(arguments.out), cores

    def command(self, step, out, *options):
        return [self.edvo, "dataset", step, self.spec, "--out", out, "--no-sync", "--quiet", *options]

    def one_process(self, out, cores):
        """Returns wall time, s, and peak memory, MB, of one process with a thread for each core."""
        begin = time.perf_counter()
        memory = run(self.command("render", out, "--threads", len(cores)), set(cores))
        return time.perf_counter() - begin, memory

    def two_processes(self, out):
        """Returns wall time, s, and peak memory, MB, of two processes, each with a core and half of the parts."""
        begin = time.perf_counter()
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            halves = [pool.submit(run, self.command("render", out, "--threads", 1, "--shard", f"{i + 1}/2"), {core})
                      for i, core in enumerate(self.cores)]
            memory = max(half.result() for half in halves)
        return time.perf_counter() - begin, memory

    def merge(self, out):
        begin = time.perf_counter()
        memory = run(self.command("merge", out))
        return time.perf_counter() - begin, memory


def files_below(folder):
    return sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file())


def is_same(folder, other):
    names = files_below(folder)
    return names == files_below(other) and not any(
        filecmp.cmpfiles(folder, other, [str(name) for name in names], shallow=False)[1:])


def compare(data_set, rounds):
    print(f"{'':22}{'s':>8}{'of linear, %':>14}{'MB':>8}")
    for turn in range(rounds):
        folder = data_set.out / str(turn)
        first, second = data_set.cores
        figures = {
            "core A": data_set.one_process(folder / "a", [first]),
            "one process, 2 threads": data_set.one_process(folder / "threads", data_set.cores),
            "two processes": data_set.two_processes(folder / "processes"),
            "core B": data_set.one_process(folder / "b", [second]),
        }
        one = (figures["core A"][0] + figures["core B"][0]) / 2
        for name, (seconds, memory) in figures.items():
            share = "" if name.startswith("core") else f"{100 * one / (2 * seconds):.1f}"
            print(f"{name:22}{seconds:8.2f}{share:>14}{memory:8.0f}", flush=True)
        for name in ("a", "threads", "processes", "b"):
            data_set.merge(folder / name)
            if not is_same(data_set.out / "0" / "a", folder / name):
                raise SystemExit(f"{folder / name}: other bytes than those of one core")
            if (turn, name) != (0, "a"):
                shutil.rmtree(folder / name)
    print("same bytes in all")


def make_once(data_set):
    out = data_set.out / "data_set"
    seconds, memory = data_set.two_processes(out)
    print(f"two processes: {seconds:.0f} s, {memory:.0f} MB each at most", flush=True)
    seconds, memory = data_set.merge(out)
    files = files_below(out)
    size = sum((out / file).stat().st_size for file in files)
    print(f"merge: {seconds:.1f} s, {memory:.1f} MB; {len(files)} files, {size / 1e6:.0f} MB")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("spec")
    parser.add_argument("out")
    parser.add_argument("--once", action="store_true")
    parser.add_argument("--edvo", default=str(ROOT / "build/release/edvo"))
    parser.add_argument("--rounds", type=int, default=2)
    arguments = parser.parse_args()
    cores = sorted(os.sched_getaffinity(0))[:2]
    data_set = DataSet(arguments, cores)
    data_set.out.mkdir(parents=True)
    if arguments.once:
        make_once(data_set)
    else:
        compare(data_set, arguments.rounds)


main()
