#!/usr/bin/python3
"""A study of convergence with mpm_granular.

    study.py STUDY_FILE [--program PROGRAM] [--output FOLDER]

runs one input over the sizes and variants that the study file lists and writes
into the folder, by default study-NAME where it is started,

    study.md     a table for each observable, with orders and estimates of errors
    study.csv    the same numbers with all digits
    study.png    a plot
    variant_*    the runs; those that are there already are not run again

doc/studies.md describes the study file, benchmarks/studies holds examples. It
needs the Debian packages python3-matplotlib, python3-numpy and python3-vtk9.
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

try:
    from plotting.run import NotARun
    from studies.program import Program, RunFailed, find_program
    from studies.study import Study, StudyError, write
except ImportError as error:
    sys.exit(f"study.py: {error}. It needs Python 3.11, the Debian packages "
             "python3-matplotlib, python3-numpy and python3-vtk9, and Debian's "
             f"/usr/bin/python3 (this is {sys.executable}).")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", help="study file (TOML)")
    parser.add_argument("--program", help="the program mpm_granular; default: "
                        "$MPM_PROGRAM or build/release/mpm_granular")
    parser.add_argument("--output", type=pathlib.Path,
                        help="folder for runs and results")
    options = parser.parse_args()
    try:
        study = Study(options.study)
        folder = options.output or pathlib.Path(f"study-{study.name}")
        program = Program(find_program(options.program), folder)
        results = study.results(study.run(program))
        write(study, results, folder, program.version)
    except (StudyError, RunFailed, NotARun) as error:
        sys.exit(f"study.py: {error}")
    print(folder / "study.md")


if __name__ == "__main__":
    main()
