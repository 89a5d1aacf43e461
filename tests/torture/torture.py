#!/usr/bin/env python3
"""Kills, faults and crowds: disturbs every command that writes, and compares what it leaves with an undisturbed run.

usage: torture.py EDVO SHIM ASSETS [--only kills,faults,processes] [--commands NAME,...] [--rounds N] [--seconds S]
                  [--seed S] [--keep DIR]

  kills      SIGKILL, either at a system call or after a part of the time that an undisturbed run takes
  faults     the N-th write, rename, fsync, open, mkdir, mmap, unlink, flock or allocation fails
  processes  2, 4 or 8 processes of one command on one output at once

A round chooses a command and a moment by the seed and its own number, so `--first N --rounds 1` repeats round N. After
kills and faults the same command runs again, undisturbed: all files must be those of an undisturbed run, and no others.
A file that differs between two undisturbed runs (it holds times) is compared by its name alone. Exit code 1 if
anything was lost, different or left behind, or a command ended otherwise than documented; 2 if one cannot be run
undisturbed.
"""

import argparse
import collections
import errno
import pathlib
import random
import re
import shlex
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import commands  # noqa: E402

KINDS = ["write", "rename", "fsync", "open", "mkdir", "mmap", "malloc", "unlink", "flock", "any"]
ERRORS = {"write": ["ENOSPC", "EIO", "EINTR", "EDQUOT"], "rename": ["ENOSPC", "EIO", "EINTR"],
          "fsync": ["ENOSPC", "EIO", "EINTR"], "open": ["EMFILE", "ENFILE", "EIO", "EINTR", "ENOMEM", "ENOSPC"],
          "mkdir": ["ENOSPC", "EIO", "EMFILE"], "mmap": ["ENOMEM", "EMFILE"], "malloc": ["ENOMEM"],
          "unlink": ["EIO", "EINTR"], "flock": ["EINTR", "ENOLCK"]}
MODES = ("kills", "faults", "processes")
MEASURED_TIME = re.compile(rb' time="[0-9.]+"')
TIMEOUT = 120  # s, after which a command hangs
FAILED_ENDS = {3, 4, 5, 75}  # documented ends of a command that met a fault


class Failure(Exception):
    pass


def bytes_of(path):
    """Returns the bytes of a file, without the times that JUnit XML has of its tests."""
    return MEASURED_TIME.sub(b"", path.read_bytes()) if path.suffix == ".xml" else path.read_bytes()


def tree(folder):
    """Returns the bytes of each file below a folder by its name, and None for each folder."""
    return {str(path.relative_to(folder)): bytes_of(path) if path.is_file() else None
            for path in sorted(folder.rglob("*"))}


class Torture:
    def __init__(self, edvo, shim, assets, work):
        self.edvo, self.shim, self.assets, self.work = edvo, shim, assets, work
        self.inputs = work / "inputs"
        self.counts = work / "counts"
        self.undisturbed = {}

    def split(self, text):
        return shlex.split(text.format(edvo=self.edvo, assets=self.assets, inputs=self.inputs))

    def environment(self, folder, fault=None):
        (folder / "tmp").mkdir(parents=True, exist_ok=True)
        environment = {"PATH": "/usr/bin:/bin", "HOME": str(folder), "TMPDIR": str(folder / "tmp")}
        if fault is not None:
            self.counts.write_bytes(bytes(8 * (len(KINDS) + 1)))
            environment |= {"LD_PRELOAD": str(self.shim), "EDVO_FAULT_COUNTS": str(self.counts), "EDVO_FAULT": fault}
        return environment

    def start(self, words, folder, fault=None):
        return subprocess.Popen([self.edvo, *self.split(words)], cwd=folder, env=self.environment(folder, fault),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")

    def end(self, process):
        try:
            out, said = process.communicate(timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            raise Failure(f"hangs for {TIMEOUT} s") from None
        return process.returncode, said + out  # `edvo test` says on stdout what it could not measure

    def run(self, words, folder, fault=None):
        return self.end(self.start(words, folder, fault))

    def run_all(self, lines, folder, ends):
        for words in lines:
            code, said = self.run(words, folder)
            if code not in ends:
                raise Failure(f"an undisturbed run ended with {code}, expected {ends}: {said.strip()}")

    def read_counts(self):
        return dict(zip(KINDS, struct.unpack(f"{len(KINDS)}q", self.counts.read_bytes()[:8 * len(KINDS)]), strict=True))

    def is_kill_asked_for(self):
        """Kills are asked for in the slot after the counts; whoever asked goes on once it is answered."""
        with self.counts.open("r+b") as file:
            file.seek(8 * len(KINDS))
            return struct.unpack("q", file.read(8))[0] == 1

    def answer_kill(self):
        with self.counts.open("r+b") as file:
            file.seek(8 * len(KINDS))
            file.write(struct.pack("q", 2))

    def prepare(self, chosen):
        self.inputs.mkdir(parents=True)
        for name, text in commands.FILES.items():
            (self.inputs / name).write_text(text.format(assets=self.assets))
        for name, content in commands.BINARY_FILES.items():
            (self.inputs / name).write_bytes(content)
        self.run_all(commands.INPUTS, self.work, (0,))
        for command in chosen:
            self.undisturbed[command.name] = self.measure(command)

    def measure(self, command):
        """Runs a command twice: its files, those of them that vary, its times and its calls."""
        trees, times, counts = [], [], []
        for attempt in range(2):
            folder = self.work / "round"
            folder.mkdir()
            self.run_all(command.before, folder, (0,))
            for words in command.words:
                begin = time.monotonic()
                code, said = self.run(words, folder, "none:0:0" if attempt else None)
                if code not in command.ends:
                    raise Failure(f"{command.name} ended with {code}, undisturbed: {said}")
                times.append(time.monotonic() - begin)
                counts.append(self.read_counts() if attempt else None)
            trees.append(tree(folder))
            shutil.rmtree(folder)
        if trees[0].keys() != trees[1].keys():
            raise Failure(f"{command.name} writes other files from run to run")
        if any(name.startswith("tmp/") for name in trees[0]):
            raise Failure(f"{command.name} leaves {[n for n in trees[0] if n.startswith('tmp/')]}, undisturbed")
        varying = {name for name in trees[0] if trees[0][name] != trees[1][name]}
        return {"files": trees[0], "varying": varying, "times": times[:len(command.words)],
                "counts": counts[len(command.words):]}

    def compare(self, command, folder):
        expected, found = self.undisturbed[command.name], tree(folder)
        lost = sorted(expected["files"].keys() - found.keys())
        left = sorted(found.keys() - expected["files"].keys())
        other = [name for name in expected["files"]
                 if name in found and name not in expected["varying"] and found[name] != expected["files"][name]]
        if lost or left or other:
            raise Failure(f"lost {lost}, left behind {left}, different {other}")

    def rerun_and_compare(self, command, folder):
        self.run_all(command.words, folder, command.ends)
        self.compare(command, folder)

    def kill(self, command, folder, dice):
        """Kills one of the command's processes, at a call or a time; returns what was done."""
        step = dice.randrange(len(command.words))
        self.run_all(command.words[:step], folder, command.ends)
        known = self.undisturbed[command.name]
        if dice.random() < 0.7:
            at = dice.randint(1, known["counts"][step]["any"])
            process = self.start(command.words[step], folder, f"any:{at}:kill")
            while process.poll() is None and not self.is_kill_asked_for():
                time.sleep(0.002)
            process.kill()
            self.answer_kill()
            code, _ = self.end(process)
            done = f"killed at call {at}"
        else:
            at = known["times"][step] * dice.random()
            process = self.start(command.words[step], folder)
            time.sleep(at)
            process.kill()
            code, _ = self.end(process)
            done = f"killed after {at:.3f} s"
        return done, "killed" if code == -9 else f"ended with {code}"

    def fail(self, command, folder, dice):
        """Lets one call of the command fail; returns what was done."""
        step = dice.randrange(len(command.words))
        self.run_all(command.words[:step], folder, command.ends)
        counts = self.undisturbed[command.name]["counts"][step]
        kind = dice.choice([kind for kind in ERRORS if counts[kind] > 0])
        error = dice.choice(ERRORS[kind])
        at = dice.randint(1, counts[kind])
        done = f"{kind} {at} of {counts[kind]} fails with {error}"
        try:
            code, said = self.run(command.words[step], folder, f"{kind}:{at}:{getattr(errno, error)}")
        except Failure as failure:
            raise Failure(f"{done}: {failure}") from None
        if code not in FAILED_ENDS | set(command.ends):
            raise Failure(f"{done}: ended with {code}: {said.strip()}")
        if code not in command.ends and not re.search(r"\w+ .*\w+", said):
            raise Failure(f"{done}: ended with {code} and said nothing")
        return done, f"ended with {code}"

    def crowd(self, command, folder, dice):
        """Runs several processes at once on one output."""
        number = dice.choice([2, 4, 8])
        processes = [self.start(words, folder) for words in command.words for _ in range(number)]
        try:
            ends = [self.end(process) for process in processes]
        finally:
            for process in processes:  # none may write into the next round's folder
                process.kill()
                process.wait()
        for code, said in ends:
            if code not in command.ends:
                raise Failure(f"one of {number} processes ended with {code}: {said.strip()}")
        return f"{number} processes", "all ended well"

    def round(self, mode, command, dice):
        folder = self.work / "round"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        self.run_all(command.before, folder, (0,))
        action = {"kills": self.kill, "faults": self.fail, "processes": self.crowd}[mode]
        done, end = action(command, folder, dice)
        try:
            if mode == "processes":
                self.compare(command, folder)
            else:
                self.rerun_and_compare(command, folder)
        except Failure as failure:
            raise Failure(f"{done}, {end}; then {failure}") from None
        return end


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("edvo", type=pathlib.Path)
    parser.add_argument("shim", type=pathlib.Path)
    parser.add_argument("assets", type=pathlib.Path)
    parser.add_argument("--only", default=",".join(MODES), help="kills,faults,processes")
    parser.add_argument("--commands", default="", help="names of commands.py, separated by commas")
    parser.add_argument("--rounds", type=int, default=0, help="number of rounds; 0 = as many as the time allows")
    parser.add_argument("--first", type=int, default=0, help="number of the first round")
    parser.add_argument("--seconds", type=float, default=0, help="time for the rounds; 0 = no limit")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="folder for what a failed round leaves")
    arguments = parser.parse_args()
    if not arguments.rounds and not arguments.seconds:
        parser.error("expected --rounds or --seconds")
    return arguments


def main():
    arguments = parse()
    modes = arguments.only.split(",")
    chosen = [c for c in commands.COMMANDS if not arguments.commands or c.name in arguments.commands.split(",")]
    failures, ends, stop = 0, collections.Counter(), []
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stop.append(True))  # ends after the round
    with tempfile.TemporaryDirectory(prefix="torture-") as name:
        work = pathlib.Path(name)
        torture = Torture(arguments.edvo.resolve(), arguments.shim.resolve(), arguments.assets.resolve(), work)
        try:
            torture.prepare(chosen)
        except Failure as failure:
            print(f"no round can be run: {failure}", file=sys.stderr)
            return 2
        for command in chosen:
            if varying := torture.undisturbed[command.name]["varying"]:
                print(f"{command.name}: compared by name alone: {', '.join(sorted(varying))}")
        begin, number = time.monotonic(), arguments.first
        while (not stop and (not arguments.rounds or number < arguments.first + arguments.rounds)
               and (not arguments.seconds or time.monotonic() - begin < arguments.seconds)):
            dice = random.Random(f"{arguments.seed} {number}")
            mode, command = dice.choice(modes), dice.choice(chosen)
            try:
                ends[mode, torture.round(mode, command, dice)] += 1
            except Failure as failure:
                failures += 1
                ends[mode, "FAILED"] += 1
                print(f"FAILED round {number} (seed {arguments.seed}), {command.name}: {failure}", flush=True)
                if arguments.keep:
                    shutil.copytree(work / "round", arguments.keep / f"{arguments.seed}_{number}", symlinks=True)
            number += 1
        seconds = time.monotonic() - begin
    for (mode, end), count in sorted(ends.items()):
        print(f"{mode:10} {end:16} {count}")
    print(f"seed {arguments.seed}, {number - arguments.first} rounds in {seconds:.0f} s, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
