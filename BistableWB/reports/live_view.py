# SPDX-License-Identifier: LGPL-2.1-or-later
"""The live 3D view of a report: a GLB within the page, and our own small program that draws it.

It asks no network for anything: the page can be mailed and opened years later.
"""

import base64
from collections.abc import Callable
from typing import TYPE_CHECKING

from .. import RESOURCES
from ..origami.errors import phrase

if TYPE_CHECKING:
    from ..origami.errors import Phrase

LIVE_STYLE = """
.live { margin: 1.4rem 0; padding: 1rem; border: 1px solid var(--line); border-radius: 10px; }
.live canvas { display: block; width: 100%; height: 460px; border-radius: 8px; cursor: grab;
               touch-action: none; background: var(--wash); }
.live canvas:active { cursor: grabbing; }
.live div { display: flex; gap: .8rem; align-items: center; margin-top: .7rem; }
.live input { flex: 1; }
.live output { min-width: 3.2em; text-align: right; font-variant-numeric: tabular-nums; }
.live button { font: inherit; padding: .25rem 1rem; border: 1px solid var(--line);
               border-radius: 6px; background: white; cursor: pointer; }
.live .without { display: none; }
.live.no-webgl .without { display: block; }
.live.no-webgl canvas, .live.no-webgl div { display: none; }
@media print { .live { display: none; } }
"""


def live_view(glb: bytes, caption: "Phrase | str", say: "Callable[[Phrase | str], str]") -> str:
    """The part of a page that shows ``glb``, a file of `exporters.glb`; needs `script` once.

    ``say`` gives a phrase in the user's language, as HTML.
    """
    data = base64.b64encode(glb).decode()
    slider = say(phrase("Deployment, 0 flat to 1"))
    without = say(phrase("This browser has no WebGL 2: see the pictures below."))
    return (
        '<figure class="live"><canvas></canvas>'
        f'<div><button type="button">{say(phrase("Open"))}</button>'
        f"<span>{say(phrase('flat'))}</span>"
        f'<input type="range" min="0" max="1" step="0.001" aria-label="{slider}">'
        f"<span>{say(phrase('deployed'))}</span><output></output></div>"
        f'<p class="without">{without}</p>'
        f"<figcaption>{say(caption)}</figcaption>"
        f'<script type="text/plain">{data}</script></figure>'
    )


def script() -> str:
    """The program that brings the live views of a page to life; at the page's end."""
    text = (RESOURCES / "report" / "viewer.js").read_text(encoding="utf-8")
    return f"<script>\n{text}</script>"
