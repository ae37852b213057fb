# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mathematics of bistable tubes: numpy only, radians, plain arrays, batched over units.

Frames are right-handed. A unit's own frame: *flat*, everything lies in the plane y = 0 with A at
x = 0, B at x = ‖AB‖ and the legs along z; *deployed*, the mid-plane is y = 0, x points from C'
to B, z is "upper" and A_left is at y < 0.
"""
