//! Constrained Delaunay triangulations of chains of boundary nodes and points between them.

use super::boundary::Chains;
use gouge_common::geometry::Vec2;
use spade::handles::{FixedFaceHandle, FixedVertexHandle, InnerTag};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};

/// A triangulation of the convex hull of nodes with all pieces of the boundary as edges.
pub(super) struct Delaunay(ConstrainedDelaunayTriangulation<Point2<f64>>);

impl Delaunay {
    /// Triangulate nodes, of which the first are those of the chains. None if two coincide or pieces cross.
    pub(super) fn new(nodes: &[Vec2], chains: &Chains) -> Option<Self> {
        let points = nodes.iter().map(|node| Point2::new(node.x, node.y));
        let mut conflicts = 0;
        let cdt = ConstrainedDelaunayTriangulation::try_bulk_load_cdt(
            points.collect(),
            chains.edges.clone(),
            |_| conflicts += 1,
        );
        let cdt = cdt.ok()?;
        (conflicts == 0 && cdt.num_vertices() == nodes.len()).then_some(Self(cdt))
    }

    /// Triangles inside the shape, anticlockwise.
    ///
    /// The triangles to the left of the boundary are inside, and so are those reached from them without crossing it.
    pub(super) fn triangles(&self, chains: &Chains) -> Vec<[u32; 3]> {
        let mut inside = vec![false; self.0.num_all_faces()];
        let mut reached: Vec<_> = chains
            .edges
            .iter()
            .filter_map(|e| self.left_of(e))
            .collect();
        while let Some(face) = reached.pop() {
            if core::mem::replace(&mut inside[face.index()], true) {
                continue;
            }
            let edges = self.0.face(face).adjacent_edges();
            let open = edges.into_iter().filter(|edge| !edge.is_constraint_edge());
            reached.extend(open.filter_map(|edge| Some(edge.rev().face().as_inner()?.fix())));
        }
        let faces = self
            .0
            .inner_faces()
            .filter(|face| inside[face.fix().index()]);
        faces
            .map(|face| face.vertices().map(|vertex| vertex.index() as u32))
            .collect()
    }

    fn left_of(&self, &[from, to]: &[usize; 2]) -> Option<FixedFaceHandle<InnerTag>> {
        let vertex = FixedVertexHandle::from_index;
        let edge = self.0.get_edge_from_neighbors(vertex(from), vertex(to))?;
        Some(edge.face().as_inner()?.fix())
    }
}
