# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other programs: finding them, running them, ending them."""
