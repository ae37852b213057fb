# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a browser shows of an SVG, kind by kind; lengths are worked out by hand."""

import gzip
import math
import time

import pytest

from BistableWB.imports import curves_in

ROOT = (
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" {}>{}</svg>'
)
MM = 'width="300mm" height="200mm" viewBox="0 0 300 200"'
LINE = '<path d="M0 0H100"/>'
PX = 25.4 / 96


@pytest.fixture
def lengths(tmp_path):
    def read(body, attributes=MM, **options):
        path = tmp_path / "drawing.svg"
        path.write_text(ROOT.format(attributes, body), encoding="utf-8")
        return [curve.length for curve in curves_in(path, **options)]

    return read


@pytest.mark.parametrize(
    ("attributes", "length"),
    [
        ('width="300mm" height="200mm"', 100 * PX),  # units are pixels then
        ('width="300" viewBox="0 0 600 400"', 50 * PX),
        ('height="200" viewBox="0 0 600 400"', 50 * PX),
        ('width="3in" height="3in" viewBox="0 0 300 300"', 25.4),
        ('width="72pt" height="72pt" viewBox="0 0 100 100"', 25.4),
        ('width="6pc" height="6pc" viewBox="0 0 100 100"', 25.4),
        ('width="101.6q" height="101.6Q" viewBox="0 0 100 100"', 25.4),
        ('width="300.0e0MM" height="+200mm" viewBox="0\n0\t300 , 200"', 100),
        ('width="600mm" height="200mm" viewBox="0 0 300 200" preserveAspectRatio="xMinYMin slice"',
         200),
        ('width="auto" height="100%" viewBox="0 0 300 200"', 100 * PX),
    ],
)  # fmt: skip
def test_size_of_the_picture(lengths, attributes, length):
    assert lengths(LINE, attributes) == pytest.approx([length])


@pytest.mark.parametrize(
    ("attributes", "message"),
    [
        ('width="50%" height="50%" viewBox="0 0 300 200"', "its width is 50% of a window"),
        ('width="300 furlongs" height="2mm"', "width is “300 furlongs”, which is no length"),
        ('width="300,5mm" height="2mm"', "with a point for its decimals"),
        ('width="3mm" height="2mm" viewBox="0 0 0 2"', "the viewBox “0 0 0 2” is not"),
        ('width="3mm" height="2mm" viewBox="0 0 3"', "the viewBox “0 0 3” is not"),
    ],
)
def test_sizes_that_cannot_be(lengths, attributes, message):
    with pytest.raises(ValueError, match=message):
        lengths(LINE, attributes)


@pytest.mark.parametrize(
    ("version", "attributes", "fine"),
    [
        ("0.48.5 r10040", 'width="744.09" height="1052.36"', False),
        ("0.91 r13725", 'width="210mm" height="297mm"', False),
        ("0.91 r13725", 'width="210mm" height="297mm" viewBox="0 0 210 297"', True),
        ("0.92.4", 'width="744.09" height="1052.36"', True),
        ("1.2", 'width="744.09" height="1052.36"', True),
    ],
)
def test_inkscape_of_ninety_dots_an_inch_is_asked_back(lengths, version, attributes, fine):
    space = "http://www.inkscape.org/namespaces/inkscape"
    attributes += f' xmlns:inkscape="{space}" inkscape:version="{version}"'
    if fine:
        assert lengths(LINE, attributes)
        return
    with pytest.raises(ValueError, match=r"whose pixel is 1/90 inch.*or give a scale"):
        lengths(LINE, attributes)
    assert lengths(LINE, attributes, scale=96 / 90) == pytest.approx([100 * 25.4 / 90])


@pytest.mark.parametrize(
    ("body", "found"),
    [
        ('<rect x="1" y="2" width="30" height="20"/>', [100]),
        ('<rect width="30" height="20" rx="5"/>', [60 + 10 * math.pi]),
        ('<rect width="30" height="20" rx="50" ry="50"/>', [79.3272]),  # cut to 15 and 10
        ('<circle r="10"/>', [20 * math.pi]),
        ('<ellipse rx="10" ry="10"/>', [20 * math.pi]),
        ('<ellipse rx="10"/>', [20 * math.pi]),
        ('<line x1="0" y1="0" x2="30" y2="40"/>', [50]),
        ('<line x2="50%"/>', [150]),
        ('<circle r="0"/><line x2="1"/>', [1]),
        ('<polygon points="0 0 30 0 30 40"/>', [120]),
        ('<rect style="width:30px;height:20px" width="1" height="1"/>', [100]),
        (f'<g transform="translate(5) rotate(30)">{LINE}</g>', [100]),
        (f'<g style="transform: translate(5px, 10%) scale(2)">{LINE}</g>', [200]),
        (f'<g style="transform: rotate(0.25turn)">{LINE}</g>', [100]),
        (f'<g transform="scale(2)" style="transform:none">{LINE}</g>', [100]),
        ('<path d="M0 0H10 M0 5H20" transform="scale(-1,1)"/>', [20, 10]),
    ],
)
def test_shapes_and_transforms(lengths, body, found):
    assert lengths(body) == pytest.approx(found, rel=1e-5)


@pytest.mark.parametrize(
    "hidden",
    [
        f"<defs>{LINE}</defs>",
        f"<symbol>{LINE}</symbol>",
        f"<clipPath>{LINE}</clipPath>",
        f"<mask>{LINE}</mask>",
        f"<pattern>{LINE}</pattern>",
        f"<marker>{LINE}</marker>",
        f'<g display="none">{LINE}</g>',
        f'<g style="display : none ;">{LINE}</g>',
        f'<g visibility="hidden">{LINE}</g>',
        f'<g opacity="0">{LINE}</g>',
        '<path d="M0 0H100" style="fill:none;stroke:none"/>',
        '<style>.off {display: none} /* .on {} */</style><path class="a off" d="M0 0H100"/>',
        '<style>g.x > path, b {visibility: hidden !important}</style><g class="x">'
        '<path d="M0 0H100"/></g>',
        '<style><![CDATA[ @media print {*{display:none}} #no{display:none} ]]></style>'
        '<path id="no" d="M0 0H100"/>',
        '<text>M0 0H100</text><image href="a.png"/>',
        '<x:path xmlns:x="http://example.org/other" d="M0 0H100"/>',
        '<use href="#nothing"/><use href="other.svg#a"/>',
        f'<switch><g systemLanguage="xx">{LINE}</g></switch>',
    ],
)  # fmt: skip
def test_what_is_not_seen_is_no_curve(lengths, hidden):
    seen = '<path d="M0 9H70" stroke="red"/>'
    assert lengths(hidden + seen) == pytest.approx([70])


def test_what_is_seen_within_what_is_not(lengths):
    body = '<g visibility="hidden"><path visibility="visible" d="M0 0H70"/></g>'
    assert lengths(body) == pytest.approx([70])


@pytest.mark.parametrize(
    ("body", "found"),
    [
        ('<defs><g id="a"><path d="M0 0H10"/></g></defs><use href="#a"/><use xlink:href="#a" y="5"'
         ' transform="scale(3)"/>', [30, 10]),
        ('<symbol id="s" viewBox="0 0 10 10"><path d="M0 0H10"/></symbol>'
         '<use href="#s" width="50" height="80"/>', [50]),
        ('<symbol id="s"><path d="M0 0H10"/></symbol><use href="#s"/>', [10]),
        ('<path id="p" d="M0 0H10"/><use href="#p" y="1"/><use href="#p" y="2"/>', [10, 10, 10]),
        ('<svg width="50%" height="50%" viewBox="0 0 15 10"><path d="M0 0H10"/></svg>', [100]),
        ('<svg x="10"><path d="M0 0H10"/></svg>', [10]),
    ],
)  # fmt: skip
def test_clones_symbols_and_pictures_in_pictures(lengths, body, found):
    assert lengths(body) == pytest.approx(found)


@pytest.mark.parametrize(
    ("content", "length"),
    [
        (ROOT.format(MM, LINE).encode("utf-16"), 100),
        (ROOT.format(MM, LINE).encode("utf-8-sig"), 100),
        (("<?xml version='1.0' encoding='utf-16'?>" + ROOT.format(MM, LINE)).encode("utf-16"), 100),
        (("<?xml version='1.0' encoding='Shift_JIS'?>" + ROOT.format(MM, f"<g id='曲'>{LINE}</g>"))
         .encode("shift_jis"), 100),
        (("<?xml version='1.0' encoding='windows-1252'?>" + ROOT.format(MM, "<!--ü–-->" + LINE))
         .encode("cp1252"), 100),
        (gzip.compress(ROOT.format(MM, LINE).encode()), 100),
        (b"<svg>" + LINE.encode() + b"</svg>", 100 * PX),
        (b"<!DOCTYPE svg [<!ENTITY w '100'><!ENTITY p 'M0 0H&w;'>]>" + ROOT.format(
            MM, '<path d="&p;"/>').encode(), 100),
    ],
    ids=["utf-16", "utf-8-sig", "declared-utf-16", "shift_jis", "cp1252", "gzip", "no-size",
         "entities"],
)  # fmt: skip
def test_encodings_and_entities(tmp_path, content, length):
    path = tmp_path / "drawing.svg"
    path.write_bytes(content)
    (curve,) = curves_in(path)
    assert curve.length == pytest.approx(length)


LAUGHS = "".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 10))
QUADRATIC = f'<!DOCTYPE svg [<!ENTITY a "{"x" * 50_000}">]>'


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (f'<!DOCTYPE svg [<!ENTITY a0 "lol">{LAUGHS}]>' + ROOT.format(MM, "<g id='&a9;'/>"),
         "blows up"),
        ('<!DOCTYPE svg [<!ENTITY a "&b;"><!ENTITY b "&a;">]>' + ROOT.format(MM, "<g id='&a;'/>"),
         "blows up"),
        (QUADRATIC + ROOT.format(MM, "<g>" + "&a;" * 5000 + "</g>"), "blows up"),
        (ROOT.format(MM, '<g id="a"><use href="#a"/></g>'), "the clone of #a holds itself"),
        (ROOT.format(MM, '<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>'), "itself"),
        (ROOT.format(MM, '<g id="g0"><path d="M0 0H1"/></g>' + "".join(
            f'<g id="g{k}">' + f'<use href="#g{k - 1}"/>' * 10 + "</g>" for k in range(1, 9))),
         "draws more than 10000 shapes"),
        (ROOT.format(MM, "<g>" * 3000 + LINE + "</g>" * 3000), "groups in groups"),
        (ROOT.format(MM, '<path d="M0 0' + "h1v1" * 240_000 + '"/>'), "more than 20000 pieces"),
        (ROOT.format(MM, "<path d='M0 0h1'/>" * 12_000), "draws more than 10000 shapes"),
        (ROOT.format(MM, "<style>" + ".a .b .c{x:y}" * 9_000 + "</style>" + "".join(
            f"<g class='b{k}'/>" for k in range(60))), "far too many rules"),
        (ROOT.format(MM, "<text>hello</text>"), r"only 1 × text \(no path: convert it to one\)"),
        (ROOT.format(MM, "<g transform='rotate(1 2)'/>"), "“rotate\\(1 2\\)” is of no kind"),
        ("<html/>", "is not an SVG file"),
        ("<svg><path", "is not a whole SVG file"),
    ],
    ids=[
        "laughs", "ring", "quadratic", "clone", "clones", "exponential", "deep", "long", "many",
        "styles", "text", "transform", "html", "half",
    ],
)  # fmt: skip
def test_bombs_and_broken_files_are_refused_at_once(tmp_path, content, message):
    path = tmp_path / "bomb.svg"
    path.write_text(content, encoding="utf-8")
    start = time.process_time()
    with pytest.raises(ValueError, match=message):
        curves_in(path)
    assert time.process_time() - start < 5


@pytest.mark.slow
@pytest.mark.parametrize(
    "body",
    [
        "<path d='M0 0" + "c1 2 3 4 5 6" * 19_000 + "'/>",
        "".join(f"<path d='M{k} 0c1 2 3 4 5 6'/>" for k in range(9_900)),
        "".join(f"<path d='M{k} {k}l1 1'/>" for k in range(9_900)),
        "<path d='M0 0" + "a1 2 3 0 1 5 6" * 19_000 + "'/>",
        "<path d='" + "M0 0l1 1" * 19_000 + "'/>",
    ],
    ids=["cubics", "paths of cubics", "lines", "arcs", "one line many times"],
)
def test_a_megabyte_is_read_in_seconds(lengths, body):
    start = time.process_time()
    assert lengths(body)
    assert time.process_time() - start < 5
