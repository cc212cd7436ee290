//! Frames of a trajectory, for ParaView (VTK) and OVITO (extended XYZ).

use super::checkpoint::write_whole;
use super::output::unbroken_lines;
use crate::error::Error;
use crate::scene::{Scene, Trajectory, role_name};
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::estimators::fragments;
use gouge_dem::particles::Role;
use std::fmt::Write;
use std::path::Path;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, DataSet, Piece, PolyDataPiece, Version, VertexNumbers, Vtk,
};

/// Write the frame of a sample, if the scene asks for frames.
///
/// # Errors
/// Failures of the file system.
pub fn write_frame(scene: &Scene, folder: &Path, sample: u64, world: &World) -> Result<(), Error> {
    let (ending, text) = match scene.output.trajectory {
        Trajectory::None => return Ok(()),
        Trajectory::Vtk => ("vtk", vtk(scene, world)?),
        Trajectory::Extxyz => ("xyz", extxyz(scene, world)),
    };
    let frames = folder.join("trajectory");
    std::fs::create_dir_all(&frames).map_err(|error| Error::file("create", &frames, error))?;
    write_whole(
        &frames.join(format!("frame_{sample:06}.{ending}")),
        text.as_bytes(),
    )?;
    if scene.output.trajectory == Trajectory::Vtk {
        write_series(scene, &frames, sample)?;
    }
    Ok(())
}

/// Remove the frames that an earlier run left, and nothing else.
///
/// # Errors
/// Failures of the file system.
pub fn remove_frames(folder: &Path) -> Result<(), Error> {
    let frames = folder.join("trajectory");
    let Ok(entries) = std::fs::read_dir(&frames) else {
        return Ok(());
    };
    for entry in entries.flatten() {
        let (path, name) = (entry.path(), entry.file_name());
        let name = name.to_string_lossy();
        if name.starts_with("frame_") || name.starts_with("run.vtk") {
            std::fs::remove_file(&path).map_err(|error| Error::file("replace", &path, error))?;
        }
    }
    // It stays if something else is in it.
    let _ = std::fs::remove_dir(&frames);
    Ok(())
}

/// The list of frames and their times that ParaView opens as one animation.
fn write_series(scene: &Scene, frames: &Path, last: u64) -> Result<(), Error> {
    let entry = |sample: u64| {
        let time = (sample as f64 * scene.output.interval).min(scene.end);
        format!("    {{ \"name\": \"frame_{sample:06}.vtk\", \"time\": {time:?} }}")
    };
    let files: Vec<String> = (0..=last).map(entry).collect();
    let text = format!(
        "{{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n{}\n  ]\n}}\n",
        files.join(",\n")
    );
    write_whole(&frames.join("run.vtk.series"), text.as_bytes())
}

fn extxyz(scene: &Scene, world: &World) -> String {
    let p = world.particles();
    let fragments = fragments(world.state());
    let mut text = format!("{}\n", p.len());
    if let (Some(width), Some(height)) = (scene.domain.width, scene.domain.height) {
        let depth = 2.0 * p.largest_radius();
        let _ = write!(
            text,
            "Lattice=\"{width:?} 0 0 0 {height:?} 0 0 0 {depth:?}\" "
        );
    }
    let periodic = if scene.domain.periodic { "T" } else { "F" };
    let _ = writeln!(
        text,
        "Properties=id:I:1:species:S:1:pos:R:3:velo:R:3:radius:R:1:angle:R:1:angular_velocity:R:1:fragment:I:1 \
         pbc=\"{periodic} F F\" Time={:?}",
        world.time()
    );
    for i in 0..p.len() {
        let (x, v) = (p.position[i], p.velocity[i]);
        let _ = writeln!(
            text,
            "{i} {} {:?} {:?} 0 {:?} {:?} 0 {:?} {:?} {:?} {}",
            role_name(p.role[i]),
            x.x,
            x.y,
            v.x,
            v.y,
            p.radius[i],
            p.angle[i],
            p.angular_velocity[i],
            fragments.label[i]
        );
    }
    text
}

/// A legacy VTK file: a vertex a particle, a line a bond.
fn vtk(scene: &Scene, world: &World) -> Result<String, Error> {
    let p = world.particles();
    let flat = |column: &[Vec2]| {
        column
            .iter()
            .flat_map(|v| [v.x, v.y, 0.0])
            .collect::<Vec<f64>>()
    };
    let fragments: Vec<i32> = fragments(world.state())
        .label
        .iter()
        .map(|&label| label as i32)
        .collect();
    let roles: Vec<i32> = p
        .role
        .iter()
        .map(|role| match role {
            Role::Free => 0,
            Role::Driven => 1,
            Role::Fixed => 2,
        })
        .collect();
    let vertices = (0..p.len() as u32).flat_map(|i| [1, i]).collect();
    let bonds: Vec<u32> = unbroken_lines(scene, world)
        .flat_map(|(i, j)| [2, i as u32, j as u32])
        .collect();
    let piece = PolyDataPiece {
        points: flat(&p.position).into(),
        verts: Some(VertexNumbers::Legacy {
            num_cells: p.len() as u32,
            vertices,
        }),
        lines: (!bonds.is_empty()).then_some(VertexNumbers::Legacy {
            num_cells: bonds.len() as u32 / 3,
            vertices: bonds,
        }),
        polys: None,
        strips: None,
        data: Attributes {
            point: vec![
                Attribute::scalars("radius", 1).with_data(p.radius.clone()),
                Attribute::vectors("velocity").with_data(flat(&p.velocity)),
                Attribute::scalars("angle", 1).with_data(p.angle.clone()),
                Attribute::scalars("angular_velocity", 1).with_data(p.angular_velocity.clone()),
                Attribute::scalars("fragment", 1).with_data(fragments),
                Attribute::scalars("role", 1).with_data(roles),
            ],
            cell: vec![],
        },
    };
    let file = Vtk {
        version: Version::new_legacy(4, 2),
        title: format!("t = {:?} s", world.time()),
        byte_order: ByteOrder::BigEndian,
        file_path: None,
        data: DataSet::PolyData {
            meta: None,
            pieces: vec![Piece::Inline(Box::new(piece))],
        },
    };
    let mut text = String::new();
    file.write_legacy_ascii(&mut text).map_err(|error| {
        Error::file(
            "write",
            Path::new("trajectory"),
            std::io::Error::other(error.to_string()),
        )
    })?;
    Ok(text)
}
