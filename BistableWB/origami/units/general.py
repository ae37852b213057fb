# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units for any curve in space: section 4 of the design notes, beyond the paper.

A unit between two planar contact quadrilaterals that share the leg at B exists whenever the legs
are parallel or all pass through one point V; the quadrilaterals need not be congruent. Unknowns
are the deployed C' and P (12) and the flat vertices (20); equations the equal lengths of 20 edges
and one diagonal a quadrilateral (24) and the planarity of the two deployed border panels (2).
On every solution these have rank 24, so each Gauss-Newton step is the minimum-norm solution of
the 24 leading equations. Units are independent: everything is batched over them.
"""

from collections.abc import Mapping
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..curves.bezier import normalised
from ..errors import require
from .closed_forms import Unit, plane_unit
from .contacts import check_opening, normalised_contacts
from .creases import INDEX, PANELS
from .shape import check_shape

_RANK = 24
_MAX_STEPS = 40
_SOLVED = 1e-13  # largest relative residual of an equation

_CONTACTS = {s: [INDEX[v] for v in PANELS[f"contact_{s}"]] for s in ("left", "right")}
_BORDERS = [[INDEX[v] for v in PANELS[f"border_{s}"]] for s in ("left", "right")]
_ENDS = ("upper", "lower")
_FREE = [INDEX[v] for v in ("C_upper", "C_lower", "P_upper", "P_lower")]


def general_unit(
    contact_left: NDArray, contact_right: NDArray | None, ratio: NDArray | float
) -> "Unit":
    """The isometric unit nearest to the symmetric one between two contact quadrilaterals.

    Parameters
    ----------
    contact_left, contact_right : (4, 3) or, for a batch, (n, 4, 3); corners A_upper, B_upper,
        B_lower, A_lower of the deployed contact panels. Each planar, with the same B corners, all
        legs parallel or through one point. They need not be congruent.
    ratio : c of the symmetric unit to start from, scalar or (n,). Plane and sphere contacts with
        their own ratio (any c; the exact rule) give `plane_unit` and `sphere_unit` again; other
        contacts change C' a little, and the unit's ``ratio`` is what came out.

    Returns a `Unit`: ``deployed`` where the contacts are, ``flat`` in the unit's flat frame (y = 0,
    A at the left, "upper" up). ``theta`` is the opening about the leg at B (between points of the
    legs that are level with B), ``alpha``, ``beta``, ``beta_prime``, ``ratio``, ``omega`` are means
    over the unit's panels (``omega`` None where the legs are parallel), ``edge_length`` and
    ``strip_height`` means over the batch.

    Seen from "upper", a `plane_unit` has its B on the right of the way from left to right. Contacts
    of the other hand are solved as well, but for thick panels turn that unit over: swap left and
    right (`contacts.contact_pairs` does).

    ValueError, naming the unit, for contacts that break these rules, a ratio that the opening does
    not allow, and contacts so oblique that panels would degenerate, flip or change their order.
    """
    single = np.ndim(contact_left) == 2
    quads, origin, scale = normalised_contacts(contact_left, contact_right)
    ratio = np.broadcast_to(np.asarray(ratio, float), len(scale))
    theta, deployed, flat = symmetric_start(quads, ratio)
    worst = solve(deployed, flat)
    # corners that were rounded far from the origin cannot be met more exactly than that
    rounding = np.finfo(float).eps * np.abs(origin).max(-1) / scale
    require(
        worst <= _SOLVED + rounding,
        "No isometric unit was found for the contacts{at} (residual {value:.2g}): make "
        "{EdgeLength} shorter, move {Ruling} nearer to square with the curve, or raise {Ratio}.",
        worst,
        parameter="EdgeLength",
    )
    flat = _in_flat_frame(flat)
    check_shape(deployed, flat)
    return _as_unit(deployed, flat, theta, origin, scale, single)


def symmetric_start(quads: NDArray, ratio: NDArray) -> tuple:
    """θ (n,), deployed (n, 10, 3) and flat (n, 10, 2) vertices of the unit to start from.

    C' is that of `plane_unit` on the triangle A', B, A', where A' is the point of A's leg level
    with B (across parallel legs; as far from V as B), moved along its leg to the line A-B of the
    flat state. P: see `_place_apex`. For plane and sphere contacts with their own ratio, and
    for parallel legs with both contacts oblique alike, the start solves all equations.
    """
    n = len(quads)
    deployed, flat = np.empty((n, 10, 3)), np.empty((n, 10, 2))
    laid = unfolded(quads)
    for k, side in enumerate(("left", "right")):
        deployed[:, _CONTACTS[side]] = quads[:, k]
        flat[:, _CONTACTS[side]] = laid[:, k]
    level, tilted, drop = bases(quads, laid)
    theta = _place_c(deployed, flat, ratio, level, drop)
    for end in _ENDS:
        _place_apex(deployed, flat, ratio, end, tilted[end])
    return theta, deployed, flat


class _Base(NamedTuple):
    """Isosceles triangle A, B, A of one end of the strip, and its flat line A-B.

    ``b`` (n, 3), unit vectors ``x`` from the middle of the A to B and ``z`` outward, ``length``
    ‖AB‖ and ``theta`` (n,); ``b_flat``, ``x_flat``, ``z_flat`` (n, 2) likewise.
    """

    b: np.ndarray
    x: np.ndarray
    z: np.ndarray
    length: np.ndarray
    theta: np.ndarray
    b_flat: np.ndarray
    x_flat: np.ndarray
    z_flat: np.ndarray


def _base(
    a: NDArray, b: NDArray, up: NDArray, a_flat: NDArray, b_flat: NDArray, sign: int
) -> _Base:
    """`_Base` from both A (n, 2, 3), B and the leg ``up`` at B; ``sign`` −1 at the lower end."""
    to_left, to_right = (normalised(a[:, k] - b) for k in (0, 1))
    inwards, across = to_left + to_right, to_right - to_left
    theta = 2 * np.arctan2(*(np.linalg.norm(v, axis=-1) for v in (across, inwards)))
    x = -normalised(inwards)
    z = np.cross(x, normalised(across))
    z *= sign * np.sign((z * up).sum(-1))[:, None]
    x_flat = normalised(b_flat - a_flat.mean(1))
    z_flat = sign * np.stack([-x_flat[:, 1], x_flat[:, 0]], -1)
    length = np.linalg.norm(a - b[:, None], axis=-1).mean(1)
    return _Base(b, x, z, length, theta, b_flat, x_flat, z_flat)


def bases(quads: NDArray, laid: NDArray) -> tuple:
    """Bases by end: level with B, and tilted to the mean height of A; that height, (n, 2 ends).

    ``laid``: the contacts by `unfolded`. A level A' lies where A' − B is square with the bisector
    of the legs at A and B.
    """
    a, b = quads[:, :, [0, 3]], quads[:, :, [1, 2]]
    a_flat, b_flat = laid[:, :, [0, 3]], laid[:, :, [1, 2]]
    leg_a, leg_b, leg_flat = (normalised(q[:, :, :1] - q[:, :, 1:]) for q in (a, b, a_flat))
    move = ((b - a) * (leg_a + leg_b)).sum(-1) / (1 + (leg_a * leg_b).sum(-1))
    mean = move.mean(1)
    found = []
    for shift in (move, move - mean[:, None]):
        moved, moved_flat = a + shift[..., None] * leg_a, a_flat + shift[..., None] * leg_flat
        found.append({
            end: _base(moved[:, :, e], b[:, 0, e], leg_b[:, 0, 0],
                       moved_flat[:, :, e], b_flat[:, 0, e], 1 - 2 * e)
            for e, end in enumerate(_ENDS)
        })  # fmt: skip
    return *found, -mean


def _place_c(
    deployed: NDArray, flat: NDArray, ratio: NDArray, level: Mapping[str, _Base], drop: NDArray
) -> NDArray:
    """Write C' of both ends; returns θ of the upper level base."""
    theta = level["upper"].theta
    check_opening(theta)
    i, j = INDEX["C_upper"], INDEX["B_upper"]
    for end, base in level.items():
        model = plane_unit(base.theta, ratio, 1.0, 1.0)
        for points, state, b, x in (
            (deployed, model.deployed, base.b, base.x), (flat, model.flat, base.b_flat, base.x_flat)
        ):  # fmt: skip
            along = (state[:, i, 0] - state[:, j, 0]) * base.length
            points[:, INDEX[f"C_{end}"]] = b + along[:, None] * x
    ends = [INDEX["C_upper"], INDEX["C_lower"]]
    for points in (deployed, flat):
        leg = normalised(points[:, ends[0]] - points[:, ends[1]])
        points[:, ends] += ((1 - ratio)[:, None] * drop)[..., None] * leg[:, None]
    return theta


def _place_apex(deployed: NDArray, flat: NDArray, ratio: NDArray, end: str, base: _Base) -> None:
    """Write P of one end, deployed and flat, for C' given.

    In the mirror plane of the base (origin between the A, ‖AB‖ = 1) equal distances to A, B and C'
    put P on the line 2 P·(C' − c B) = 2 c σ + C'² − σ − c², and p_x = P·B + σ in the flat state.
    The start takes the point of that line with the apex height p_z of `plane_unit`.
    """
    model = plane_unit(base.theta, ratio, 1.0, 1.0)
    height = model.flat[:, INDEX["P_upper"], 2] - 0.5
    near = model.deployed[:, INDEX["P_upper"]][:, [0, 2]] - [0, 0.5]
    sigma = np.sin(base.theta / 2) ** 2
    b = np.stack([np.cos(base.theta / 2), 0 * sigma], -1)
    middle = base.b - (base.length * b[:, 0])[:, None] * base.x
    offset = (deployed[:, INDEX[f"C_{end}"]] - middle) / base.length[:, None]
    c = np.stack([(offset * base.x).sum(-1), (offset * base.z).sum(-1)], -1)

    normal = c - ratio[:, None] * b
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    span = np.linalg.norm(c - ratio[:, None] * b, axis=-1)
    distance = (ratio * sigma + (_dot(c, c) - sigma - ratio**2) / 2) / span
    near = near + (distance - _dot(near, normal))[:, None] * normal
    along = np.stack([-normal[:, 1], normal[:, 0]], -1)
    along *= np.sign(along[:, 1:])
    x = _dot(near, b) + sigma
    p, q = 1 - _dot(along, b) ** 2, _dot(near, along) - x * _dot(along, b)
    r = _dot(near, near) + sigma - x * x - height**2
    near = near - (r / (q + np.sqrt(np.maximum(q * q - p * r, 0))))[:, None] * along

    x = _dot(near, b) + sigma
    z = np.sqrt(np.maximum(_dot(near, near) + sigma - x * x, 0))
    length = base.length[:, None]
    deployed[:, INDEX[f"P_{end}"]] = middle + length * (near[:, :1] * base.x + near[:, 1:] * base.z)
    flat[:, INDEX[f"P_{end}"]] = base.b_flat + length * (
        (x - 1)[:, None] * base.x_flat + z[:, None] * base.z_flat
    )


def _dot(a: NDArray, b: NDArray) -> NDArray:
    return (a * b).sum(-1)


def unfolded(quads: NDArray) -> NDArray:
    """Contacts laid flat, left of their leg at B, which runs up the axis x = 0: (n, 2, 4, 2)."""
    b, b_low = quads[:, :, 1:2], quads[:, :, 2:3]
    up = normalised(b - b_low)
    height = ((quads - (b + b_low) / 2) * up).sum(-1)
    away = np.linalg.norm(np.cross(quads - b_low, up), axis=-1)
    away[:, :, 1:3] = 0
    return np.stack([-away, height], -1)


def _pairs() -> NDArray:
    """The 20 edges and one diagonal of each quadrilateral, as index pairs (24, 2)."""
    found = set()
    for corners in PANELS.values():
        loop = [INDEX[v] for v in (*corners, corners[0])]
        found |= {tuple(sorted(edge)) for edge in pairwise(loop)}
        if len(corners) == 4:
            found.add(tuple(sorted((loop[0], loop[2]))))
    return np.array(sorted(found)).T


_I, _J = _pairs()
_ROWS = np.arange(len(_I))


def solve(deployed: NDArray, flat: NDArray) -> NDArray:
    """Gauss-Newton in place; returns the largest relative residual of each unit (n,)."""
    worst = np.full(len(flat), np.inf)
    active = np.arange(len(flat))
    for _ in range(_MAX_STEPS):
        residual, jacobian = _equations(deployed[active], flat[active])
        worst[active] = np.abs(residual).max(1)
        going = (worst[active] > _SOLVED) & (worst[active] < 1e3)
        active, residual, jacobian = active[going], residual[going], jacobian[going]
        if not len(active):
            break
        step = _minimum_norm(jacobian, residual)
        deployed[active[:, None], _FREE] -= step[:, :12].reshape(-1, 4, 3)
        flat[active] -= step[:, 12:].reshape(-1, 10, 2)
    return np.where(np.isfinite(worst), worst, np.inf)


def _minimum_norm(jacobian: NDArray, residual: NDArray) -> NDArray:
    """Shortest step that solves the leading `_RANK` equations of each unit: (n, 32)."""
    transposed = jacobian.transpose(0, 2, 1)
    values, vectors = np.linalg.eigh(jacobian @ transposed)
    values, vectors = values[:, -_RANK:], vectors[:, :, -_RANK:]
    weights = vectors.transpose(0, 2, 1) @ residual[..., None]
    weights /= np.maximum(values, 1e-30)[..., None]
    return (transposed @ (vectors @ weights))[..., 0]


def _equations(deployed: NDArray, flat: NDArray) -> tuple[NDArray, NDArray]:
    """Residuals (n, 26) and their Jacobian (n, 26, 32) by C', P deployed and all flat vertices.

    Lengths: half the difference of squares over the deployed square. Planarity: volume of the
    border's corners over that of its edges at A_upper.
    """
    n, m = len(flat), len(_I)
    residual = np.empty((n, m + 2))
    by_deployed, by_flat = np.zeros((n, m + 2, 10, 3)), np.zeros((n, m + 2, 10, 2))
    after, before = deployed[:, _I] - deployed[:, _J], flat[:, _I] - flat[:, _J]
    square = (after * after).sum(-1)
    ratio = (before * before).sum(-1) / square
    residual[:, :m] = (1 - ratio) / 2
    after *= (ratio / square)[..., None]
    before /= -square[..., None]
    by_deployed[:, _ROWS, _I], by_deployed[:, _ROWS, _J] = after, -after
    by_flat[:, _ROWS, _I], by_flat[:, _ROWS, _J] = before, -before
    for row, corners in enumerate(_BORDERS, m):
        a, c, c_low, a_low = (deployed[:, i] for i in corners)
        u, v, w = c - a, c_low - a, a_low - a
        size = np.prod([np.linalg.norm(edge, axis=-1) for edge in (u, v, w)], axis=0)[:, None]
        by_u, by_v, by_w = np.cross(v, w) / size, np.cross(w, u) / size, np.cross(u, v) / size
        # The size is held fixed here: its change is weighted by a residual that vanishes.
        residual[:, row] = (u * by_u).sum(-1)
        for i, by in zip(corners, (-(by_u + by_v + by_w), by_u, by_v, by_w), strict=True):
            by_deployed[:, row, i] = by
    free = by_deployed[:, :, _FREE].reshape(n, m + 2, 12)
    return residual, np.concatenate([free, by_flat.reshape(n, m + 2, 20)], -1)


def _in_flat_frame(flat: NDArray) -> NDArray:
    """Flat vertices (n, 10, 3): y = 0, x from the A_upper to B_upper, z = 0 half way down."""

    def middle(end: str) -> NDArray:
        left, right = (flat[:, INDEX[f"A_{side}_{end}"]] for side in ("left", "right"))
        return (left + right) / 2

    a, b = middle("upper"), flat[:, INDEX["B_upper"]]
    x = normalised(b - a)
    z = np.stack([-x[:, 1], x[:, 0]], -1)
    low = (middle("lower") + flat[:, INDEX["B_lower"]]) / 2
    drop = (((a + b) / 2 - low) * z).sum(-1)
    shifted = flat - (a - drop[:, None] / 2 * z)[:, None]
    xs, zs = ((shifted * axis[:, None]).sum(-1) for axis in (x, z))
    return np.stack([xs, np.zeros_like(xs), zs], -1)


def _ratio(flat: NDArray) -> NDArray:
    """c (n,): where on the flat line from A' (level with B) to B the leg of C' crosses it."""
    b, b_low, c, c_low = (flat[:, INDEX[v]] for v in ("B_upper", "B_lower", "C_upper", "C_lower"))
    found = []
    for side in _CONTACTS:
        a, leg = flat[:, INDEX[f"A_{side}_upper"]], normalised(b - b_low)
        leg_a = normalised(a - flat[:, INDEX[f"A_{side}_lower"]])
        a = a + (_dot(b - a, leg + leg_a) / (1 + _dot(leg, leg_a)))[:, None] * leg_a
        across = np.cross(c - c_low, [0, 1.0, 0])
        found.append(_dot(c - a, across) / _dot(b - a, across))
    return np.mean(found, axis=0)


def _as_unit(
    deployed: NDArray, flat: NDArray, theta: NDArray, origin: NDArray, scale: NDArray, single: bool
) -> Unit:
    def corner(at: str, first: str, second: str) -> NDArray:
        u, v = (normalised(flat[:, INDEX[k]] - flat[:, INDEX[at]]) for k in (first, second))
        return np.arctan2(np.linalg.norm(np.cross(u, v), axis=-1), (u * v).sum(-1))

    ends = [(f"A_{s}_{e}", f"B_{e}", f"C_{e}", f"P_{e}") for s in _CONTACTS for e in _ENDS]
    alpha = np.mean([(corner(a, b, p) + corner(a, p, c)) / 2 for a, b, c, p in ends], axis=0)
    beta = np.mean([corner(b, a, p) for a, b, c, p in ends], axis=0)
    beta_prime = np.mean([corner(p, a, c) for a, b, c, p in ends], axis=0)
    omega = np.mean(
        [
            (corner("B_upper", a, "B_lower") + corner(a, "B_upper", f"{a[:-5]}lower")) / 2
            for a in ("A_left_upper", "A_right_upper")
        ],
        axis=0,
    )
    strips = [flat[:, c[:2]].mean(1) - flat[:, c[2:]].mean(1) for c in _CONTACTS.values()]
    height = np.mean(np.linalg.norm(strips, axis=-1) * scale)
    legs = [normalised(deployed[:, c[0]] - deployed[:, c[3]]) for c in _CONTACTS.values()]
    parallel = np.abs(legs[0] - legs[1]).max() <= 1e-9
    flat = flat * scale[:, None, None]
    deployed = deployed * scale[:, None, None] + origin[:, None]
    values: Any = (flat, deployed, theta, _ratio(flat), alpha, beta, beta_prime, omega)
    if single:
        values = [v[0] for v in values]
    *values, omega = values
    shape: Any = (*values, float(scale.mean()), float(height), None if parallel else omega)
    return Unit(*shape)
