"""What the cases of adaptive meshes share."""

import dataclasses
import shutil

from plotting import mesh


@dataclasses.dataclass
class Outcome:
    """What a run gave and cost."""
    front: float
    height: float
    closure: float
    cells: int
    speed: float  # million point-steps/s
    part: float   # of the loop's time that the adaptations took
    adaptations: int
    set_up: float  # s
    memory: float  # MB


def outcome(run):
    """The outcome of a run."""
    last = run.table[-1]
    performance = run.manifest["performance"]
    return Outcome(
        last["front"], last["height"], last["closure"],
        run.manifest["counts"]["cells"],
        performance["million_point_steps_per_second"],
        performance["adaptation_seconds"] / performance["loop_seconds"],
        performance["adaptations"], performance["set_up_seconds"],
        performance["peak_memory_bytes"] / 1e6)


def picture(suite, run, name, caption):
    """The mesh at four instants."""
    if suite.quick:
        return
    mesh.stages(run, "mesh.png")
    shutil.copy(run.folder / "pictures" / "mesh.png",
                suite.pictures / f"{name}.png")
    suite.lines += [f"![{caption}]({name}.png)\n"]
