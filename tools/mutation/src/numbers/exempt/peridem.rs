//! Exemptions of peridynamic grains.

use super::{Exemption, exempt};

const SEARCH: &str =
    "a search for candidates, whose distances are then compared with the exact bound";
const FINITE: &str = "whether it is finite does not depend on a factor";
const SWITCH: &str = "where one formula takes over from another with the same value";
const END: &str = "an edge forbids no segment that touches its box only at this end of either";
const START: &str =
    "a vector from which an iteration starts; any with a part of every mode will do";
const ROUNDING: &str = "how a point is moved by rounding errors until it is on the right side";
const RIM: &str = "the end of a chord on the rim of the disc, where the integrand vanishes";
const MARGIN: &str = "the extent of a lattice, whose outer points are left out anyway";

/// Exemptions of peridynamic grains.
pub const EXEMPTIONS: &[Exemption] = &[
    exempt(
        "kernel/peridem/src/bond_law.rs",
        "Elongation::pull",
        "TINIEST",
        "a distance too small to occur, below which a force fades",
    ),
    exempt(
        "kernel/peridem/src/bonds.rs",
        "Vicinity::new",
        "ROOM",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/bonds.rs",
        "ROOM * «horizon»",
        "horizon",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/contacts.rs",
        "Candidates::new",
        "0.5",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/contacts.rs",
        "Candidates::new",
        "radius",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/contacts.rs",
        "Candidates::is_near",
        "self.radii[i]",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/contacts.rs",
        "Candidates::is_near",
        "self.radii[j]",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/contacts.rs",
        "Candidates::is_near",
        "2.0",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/error.rs",
        "condition && «value».is_finite()",
        "value",
        FINITE,
    ),
    exempt(
        "kernel/peridem/src/forces/contact_pass.rs",
        "ContactPass::is_too_far",
        "self.contact.law.radius",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/forces/lanes.rs",
        "Lanes::compute",
        "1.0",
        "the length of bonds that only fill a vector",
    ),
    exempt(
        "kernel/peridem/src/forces/mod.rs",
        "Workspace::new",
        "settings.time_step",
        "the elastic forces of walls, for which it is set, do not depend on it",
    ),
    exempt(
        "kernel/peridem/src/forces/mod.rs",
        "Workspace::new",
        "contact.law.radius",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/forces/wall_pass.rs",
        "WallPass::add_forces",
        "self.walls.law.radius",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/interior/mod.rs",
        "boxes_meet",
        "b.x",
        END,
    ),
    exempt(
        "kernel/peridem/src/interior/mod.rs",
        "boxes_meet",
        "d.x",
        END,
    ),
    exempt(
        "kernel/peridem/src/interior/mod.rs",
        "boxes_meet",
        "b.y",
        END,
    ),
    exempt(
        "kernel/peridem/src/interior/mod.rs",
        "boxes_meet",
        "d.y",
        END,
    ),
    exempt(
        "kernel/peridem/src/interior/section_five.rs",
        "Corner::new",
        "1e-7",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/limits.rs",
        "Vibration::largest_eigenvalue",
        "CONVERGED",
        "when an iteration ends",
    ),
    exempt("kernel/peridem/src/limits.rs", "start", "1.0", START),
    exempt(
        "kernel/peridem/src/limits.rs",
        "start",
        "2.236_067_977",
        START,
    ),
    exempt("kernel/peridem/src/limits.rs", "start", "2.0", START),
    exempt(
        "kernel/peridem/src/limits.rs",
        "start",
        "2.645_751_311",
        START,
    ),
    exempt(
        "kernel/peridem/src/limits.rs",
        "Tridiagonal::is_above_all",
        "1.0",
        "divides the side of the first row, which is zero",
    ),
    exempt(
        "kernel/peridem/src/limits.rs",
        "-«law.radius»].map",
        "law.radius",
        "from this distance on, the whole disc is beyond the wall",
    ),
    exempt(
        "kernel/peridem/src/mesh/boundary.rs",
        "pieces",
        "1.0",
        "an edge of one piece has no nodes inside",
    ),
    exempt(
        "kernel/peridem/src/mesh/boundary.rs",
        "between",
        "1.0",
        ROUNDING,
    ),
    exempt(
        "kernel/peridem/src/mesh/boundary.rs",
        "between",
        "2.0",
        ROUNDING,
    ),
    exempt(
        "kernel/peridem/src/mesh/distance.rs",
        "smallest_distance",
        "point.y",
        "along which axis points are sorted",
    ),
    exempt(
        "kernel/peridem/src/mesh/distance.rs",
        "smallest_distance",
        "point.x",
        "along which axis points are sorted",
    ),
    exempt(
        "kernel/peridem/src/mesh/lattice.rs",
        "Mesh::lattice",
        "1e-9",
        "a tolerance for rounding",
    ),
    exempt(
        "kernel/peridem/src/mesh/lattice.rs",
        "offset / «spacing»",
        "spacing",
        MARGIN,
    ),
    exempt(
        "kernel/peridem/src/mesh/lattice.rs",
        "index(upper.x) + «2.0»",
        "2.0",
        MARGIN,
    ),
    exempt(
        "kernel/peridem/src/mesh/lattice.rs",
        "index(upper.y) + «2.0»",
        "2.0",
        MARGIN,
    ),
    exempt(
        "kernel/peridem/src/mesh/mod.rs",
        "Mesh::covering",
        "AREA_TOLERANCE",
        "a tolerance far above rounding and far below the parts of a mesh",
    ),
    exempt(
        "kernel/peridem/src/mesh/triangulated.rs",
        "bounds.lower) * «0.5»",
        "0.5",
        MARGIN,
    ),
    exempt(
        "kernel/peridem/src/mesh/triangulated.rs",
        "half.y / («HEIGHT»",
        "HEIGHT",
        MARGIN,
    ),
    exempt(
        "kernel/peridem/src/mesh/triangulated.rs",
        "half.y / (HEIGHT * «spacing»",
        "spacing",
        MARGIN,
    ),
    exempt(
        "kernel/peridem/src/mesh/triangulated.rs",
        "half.x / «spacing»",
        "spacing",
        MARGIN,
    ),
    exempt(
        "kernel/peridem/src/mesh/triangulated.rs",
        "distance_to",
        "1.0",
        "beyond the end of an edge is a vertex, near which points are left out anyway",
    ),
    exempt(
        "kernel/peridem/src/observables/connected.rs",
        "Cells::cell",
        "at.x",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/observables/connected.rs",
        "Cells::cell",
        "at.y",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/observables/connected.rs",
        "Cells::cell",
        "self.size",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/observables/connected.rs",
        "Vec2::new(«radius», radius)",
        "radius",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/observables/connected.rs",
        "Vec2::new(radius, «radius»)",
        "radius",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/observables/connected.rs",
        "size: «row.constants.horizon»",
        "row.constants.horizon",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/observables/gaps.rs",
        "vec![«0.5» * reach",
        "0.5",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/observables/gaps.rs",
        "vec![0.5 * «reach»",
        "reach",
        SEARCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "if «height» < SERIES_HEIGHT",
        "height",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "if height < «SERIES_HEIGHT»",
        "SERIES_HEIGHT",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "Segment::has_series",
        "self.height",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "Segment::has_series",
        "SERIES_HEIGHT",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "Segment::exact",
        "SERIES_HALF_CHORD",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "((radius + distance) / radius).clamp(0.0, «2.0»",
        "2.0",
        "a wall that does not reach the disc does not act",
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "Corner::shared",
        "self.first.distance",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "Corner::shared",
        "self.second.distance",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "Corner::shared",
        "1.0",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "(«other» > -wall",
        "other",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "(other > -«wall.half_chord»",
        "wall.half_chord",
        SWITCH,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "let s = «self.half_chord»;",
        "self.half_chord",
        RIM,
    ),
    exempt(
        "kernel/peridem/src/wall_law/segment.rs",
        "+ line.force(«wall.half_chord»)",
        "wall.half_chord",
        RIM,
    ),
];
