#!/usr/bin/env python3
"""Runs every command that writes a file or prints JSON and reads all of it with parsers that are not
the project's own: written_files_test.py EDVO SOURCE_FOLDER WORK_FOLDER [OPENNI2_FOLDER], the last with the library OpenNI2
and a driver of a camera without hardware; without it no camera is read.

Exits with 77 (skipped) where xmllint, python3-jsonschema or python3-numpy is not installed.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time

try:
    import parsers
    import schemas
except ImportError:
    schemas = None

import commands


class Check:
    """Collects what is wrong, so that one run shows all of it."""

    def __init__(self, program, work, known_schemas, openni2):
        self.program, self.work, self.schemas, self.openni2 = program, work, known_schemas, openni2
        self.problems = []
        self.left_out = set()

    def attempt(self, what, action):
        try:
            action()
        except Exception as error:  # any parser's own kind
            self.problems.append(f"{what}: {type(error).__name__}: {error}")

    def environment(self, run):
        if run.slurm:
            return os.environ | {"PATH": f"{self.work / 'stand_ins'}:{os.environ['PATH']}"}
        if not run.camera:
            return None
        return os.environ | {"LD_LIBRARY_PATH": str(self.openni2), "EDVO_DEVICE_FOLDER": str(self.work / "sequence")}

    def run(self, run):
        if run.camera and self.openni2 is None:
            print(f"   left out, without OpenNI2:  edvo {run.words}")
            self.left_out.add(run.json)
            return
        if run.video and not (self.program.parent / "libedvo_video.so").exists():
            print(f"   left out, without videoio:  edvo {run.words}")
            return
        begin = time.monotonic()
        words = shlex.split(run.words.replace("{edvo}", str(self.program)))
        done = subprocess.run([self.program, *words], cwd=self.work, env=self.environment(run), capture_output=True,
                              check=False)
        print(f"{time.monotonic() - begin:6.2f} s  edvo {run.words}", flush=True)
        if done.returncode not in run.exit_codes:
            self.problems.append(f"edvo {run.words}: exit code {done.returncode}, expected {run.exit_codes}: "
                                 f"{done.stderr.decode(errors='replace')[-400:]}")
        elif run.json:
            self.attempt("edvo " + run.words, lambda: self.validate(done.stdout.decode("utf-8"), run.json))

    def validate(self, text, name):
        document = parsers.load_json(text)
        self.schemas.validate(document)
        parsers.require(document["schema"] == "edvo." + name, f"is of {document['schema']}")

    def read_files(self):
        """Parses every file below the folder; JSON that names a schema is held to it."""
        count = 0
        for path in sorted(self.work.rglob("*")):
            if path.is_file() and self.work / "assets" not in path.parents:
                self.attempt(path.relative_to(self.work), lambda: parsers.parse(path))
                count += 1
        for path in sorted(self.work.glob("**/*.json")):
            is_ours = path.name != "transforms.json"  # Nerfstudio's, which exports_test reads
            if is_ours and "cache" not in path.parts and self.work / "assets" not in path.parents:
                self.attempt(path.relative_to(self.work),
                             lambda: self.schemas.validate(parsers.load_json(path.read_text("utf-8"))))
        for path in sorted(self.work.glob("**/*.jsonl")):
            self.attempt(path.relative_to(self.work), lambda: self.schemas.validate(parsers.load_json_lines(path)))
        print(f"{count} files read")

    def read_pictures(self, docs):
        """Parses the plots of the documentation, which commands wrote."""
        for path in sorted(docs.rglob("*.svg")):
            self.attempt(path.relative_to(docs), lambda: parsers.parse(path))

    def require_every_command(self):
        """A command with --json has a run here whose document was validated, and every schema one."""
        ran = {" ".join(run.words.split()[:2]) for run in commands.RUNS if run.json}
        for command in commands_with_json(self.program):
            if not any((name + " ").startswith(command + " ") for name in ran):
                self.problems.append(f"edvo {command} has --json, but no run in commands.py with a schema")
        self.problems += [f"docs/schemas: no document of {name} was seen" for name in self.schemas.unused() if name not in self.left_out]


def help_of(program, words):
    return subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True).stdout


def subcommands(help_text):
    listed = help_text.partition("\nSubcommands:\n")[2]
    return re.findall(r"^  (\S+)", listed.partition("\n\n")[0], re.M)


def commands_with_json(program, words=()):
    """The commands, as words with a space between, whose help has --json."""
    text = help_of(program, words)
    found = [" ".join(words)] if re.search(r"^  --json\b", text, re.M) else []
    for name in subcommands(text):
        found += commands_with_json(program, (*words, name))
    return found


def prepare(work, source):
    shutil.rmtree(work, ignore_errors=True)
    (work / "scenarios").mkdir(parents=True)
    (work / "assets").symlink_to(source / "assets")
    for name, text in commands.FILES.items():
        (work / name).write_text(text, encoding="utf-8")
    sbatch = work / "stand_ins" / "sbatch"
    sbatch.parent.mkdir()
    sbatch.write_text("#!/bin/sh\necho 7\n")
    sbatch.chmod(0o755)


def main():
    program, source, work, *openni2 = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    if schemas is None or shutil.which("xmllint") is None:
        print("skipped: python3-jsonschema, python3-numpy or xmllint (libxml2-utils) is not installed")
        return 77
    prepare(work, source)
    check = Check(program, work, schemas.Schemas(source / "docs" / "schemas"),
                  openni2[0] if openni2 else None)
    for run in commands.RUNS:
        check.run(run)
    check.read_files()
    check.read_pictures(source / "docs")
    check.require_every_command()
    print(*check.problems, sep="\n")
    return 1 if check.problems else 0


if __name__ == "__main__":
    sys.exit(main())
