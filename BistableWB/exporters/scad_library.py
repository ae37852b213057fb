# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text that every OpenSCAD file of ours carries: parameters on top, modules below."""

HEADER = """\
// {title}: made by Bistable Workbench {version}. Millimetres, degrees.

/* [View] */
// show this part only, by its name ("" shows all)
only = "";
"""

HINGED = """\
// which state: {states}
state = {state}; // [0:{last}]
// lift the layers of the flat print apart by this much, to look inside
explode = 0;
// number of sides of barrels and cones; they have the volume of round ones
sides = 24;

/* [Design] */
// Ends with joints, plates or flanges and ties are drawn as they are: they follow no number.
// Stand-offs keep their heights. Plates, barrels, cones and gaps follow these numbers. Where hinges
// begin and end was laid out for the values below: small changes (some tenths) are safe here,
// larger ones belong into FreeCAD.
face_thickness = {face_thickness};
gap_between_planes = {gap_between_planes};
gap_length = {gap_length};
cone_angle = {cone_angle};
nozzle_diameter = {nozzle};
pivot = "{pivot}"; // [cone, pin]
pin_radius = {pin};

/* [Hidden] */
pitch = face_thickness + gap_between_planes;
radius = face_thickness + gap_between_planes / 2; // of every barrel
cut_back = radius + gap_length; // panels end this far from the axes of other panels' knuckles
laid_out_cut_back = {cut_back};
spread = cut_back - laid_out_cut_back;
fit = sqrt(2 * PI / (sides * sin(360 / sides)));
// plates begin inside the wall of a barrel, short of its recess
wall = radius - nozzle_diameter / 2;
start_of_plate = sqrt(wall * wall - gap_between_planes * gap_between_planes / 4);
cone_base = radius - nozzle_diameter;
// section of the links, outwards from their axes: half-width of the web, spine from … to
link_web = {web};
link_inner = {inner};
link_outer = {outer} + spread;
eps = 0.01;

// Where the units lie in the print: [x, y, angle]; unit k is the k-th layer of four.
units = [
  {units}
];

// Where each part goes from the print, for each state: rows of a matrix.
motions = [
  {motions}
];

module in_unit(k) {{
  at = units[k - 1];
  translate([at[0], at[1], 2 * pitch - gap_between_planes / 2 + 4 * pitch * (k - 1)])
    rotate([0, 0, at[2]]) children();
}}

module part(number, name, kind, layer) {{
  if (only == "" || only == name)
    color(colour(kind)) translate([0, 0, explode * layer]) multmatrix(motions[number][state])
      children();
}}

// Knuckle: [start, end (on the axis, with half a gap at both ends), height of the axis in pitches,
// depth from the axis into the panel (positive to the left), index, number of knuckles, cones,
// width and height of a stand-off on top of the barrel (or neither)]
function direction(k) = (k[1] - k[0]) / norm(k[1] - k[0]);
function length_of(k) = norm(k[1] - k[0]) - gap_length;
function has_start(k) = k[4] > 0;
function has_end(k) = k[4] < k[5] - 1;
function across(u) = [-u[1], u[0]];

// Puts children, made along z, onto the axis of a knuckle, `shift` mm from its start.
module on_axis(k, shift = 0) {{
  u = direction(k);
  at = k[0] + u * (gap_length / 2 + shift);
  translate([at[0], at[1], k[2] * pitch]) rotate([0, 90, atan2(u[1], u[0])]) children();
}}

// A barrel with what stands out of it (a cone; the pin of an even one) and what is hollow in it
// (the recess for a cone; the bore of an odd one): its outline, turned about the axis.
module barrel(k) {{
  h = length_of(k);
  tip = cone_base - k[6] / tan(cone_angle);
  odd = k[4] % 2 == 1;
  profile = pivot == "pin" && odd ? [[pin_radius + gap_length, 0], [radius, 0], [radius, h],
      [pin_radius + gap_length, h]] :
    pivot == "pin" ? concat([[0, 0], [radius, 0], [radius, h]],
      has_end(k) ? [[pin_radius, h], [pin_radius, 2 * h + 2 * gap_length + eps],
        [0, 2 * h + 2 * gap_length + eps]] : [[0, h]]) :
    concat(has_start(k) ? [[0, k[6]], [tip, k[6]], [cone_base, 0]] : [[0, 0]],
      [[radius, 0], [radius, h]],
      has_end(k) ? [[cone_base, h], [tip, h + k[6]], [0, h + k[6]]] : [[0, h]]);
  on_axis(k) rotate_extrude($fn = sides) polygon([for (p = profile) [fit * p[0], p[1]]]);
  if (len(k) > 7) on_axis(k) linear_extrude(h)
    translate([-radius - k[8], -k[7] / 2]) square([radius + k[8] - wall, k[7]]);
}}

// The part of a panel's tab below (up = -1) or above (up = 1) its barrel, within the round.
module foot(k, up) {{
  far = start_of_plate + 2 * eps;
  last = asin(start_of_plate / wall);
  section = concat([[0, radius], [far, radius], [far, gap_between_planes / 2]],
    [for (i = [5:-1:0]) wall * [sin(last * i / 5), cos(last * i / 5)]]);
  on_axis(k) linear_extrude(length_of(k))
    polygon([for (p = section) [-up * p[1], sign(k[3]) * p[0]]]);
}}

// From the barrel into the panel, as wide as the knuckle.
module tab(k) {{
  u = direction(k);
  a = k[0] + u * gap_length / 2;
  b = k[1] - u * gap_length / 2;
  near = across(u) * sign(k[3]) * start_of_plate;
  far = across(u) * (k[3] + sign(k[3]) * max(0, 2 * spread));
  polygon([a + near, b + near, b + far, a + far]);
}}

// A panel with its knuckles; `core` is its outline, cut back from the axes along its edges; ribs:
// stand-offs on its upper face, [outline, height].
module plate(layer, core, knuckles, ribs = []) {{
  translate([0, 0, layer * pitch - face_thickness / 2]) linear_extrude(face_thickness) {{
    offset(delta = -spread) polygon(core);
    for (k = knuckles) tab(k);
  }}
  for (k = knuckles) {{
    barrel(k);
    foot(k, k[2] > layer ? -1 : 1);
  }}
  for (rib = ribs) translate([0, 0, layer * pitch + face_thickness / 2 - eps])
    linear_extrude(rib[1] + eps) polygon(rib[0]);
}}

// The block between two units: their contact panels (children) and what fills the gap between.
module block(unit, filler) {{
  union() {{
    children();
    translate([0, 0, 4 * pitch * unit - gap_between_planes - eps])
      linear_extrude(gap_between_planes + 2 * eps) polygon(filler);
  }}
}}

// The link of a double hinge: knuckles on two axes, webs between them, and a spine that joins all.
// pairs: [[lower knuckle, upper knuckle], …]; outwards: unit vector away from the panels.
module link(outwards, pairs) {{
  for (pair = pairs) {{
    for (k = pair) barrel(k);
    between_axes(pair, outwards, -link_web, wall);
  }}
  for (i = [1:1:len(pairs) - 1])
    between_axes([gap_after(pairs[i - 1][0], pairs[i][0]), gap_after(pairs[i - 1][1], pairs[i][1])],
      outwards, link_inner, cut_back);
}}

// What looks like a knuckle from the end of one to the start of the next, a little longer.
function gap_after(before, after) = let(u = direction(before) * (gap_length + eps))
  [before[1] - u, after[0] + u, before[2]];

// Between two axes, from `near` outwards, but no nearer to an axis than `free`.
module between_axes(pair, outwards, near, free) {{
  middle = [for (i = [0, 1]) (pair[0][i] + pair[1][i]) / 2];
  left = across(direction(middle)) * outwards;
  lateral = [for (k = pair) (k[0] + k[1] - middle[0] - middle[1]) * outwards / 2];
  corner = function(i, n) [-pair[i][2] * pitch, left * (lateral[i] + n)];
  on_axis([middle[0], middle[1], 0]) linear_extrude(length_of(middle)) difference() {{
    polygon([corner(0, near), corner(1, near), corner(1, link_outer), corner(0, link_outer)]);
    for (i = [0, 1]) translate(corner(i, 0)) circle(fit * free, $fn = sides);
  }}
}}

"""

PLAIN = """\
module part(name) if (only == "" || only == name) children();

"""
