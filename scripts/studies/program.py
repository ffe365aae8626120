"""Running mpm_granular with settings, and not a second time."""

import hashlib
import os
import pathlib
import subprocess
import sys

from plotting.run import Run, read_parameters

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEY_FILE = "study_key.txt"


class RunFailed(Exception):
    """The program did not end with exit code 0."""


def find_program(path=None):
    """The program of this path; else that of the environment variable
    MPM_PROGRAM; else build/release/mpm_granular beside the scripts."""
    program = pathlib.Path(path or os.environ.get("MPM_PROGRAM") or
                           ROOT / "build" / "release" / "mpm_granular")
    if not program.is_file():
        raise RunFailed(f"there is no program '{program}'; build it, or give "
                        "its path with --program")
    return program.resolve()


class Program:
    """A program whose runs are kept in a folder."""

    def __init__(self, path, folder):
        self.path = pathlib.Path(path)
        self.folder = pathlib.Path(folder)
        self.hash = hashlib.sha256(self.path.read_bytes()).hexdigest()
        self.version = subprocess.run(
            [self.path, "--version"], capture_output=True, text=True,
            check=True).stdout.splitlines()[0]

    def key(self, input_file, settings):
        """What the result of a run depends on: program, input, settings and
        files that an entry 'File' names."""
        entries = read_parameters(input_file) | settings
        parts = [self.hash, input_file.read_text()]
        parts += [f"{name}={value}" for name, value in settings.items()]
        for name, value in entries.items():
            file = input_file.parent / str(value)
            if name.endswith("/File") and file.is_file():
                parts.append(hashlib.sha256(file.read_bytes()).hexdigest())
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()

    def run(self, input_file, name, settings=None):
        """The run of an input with settings {"Section/Entry": value}, in the
        subfolder `name`. If it is there already, it is only read.

        Raises RunFailed, with the last lines that the program said.
        """
        input_file = pathlib.Path(input_file).resolve()
        settings = {entry: setting_text(value)
                    for entry, value in (settings or {}).items()}
        folder = self.folder / name
        key = self.key(input_file, settings)
        key_file = folder / KEY_FILE
        if not key_file.is_file() or key_file.read_text() != key:
            print(f"  running {name}", file=sys.stderr, flush=True)
            self.start(input_file, folder, settings)
            key_file.write_text(key)
        return Run(folder)

    def start(self, input_file, folder, settings):
        """Runs the program and replaces what is in the folder."""
        folder.mkdir(parents=True, exist_ok=True)
        command = [self.path, input_file, "--output", folder, "--overwrite"]
        for entry, value in settings.items():
            command += ["--set", f"{entry}={value}"]
        process = subprocess.run(
            [str(word) for word in command], capture_output=True, text=True,
            errors="replace", stdin=subprocess.DEVNULL, check=False)
        if process.returncode != 0:
            said = "\n".join((process.stdout + process.stderr)
                             .strip().splitlines()[-8:])
            raise RunFailed(f"{folder.name} ended with exit code "
                            f"{process.returncode}:\n{said}")


def setting_text(value):
    """A value as the parameter file has it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return ", ".join(setting_text(part) for part in value)
    return str(value)
