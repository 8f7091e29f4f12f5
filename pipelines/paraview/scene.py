"""What the picture shows: two maps of one cortex, each also on the cortex itself, in one scale of colours."""
from paraview import simple

TITLES = ("Mean-value map", "Area-preserving map")
SIZE = (1600, 1500)
LIMIT = 6  # log2: deep blue = 1/64 of its share of area or less, deep red = 64 times or more
INK = [0.12, 0.12, 0.14]
DISTORTION = "VertexAreaDistortion"
LIFT = 0.002  # of lines above the flat map, in units of the disk


def colours():
    """Blue – light grey – red, symmetric: grey = area preserved."""
    table = simple.GetColorTransferFunction(DISTORTION)
    table.ApplyPreset("Cool to Warm", True)
    table.RescaleTransferFunction(-LIMIT, LIMIT)
    table.AutomaticRescaleRangeMode = "Never"
    return table


def window(title):
    """An empty view with a white ground, ready for layout."""
    made = simple.CreateView("RenderView", registrationName=title)
    made.UseColorPaletteForBackground = 0
    made.Background = [1, 1, 1]
    made.OrientationAxesVisibility = 0
    made.CameraParallelProjection = 1
    return made


def write_title(text, made):
    shown = simple.Show(simple.Text(registrationName="Title: " + text, Text=text), made)
    shown.FontSize, shown.Color, shown.WindowLocation = 18, INK, "Upper Center"


def show_distorted(proxy, made):
    """A surface or a map, coloured by what the map does to areas."""
    shown = simple.Show(proxy, made)
    shown.Representation = "Surface"
    simple.ColorBy(shown, ("POINTS", DISTORTION))
    shown.LookupTable = colours()
    shown.SetScalarBarVisibility(made, False)
    return shown


def show_lines(proxy, made, width):
    shown = simple.Show(proxy, made)
    shown.Representation = "Wireframe"
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = INK
    shown.LineWidth = width
    return shown


def on_cortex(map_, name):
    """The map with its points moved back to where they came from, shaded smoothly."""
    back = simple.Calculator(registrationName=name, Input=map_, Function="OriginalPoints", CoordinateResults=1)
    return simple.GenerateSurfaceNormals(registrationName=name + "Shaded", Input=back, FeatureAngle=180.0)


def look_at_map(made):
    made.CameraFocalPoint, made.CameraPosition, made.CameraViewUp = [0, 0, 0], [0, 0, 10], [0, 1, 0]
    made.CameraParallelScale = 1.1


def look_at_cortex(made, bounds):
    """From the side that looks out of the head, nose to the left or right as it comes."""
    middle = [(bounds[k] + bounds[k + 1]) / 2 for k in (0, 2, 4)]
    outward = -1 if middle[0] < 0 else 1
    made.CameraFocalPoint = middle
    made.CameraPosition = [middle[0] + 500 * outward, middle[1], middle[2]]
    made.CameraViewUp = [0, 0, 1]
    made.CameraParallelScale = 0.5 * max(bounds[3] - bounds[2], bounds[5] - bounds[4])


def show_bar(made):
    bar = simple.GetScalarBar(colours(), made)
    bar.Title, bar.ComponentTitle = "log2 (area on the map / share of area)", ""
    bar.Orientation, bar.WindowLocation = "Horizontal", "Any Location"
    bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = [0.2, 0.02], 0.6, 14
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize, bar.LabelFontSize = 16, 14
    bar.UseCustomLabels, bar.CustomLabels, bar.AddRangeLabels = 1, list(range(-LIMIT, LIMIT + 1, 2)), 0
    bar.LabelFormat, bar.Visibility = "%-#.0f", 1


def row(title, map_, borders):
    """(map, cortex): the two views of one map, with the borders of elements where there are any."""
    name = title.title().replace("-", "").replace(" ", "")
    flat, folded = window(title + ", flat"), window(title + ", on the cortex")
    write_title(title, flat)
    write_title(title + ", on the cortex", folded)
    shown = show_distorted(map_, flat)
    shown.Ambient, shown.Diffuse = 1.0, 0.0  # the colours of the scale, unshaded
    show_distorted(on_cortex(map_, name + "OnCortex"), folded)
    rim = simple.FeatureEdges(registrationName=name + "Rim", Input=map_, FeatureEdges=0, NonManifoldEdges=0)
    show_lines(rim, flat, 2).Position = [0, 0, LIFT]
    if borders:
        image = simple.Calculator(registrationName="BordersOnMap", Input=borders, Function="ImagePoints",
                                  CoordinateResults=1)
        show_lines(image, flat, 2).Position = [0, 0, LIFT]
        show_lines(borders, folded, 3)
    return flat, folded


def arrange(rows):
    """Two rows of two views in one layout."""
    layout = simple.CreateLayout("Flattened cortex")
    below = layout.SplitVertical(0, 0.5)
    for cell, views in zip((below, below + 1), rows):
        left = layout.SplitHorizontal(cell, 0.5)
        for place, made in zip((left, left + 1), views):
            layout.AssignView(place, made.SMProxy)
    return layout


def draw(surface, angles, elements, folder):
    """Fills a layout and writes it as flattened.png."""
    simple._DisableFirstRenderCameraReset()
    bounds = surface.GetDataInformation().GetBounds()
    rows = [row(TITLES[0], angles, None),
            row(TITLES[1], simple.OutputPort(elements, 0), simple.OutputPort(elements, 1))]
    show_bar(rows[0][1])
    layout = arrange(rows)
    layout.SetSize(SIZE[0], SIZE[1])
    for flat, folded in rows:
        look_at_map(flat)
        look_at_cortex(folded, bounds)
        for made in (flat, folded):
            simple.Render(made)
    path = folder / "flattened.png"
    simple.SaveScreenshot(str(path), layout, ImageResolution=list(SIZE), SeparatorWidth=0)
    print(f"Picture: {path}", flush=True)
