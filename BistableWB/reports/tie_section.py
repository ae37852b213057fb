# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sections of a report on ties and pillars: how many, and how they come off."""

from collections import defaultdict

from ..origami.errors import phrase
from ..origami.hinges.pillars import BED as ON_BED
from ..origami.hinges.ties import BED, breaking_force, knuckle_bears
from .snap_section import Section

TITLE = phrase("Where to cut")
PILLARS = phrase("Loose pillars")
_COLUMNS = (phrase("held"), phrase("by"), phrase("ties"), phrase("cut at heights, mm"))
_MOST = 60  # rows


def tie_section(tied, names, plastic, parameters, material):
    """`Section` on `tying.Tied` ties of bodies with ``names``.

    ``plastic``: volume of the bodies, mm³; ``parameters``: `HingeParameters`; ``material``:
    `materials.Material`.
    """
    cuts = defaultdict(list)
    for tie in tied.ties:
        cuts[names[tie.holds], "" if tie.on == BED else names[tie.on]].append(tie.head[2])
    volume = sum(tie.boundary().volume for tie in tied.ties)
    text = phrase(
        "{count} ties hold what begins in mid-air in {places} places; {left:.2f} mm² are left. "
        "They take {taken:.2f} cm³, {share:.1%} of the plastic. Each comes off at its necks, "
        "{neck:g} mm square, by {force:.1f} N at most; a knuckle bears {bears:.0f} N. They are the "
        "green ones in the picture: run a blade between the bodies below, from the outside "
        "inwards, before the first unit is opened.",
        count=len(tied.ties),
        places=len(tied.starts),
        left=tied.left_area,
        taken=volume / 1000,
        share=volume / plastic,
        neck=parameters.nozzle_diameter,
        force=breaking_force(parameters.nozzle_diameter, material),
        bears=knuckle_bears(parameters.face_thickness, material),
    )
    rows = [
        [
            held,
            by or phrase("the bed"),
            str(len(heights)),
            ", ".join(f"{z:.0f}" for z in sorted(heights)[:12]),
        ]
        for (held, by), heights in sorted(cuts.items())[:_MOST]
    ]
    return Section(TITLE, text, _COLUMNS, rows)


def pillar_section(propped, plastic):
    """`Section` on `propping.Propped` pillars; ``plastic``: volume of the bodies, mm³."""
    pillars = propped.pillars
    volume = sum(pillar.boundary().volume for pillar in pillars)
    text = phrase(
        "{count} loose pillars hold what reaches beyond the panels below, in {places} places; "
        "{left:.2f} mm² are left. They take {taken:.2f} cm³, {share:.1%} of the plastic, keep a "
        "layer of air from everything and fall out when the tube is opened for the first time: "
        "open it a little, and shake. {bed} stand on the bed.",
        count=len(pillars),
        places=propped.starts,
        left=propped.left_area,
        taken=volume / 1000,
        share=volume / plastic,
        bed=sum(pillar.on == ON_BED for pillar in pillars),
    )
    return Section(PILLARS, text, (), [])
