# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for a tube that suits a curve, a printer and a wanted snap."""
