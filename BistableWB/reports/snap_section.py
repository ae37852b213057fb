# SPDX-License-Identifier: LGPL-2.1-or-later
"""Will it snap, will it stand: a tube's study in plain words and as a table of its units."""

import numpy as np

from ..origami.errors import Choice, joined, phrase
from ..origami.snap.forces import ON_EDGE
from ..slicing.section import Section

_COLUMNS = (
    phrase("barrier"),
    phrase("opened by"),
    phrase("folded back by"),
    phrase("stress"),
    phrase("bends freely"),
    phrase("twists freely"),
    phrase("safety"),
)
_NOTHING = 0.05  # N·mm: no snap
_ENOUGH = 1.2  # safety factor; slop as a share of the length below
_STEADY = 0.02
_HELD = phrase(
    "set {SegmentWidth} to 5 mm and {PreloadRule} to Automatic (three knuckles have their cones "
    "too far from the ends of a hinge for that)"
)
_LINEAR = 0.1  # of the length: what a linear law tells of the sag


def snap_section(study, conditions):
    """`Section` of a `snap.study.Study` under its `snap.study.Conditions`."""
    told = [_snaps(study), _breaks(study, conditions), _wobbles(study), _stands(study, conditions)]
    return Section(
        phrase("Will it snap, will it stand?"),
        joined([one for one in told if one], " "),
        _COLUMNS,
        [_row(study, k) for k in range(len(study.units))],
    )


def _row(study, k):
    unit, slop, load = study.units[k], study.slop, study.load
    return [
        f"{unit.barrier:.1f} N·mm",
        f"{unit.hand:.2f} N",
        f"{unit.closing_torque / unit.lever:.2f} N",
        f"{unit.weakest.share:.0%}",
        f"± {np.degrees(slop.bend[k]):.2f}°",
        f"± {np.degrees(slop.twist[k]):.2f}°",
        phrase("holds") if load.factors[k] > 99 else f"{load.factors[k]:.2g}",
    ]


def _snaps(study):
    units, weakest = study.units, study.order[0]
    limp = [k + 1 for k, unit in enumerate(units) if unit.barrier < _NOTHING]
    if limp:
        return _limp(study, limp)
    return phrase(
        "Every unit snaps. Hands that pull ‖AB‖ = {lever:.0f} mm from the leg at B open the "
        "weakest, unit {unit}, with {force:.1f} N; units open one after another, the weakest "
        "first: {order}.",
        lever=units[0].lever,
        unit=weakest + 1,
        force=units[weakest].hand,
        order=_listed([k + 1 for k in study.order], 6),
    )


def _limp(study, limp):
    why = (
        phrase("strips of TPU take more to bend than the panels resist.")
        if study.flexible
        else phrase(
            "the hinges' play swallows it. A smaller {GapLength} or ratio, or a larger "
            "{EdgeLength} help."
        )
    )
    return phrase(
        "Unit {units} does not snap: {why}"
        if len(limp) == 1
        else "Units {units} do not snap: {why}",
        units=_listed(limp, 8),
        why=why,
    )


def _breaks(study, conditions):
    k = int(np.argmax([unit.weakest.share for unit in study.units]))
    worst = study.units[k].weakest
    if not worst.hinge:
        return None
    where = phrase(
        "the strip of hinge {hinge} of unit {unit}"
        if study.flexible
        else "knuckle {knuckle} of {body} on hinge {hinge} of unit {unit}",
        knuckle=worst.knuckle,
        body=worst.body,
        hinge=worst.hinge,
        unit=k + 1,
    )
    name = "TPU" if study.flexible else conditions.material.name
    pieces = {
        "where": where,
        "stress": worst.stress,
        "share": worst.share,
        "material": Choice(name),
    }
    if worst.share > 1:
        return phrase(
            "It would break where it snaps: {where} bears {stress:.0f} MPa, {share:.1f} times what "
            "{material} bears printed on edge; a larger ratio, thicker panels or another "
            "orientation help."
            if conditions.orientation == ON_EDGE
            else "It would break where it snaps: {where} bears {stress:.0f} MPa, {share:.1f} times "
            "what {material} bears printed flat; a larger ratio, thicker panels or another "
            "orientation help.",
            **pieces,
        )
    return phrase(
        "The hardest worked place, {where}, bears {stress:.0f} MPa of {material}, {share:.0%} of "
        "its strength.",
        **pieces,
    )


def _wobbles(study):
    if study.flexible:
        return phrase("Strips have no play: deployed, nothing moves before something bears.")
    return phrase(
        "Deployed, before anything bears, the free end moves by up to {end:.1f} mm ({share:.1%} of "
        "the length; {usual:.1f} mm as a rule)."
        if study.slop_share <= _STEADY
        else "Deployed, before anything bears, the free end moves by up to {end:.1f} mm "
        "({share:.1%} of the length; {usual:.1f} mm as a rule): {cure}, or make {GapLength} "
        "smaller.",
        cure=phrase("set {PreloadRule} to Automatic") if study.holds else _HELD,
        end=study.slop.end,
        share=study.slop_share,
        usual=study.slop.usual,
    )


def _stands(study, conditions):
    load, k = study.load, study.load.weakest
    held = phrase(
        "It weighs {weight:.0f} g; its free end gives way elastically by {sag}. Held by its first "
        "block, gravity along {gravity},"
        if conditions.fixed == "Start"
        else "It weighs {weight:.0f} g; its free end gives way elastically by {sag}. Held at both "
        "ends, gravity along {gravity},",
        weight=load.weight,
        sag=_sag(study),
        gravity=_way(conditions.gravity),
    )
    told = _carries(load, k) if load.stands else _folds(study, k)
    return joined([held, told, _turned(load)], " ")


def _turned(load):
    """Of all directions of gravity the worst."""
    factor = float(load.turned.min())
    pieces = {"unit": load.first_turned + 1, "factor": factor}
    if factor >= 1:
        return phrase(
            "Turned whatever way, no unit folds below {factor:.1f} times its load (unit {unit}).",
            **pieces,
        )
    return phrase(
        "Turned the worst way, unit {unit} would fold at {factor:.2f} times its load.", **pieces
    )


def _carries(load, k):
    more = phrase(" and bears {force:.2f} N more at its free end", force=load.free)
    return phrase(
        "it carries itself: unit {unit} would give way first, at {factor:.1f} times its load{more}."
        if load.factors.min() >= _ENOUGH
        else "it carries itself, barely: unit {unit} would give way first, at {factor:.1f} times "
        "its load{more}.",
        unit=k + 1,
        factor=load.factors[k],
        more=more if load.free > 0 else "",
    )


def _folds(study, k):
    load, closing = study.load, study.units[k].closing_torque
    told = phrase(
        "it does not carry itself: unit {unit} folds at {factor:.2f} times the weight.",
        unit=k + 1,
        factor=load.factors[k],
    )
    if load.moments[k] < 0:
        cure = phrase(
            "It is bent open, beyond its stop: a larger {EdgeLength} or both ends held ({FixedAt}) "
            "help."
        )
    else:
        cure = phrase(
            "It folds back at {closing:.0f} N·mm and needs {wanted:.1f} times that: aim at it "
            "(fitting.aim, carry=1.5), make {TargetMargin} or {EdgeLength} larger, the tube "
            "shorter, or hold both ends ({FixedAt}).",
            closing=closing,
            wanted=np.abs(load.moments[k]) / max(closing, 1e-9),
        )
    return joined([told, cure], " ")


def _sag(study):
    """The free end's elastic give: a linear law, which large ones pass."""
    most, sag = _LINEAR * study.length, study.load.sag
    if sag > most:
        return phrase("more than {most:.0f} mm (further than a linear law tells)", most=most)
    return phrase("about {sag:.1f} mm", sag=sag)


def _way(gravity):
    return "(" + ", ".join(f"{value:g}" for value in gravity) + ")"


def _listed(units, most):
    return ", ".join(map(str, units[:most])) + (" …" if len(units) > most else "")
