# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solid models of plates for CalculiX, which judges our stiffness: meshes, loads, energies."""

import shutil
import subprocess
from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial import Delaunay

needed = pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX (ccx) is not here")


def plate_mesh(core, roots, size):
    """Quadratic triangles of a convex polygon: points (n, 2), triangles (m, 6), nodes of each root.

    ``core`` (k, 2), counter-clockwise or not; ``roots`` (r, 2, 2) on its edges; ``size`` mm.
    """
    edge_points, on_root = [], []
    for a, b in zip(core, np.roll(core, -1, 0), strict=True):
        along = (b - a) / np.linalg.norm(b - a)
        stops = {0.0, float(np.linalg.norm(b - a))}
        for root in roots:
            off = (root - a) @ [-along[1], along[0]]
            if np.abs(off).max() < 1e-4:
                stops |= {float(s) for s in (root - a) @ along}
        stops = sorted(stops)
        for low, high in pairwise(stops):
            if high - low < 1e-6:
                continue
            count = max(int(np.ceil((high - low) / size)), 1)
            edge_points += [a + s * along for s in np.linspace(low, high, count + 1)[:-1]]
    edge_points = np.array(edge_points)
    low, high = core.min(0), core.max(0)
    x, y = np.meshgrid(np.arange(low[0], high[0], size), np.arange(low[1], high[1], 0.87 * size))
    x[1::2] += size / 2
    inner = np.stack([x.ravel(), y.ravel()], -1)
    depth = np.full(len(inner), np.inf)
    sense = np.sign(_area(core))
    for a, b in zip(core, np.roll(core, -1, 0), strict=True):
        along = (b - a) / np.linalg.norm(b - a)
        depth = np.minimum(depth, sense * ((inner - a) @ [-along[1], along[0]]))
    points = np.concatenate([edge_points, inner[depth > 0.45 * size]])
    triangles = Delaunay(points).simplices
    corners = points[triangles]
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    triangles = triangles[np.abs(areas) > 1e-3 * size**2]
    areas = areas[np.abs(areas) > 1e-3 * size**2]
    triangles[areas < 0] = triangles[areas < 0][:, ::-1]
    middles, six = {}, []
    everything = list(points)
    for t in triangles:
        mids = []
        for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
            key = tuple(sorted((a, b)))
            if key not in middles:
                middles[key] = len(everything)
                everything.append((points[a] + points[b]) / 2)
            mids.append(middles[key])
        six.append([*t, *mids])
    everything = np.array(everything)
    for root in roots:
        along = (root[1] - root[0]) / np.linalg.norm(root[1] - root[0])
        s = (everything - root[0]) @ along
        off = np.abs((everything - root[0]) @ [-along[1], along[0]])
        inside = (s > -1e-6) & (s < np.linalg.norm(root[1] - root[0]) + 1e-6) & (off < 1e-4)
        on_root.append(np.flatnonzero(inside))
    return everything, np.array(six), on_root


def _area(core):
    x, y = core.T
    return (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2


_CORNER = 0.1  # of the load that a node in the middle of an edge bears


class Plate:
    """A plate of wedges (C3D15), plan (x, z), thickness along y, loaded at its roots."""

    def __init__(self, core, roots, thickness, size=1.6):
        plan, six, on_root = plate_mesh(np.asarray(core, float), np.asarray(roots, float), size)
        n, half = len(plan), thickness / 2
        levels = np.array([-half, 0.0, half])
        self.nodes = np.zeros((3 * n, 3))
        for k, y in enumerate(levels):
            self.nodes[k * n : (k + 1) * n] = np.stack([plan[:, 0], np.full(n, y), plan[:, 1]], -1)
        # (x, y, z) with y up is left-handed seen from above: the wedge's bottom is at +y
        low, mid, top = six + 2 * n, six + n, six
        self.wedges = np.concatenate(
            [low[:, :3], top[:, :3], low[:, 3:], top[:, 3:], mid[:, :3]], 1
        )
        used = np.unique(self.wedges)
        self.used = np.zeros(len(self.nodes), bool)
        self.used[used] = True
        self.middle = np.zeros(len(self.nodes), bool)
        self.middle[self.wedges[:, 6:]] = True
        self.patches = [
            np.array([k * n + i for k in range(3) for i in nodes if self.used[k * n + i]])
            for nodes in on_root
        ]

    def forces(self, loads):
        """Nodal forces (nodes, 3) of wrenches (roots, 6) about the middles of the roots."""
        found = np.zeros_like(self.nodes)
        for patch, wrench in zip(self.patches, loads, strict=True):
            at = self.nodes[patch]
            middle = np.append((at.min(0) + at.max(0)) / 2, 1)[:3]
            arms = at - middle
            rows = np.zeros((6, len(patch), 3))
            rows[:3] = np.eye(3)[:, None]
            for axis in range(3):
                rows[3 + axis] = np.cross(np.eye(3)[axis], arms)
            rows = rows.reshape(6, -1)
            # nodes in the middle of an edge bear most of an even load
            shares = np.repeat(np.where(self.middle[patch], 1.0, _CORNER), 3)
            inner = np.linalg.pinv((rows * shares) @ rows.T, rcond=1e-10)
            found[patch] += (shares * (rows.T @ (inner @ wrench))).reshape(-1, 3)
        return found

    def work(self, folder, cases, young=1.0, poisson=0.35):
        """Twice the strain energy of every load case (cases, roots, 6), by CalculiX."""
        forces, moved = self._solved(folder, cases, young, poisson)
        return np.array([(f * u).sum() for f, u in zip(forces, moved, strict=True)])

    def compliance(self, folder, young=1.0, poisson=0.35):
        """Motions of all roots (6 r, 6 r) by unit wrenches on each: true for loads in balance."""
        cases = np.eye(6 * len(self.patches)).reshape(-1, len(self.patches), 6)
        forces, moved = self._solved(folder, cases, young, poisson)
        rows = np.array(forces).reshape(len(cases), -1)
        found = rows @ np.array(moved).reshape(len(cases), -1).T
        return (found + found.T) / 2

    def _solved(self, folder, cases, young, poisson):
        """Nodal forces and displacements (nodes, 3) of every load case."""
        held = self._held()
        lines = ["*NODE, NSET=ALL"]
        lines += [f"{i + 1}, {x:.9g}, {y:.9g}, {z:.9g}" for i, (x, y, z) in enumerate(self.nodes)
                  if self.used[i]]  # fmt: skip
        lines.append("*ELEMENT, TYPE=C3D15, ELSET=PLATE")
        lines += _elements(self.wedges, 8)
        lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{young}, {poisson}"]
        lines += ["*SOLID SECTION, ELSET=PLATE, MATERIAL=M", "*BOUNDARY"]
        lines += [f"{node + 1}, {axis + 1}, {axis + 1}" for node, axis in held]
        all_forces = [self.forces(case) for case in cases]
        for forces in all_forces:
            lines += ["*STEP", "*STATIC", "*CLOAD, OP=NEW"]
            for node in np.flatnonzero(np.abs(forces).max(1) > 0):
                lines += [f"{node + 1}, {axis + 1}, {forces[node, axis]:.12g}" for axis in range(3)]
            lines += ["*NODE PRINT, NSET=ALL", "U", "*END STEP"]
        (folder / "plate.inp").write_text("\n".join(lines) + "\n")
        subprocess.run(["ccx", "plate"], cwd=folder, check=True, capture_output=True,
                       env={"OMP_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"})  # fmt: skip
        moved = _displacements(folder / "plate.dat", len(self.nodes), len(cases))
        return all_forces, moved

    def _held(self):
        """Six degrees of freedom, (node, axis), that hold the plate without straining it."""
        corner = np.flatnonzero(self.used & (np.abs(self.nodes[:, 1]) < 1e-9))
        at = self.nodes[corner]
        a = corner[at[:, 0].argmin()]
        b = corner[((at - self.nodes[a]) ** 2).sum(1).argmax()]
        ab = self.nodes[b] - self.nodes[a]
        c = corner[np.abs(np.cross(at - self.nodes[a], ab)[:, 1]).argmax()]
        across = 2 if abs(ab[0]) > abs(ab[2]) else 0
        return [(a, 0), (a, 1), (a, 2), (b, 1), (b, across), (c, 1)]


def _displacements(path, nodes, steps):
    found, block = [], None
    for line in path.read_text().splitlines():
        words = line.split()
        if "displacements" in line:
            block = np.zeros((nodes, 3))
            found.append(block)
        elif block is not None and len(words) == 4:
            block[int(words[0]) - 1] = [float(word) for word in words[1:]]
    assert len(found) == steps
    return found


class Block:
    """A bar of bricks (C3D20) held at x = 0 and pushed at its other end: a knuckle's tab."""

    def __init__(self, length, width, thickness, counts=(12, 4, 10)):
        nx, ny, nz = counts
        grid = np.meshgrid(
            np.linspace(0, length, 2 * nx + 1),
            np.linspace(-thickness / 2, thickness / 2, 2 * ny + 1),
            np.linspace(-width / 2, width / 2, 2 * nz + 1), indexing="ij",
        )  # fmt: skip
        self.nodes = np.stack(grid, -1).reshape(-1, 3)
        number = np.arange(len(self.nodes)).reshape(grid[0].shape)
        corner = np.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)])
        corners = np.concatenate([corner, corner + np.array([0, 0, 2])])
        pairs = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5),
                 (2, 6), (3, 7)]  # fmt: skip
        middles = [(corners[a] + corners[b]) // 2 for a, b in pairs]
        offsets = np.concatenate([corners, middles])
        cells = np.stack(np.meshgrid(*(np.arange(n) for n in counts), indexing="ij"), -1)
        at = 2 * cells.reshape(-1, 1, 3) + offsets
        self.bricks = number[at[..., 0], at[..., 1], at[..., 2]]
        self.size = length, width, thickness

    def pushed(self, folder, force, young, poisson):
        """Largest von Mises stress (MPa) at half the length, and how far the end gives way, mm."""
        used = np.unique(self.bricks)
        x = self.nodes[:, 0]
        end = used[np.isclose(x[used], self.size[0])]
        root = used[np.isclose(x[used], 0)]
        lines = ["*NODE, NSET=ALL"]
        lines += [f"{i + 1}, {', '.join(f'{c:.9g}' for c in self.nodes[i])}" for i in used]
        lines.append("*ELEMENT, TYPE=C3D20, ELSET=BAR")
        lines += _elements(self.bricks, 10)
        lines += ["*NSET, NSET=END", ",\n".join(str(i + 1) for i in end)]
        lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{young}, {poisson}"]
        lines += ["*SOLID SECTION, ELSET=BAR, MATERIAL=M", "*BOUNDARY"]
        lines += [f"{i + 1}, 1, 3" for i in root]
        lines += ["*STEP", "*STATIC", "*CLOAD"]
        for axis in np.flatnonzero(force):
            lines += [f"{i + 1}, {axis + 1}, {force[axis] / len(end):.9g}" for i in end]
        lines += ["*NODE PRINT, NSET=ALL", "U", "*EL FILE", "S", "*END STEP"]
        (folder / "bar.inp").write_text("\n".join(lines) + "\n")
        subprocess.run(["ccx", "bar"], cwd=folder, check=True, capture_output=True,
                       env={"OMP_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"})  # fmt: skip
        moved = _displacements(folder / "bar.dat", len(self.nodes), 1)[0]
        along = np.flatnonzero(force)[0]
        half = used[np.isclose(x[used], self.size[0] / 2)]
        return _von_mises(folder / "bar.frd", half), abs(moved[end, along].mean())


def _elements(nodes, in_a_line):
    """Lines of elements by their nodes, from 0."""
    numbered = [[str(i + 1) for i in each] for each in nodes]
    parts = [(", ".join(e[:in_a_line]), ", ".join(e[in_a_line:])) for e in numbered]
    return [f"{k + 1}, {first},\n{rest}" for k, (first, rest) in enumerate(parts)]


def _von_mises(path, nodes):
    """Largest von Mises stress at nodes, from a results file."""
    wanted, found, reading = {i + 1 for i in nodes}, [], False
    for line in path.read_text().splitlines():
        if "STRESS" in line:
            reading = True
        elif reading and line.startswith(" -3"):
            break
        elif reading and line.startswith(" -1") and int(line[3:13]) in wanted:
            found.append([float(line[13 + 12 * k : 25 + 12 * k]) for k in range(6)])
    xx, yy, zz, xy, yz, zx = np.array(found).T
    square = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2 + 6 * (xy**2 + yz**2 + zx**2)
    return float(np.sqrt(square / 2).max())
