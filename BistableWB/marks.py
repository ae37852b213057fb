# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks of texts for translators, for modules that know nothing of languages."""


def QT_TRANSLATE_NOOP(context, text):
    """The text as it is; whoever shows it translates it in this context."""
    return text
