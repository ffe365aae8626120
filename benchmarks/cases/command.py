"""What the commands that run cases have in common."""

import argparse
import dataclasses
import importlib
import pathlib
import sys

from studies.program import ROOT, Program, RunFailed, find_program

from .suite import Suite


@dataclasses.dataclass
class Command:
    """A command that runs cases and writes their page.

    name: of the command and of the function of each case; subject: names the
    folders prm/SUBJECT of inputs, doc/SUBJECT of the page and build/SUBJECT of
    runs; cases: modules beside this one; page(suite, program): the document.
    """
    name: str
    subject: str
    description: str
    cases: list
    page: callable

    def main(self):
        """Runs as the command line says; exit code 1 if a check fails."""
        options = self.options()
        try:
            program = Program(find_program(options.program), options.runs)
            options.page.mkdir(parents=True, exist_ok=True)
            suite = Suite(program, self.subject, options.page, options.quick)
            for name in options.only:
                print(name, flush=True)
                case = importlib.import_module(f"cases.{name}")
                suite.begin(case.TITLE)
                getattr(case, self.name)(suite)
                suite.end()
        except RunFailed as error:
            sys.exit(f"{self.name}: {error}")

        failed = [check for check in suite.checks if not check.holds]
        for check in failed:
            print(f"FAILED: {check.what}: {check.value:.4g}, allowed "
                  f"{check.band}")
        print(f"{len(suite.checks)} checks, {len(failed)} failed")
        if not options.quick and options.only == self.cases:
            (options.page / "README.md").write_text(self.page(suite, program),
                                                    encoding="utf8")
            print(options.page / "README.md")
        elif not options.quick:
            print("\n".join(suite.lines))
        sys.exit(1 if failed else 0)

    def options(self):
        parser = argparse.ArgumentParser(
            description=self.description,
            formatter_class=argparse.RawDescriptionHelpFormatter)
        parser.add_argument("--quick", action="store_true",
                            help="only the smallest form of each case, no page")
        parser.add_argument("--only", nargs="+", choices=self.cases,
                            default=self.cases, metavar="CASE",
                            help=f"of {', '.join(self.cases)}; no page")
        parser.add_argument("--program", help="the program mpm_granular; "
                            "default: $MPM_PROGRAM or "
                            "build/release/mpm_granular")
        parser.add_argument("--runs", type=pathlib.Path,
                            default=ROOT / "build" / self.subject,
                            help="folder for the runs")
        parser.add_argument("--page", type=pathlib.Path,
                            default=ROOT / "doc" / self.subject,
                            help="folder for the page")
        return parser.parse_args()
