# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a deployed tube may lie on the bed: on its sides, and as it comes to rest by itself."""

import numpy as np

_DIRECTIONS = 1500  # tried as "down"
_NEIGHBOURS = 10
_SAME = np.cos(np.radians(8))  # directions nearer to each other are one
_STEPS = 1e-1, 1e-5  # first and last step (radians) of the search for where it rests
_ALIKE = 1e-3  # share by which guesses of mirror images may differ
# Rough rates of printing, only to tell what is worth slicing: support fills a quarter of its room,
# at some 3 mm³ a second; a mm of height costs five layers' moves and waiting.
_ROOM_PER_SECOND, _SECONDS_PER_HEIGHT = 12.0, 20.0


def candidates(mesh):
    """Directions (n, 3) that may point down: along the axes, and those in which ``mesh`` rests.

    It rests where the height of its middle over the bed is less than in all directions round
    about: on a face of its convex hull.
    """
    vertices = mesh.vertices - _middle(mesh)
    sphere = _sphere(_DIRECTIONS)
    hull = vertices[np.unique((sphere @ vertices.T).argmax(1))]
    height = (sphere @ hull.T).max(1)
    near = np.argsort(-(sphere @ sphere.T), axis=1)[:, 1 : _NEIGHBOURS + 1]
    lowest = np.flatnonzero((height[:, None] <= height[near]).all(1))
    resting = [_settled(hull, sphere[k]) for k in lowest[np.argsort(height[lowest])]]
    found = []
    for down in [*np.eye(3), *-np.eye(3), *resting]:
        if all(down @ other < _SAME for other in found):
            found.append(down)
    return np.array(found)


def best_guesses(mesh, count, steepest):
    """Rotations (k, 3, 3) of the ``count`` candidates that look quickest to print, best first.

    ``steepest``: angle from the vertical (degrees) from which a face needs support. Of mirror
    images, which print alike, there is only one.
    """
    downs = candidates(mesh)
    flat = np.sin(np.radians(steepest))
    guesses = np.array([_guess(mesh, down, flat) for down in downs])
    order = np.argsort(guesses)
    new = np.diff(guesses[order], prepend=0) > _ALIKE * guesses[order]
    return np.array([upright(downs[k]) for k in order[new][:count]])


def upright(down):
    """The rotation (3, 3) that turns the unit vector ``down`` to −z by the shortest way."""
    target = np.array([0, 0, -1.0])
    axis, cosine = np.cross(down, target), down @ target
    if cosine < -1 + 1e-12:
        return np.diag([1.0, -1.0, -1.0])
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + cross + cross @ cross / (1 + cosine)


def _guess(mesh, down, flat):
    """About how many seconds more than its own plastic a print takes with ``down`` below.

    Faces that look down by more than the cosine ``flat`` need support.
    """
    corners = mesh.corners
    sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    area = sides @ down
    over = corners.mean(1) @ -down
    heights = mesh.vertices @ -down
    hangs = area > flat * np.linalg.norm(sides, axis=1)
    room = (area * (over - heights.min()))[hangs].sum()
    return room / _ROOM_PER_SECOND + _SECONDS_PER_HEIGHT * np.ptp(heights)


def _settled(hull, down):
    """The direction near ``down`` in which the height of ``hull`` (n, 3) over the bed is least."""
    step, least = _STEPS
    turns = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    while step > least:
        frame = upright(down)[:2]
        tried = down + step * (
            np.cos(turns)[:, None] * frame[0] + np.sin(turns)[:, None] * frame[1]
        )
        tried /= np.linalg.norm(tried, axis=1, keepdims=True)
        heights = (tried @ hull.T).max(1)
        if heights.min() < (hull @ down).max():
            down = tried[heights.argmin()]
        else:
            step /= 2
            turns = turns + 0.1
    return down


def _middle(mesh):
    """Middle of the volume of closed meshes (3,)."""
    corners = mesh.corners
    volumes = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
    return volumes @ corners.sum(1) / 4 / volumes.sum()


def _sphere(count):
    """Directions (count, 3) spread evenly."""
    k = np.arange(count) + 0.5
    z, turn = 1 - 2 * k / count, k * np.pi * (3 - 5**0.5)
    flat = np.sqrt(1 - z * z)
    return np.stack([flat * np.cos(turn), flat * np.sin(turn), z], 1)
