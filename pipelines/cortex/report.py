"""index.html: one file that opens offline and says what one sees."""
import base64
import html

import whole_file

TITLES = {"lh": "Left hemisphere", "rh": "Right hemisphere"}

# picture: (heading, what one sees, what to look for)
FIGURES = {
    "cortex": (
        "The cortex and its elements",
        "The border of grey and white matter from the lateral and the medial side, and its flat map. "
        "Colour tells the place: what has the same colour is the same piece of cortex. The lines cut "
        "the map into equal squares; carried back, they cut the cortex into elements of equal area. "
        "Beige: the medial wall, which is no cortex and was removed to open the surface.",
        "Sulci must be open, without bridges; the medial wall must be one piece, bounded by the "
        "corpus callosum and the brainstem. Elements look small where they dive into a sulcus: their "
        "area is counted along its banks."),
    "flatmap": (
        "The flat map",
        "The same cortex flat: light gyri, dark sulci (depth below a smoothed surface). Red lines and "
        "names: regions of the atlas, read at the nearest labelled voxel. The compass gives the mean "
        "direction of superior (S) and anterior (A). Areas are true everywhere, so the bar and the "
        "square hold all over the map; shapes are not.",
        "The rim is the border of the medial wall. Find the central sulcus between precentral and "
        "postcentral, and the Sylvian fissure around the insula; if they are not where the names say, "
        "image and atlas are not aligned."),
    "checkerboard": (
        "A checkerboard carried back",
        "A board of equal squares on each map, drawn on the cortex. Above the initial (Tutte) map, "
        "below the area-preserving one.",
        "Above, squares of one board are many times larger in one place than in another. Below, all "
        "cover the same area of cortex; what is given up is their shape."),
    "distortion": (
        "Area distortion on the cortex",
        "log2 of the share of a triangle in the map over its share in the cortex: 0 (light) = "
        "preserved, 1 = twice, −1 = half. One scale for both maps.",
        "Below should be light throughout. Colour that remains sits near the rim or on needle-shaped "
        "triangles, and is what the last column of the histograms adds up to."),
    "histograms": (
        "Areas and angles, before and after",
        "Share of the cortex per bin of area distortion and of angle distortion, and the areas of the "
        "elements over their target, for the initial and the area-preserving map. The outermost bins "
        "hold what lies beyond.",
        "Blue should stand at 0 in the first and at 1 in the third chart. The second is the price: "
        "angles cannot be kept when areas are."),
    "field": (
        "A sampled field, per vertex and per element",
        "T1 signal sampled into the cortex: every vertex on the flat map, then its area-weighted mean "
        "per element, there and on the cortex.",
        "Elements average equal areas, so they have equal weight in statistics. Myelin-rich "
        "sensorimotor, visual and auditory cortex is brighter in T1."),
}

STYLE = """
body { font: 16px/1.5 sans-serif; color: #1a1a1f; max-width: 1700px; margin: 0 auto; padding: 1.2em; }
h1 { margin-bottom: .1em; } h2 { margin: 1.8em 0 .3em; border-bottom: 1px solid #ccc; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 1em; }
figure { margin: 0; } figcaption { font-weight: bold; text-align: center; }
img { width: 100%; border: 1px solid #e4e4e4; }
table { border-collapse: collapse; } td, th { padding: .2em .9em; border-bottom: 1px solid #e4e4e4; text-align: left; }
td.n { text-align: right; font-variant-numeric: tabular-nums; } tr.head th { background: #f3f3f5; }
.look { background: #eef3fa; border-left: 4px solid #0059b3; padding: .4em .8em; }
.note { background: #fff6e5; border-left: 4px solid #d65f00; padding: .4em .8em; }
code { background: #f3f3f5; padding: 0 .2em; } .scroll { overflow-x: auto; } p { max-width: 75em; }
"""

NOTE = ("Not a medical device. These maps and numbers are for research and teaching; they are not validated for, and "
        "must not be used in, diagnosis or treatment.")


def write(path, title, lead, tables, pictures, warnings):
    """Writes the page.

    tables    [(heading, [column titles], [[cells]])]
    pictures  {"lh": {picture: path}}, one column per hemisphere
    """
    parts = [f"<h1>{html.escape(title)}</h1>", f"<p>{html.escape(lead)}</p>", f'<p class="note">{NOTE}</p>']
    parts += [f'<p class="note">{html.escape(warning)}</p>' for warning in warnings]
    parts += [_table(*table) for table in tables[:1]]
    for name, (heading, seen, look) in FIGURES.items():
        shown = {side: paths[name] for side, paths in pictures.items() if name in paths}
        if shown:
            parts.append(_figure(heading, seen, look, shown))
    if not any(pictures.values()):
        parts.append('<p class="note">No pictures: there was no X server, and Xvfb is not installed.</p>')
    parts += [_table(*table) for table in tables[1:]]
    body = "\n".join(parts)
    text = (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>\n'
            f"<style>{STYLE}</style></head>\n<body>\n{body}\n</body></html>\n")
    whole_file.write_text(path, text)


def _figure(heading, seen, look, shown):
    figures = "\n".join(
        f'<figure><figcaption>{TITLES[side]}</figcaption><img alt="{html.escape(heading)}, {TITLES[side].lower()}" '
        f'src="data:image/png;base64,{base64.b64encode(path.read_bytes()).decode()}"></figure>'
        for side, path in shown.items())
    return (f"<h2>{html.escape(heading)}</h2>\n<p>{html.escape(seen)}</p>\n"
            f'<p class="look"><b>What to look for.</b> {html.escape(look)}</p>\n<div class="pair">{figures}</div>')


def _table(heading, columns, rows):
    head = "".join(f"<th>{html.escape(column)}</th>" for column in columns)
    lines = "\n".join("<tr>" + "".join(_cell(cell) for cell in row) + "</tr>" for row in rows)
    return (f'<h2>{html.escape(heading)}</h2>\n<div class="scroll"><table><tr class="head">{head}</tr>\n{lines}'
            "</table></div>")


def _cell(value):
    if isinstance(value, float):
        return f'<td class="n">{value:,.4g}</td>' if abs(value) < 1000 else f'<td class="n">{value:,.0f}</td>'
    if isinstance(value, int):
        return f'<td class="n">{value:,}</td>'
    return f"<td>{html.escape(str(value))}</td>"
