# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three steps of the search of `auto_fit`."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import degrees, radians
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import rigid
from ..curves.crossing import CurveTable
from ..design import Thickness, TubeDesign
from ..errors import Refusal
from ..snap.bearing import Preloader
from ..snap.contact import holding
from ..snap.margin import assess
from ..snap.table import SHARES as TABLE_SHARES
from ..snap.table import at
from ..thick import print_stack
from ..thick.linkage import ThickUnit
from ..units.angles import angles_for, exact_sphere_ratio
from .terms import Candidate, Trial, rule_of, target_of

if TYPE_CHECKING:
    from ..curves.curve import Curve
    from ..curves.placement import Placement
    from ..progress import Progress
    from ..snap.margin import Snap
    from ..units.tube import Tube
    from .terms import Course, Refusals, Wanted

EDGES = 8
GAMMAS = tuple(radians(g) for g in (12, 16, 20, 25, 30, 36))
SHARES = (0.02, 0.03, 0.045, 0.07, 0.1, 0.15)
LEAST_COVERAGE = 0.75
_MEASURED = 10  # candidates
# What the table leaves of margins (more on a sphere), so that few measurements are in vain.
_GUARDS = {"Adaptive": 1.03, "TargetSnap": 0.97, "Exact": 0.95}
# Of the wanted margin: what two units need so that all are measured, and what all need.
_NEAR, _SHORT = 0.9, 0.95


# -- step 1: placements -------------------------------------------------------------------------


def edge_lengths(length: float, wanted: "Wanted") -> NDArray:
    """Edge lengths to try (mm): from as many units as the bed is high to a few on the curve."""
    most = max(2.0, (wanted.bed[2] + wanted.gap_between_planes) / (4 * wanted.pitch))
    low = max(length / (0.6 * most), 10 * wanted.pitch)
    high = min(max(wanted.bed[:2]) - 2 * wanted.reach, length / 1.5)
    return np.geomspace(min(low, high / 1.5), high, EDGES)


def placed_trials(
    course: "Course", wanted: "Wanted", refusals: "Refusals", progress: "Progress"
) -> tuple[list[Trial], int]:
    """Trials, without a rule yet, that follow the curve and fit the bed; and how many tried."""
    table = CurveTable(course.curve, 1e9)
    length = float(table.lengths[-1])
    edges = edge_lengths(length, wanted)
    trials = []
    for i, edge in enumerate(edges):
        progress.step(f"Placing triangles, EdgeLength {edge:.0f} mm", 0.2 * i / len(edges))
        for gamma in GAMMAS:
            trial = _place(course, wanted, float(edge), gamma, length, refusals)
            if trial is not None:
                trials.append(trial)
    return trials, len(edges) * len(GAMMAS)


def _place(
    course: "Course",
    wanted: "Wanted",
    edge: float,
    gamma: float,
    length: float,
    refusals: "Refusals",
) -> Trial | None:
    try:
        placing = course.placing(edge, gamma, wanted)
        placed = placing.placement()
    except Refusal as error:
        refusals.add("curve", error)
        return None
    widest = placed.thetas.max()
    height = wanted.height(len(placed))
    if placed.followed < LEAST_COVERAGE * placed.length:
        refusals.add("coverage", placed.followed / placed.length)
    elif course.family == "Sphere" and widest >= radians(60):
        refusals.add("sphere", degrees(widest))
    elif height > wanted.bed[2]:
        refusals.add("height", height)
    elif not wanted.holds(*_plan(placed, wanted)):
        refusals.add("plan", edge)
    else:
        deviation = _deviation(course.curve, placed)
        return Trial(placing, placed, deviation, length, "Exact")
    return None


def _plan(placed: "Placement", wanted: "Wanted") -> tuple[float, float]:
    """Length and width of the print in plan, about (mm)."""
    low = np.sin(placed.thetas / 2)
    alpha, _, _ = angles_for(placed.thetas, low + 0.05 * (1 - low))
    apex = placed.edge_length * ((1 + low) * np.cos(alpha) / 2 * np.sin(alpha)).max()
    strip = placed.edge_length / wanted.height_ratio
    return placed.edge_length + 2 * wanted.reach, strip + 2 * apex + 2 * wanted.reach


def _deviation(curve: "Curve", placed: "Placement", samples: int = 9) -> float:
    """Largest distance (mm) of the curve from the chords between the blocks' midpoints."""
    ends = placed.parameters
    share = np.linspace(0, 1, samples)
    s = ends[:-1, None] + share * np.diff(ends)[:, None]
    points = np.asarray(curve.point(s.ravel()), float).reshape(*s.shape, 3)
    start, chord = points[:, :1], points[:, -1:] - points[:, :1]
    along = ((points - start) * chord).sum(-1) / (chord**2).sum(-1)
    return float(np.linalg.norm(points - start - along[..., None] * chord, axis=-1).max())


# -- step 2: snap by the table ------------------------------------------------------------------


def looked_up(
    course: "Course", wanted: "Wanted", trials: Sequence[Trial], refusals: "Refusals"
) -> list[Trial]:
    """The trials with every rule that there is, those that snap as wanted."""
    variants = _on_sphere if course.family == "Sphere" else _variants
    found = [variant for trial in trials for variant in variants(trial, wanted)]
    firm = [t for t in found if t.margin >= _GUARDS[t.rule] * wanted.margin]
    if found and not firm:
        refusals.add("margin", max(t.margin for t in found))
    kept = [t for t in firm if wanted.bears(t.strain)]
    if firm and not kept:
        refusals.add("strain", min(t.strain for t in firm))
    return kept


def _variants(trial: Trial, wanted: "Wanted") -> Iterator[Trial]:
    """A trial with each rule, and the snap of its narrowest and widest unit."""
    edge, thetas = trial.placed.edge_length, trial.placed.thetas
    ends = np.array([thetas.min(), thetas.max()])
    for share in SHARES:
        plays, strains = at(ends, share, wanted.pitch / edge)
        yield _variant(trial, "Adaptive", share, plays.min() * edge / wanted.play, strains.max())
    try:
        choice = target_of(wanted, edge).choose(ends)
    except Refusal:
        return
    yield _variant(trial, "TargetSnap", None, choice.achieved.min(), choice.strain.max())


def _on_sphere(trial: Trial, wanted: "Wanted") -> Iterator[Trial]:
    """A trial with the one rule of a sphere, and the snap of plane units with the same ratios."""
    edge, thetas = trial.placed.edge_length, trial.placed.thetas
    ends = np.array([thetas.min(), thetas.max()])
    low = np.sin(ends / 2)
    shares = np.clip(
        (exact_sphere_ratio(ends) - low) / (1 - low), TABLE_SHARES[0], TABLE_SHARES[-1]
    )
    plays, strains = at(ends, shares, wanted.pitch / edge)
    yield _variant(trial, "Exact", None, plays.min() * edge / wanted.play, strains.max())


def _variant(trial: Trial, rule: str, share: float | None, margin: float, strain: float) -> Trial:
    return replace(trial, rule=rule, share=share, margin=float(margin), strain=float(strain))


# -- step 3: measurements -----------------------------------------------------------------------


def measured(
    wanted: "Wanted", trials: Sequence[Trial], refusals: "Refusals", progress: "Progress"
) -> list[Candidate]:
    """`Candidate` objects of the most promising trials."""
    if not trials:
        return []
    used = [t.used(wanted, t.margin, t.strain) for t in trials]
    front = sorted(undominated(used), key=lambda i: sum(used[i]))
    if len(front) > _MEASURED:  # the best half, and some of the others evenly
        rest = np.linspace(_MEASURED // 2, len(front) - 1, _MEASURED - _MEASURED // 2)
        front = front[: _MEASURED // 2] + [front[round(i)] for i in rest]
    found = []
    for n, i in enumerate(front):
        progress.step(f"Measuring candidate {n + 1} of {len(front)}", 0.2 + 0.8 * n / len(front))
        candidate = _measure(wanted, trials[i], refusals)
        if candidate is not None:
            found.append(candidate)
    return found


def _measure(wanted: "Wanted", trial: Trial, refusals: "Refusals") -> Candidate | None:
    """The `Candidate` of a trial: its tube is made, and all its units are assessed.

    Its narrowest and its widest unit first: few tubes that fail do so elsewhere.
    """
    placed = trial.placed
    try:
        rule = rule_of(trial.rule, trial.share, wanted, placed.edge_length)
        parameters = wanted.parameters
        preload = None if parameters.has_knuckles else 0.0  # as new hinge sets have it
        panels = Thickness(wanted.face_thickness, wanted.gap_between_planes, True, preload,
                           parameters)  # fmt: skip
        design = TubeDesign(trial.placing, rule, wanted.height_ratio, panels)
        tube = design.tube()
        thick = ThickUnit(tube.unit, panels.face, panels.gap)
        size = _print_size(thick, tube, wanted)
        ends = np.unique([np.argmin(placed.thetas), np.argmax(placed.thetas)])
        snap = _assessed(Preloader(preload, parameters)(thick[ends].compensated()), wanted)
        if snap.margin.min() >= _NEAR * wanted.margin:
            snap = _assessed(design.thick().thick, wanted)
    except Refusal as error:
        refusals.add("units", error)
        return None
    margins, strain = np.atleast_1d(snap.margin), float(np.max(snap.strain))
    if margins.min() < _SHORT * wanted.margin:
        refusals.add("margin", float(margins.min()))
    elif not wanted.bears(strain):
        refusals.add("strain", strain)
    elif not wanted.holds(*size[:2]):
        refusals.add("plan", placed.edge_length)
    else:
        return _candidate(wanted, trial, margins, strain, size)
    return None


def _assessed(thick: ThickUnit, wanted: "Wanted") -> "Snap":
    return assess(thick, holding(thick, wanted.parameters), strain_limit=wanted.strain_limit)


def _candidate(
    wanted: "Wanted", trial: Trial, margins: NDArray, strain: float, size: tuple[float, ...]
) -> Candidate:
    placed = trial.placed
    return Candidate(
        placed.edge_length,
        trial.placing.gamma,
        trial.rule,
        trial.share,
        len(placed),
        (float(placed.thetas.min()), float(placed.thetas.max())),
        float(margins.min()),
        strain,
        int(margins.argmin()) + 1,
        size,
        placed.followed / placed.length,
        trial.deviation,
        trial.used(wanted, float(margins.min()), strain),
    )


def _print_size(thick: ThickUnit, tube: "Tube", wanted: "Wanted") -> tuple[float, ...]:
    """Length and width (to about 3 mm) and height of the flat-folded print, mm."""
    frames = print_stack.frames(thick, tube.incoming_left)
    flat = rigid.apply(frames, thick.unit.flat)
    plan = np.ptp(flat[..., :2].reshape(-1, 2), axis=0) + 2 * wanted.reach
    return float(plan[0]), float(plan[1]), float(wanted.height(len(tube)))


def undominated(rows: ArrayLike) -> list[int]:
    """Indices of rows (smaller is better) that no other row beats or equals in every column."""
    table = np.round(np.array(rows), 9)
    _, first = np.unique(table, axis=0, return_index=True)
    return [
        int(i) for i in first
        if not ((table <= table[i]).all(1) & (table < table[i]).any(1)).any()
    ]  # fmt: skip
