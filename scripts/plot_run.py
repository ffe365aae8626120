#!/usr/bin/python3
"""Pictures of runs of mpm_granular.

    plot_run.py RUNFOLDER [RUNFOLDER]

writes into RUNFOLDER/pictures:

    stages_strain.png    six instants from the side, coloured by the equivalent
                         viscoplastic strain
    stages_pressure.png  the same, coloured by the pressure
    perspective.png      six instants of a body in space
    energies.png         all terms of the energy balance over time
    front.png            front and height over time
    mesh.png             an adaptive mesh from the side, at four instants (with
                         Output/Write grid = true)
    settling.png         how the initial equilibrium was reached, if that was a
                         stage

and with two folders also, into the pictures of the first one,
compare_stages.png and compare_front.png, say the wall in 2D beside 3D.

It needs the Debian packages python3-matplotlib, python3-numpy and python3-vtk9,
and no display.
"""

import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

try:
    from plotting import curves, mesh, perspective, stages
    from plotting.run import NotARun, Run
except ImportError as error:
    sys.exit(f"plot_run.py: {error}. It needs the Debian packages "
             "python3-matplotlib, python3-numpy and python3-vtk9, and Debian's "
             f"/usr/bin/python3 (this is {sys.executable}).")


def plot(run):
    """All pictures of one run."""
    strain = stages.strain([run])
    stages.stages(run, strain, "stages_strain.png")
    if "pressure" in run.points(0):
        stages.stages(run, stages.pressure([run]), "stages_pressure.png")
    if run.dimension == 3:
        perspective.perspective(run, strain, "perspective.png")
    curves.energies(run)
    curves.front([run], run.folder, "front.png")
    if run.has_adaptive_mesh:
        mesh.stages(run, "mesh.png")
    if len(run.stage) > 1:
        curves.settling(run)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="+", help="output folder of a run")
    folders = parser.parse_args().folder
    try:
        runs = [Run(folder) for folder in folders]
        for run in runs:
            if run.manifest.get("outcome") != "done":
                print(f"Note: the run in '{run.folder}' has the outcome "
                      f"'{run.manifest.get('outcome')}'.", file=sys.stderr)
            plot(run)
        if len(runs) > 1:
            pair = runs[:2]
            stages.compare(pair, stages.strain(pair), "compare_stages.png")
            curves.front(runs, runs[0].folder, "compare_front.png")
    except NotARun as error:
        sys.exit(f"plot_run.py: {error}.")


if __name__ == "__main__":
    main()
