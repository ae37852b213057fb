# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records a deployment as a series of PNG pictures, and as one GIF where pillow is installed."""

import importlib.util
from pathlib import Path

from PySide import QtCore, QtGui

from .. import settings
from ..language.labels import translate

_FRAMES = 36
_SIZE = (960, 640)
_PAUSE = 90  # ms a picture is shown in the GIF


class Recorder:
    """A box of the deploy panel: folder, button, state. One picture a turn of the event loop."""

    def __init__(self, panel):
        self.panel = panel
        self.box = QtGui.QGroupBox(translate("BistableDeploy", "Record"))
        self._timer = QtCore.QTimer(self.box)
        self._timer.timeout.connect(self._next)
        self._files = []
        form = QtGui.QVBoxLayout(self.box)
        row = QtGui.QHBoxLayout()
        home = str(Path.home())
        self.folder = QtGui.QLineEdit(settings.group().GetString("RecordFolder", home))
        self.folder.setObjectName("RecordFolder")
        self.folder.setMinimumWidth(40)
        self.folder.setToolTip(translate("BistableDeploy", "Folder for the pictures"))
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
        """Record from flat to deployed."""
        folder = Path(self.folder.text()).expanduser()
        if not folder.is_dir():
            missing = translate("BistableDeploy", "There is no folder {}: choose another one.")
            self.state.setText(missing.format(folder))
            return
        settings.group().SetString("RecordFolder", str(folder))
        self.panel.stop()
        self.target, self._files = folder, []
        self.button.setEnabled(False)
        self._timer.start(0)

    def cancel(self):
        """Stop recording; pictures that are written stay."""
        self._timer.stop()

    def _next(self):
        number = len(self._files)
        self.panel.set_opening(number / (_FRAMES - 1))
        path = self.target / f"{self.panel.obj.Label}-{number + 1:03d}.png"
        self.panel.view.saveImage(str(path), *_SIZE, "White")
        self._files.append(path)
        progress = translate("BistableDeploy", "Picture {} of {}")
        self.state.setText(progress.format(number + 1, _FRAMES))
        if len(self._files) == _FRAMES:
            self._timer.stop()
            self._finish()

    def _finish(self):
        written = translate("BistableDeploy", "{} pictures were written to {}.")
        text = written.format(len(self._files), self.target)
        if has_pillow():
            path = self.target / f"{self.panel.obj.Label}.gif"
            self._write_film(path)
            text += " " + translate("BistableDeploy", "The film is {}.").format(path.name)
        self.state.setText(text)
        self.button.setEnabled(True)

    def _write_film(self, path):
        from PIL import Image

        from ..pictures.film import write_gif

        write_gif([Image.open(file) for file in self._files], path, _PAUSE)

    def _label(self):
        if has_pillow():
            return translate("BistableDeploy", "Pictures and GIF")
        return translate("BistableDeploy", "Pictures")

    def _browse(self):
        title = translate("BistableDeploy", "Folder for the pictures")
        chosen = QtGui.QFileDialog.getExistingDirectory(self.box, title, self.folder.text())
        if chosen:
            self.folder.setText(chosen)


def has_pillow():
    """Whether GIFs can be written."""
    return importlib.util.find_spec("PIL") is not None
