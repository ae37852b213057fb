# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of the user's language."""
