# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundaries of the links of double hinges ("offset crease" in the paper): dogbones and a spine.

Section (n outwards, away from the panels; v along the stack): a barrel on each axis, a web between
them, and outside the reach of the panels' knuckles a spine that makes all dogbones one body.
"""

import itertools
from collections.abc import Sequence
from math import asin, copysign, cos, pi, sin, sqrt
from typing import TYPE_CHECKING, Any

from . import polygons
from .drafting import Draft
from .knuckles import at, pivot_faces
from .link_section import link_section

if TYPE_CHECKING:
    from .boundary import Boundary
    from .parameters import HingeParameters
    from .unit_layout import Link

_SAME = 1e-9  # mm by which two motions may differ and be one


def link_boundary(link: "Link", parameters: "HingeParameters") -> "Boundary":
    """`Boundary` of one `Link` in the unit's flat frame."""
    draft = Draft()
    axis = polygons.unit(sum(hinge.direction for hinge in link.hinges))
    turn = copysign(1, polygons.cross(axis, link.outward))
    before: Any = None
    holes_before: Any = None
    for index in range(1, len(link.hinges[0].segments), 2):
        start, end = (_Section(draft, link, parameters, index, k) for k in (0, 1))
        made = [pivot_faces(draft, h, parameters, index, axis, {}) for h in link.hinges]
        holes = [[loop for of_hinge in made for loop in of_hinge[k]] for k in (0, 1)]
        if before is None:
            start.face(start.dogbone, -turn, holes[0])
        else:
            hollow = before.hollow(), start.hollow()
            before.face(before.shoulder(hollow[0]), turn, holes_before)
            start.face(start.shoulder(hollow[1]), -turn, holes[0])
            sweep(draft, before, start, before.back + hollow[0], start.back + hollow[1], turn)
        sweep(draft, start, end, start.dogbone, end.dogbone, turn)
        before, holes_before = end, holes[1]
    before.face(before.dogbone, turn, holes_before)
    return draft.boundary()


def sweep(
    draft: Draft,
    first: "_Section",
    second: "_Section",
    edges: Sequence[int],
    others: Sequence[int],
    turn: float,
) -> None:
    """Side faces between the same edges of two sections, run through alike."""
    moves = [b - a for a, b in zip(first.centres, second.centres, strict=True)]
    alike = abs(moves[0] - moves[1]) < _SAME
    for a, b in zip(edges, others, strict=True):
        flat = alike or first.of_one_axis(a)
        draft.ruled(a, b, turn, flat=flat and first.is_line(a))


class _Section:
    """Vertices and edges of a link's section at one end (0, 1) of dogbone ``index``."""

    def __init__(
        self, draft: Draft, link: "Link", parameters: "HingeParameters", index: int, end: int
    ) -> None:
        self.draft, self.link, self.size = draft, link, link_section(parameters)
        self.radius = parameters.radius
        self.centres = [hinge.point(hinge.segments[index][end]) for hinge in link.hinges]
        self._axes: dict[int, int] = {}
        self._round: set[int] = set()
        r, w, clear, outer = self.radius, self.size.web, self.size.clear, self.size.outer
        q = sqrt(r * r - w * w)
        places = ((r, 0), (-w, q), (clear, 0), (outer, 0))
        self.start, self.foot, self.neck, self.edge = (
            [self._vertex(which, n, v) for which in (0, 1)] for n, v in places
        )
        barrels = self._barrels(w, q)
        collar = [self._line(self.start[k], self.neck[k]) for k in (0, 1)]
        self.back = [
            self._line(self.neck[1], self.edge[1]),
            self._line(self.edge[1], self.edge[0]),
            self._line(self.edge[0], self.neck[0]),
        ]
        self.front = [*barrels, collar[1]], ~collar[0]
        self.dogbone = [*self.front[0], *self.back, self.front[1]]

    def shoulder(self, hollow: Sequence[int]) -> list:
        """Closed section of a dogbone less the spine."""
        return [*self.front[0], *(~edge for edge in reversed(hollow)), self.front[1]]

    def hollow(self) -> list:
        """Inner side of the spine, clear of the panels' knuckles, from the lower neck up."""
        clear, inner = self.size.clear, self.size.inner
        high = sqrt(clear * clear - inner * inner)
        low, top = (self._vertex(which, inner, high) for which in (0, 1))
        sweep_angle = asin(high / clear)
        lower = self._arc(0, self.neck[0], low, (clear, 0), (0, clear), sweep_angle)
        rise = self._line(low, top)
        upper = self._arc(1, top, self.neck[1], (inner, -high), (high, inner), sweep_angle)
        return [lower, rise, upper]

    def face(self, loop: Sequence[int], side: float, holes: Sequence[Sequence[int]]) -> None:
        """Plane face within a closed section, seen from outside as it runs (1) or backwards."""
        if side < 0:
            loop = [~ref for ref in reversed(loop)]
        self.draft.plane(loop, *holes)

    def of_one_axis(self, edge: int) -> bool:
        """Whether all of an edge moves with one of the two axes."""
        start = self.draft.start(edge), self.draft.start(~edge)
        return self._axes[start[0]] == self._axes[start[1]]

    def is_line(self, edge: int) -> bool:
        """Whether an edge of this section is straight."""
        return edge not in self._round

    def _barrels(self, w: float, q: float) -> list[int]:
        """Barrel of the lower axis, the web, barrel of the upper axis, a crest on one of them."""
        r = self.radius
        turn = pi + asin(q / r)
        width, height, up = self.link.crest or (0.0, 0.0, 0)
        lower = self._barrel(
            0, (self.start[0], self.foot[0]), ((r, 0), (0, -r)), turn,
            (pi / 2, width, height) if up < 0 else None,
        )  # fmt: skip
        web = self._line(*self.foot)
        # the upper one starts at (−w, −q) and runs over the top, clockwise
        upper = self._barrel(
            1, (self.foot[1], self.start[1]), ((-w, -q), (-q, w)), turn,
            (turn - pi / 2, width, height) if up > 0 else None,
        )  # fmt: skip
        return [*lower, web, *upper]

    def _barrel(
        self,
        which: int,
        ends: tuple[int, int],
        axes: tuple[tuple[float, float], tuple[float, float]],
        turn: float,
        crest: tuple[float, float, float] | None,
    ) -> list[int]:
        """Edges of a barrel: an arc, or two with a crest ``(where along, width, height)``."""
        if crest is None:
            return [self._arc(which, *ends, *axes, turn)]
        middle, width, height = crest
        half = asin(width / 2 / self.radius)
        away = self.radius + height
        foot = [self._turned(axes, middle + sign * half) for sign in (-1, 1)]
        out, along = (
            self._turned(axes, middle, away),
            self._turned(axes, middle + pi / 2, width / 2),
        )
        tops = [tuple(o + sign * a for o, a in zip(out, along, strict=True)) for sign in (-1, 1)]
        # (n, upwards) of an axis is n and, towards the other axis, its height the other way above
        towards = 1 if which == 0 else -1
        corners = [
            self._vertex(which, n, towards * up) for n, up in (foot[0], tops[0], tops[1], foot[1])
        ]
        first = self._arc(which, ends[0], corners[0], *axes, middle - half)
        lines = [self._line(a, b) for a, b in itertools.pairwise(corners)]
        rest = self._turned(axes, middle + half), self._turned(axes, middle + half + pi / 2)
        return [
            first, *lines, self._arc(which, corners[3], ends[1], *rest, turn - middle - half),
        ]  # fmt: skip

    def _turned(
        self,
        axes: tuple[tuple[float, float], tuple[float, float]],
        angle: float,
        radius: float | None = None,
    ) -> tuple[float, float]:
        """(n, upwards) at an angle along an arc with these axes."""
        share = (radius or self.radius) / self.radius
        (a, b), (c, d) = axes
        return (
            share * (cos(angle) * a + sin(angle) * c),
            share * (cos(angle) * b + sin(angle) * d),
        )

    def _vertex(self, which: int, n: float, v: float) -> int:
        """Vertex n outwards and v towards the other axis, from the lower or upper axis."""
        height = self.link.hinges[which].height + (v if which == 0 else -v)
        found = self.draft.vertex(at(self.centres[which] + n * self.link.outward, height))
        self._axes[found] = which
        return found

    def _line(self, a: int, b: int) -> int:
        return self.draft.line(a, b)

    def _arc(
        self,
        which: int,
        a: int,
        b: int,
        along: Sequence[float],
        across: Sequence[float],
        turn: float,
    ) -> int:
        """Arc about an axis; ``along``, ``across``: (n, upwards) of radii."""
        centre = at(self.centres[which], self.link.hinges[which].height)
        out = self.link.outward
        radii = [(n * out.real, up, n * out.imag) for n, up in (along, across)]
        edge = self.draft.arc(a, b, centre, radii[0], radii[1], turn)
        self._round.add(edge)
        return edge
