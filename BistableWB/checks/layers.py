# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers of a print: their home is `origami.layers`, where ties are found by them too."""

from ..origami.layers import PIXEL, Layers, Tops, crossings, extent, layers

__all__ = ["PIXEL", "Layers", "Tops", "crossings", "extent", "layers"]
