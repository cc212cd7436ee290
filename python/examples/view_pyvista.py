"""A sheared fault in PyVista: grains with their radii, coloured by their fragment."""

import gouge
import pyvista


def spheres(folder, overrides=None):
    """The grains of the last frame of a run as spheres."""
    overrides = {"output.trajectory": "vtk", **(overrides or {})}
    run = gouge.run("granite-fault-small", folder, overrides)
    grains = pyvista.read(max((run.folder / "trajectory").glob("frame_*.vtk")))
    sphere = pyvista.Sphere(radius=1.0, theta_resolution=16, phi_resolution=16)
    return grains.glyph(orient=False, scale="radius", geom=sphere)


if __name__ == "__main__":
    plotter = pyvista.Plotter(off_screen=True)
    plotter.add_mesh(spheres("out/pyvista"), scalars="fragment", cmap="tab20", show_scalar_bar=False)
    plotter.view_xy()
    plotter.screenshot("view_pyvista.png")
