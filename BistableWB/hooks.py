# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hooks by which lower parts reach higher ones that they must not know; `wiring` joins them.

Each is a function without arguments that imports and returns a package, or None without a window.
"""

views = None  # -> `viewproviders`, for `objects`
panels = None  # -> `taskpanels.base`, for `viewproviders`
words = None  # -> `language.words`, for `objects`
