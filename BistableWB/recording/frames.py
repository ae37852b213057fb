# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records a deployment: PNG pictures, a GIF where pillow is installed, an MP4 where ffmpeg is."""

import importlib.util
import itertools
from pathlib import Path

from PySide import QtCore, QtGui

from .. import settings
from ..files import check_target, file_name, refuse_to_write
from ..language.labels import translate
from ..language.words import in_words
from ..origami.errors import Refusal
from ..programs import ffmpeg
from ..scene import threads

_FRAMES = 36
_SIZE = (960, 640)
_PAUSE = 90  # ms a picture is shown in a film
_POLL = 50  # ms


class Recorder:
    """A box of the deploy panel: folder, button, state. One picture a turn of the event loop.

    Every recording makes a folder of its own, so that it never covers an older one.
    """

    def __init__(self, panel):
        self.panel = panel
        self.box = QtGui.QGroupBox(translate("BistableDeploy", "Record"))
        self._timer = QtCore.QTimer(self.box)  # once: a turn that breaks is not tried again
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._go_on)
        self._files, self._films = [], None
        form = QtGui.QVBoxLayout(self.box)
        row = QtGui.QHBoxLayout()
        self.folder = QtGui.QLineEdit(settings.group().GetString("RecordFolder", ""))
        self.folder.setObjectName("RecordFolder")
        self.folder.setMinimumWidth(40)
        self.folder.setPlaceholderText(translate("BistableDeploy", "Folder for recordings"))
        self.folder.setToolTip(
            translate("BistableDeploy", "Every recording makes a folder of its own in this one")
        )
        browse = QtGui.QToolButton()
        browse.setText("…")
        browse.clicked.connect(self._browse)
        row.addWidget(self.folder, 1)
        row.addWidget(browse)
        form.addLayout(row)
        self.button = QtGui.QPushButton(self._label())
        self.button.setObjectName("Record")
        self.button.clicked.connect(self.start)
        self.button.setMinimumWidth(40)  # a narrow dock must not be made wider
        form.addWidget(self.button)
        self.state = QtGui.QLabel()
        self.state.setObjectName("RecordState")
        self.state.setWordWrap(True)
        form.addWidget(self.state)

    def start(self):
        """Record from flat to deployed; the folder is asked for once, and kept."""
        if not self.folder.text().strip():
            self._browse()
        if not self.folder.text().strip():
            return
        folder = Path(self.folder.text().strip()).expanduser()
        try:
            self.name, self.target = _new_folder(folder, self.panel.obj.Label)
        except Refusal as refusal:
            self.state.setText(in_words(refusal))
            return
        settings.group().SetString("RecordFolder", str(folder))
        self.panel.stop()
        self._files, self._films = [], None
        self.button.setEnabled(False)
        self._timer.start(0)

    def cancel(self):
        """Stop recording; pictures that are written stay."""
        self._timer.stop()

    def _go_on(self):
        if len(self._files) < _FRAMES:
            self._next()
        elif self._films is None:
            self._films = _Films(self._files, self.target / self.name)
            self.state.setText(translate("BistableDeploy", "Making the film…"))
            self._timer.start(_POLL)
        elif not self._films.is_done():
            self._timer.start(_POLL)
        else:
            self._finish()

    def _next(self):
        number = len(self._files)
        self.panel.set_opening(number / (_FRAMES - 1))
        path = self.target / f"{self.name}-{number + 1:03d}.png"
        self.panel.view.saveImage(str(path), *_SIZE, "White")
        if not path.is_file() or not path.stat().st_size:  # FreeCAD does not say why
            text = translate("BistableDeploy", "The picture {} was not written: is the disk full?")
            self._end(text.format(path))
            return
        self._files.append(path)
        progress = translate("BistableDeploy", "Picture {} of {}")
        self.state.setText(progress.format(number + 1, _FRAMES))
        self._timer.start(0)

    def _finish(self):
        written = translate("BistableDeploy", "{} pictures were written to {}.")
        parts = [written.format(len(self._files), self.target)]
        for film in self._films.written:
            parts.append(translate("BistableDeploy", "The film is {}.").format(film.name))
        parts += [in_words(reason) for reason in self._films.refused]
        self._end(" ".join(parts))

    def _end(self, text):
        self.state.setText(text)
        self.button.setEnabled(True)

    def _label(self):
        kinds = ["PNG"] + ["GIF"] * has_pillow() + ["MP4"] * bool(ffmpeg.program())
        return translate("BistableDeploy", "Record {}").format(", ".join(kinds))

    def _browse(self):
        title = translate("BistableDeploy", "Folder for recordings")
        movies = QtCore.QStandardPaths.writableLocation(QtCore.QStandardPaths.MoviesLocation)
        start = self.folder.text() or movies
        chosen = QtGui.QFileDialog.getExistingDirectory(self.box, title, start)
        if chosen:
            self.folder.setText(chosen)


class _Films:
    """Films of pictures, made beside the window: ``written`` paths, and why others are not."""

    def __init__(self, pictures, stem):
        self._pictures, self._stem = list(pictures), stem
        self.written, self.refused = [], []
        self._thread = threads.start(self._run)

    def is_done(self):
        """Whether all are there."""
        return not self._thread.is_alive()

    def _run(self):
        for suffix, is_there, write in (
            (".gif", has_pillow(), _write_gif),
            (".mp4", bool(ffmpeg.program()), ffmpeg.write_mp4),
        ):
            path = self._stem.with_name(self._stem.name + suffix)  # its name may have a dot
            if is_there:
                try:
                    _written(write, self._pictures, path)
                except Refusal as refusal:
                    self.refused.append(refusal)
                else:
                    self.written.append(path)


def _written(write, pictures, path):
    try:
        write(pictures, path, _PAUSE)
    except OSError as error:
        refuse_to_write(path, error)


def _write_gif(pictures, path, pause):
    from PIL import Image

    from ..pictures.film import write_gif

    write_gif([Image.open(file) for file in pictures], path, pause)


def _new_folder(folder, label):
    """Name of a recording, and its new folder in ``folder``; `Refusal` where there can be none."""
    label = file_name(label)
    check_target(folder / f"{label}.png")
    names = itertools.chain([label], (f"{label} {number}" for number in itertools.count(2)))
    name = next(name for name in names if not (folder / name).exists())
    try:
        (folder / name).mkdir()
    except OSError as error:
        refuse_to_write(folder / name, error)
    return name, folder / name


def has_pillow():
    """Whether GIFs can be written."""
    return importlib.util.find_spec("PIL") is not None
