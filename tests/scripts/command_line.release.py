#!/usr/bin/env python3
"""What a user meets on the command line: every mistake gets exit code 1 and
one message that tells what to change, and leaves no file behind.

Usage: command_line.release.py [PROGRAM]
"""


from _program import INPUTS, Checks, Folder

CASE = INPUTS / "wall_2d.prm"
CASE_3D = INPUTS / "wall.prm"
PREFIX = "mpm_granular: error: "
checks = Checks()


def done(name, arguments, *fragments):
    """The program must succeed, write no files, and print the fragments."""
    with Folder() as folder:
        result = folder.run(*arguments)
        for condition, problem in (
                (result.returncode == 0, "exit code"),
                (not result.stderr, "message"),
                (not folder.files(), f"files {folder.files()}"),
                *((f in result.stdout, f"no {f!r}") for f in fragments)):
            checks.that(condition, f"{name}: {problem}", str(result))
        return result.stdout


def refused(name, arguments, *fragments, prepare=None, before=()):
    """The program must refuse its input with the fragments in its message."""
    with Folder() as folder:
        if prepare:
            prepare(folder.path)
        files = folder.files()
        result = folder.run(*arguments, before=before)
        message = result.stderr
        for condition, problem in (
                (result.returncode == 1, "exit code"),
                (message.count(PREFIX) == 1, "one message"),
                (before or message.startswith(PREFIX), "nothing before it"),
                (before or len(message.splitlines()) <= 3, "a short one"),
                ("----" not in message.split(PREFIX)[-1] or before, "banner"),
                ("exception" not in message.lower(), "no exception"),
                (folder.files() == files, f"files {folder.files()}"),
                *((f in message, f"no {f!r}") for f in fragments)):
            checks.that(condition, f"{name}: {problem}", str(result))


def refused_values(name, assignments, *fragments, case=CASE):
    """The shipped case with other values must be refused."""
    refused(name, [case, *options(assignments)], *fragments)


def refused_cases(name, assignments, *fragments, case=CASE):
    """The same for what only the set-up finds, when the case is run and when it
    is only checked."""
    refused_values(name, assignments, *fragments, case=case)
    refused(f"{name}, --check", ["--check", case, *options(assignments)],
            *fragments)


def options(assignments):
    """The command line that changes values."""
    return [f"--set={assignment}" for assignment in assignments]


def changed_case(old, new):
    """Writes changed.prm, the shipped case with another text in one place."""
    def prepare(path):
        text = CASE.read_text()
        assert old in text, old
        (path / "changed.prm").write_text(text.replace(old, new, 1))
    return prepare


def line_of(text):
    """Where a text is in the shipped case."""
    return CASE.read_text().split(text)[0].count("\n") + 1


def test_information():
    """Options that tell something."""
    done("help", ["--help"], "Usage", "--check", "--set", "--overwrite",
         "--output", "--print-parameters", "--version", "Exit code")
    done("version", ["--version"], "mpm_granular ", "git commit ", "deal.II ",
         "Trilinos")

    defaults = done("default parameters", ["--print-parameters"],
                    "set Dimension = 3", "subsection Time step", "Units: ")
    with Folder() as folder:
        (folder.path / "default.prm").write_text(defaults)
        again = folder.run("--print-parameters", "default.prm").stdout
        checks.that(again == defaults, "printed parameters can be read", again)
    done("parameters in 2D", ["--print-parameters", "--set=Dimension=2"],
         "set Dimension = 2", "set Gravity = 0, -9.81\n")
    done("parameters as used",
         ["--print-parameters", CASE, "--set=Time step/CFL=0.25"],
         "set Dimension = 2", "set CFL = 0.25", "Default: 0.5")
    done("parameters as Markdown", ["--print-parameters=markdown"],
         "## Time step, Type = fixed", "| Fixed step |", "| CFL |")
    done("check", ["--check", CASE])


def test_command_line():
    """Mistakes in the options."""
    refused("no file", [], "name a parameter file", "--help")
    refused("two files", [CASE, CASE_3D], "wall_2d.prm", "wall.prm")
    refused("unknown option", [CASE, "--chek"], "'--check'")
    refused("short option", [CASE, "-v"], "'-v'")
    refused("no value", [CASE, "--set"], "--set")
    refused("no assignment", [CASE, "--set", "CFL"], "Section/Entry=value")
    refused("form of parameters", ["--print-parameters=xml"], "markdown")
    refused("missing file", ["wal.prm"], "'wal.prm'")
    refused("folder", [INPUTS], "folder")


def test_file():
    """Mistakes in the format of the file, with their lines."""
    refused("misspelt entry", ["changed.prm"], "'Young modulus'",
            f"changed.prm:{line_of('Young modulus')}: ",
            prepare=changed_case("Young modulus", "Youngs modulus"))
    refused("misspelt subsection", ["changed.prm"], "'Body force'",
            f"changed.prm:{line_of('subsection Body force')}: ",
            prepare=changed_case("subsection Body force",
                                 "subsection Body forces"))
    refused("no end", ["changed.prm"], "'end'", "'Materials",
            prepare=changed_case("  end\nend", "end"))
    refused("end too many", ["changed.prm"], "'end'",
            prepare=changed_case("end\n", "end\nend\n"))
    refused("twice", ["changed.prm"], "already", "Dimension",
            prepare=changed_case("set Dimension = 2",
                                 "set Dimension = 2\nset Dimension = 3"))
    refused("no set", ["changed.prm"], "changed.prm:", "not understood",
            prepare=changed_case("set Dimension", "Dimension"))


def test_values():
    """Values that cannot be right, alone or together."""
    sand = "Materials/sand/"
    refused_values("dimension", ["Dimension=4"], "'2', '3'")
    refused_values("misspelt", [sand + "Yung modulus=1"], "'Young modulus'")
    refused_values("unit", [sand + "Young modulus=1 MPa"], "Pa", "alone")
    refused_values("range", [sand + "Poisson ratio=0.7"], "0.5", "0.7")
    refused_values("limit of range", [sand + "Poisson ratio=0.5"],
                   "Poisson ratio", "0.5")
    refused_values("choice", [sand + "Law=Druker"], "Drucker-Prager")
    refused_values("other choice", ["Time step/Fixed step=1e-5"],
                   "'Type = fixed'")
    refused_values("components", ["Body force/Gravity=0, 0, -9.81"], "2 values")
    refused_values("material", ["Points/wall/Material=snad"], "snad", "sand")
    refused_values("expression", ["Initial state/Velocity=1 +; 0"], "Velocity")
    refused_values("no region", ["Points/Names="], "Points")


def test_case():
    """What cannot be right with this mesh and these points."""
    refused_cases("missing mesh", ["Mesh/File=meshes/nothing.msh"],
                  "Mesh/File", "nothing.msh")
    refused_cases("not a mesh", ["Mesh/File=wall.prm"], "wall.prm")
    refused_cases("unknown boundary",
                  ["Boundary conditions/base/Boundaries=y_mni"],
                  "y_mni", "y_min")
    refused_cases("boundary without condition",
                  ["Boundary conditions/open/Boundaries=x_max"], "y_max")
    refused_cases("unknown cells", ["Points/wall/Cell sets=snad"],
                  "snad", "sand")
    refused_cases("step above the limit",
                  ["Time step/Type=fixed", "Time step/Fixed step=1"],
                  "Fixed step")
    refused_cases("points outside of the mesh",
                  ["Points/wall/Upper corner=99, 0.2, 2"],
                  "Points/wall", case=INPUTS / "wall_paper.prm")


def test_output_folder():
    """Files of an earlier run are safe."""
    def earlier_run(path):
        (path / "earlier").mkdir()
        (path / "earlier" / "observables.csv").write_text("time\n0\n")

    refused("folder of an earlier run", [CASE, "--output", "earlier"],
            "'earlier'", "--overwrite", prepare=earlier_run)
    refused("file as folder", [CASE, "--output", "earlier/observables.csv"],
            "observables.csv", prepare=earlier_run)


test_information()
test_command_line()
test_file()
test_values()
test_case()
test_output_folder()
checks.exit()
