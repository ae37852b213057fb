# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the page of a report looks: its style, and the frame that everything stands in."""

import string

STYLE = """
:root { --ink: #14283c; --muted: #5b6b7b; --line: #d9e0e6; --wash: #f5f8fa; --accent: #1f5f99; }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: white;
       font: 15px/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 2.2rem 1.4rem 4rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.45rem; margin: 3.2rem 0 .3rem; padding-top: 1.2rem;
     border-top: 2px solid var(--ink); }
h3 { font-size: 1.02rem; margin: 1.8rem 0 .5rem; }
p { margin: .3rem 0 .8rem; max-width: 46rem; }
.muted, figcaption { color: var(--muted); }
nav ul { display: flex; flex-wrap: wrap; gap: .4rem 1.6rem; list-style: none; padding: 0; }
a { color: var(--accent); }
.numbers { display: flex; flex-wrap: wrap; gap: .7rem; margin: 1.1rem 0; padding: 0; }
.numbers div { flex: 1 1 8.2rem; background: var(--wash); border-radius: 8px;
               padding: .6rem .9rem; }
.numbers dt { color: var(--muted); font-size: .84rem; }
.numbers dd { margin: 0; font-size: 1.22rem; font-variant-numeric: tabular-nums; }
figure { margin: 1.4rem 0; padding: 1rem; border: 1px solid var(--line); border-radius: 10px; }
figure img { display: block; width: 100%; height: auto; }
figcaption { font-size: .9rem; margin-top: .6rem; }
.columns { display: flex; flex-wrap: wrap; gap: 0 2.6rem; }
.columns > div { flex: 1 1 20rem; min-width: 0; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: .92rem;
        font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: 600; border-bottom: 1.5px solid var(--ink); }
th, td { padding: .28rem .8rem .28rem 0; }
td { border-bottom: 1px solid var(--line); }
.units th, .units td { text-align: right; white-space: nowrap; }
ul.files { padding-left: 1.1rem; margin: .2rem 0; }
pre { background: var(--wash); border-radius: 8px; padding: .8rem 1rem; overflow-x: auto;
      font: 13px/1.45 "DejaVu Sans Mono", monospace; }
.problems { border-left: 4px solid #d81b72; background: #fdf0f5; padding: .6rem 1rem; }
ul.findings { list-style: none; padding: 0; }
.findings li { margin: .3rem 0; padding-left: 1.5rem; text-indent: -1.5rem; }
.findings li::before { display: inline-block; width: 1.5rem; text-indent: 0; font-weight: 700; }
.findings .note::before { content: "✓"; color: #2b7a4b; }
.findings .warning::before { content: "!"; color: #b36200; }
.findings .error::before { content: "✗"; color: #d81b72; }
footer { margin-top: 3.5rem; border-top: 1px solid var(--line); padding-top: .8rem;
         font-size: .88rem; }
@media print { main { max-width: none; padding: 0; } figure, .numbers div { break-inside: avoid; }
               h2 { break-before: page; border: 0; } }
"""

PAGE = string.Template("""<!DOCTYPE html>
<html lang="$language">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>$title</title>
<style>$style</style>
</head>
<body>
<main>
<header>
<h1>$title</h1>
<p class="muted">$subtitle</p>
$contents
</header>
$sections
<footer class="muted">
<p>$versions</p>
</footer>
</main>
$script
</body>
</html>
""")
