# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of a design without FreeCAD: prints as meshes, nets, from the mathematics alone.

For the tubes of `library`, with their hinges; values as the objects have them by default.
Documents, exact solids, pictures, reports and checks are FreeCAD's.
"""

from collections.abc import Callable
from dataclasses import replace
from math import radians
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import exporters
from ..exporters.bodies import Body
from ..exporters.thin import ThinModel
from ..origami.design import Placing, Thickness, TubeDesign
from ..origami.hinges.bodies import Drawn
from ..origami.hinges.ends import Ends
from ..origami.hinges.feet import Plane
from ..origami.hinges.joints import Joint
from ..origami.hinges.parts import part_drawn
from ..origami.hinges.pillars import boundary_of
from ..origami.hinges.presets import PRESETS
from ..origami.hinges.processes import BY_STANDOFFS, PROCESSES, STANDOFFS
from ..origami.hinges.propping import propped_print
from ..origami.hinges.standoff_inputs import LINE_IN_NOZZLES, StandOffs, usual_air
from ..origami.snap.materials import PLA, material
from ..origami.snap.table import PITCH_RATIOS, USUAL
from ..origami.snap.targets import FIRM, TargetBarrier, TargetMargin
from ..origami.units.ratios import DEFAULT_SHARE, RatioRule
from . import library
from .keys import TEST_PRINTS
from .reading import DesignError

if TYPE_CHECKING:
    from ..origami.hinges.parameters import HingeParameters
    from .reading import Design

MESHES, NETS = ("stl", "3mf"), ("fold", "svg", "dxf")
_ANGLES = ("cone_angle",)


def files_of(
    design: "Design", folder: Path, progress: Callable[..., Any] = lambda text: None
) -> tuple[list[Path], list[str]]:
    """Write the files of a `reading.Design` that need no FreeCAD; returns (paths, problems).

    `DesignError` for a design that does need it, and ValueError for what no tube can be.
    """
    _check(design)
    parameters = parameters_of(design)
    wanted = tube_design(design, parameters)
    folder.mkdir(parents=True, exist_ok=True)
    paths: list[Path] = []
    drawn, feet = None, []
    for suffix in design.formats:
        if suffix in MESHES:
            if drawn is None:
                drawn = _drawn(design, wanted, parameters)
                feet = _pillars(drawn, parameters)
            path = folder / f"{design.stem}-print.{suffix}"
            bodies: list[Any] = [Body(body.name, body, (), None, body.kind) for body in drawn]
            bodies += feet
        else:
            path = folder / f"{design.stem}.{suffix}"
            model = ThinModel(design.title, wanted.tube(), np.eye(4))
            bodies = [model]
        progress(exporters.write_bodies(bodies, path).name)
        paths.append(path)
    left = ["document", "checks"]
    left += [key for key in ("pictures", "report") if design.get("output", key, True)]
    return paths, [f"without FreeCAD there is no {', no '.join(left)}"]


def parameters_of(design: "Design") -> "HingeParameters":
    """`HingeParameters` of the table [hinges]."""
    table = design.tables.get("hinges", {})
    process = table.get("process", STANDOFFS)
    base = replace(USUAL, process=process, **PROCESSES[process].gives)
    if "preset" in table:
        preset = PRESETS[table["preset"]]
        base = preset.parameters(base)
        if "segmentations" in preset.given:
            base = replace(base, segment_width=0.0)
    if "segmentations" in table:
        base = replace(base, segment_width=0.0)
    fields: dict[str, Any] = {
        key: radians(value) if key in _ANGLES else value
        for key, value in table.items()
        if hasattr(base, key)
    }
    found = replace(base, **fields)
    if PROCESSES[process].held != BY_STANDOFFS or not found.has_knuckles:
        return found
    usual = StandOffs(width=LINE_IN_NOZZLES * found.nozzle_diameter)
    ribs = StandOffs(
        table.get("standoff_spacing", usual.spacing),
        table.get("standoff_width") or usual.width,
        table.get("air_layers") or usual_air(found.layer_height, found.gap_between_planes),
        table.get("standoff_rim", usual.rim),
        table.get("pillars", usual.pillars),
    )
    return replace(found, standoffs=ribs)


def tube_design(design: "Design", parameters: "HingeParameters") -> TubeDesign:
    """The `TubeDesign` that the objects of a document would have."""
    where = library.tube_design(design).where
    compensate = design.get("hinges", "compensate", True)
    preload = preload_of(design, parameters) if compensate else 0.0
    panels = Thickness(
        parameters.face_thickness,
        parameters.gap_between_planes,
        compensate,
        preload,
        None if preload == 0 else parameters,
    )
    rule = _rule(design, where, parameters)
    return TubeDesign(where, rule, design.get("unit", "height_ratio", 2.5), panels)


def preload_of(design: "Design", parameters: "HingeParameters") -> float | None:
    """Gap (mm) that hinges take up when deployed; None: as much as each unit needs."""
    table = design.tables.get("hinges", {})
    if not parameters.has_knuckles:
        return 0.0
    automatic = "Automatic" if "preload" not in table else "Given"
    if table.get("preload_rule", automatic) == "Automatic":
        return None
    return float(table.get("preload", 0.0)) * parameters.gap_length


def _rule(design: "Design", where: "Any", parameters: "HingeParameters") -> RatioRule:
    """The rule of the ratios: the file's, or the one that a hinge set aims with."""
    table = design.tables.get("unit", {})
    chosen = table.get("ratio_rule", "Fixed" if "ratio" in table else "Adaptive")
    along = isinstance(where, Placing)
    aims = "hinges" in design.tables and along and "ratio_rule" not in table
    aims = (
        aims and chosen == "Adaptive" and table.get("ratio_share", DEFAULT_SHARE) == DEFAULT_SHARE
    )
    if aims and parameters.play > 0 and where.pitch <= PITCH_RATIOS[-1] * where.edge_length:
        chosen = "TargetSnap"
    if chosen == "TargetSnap":
        if table.get("target_barrier"):
            return RatioRule(chosen, target=TargetBarrier(table["target_barrier"]))
        play = parameters.play if along and "hinges" in design.tables else 0.28
        target = TargetMargin(
            where.edge_length,
            where.pitch,
            tuple(table.get("unit_margins", ())) or table.get("target_margin", FIRM),
            table.get("hinge_play", play),
            table.get("strain_limit", 0.0),
        )
        return RatioRule(chosen, target=target)
    number = {
        "Adaptive": {"share": table.get("ratio_share", DEFAULT_SHARE)},
        "Fixed": {"ratio": table.get("ratio", 0.5)},
    }
    return RatioRule(chosen, **number.get(chosen, {}))


def _stands(design: "Design") -> str:
    """How the print stands: as the file says, else as its process does."""
    process = PROCESSES[design.get("hinges", "process", STANDOFFS)]
    return str(design.get("hinges", "orientation", process.orientation))


def _check(design: "Design") -> None:
    """`DesignError` where the files of a design need FreeCAD."""
    needs = ""
    test = next((table for table in TEST_PRINTS if table in design.tables), "")
    if test:
        needs = f"[{test}]"
    elif design.get("design", "make_printable", False):
        needs = "[design] make_printable"
    elif _stands(design) != "Flat" or design.get("hinges", "support"):
        needs = "[hinges] orientation OnEdge or support"
    elif set(design.get("output", "print_states", ["flat"])) != {"flat"}:
        needs = "[output] print_states"
    else:
        other = [suffix for suffix in design.formats if suffix not in (*MESHES, *NETS)]
        needs = f"[output] formats {', '.join(other)}" if other else ""
    if needs:
        raise DesignError(
            f"{design.path}: {needs} needs FreeCAD, which was not found: install it, or leave "
            "that out."
        )


def _ends(design: "Design") -> Ends:
    """The `Ends` that a hinge set of a document would have."""
    table = design.tables.get("hinges", {})
    sizes = ("dowel_diameter", "magnet_diameter", "magnet_depth", "screw_diameter")
    joint = Joint(
        table.get("joint", Joint.kind),
        **{key: table[key] for key in sizes if key in table},
        strain=material(PLA).snap_strain,
    )
    ends = Ends.start, Ends.end, Ends.thickness
    keys = "start_part", "end_part", "plate_thickness"
    usual = Plane()
    ground = Plane(tuple(table.get("foot_point", usual.point)),
                   tuple(table.get("foot_normal", usual.normal)))  # fmt: skip
    start, end, thickness = (table.get(key, value) for key, value in zip(keys, ends, strict=True))
    return Ends(joint, start, end, thickness, ground)


def _drawn(design: "Design", wanted: TubeDesign, parameters: "HingeParameters") -> "list[Drawn]":
    """Bodies of the print, or of the part of it that is asked for."""
    parameters.check()
    whole = wanted.thick()
    count = len(whole.tube)
    first = design.get("hinges", "first_unit", 1) - 1
    last = (design.get("hinges", "last_unit", 0) or count) - 1
    left = whole.tube.incoming_left
    if not 0 <= first <= last < count:
        raise DesignError(
            f"{design.path}: [hinges] first_unit and last_unit do not name units of a tube of "
            f"{count}; set last_unit to at most {count}."
        )
    given, ends = (whole.thick, parameters, first, last, left), _ends(design)
    deployed = whole.part(first, last).motions(1.0) if ends.has_feet else None
    return part_drawn(*given, ends=ends, closed=whole.is_closed, deployed=deployed).bodies


def _pillars(drawn: "list[Drawn]", parameters: "HingeParameters") -> list[Body]:
    """The loose pillars of the print, as one body, if it has some."""
    found = propped_print(drawn, parameters).pillars
    if not found:
        return []
    body = Drawn("pillars", boundary_of(found), np.eye(4), 0, (), "foot")
    return [Body("pillars", body, (), None, "foot")]
