"""A sheared fault in OVITO's Python module: grains with their radii, coloured by their speed."""

import gouge
from ovito.io import import_file
from ovito.modifiers import ColorCodingModifier
from ovito.vis import TachyonRenderer, Viewport


def opened(folder, overrides=None):
    """The frames of a run, opened by OVITO."""
    overrides = {"output.trajectory": "extxyz", **(overrides or {})}
    run = gouge.run("granite-fault-small", folder, overrides)
    pipeline = import_file(str(run.folder / "trajectory" / "frame_*.xyz"))
    pipeline.modifiers.append(ColorCodingModifier(property="Velocity Magnitude"))
    return pipeline


if __name__ == "__main__":
    pipeline = opened("out/ovito")
    pipeline.add_to_scene()
    view = Viewport(type=Viewport.Type.Top)
    view.zoom_all()
    frame = pipeline.num_frames - 1
    view.render_image(filename="view_ovito.png", frame=frame, renderer=TachyonRenderer())
