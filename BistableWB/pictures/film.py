# SPDX-License-Identifier: LGPL-2.1-or-later
"""A print that opens and folds again, as a film that repeats itself (GIF, by Pillow)."""

import math

import numpy as np

from ..files import whole_file
from . import stage
from .prints import frame_of
from .shading import Ground, render_solids

_WIDTH = 720  # pixels
_FRAMES = 34  # from flat to deployed; the way back shows them again
_PAUSE, _HELD = 60, 1200  # ms that a picture is shown, and both ends
_ELEVATION, _TURN = math.radians(34), math.radians(20)
_COLOURS = 96


def deployment(path, bodies, motions, legs=None, forward=None):
    """Film of `PlacedMesh` bodies from flat to deployed and back; returns the path.

    ``motions(opening)``: one (4, 4) a body from the flat print, None for what is left out;
    ``legs`` and ``forward`` (3,): what points up, and the horizontal direction one looks along.
    """
    axes = np.eye(3) if legs is None else stage.upright(legs)
    view = stage.view_along((0, 1, 0) if forward is None else forward, _TURN, _ELEVATION)
    steps = np.linspace(0, 1, _FRAMES)
    states = [
        _standing(stage.turned(stage.solids(bodies, motions(opening)), axes))
        for opening in steps**2 * (3 - 2 * steps)  # it starts and ends gently
    ]
    frame = _common([frame_of(view, things, []) for things in states])
    low, high = stage.box([thing for things in states for thing in things])
    reach = 2 * (high - low).max()
    ground = Ground(low[:2] - reach, high[:2] + reach, -0.05)
    resolution = _WIDTH / (frame[1] - frame[0])[0]
    images = [
        render_solids(view, things, resolution, [ground], frame=frame)[0] for things in states
    ]
    write_gif([_on_white(image) for image in images], path, _PAUSE, _HELD)
    return path


def write_gif(images, path, pause, held=None):
    """A film of `PIL.Image` pictures, there and back, for ever.

    ``pause``: ms that each one is shown, ``held``: the first and the last one.
    """
    from PIL import Image

    images = [image.convert("RGB") for image in images]
    palette = _palette(images)
    frames = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    film = [*frames, *frames[-2:0:-1]]
    times = [pause] * len(film)
    times[0] = times[len(frames) - 1] = held or pause
    given = {"append_images": film[1:], "duration": times, "loop": 0, "optimize": True}
    with whole_file(path) as unfinished:
        film[0].save(unfinished, save_all=True, **given)


def _palette(images):
    """Palette picture of the colours in all of a film: those of pixels that lie evenly in it."""
    from PIL import Image

    seen = np.concatenate([np.asarray(image)[::4, ::4].reshape(-1, 3) for image in images[::3]])
    drawn = seen[seen.min(1) < 250]  # the ground would take all colours for shades of white
    few = np.concatenate([drawn, np.full((max(1, len(drawn) // 20), 3), 255, np.uint8)])
    return Image.fromarray(few[None]).quantize(_COLOURS)


def _standing(things):
    """Solids raised or lowered until the lowest of them stands on the ground."""
    return stage.shifted(things, [0, 0, -stage.box(things)[0][2]])


def _common(frames):
    """The frame (2, 2) that holds all frames."""
    return np.stack([np.min(frames, 0)[0], np.max(frames, 0)[1]])


def _on_white(image):
    """`PIL.Image` of an RGBA array in 0…1."""
    from PIL import Image

    alpha = image[..., 3:]
    opaque = image[..., :3] * alpha + 1 - alpha
    return Image.fromarray(np.rint(255 * np.clip(opaque, 0, 1)).astype(np.uint8))
