"""Cases with a known answer, for benchmarks/verify and benchmarks/validate."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

try:
    import matplotlib  # noqa: F401  (asked for here to tell what is missing)
    import numpy  # noqa: F401
    import vtkmodules  # noqa: F401
except ImportError as error:
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {error}. It needs the Debian "
             "packages python3-matplotlib, python3-numpy and python3-vtk9, and "
             f"Debian's /usr/bin/python3 (this is {sys.executable}).")
