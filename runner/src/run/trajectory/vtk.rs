//! Legacy VTK files: one vertex per disc or one cell per polygon, one segment per line.

use super::super::table::Values;
use super::{Frame, LinkFrame, Shapes};
use crate::error::Error;
use gouge_common::geometry::Vec2;
use std::path::Path;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, DataSet, Piece, PolyDataPiece, Version, VertexNumbers, Vtk,
};

/// A frame as text.
///
/// # Errors
/// A frame that the library cannot write.
pub fn text(frame: &Frame) -> Result<String, Error> {
    let piece = match &frame.shapes {
        Shapes::Discs(_) => piece(frame, &[]),
        Shapes::Nodes(_, triangles) => piece(frame, triangles),
        Shapes::Polygons(_, outlines) => polygons(frame, outlines),
    };
    file(frame.time, &frame.note, piece)
}

/// Links as text: a segment from the centre of i to that of j, or beyond the seam to its image; their data belong to
/// the segments.
///
/// # Errors
/// A frame that the library cannot write.
pub fn links(frame: &LinkFrame) -> Result<String, Error> {
    let number = frame.segments.len() as u32;
    let lines: Vec<u32> = (0..number).flat_map(|n| [2, 2 * n, 2 * n + 1]).collect();
    let points: Vec<Vec2> = frame.segments.iter().copied().flatten().collect();
    let piece = PolyDataPiece {
        points: flat(&points).into(),
        verts: None,
        lines: (number > 0).then_some(VertexNumbers::Legacy {
            num_cells: number,
            vertices: lines,
        }),
        polys: None,
        strips: None,
        data: Attributes {
            point: vec![],
            cell: frame.links.columns.iter().map(scalar).collect(),
        },
    };
    file(frame.time, "", piece)
}

fn file(time: f64, note: &str, piece: PolyDataPiece) -> Result<String, Error> {
    let note = match note {
        "" => String::new(),
        note => format!(", {note}"),
    };
    let file = Vtk {
        version: Version::new_legacy(4, 2),
        title: format!("t = {time:?} s{note}"),
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

/// One vertex per particle, or one cell per triangle if there are any.
fn piece(frame: &Frame, triangles: &[[u32; 3]]) -> PolyDataPiece {
    let number = frame.positions.len() as u32;
    let vertices = (0..number).flat_map(|i| [1, i]).collect();
    let cells = triangles.iter().flat_map(|&[a, b, c]| [3, a, b, c]);
    let lines: Vec<u32> = frame
        .lines
        .iter()
        .flat_map(|&(i, j)| [2, i as u32, j as u32])
        .collect();
    PolyDataPiece {
        points: flat(&frame.positions).into(),
        verts: triangles.is_empty().then_some(VertexNumbers::Legacy {
            num_cells: number,
            vertices,
        }),
        lines: (!lines.is_empty()).then_some(VertexNumbers::Legacy {
            num_cells: lines.len() as u32 / 3,
            vertices: lines,
        }),
        polys: (!triangles.is_empty()).then_some(VertexNumbers::Legacy {
            num_cells: triangles.len() as u32,
            vertices: cells.collect(),
        }),
        strips: None,
        data: Attributes {
            point: attributes(frame).collect(),
            cell: vec![],
        },
    }
}

/// One cell per polygon, to which its data belong.
fn polygons(frame: &Frame, outlines: &[Vec<Vec2>]) -> PolyDataPiece {
    let mut corners = 0;
    let mut cells = Vec::new();
    for outline in outlines {
        let number = outline.len() as u32;
        cells.push(number);
        cells.extend(corners..corners + number);
        corners += number;
    }
    let points: Vec<Vec2> = outlines.iter().flatten().copied().collect();
    PolyDataPiece {
        points: flat(&points).into(),
        verts: None,
        lines: None,
        polys: Some(VertexNumbers::Legacy {
            num_cells: outlines.len() as u32,
            vertices: cells,
        }),
        strips: None,
        data: Attributes {
            point: vec![],
            cell: attributes(frame).collect(),
        },
    }
}

fn attributes(frame: &Frame) -> impl Iterator<Item = Attribute> + '_ {
    let radii = Attribute::scalars("radius", 1).with_data(frame.radii().to_vec());
    let vectors = frame
        .vectors
        .iter()
        .map(|(name, column)| Attribute::vectors(*name).with_data(flat(column)));
    let scalars = frame.scalars.columns.iter().map(scalar);
    [radii].into_iter().chain(vectors).chain(scalars)
}

fn scalar((name, values): &(&'static str, Values)) -> Attribute {
    let attribute = Attribute::scalars(*name, 1);
    let integers = |column: &[usize]| column.iter().map(|&x| x as i32).collect::<Vec<i32>>();
    match values {
        Values::Numbers(numbers) => attribute.with_data(numbers.clone()),
        Values::Integers(column) => attribute.with_data(integers(column)),
        Values::Kinds(kinds) => attribute.with_data(integers(&kinds.codes)),
    }
}

/// The components of all vectors in sequence; the third component is zero.
fn flat(column: &[Vec2]) -> Vec<f64> {
    column.iter().flat_map(|v| [v.x, v.y, 0.0]).collect()
}
