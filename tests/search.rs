//! The search finds every near pair once, wherever grains are and however their sizes differ, and its work grows
//! with their number only.

use gouge_common::geometry::{Domain, Metric, Vec2, WithMetric};
use gouge_common::neighbors::{CellIndex, Cells, Neighbors, SearchSpheres};
use gouge_common::pair::Pair;
use proptest::prelude::*;

/// Grains of a cloud.
#[derive(Clone, Debug, Default)]
struct Cloud {
    positions: Vec<Vec2>,
    radii: Vec<f64>,
}

impl Cloud {
    fn spheres(&self) -> SearchSpheres<'_, f64> {
        SearchSpheres {
            positions: &self.positions,
            radii: &self.radii,
        }
    }

    fn with(mut self, x: f64, y: f64, radius: f64) -> Self {
        self.positions.push(Vec2::new(x, y));
        self.radii.push(radius);
        self
    }

    /// Equal grains of radius one in a square, at distances in radii.
    fn square(number: usize, distance: f64) -> Self {
        let side = (number as f64).sqrt().ceil() as usize;
        (0..number).fold(Self::default(), |cloud, k| {
            let (column, row) = (k % side, k / side);
            cloud.with(column as f64 * distance, row as f64 * distance, 1.0)
        })
    }

    fn moved(mut self, x: f64, y: f64) -> Self {
        for position in &mut self.positions {
            *position += Vec2::new(x, y);
        }
        self
    }

    fn and(mut self, other: Self) -> Self {
        self.positions.extend(other.positions);
        self.radii.extend(other.radii);
        self
    }

    /// The distance beyond touch up to which pairs are listed.
    fn skin(&self, domain: &Domain) -> f64 {
        let largest = self.radii.iter().copied().fold(0.0, f64::max);
        // The mean, of which radii above ten times the median are cut.
        let mut sorted = self.radii.clone();
        sorted.sort_by(f64::total_cmp);
        let most = sorted
            .get(sorted.len() / 2)
            .map_or(0.0, |median| 10.0 * median);
        let cut = self.radii.iter().map(|radius| radius.min(most));
        let mean = cut.sum::<f64>() / self.radii.len().max(1) as f64;
        let available = domain
            .period()
            .map_or(f64::INFINITY, |w| 0.5 * w - 2.0 * largest);
        (0.2 * mean).min(available).max(0.0)
    }
}

const OPEN: Domain = Domain {
    width: None,
    height: None,
    periodic: false,
};

fn given(width: f64, height: f64) -> Domain {
    Domain {
        width: Some(width),
        height: Some(height),
        periodic: false,
    }
}

fn periodic(width: f64) -> Domain {
    Domain {
        width: Some(width),
        height: None,
        periodic: true,
    }
}

/// Rebuilds a list.
struct Rebuild<'a>(&'a Cloud, &'a mut Neighbors<f64>);

impl WithMetric for Rebuild<'_> {
    type Output = Vec<Pair>;
    fn call<M: Metric>(self, metric: M) -> Vec<Pair> {
        let mut pairs = Vec::new();
        self.1
            .rebuild(metric, self.0.spheres(), |_, _| true, &mut pairs);
        pairs
    }
}

/// All near pairs, by brute force.
struct Near<'a>(&'a Cloud, f64);

impl WithMetric for Near<'_> {
    type Output = Vec<Pair>;
    fn call<M: Metric>(self, metric: M) -> Vec<Pair> {
        let Self(cloud, skin) = self;
        let mut pairs = Vec::new();
        for j in 0..cloud.radii.len() {
            for i in 0..j {
                let d = metric.displacement(cloud.positions[i], cloud.positions[j]);
                let reach = cloud.radii[i] + cloud.radii[j] + skin;
                if d.norm_squared() <= reach * reach {
                    pairs.push(Pair::new(i, j));
                }
            }
        }
        pairs
    }
}

fn listed(cloud: &Cloud, domain: &Domain) -> Vec<Pair> {
    let mut neighbors = Neighbors::new(cloud.spheres(), domain);
    domain.with_metric(Rebuild(cloud, &mut neighbors))
}

fn near(cloud: &Cloud, domain: &Domain) -> Vec<Pair> {
    domain.with_metric(Near(cloud, cloud.skin(domain)))
}

/// Clouds within a unit square, with radii over as many decades as given.
fn clouds(decades: f64) -> impl Strategy<Value = Cloud> {
    let grain = (0.0..1.0, 0.0..1.0, -decades..0.0);
    prop::collection::vec(grain, 0..80).prop_map(|grains| {
        grains
            .iter()
            .fold(Cloud::default(), |cloud, &(x, y, size)| {
                cloud.with(x, y, 0.2 * 10.0_f64.powf(size))
            })
    })
}

/// Coordinates far away.
fn far() -> impl Strategy<Value = f64> {
    (any::<bool>(), 0.0..300.0).prop_map(|(left, exponent)| {
        let distance = 10.0_f64.powf(exponent);
        if left { -distance } else { distance }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn open_clouds_of_any_sizes_equal_brute_force(
        cloud in (0.01..4.5).prop_flat_map(clouds),
        at in (-50.0..50.0, -50.0..50.0),
        outliers in prop::collection::vec((far(), far(), 1e-5..0.2), 0..4),
        extent in (1e-3..3.0, 1e-3..3.0),
        fits in any::<bool>(),
    ) {
        let far_away = outliers.iter().fold(Cloud::default(), |all, &(x, y, r)| all.with(x, y, r));
        let cloud = cloud.moved(at.0, at.1).and(far_away);
        let domain = if fits { OPEN } else { given(extent.0, extent.1) };
        prop_assert_eq!(listed(&cloud, &domain), near(&cloud, &domain));
    }

    #[test]
    fn periodic_clouds_of_any_sizes_equal_brute_force(
        cloud in (0.01..4.5).prop_flat_map(clouds),
        width in prop_oneof![0.0..1.0, Just(0.0), 1.0..1e3],
        up in prop_oneof![Just(1.0), far()],
        edges in any::<bool>(),
    ) {
        let mut cloud = cloud;
        let largest = cloud.radii.iter().copied().fold(0.01, f64::max);
        // The narrowest valid box is two diameters wide.
        let width = 4.0 * largest * (1.0 + width);
        for (k, position) in cloud.positions.iter_mut().enumerate() {
            let edge = if k % 2 == 0 { 0.0 } else { width };
            position.x = if edges && k % 3 == 0 { edge } else { position.x * width };
            position.y *= if k % 5 == 0 { up } else { 1.0 };
        }
        let domain = periodic(width);
        prop_assert_eq!(listed(&cloud, &domain), near(&cloud, &domain));
    }

    /// As when bonds are sought with radii that the box is too narrow for.
    #[test]
    fn a_box_narrower_than_a_grain_equals_brute_force(cloud in clouds(1.0), width in 0.01..0.5) {
        let mut cloud = cloud;
        for position in &mut cloud.positions {
            position.x *= width;
        }
        let domain = periodic(width);
        prop_assert_eq!(listed(&cloud, &domain), near(&cloud, &domain));
    }

    #[test]
    fn runs_around_a_cell_are_all_cells_at_a_distance_of_one(
        columns in prop::option::of(1..7_i64), x in 0..7_i64, y in -3..3_i64,
    ) {
        let cells = Cells::new(1.0, columns.map(|all| all as f64 + 0.5));
        let own = CellIndex { x: x % columns.unwrap_or(7), y };
        let columns = columns.map_or(-2..9, |all| 0..all);
        let all = (-5..5).flat_map(|y| columns.clone().map(move |x| CellIndex { x, y }));
        for cell in all {
            let runs = || cells.around(own);
            let is_near = cells.distance(own, cell) <= 1;
            let times = runs().filter(|run| run.contains(cell)).count();
            prop_assert_eq!(times, usize::from(is_near), "{:?} {:?}", own, cell);
            let times = runs().filter(|run| run.from(own).contains(cell)).count();
            prop_assert_eq!(times, usize::from(is_near && cell >= own), "{:?} {:?}", own, cell);
        }
    }
}

#[test]
fn cells_have_the_side_asked_for_or_divide_the_period() {
    assert_eq!(Cells::new(0.3, None).side(), Vec2::new(0.3, 0.3));
    for (period, columns) in [
        (0.2, 1.0),
        (0.3, 1.0),
        (0.5, 1.0),
        (0.7, 2.0),
        (30.1, 100.0),
    ] {
        let side = Cells::new(0.3, Some(period)).side();
        assert_eq!(side, Vec2::new(period / columns, 0.3), "{period}");
    }
}

/// Positions that are not finite are near nothing.
#[test]
fn positions_that_are_not_finite_are_searched_without_harm() {
    let bad = [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, -1e300];
    let mut cloud = Cloud::square(9, 2.0);
    for x in bad {
        for y in bad {
            cloud = cloud.with(x, y, 1e-3).with(0.0, y, 2.0);
        }
    }
    for domain in [OPEN, given(1.0, 1.0), periodic(40.0)] {
        assert_eq!(listed(&cloud, &domain), near(&cloud, &domain), "{domain:?}");
    }
}

/// How many grains a search looks at, per grain.
fn work(cloud: &Cloud, domain: &Domain) -> f64 {
    let mut neighbors = Neighbors::new(cloud.spheres(), domain);
    domain.with_metric(Rebuild(cloud, &mut neighbors));
    neighbors.examined() as f64 / cloud.radii.len() as f64
}

const MANY: usize = 4000;

#[test]
fn the_work_per_grain_does_not_depend_on_where_grains_are() {
    let block = || Cloud::square(MANY, 2.05);
    let usual = work(&block(), &OPEN);
    assert!((5.0..8.0).contains(&usual), "{usual}");
    let row = (0..MANY).fold(Cloud::default(), |row, k| {
        row.with(2.05 * k as f64, 0.0, 1.0)
    });
    let column = (0..MANY).fold(Cloud::default(), |all, k| {
        all.with(0.0, 2.05 * k as f64, 1.0)
    });
    let cases = [
        ("far grain", block().with(1e9, -1e12, 1.0), OPEN),
        ("farthest grain", block().with(-1e300, 1e300, 1.0), OPEN),
        ("far cloud", block().moved(1e10, -1e9), OPEN),
        ("two clouds", block().and(block().moved(-1e8, 1e5)), OPEN),
        ("small box", block(), given(1.0, 1.0)),
        ("elsewhere", block().moved(5e3, -5e3), given(100.0, 100.0)),
        ("wide box", block().moved(1e6, 0.0), given(1e9, 1e9)),
        ("wide period", block().moved(1e6, 0.0), periodic(1e9)),
        (
            "across the seam",
            block().moved(0.0, 9e7),
            periodic(65.0 * 2.05),
        ),
        ("row", row.clone().with(1e7, 1e7, 1.0), OPEN),
        ("column", column.clone().with(1e7, 1e7, 1.0), OPEN),
        ("periodic column", column, periodic(4.5)),
    ];
    for (name, cloud, domain) in cases {
        let found = work(&cloud, &domain);
        assert!(found < 1.5 * usual, "{name}: {found} instead of {usual}");
    }
}

#[test]
fn sparse_grains_at_regular_distances_cost_no_more() {
    for distance in [3, 8, 64, 100, 1024, 4096, 1_000_000] {
        // As many cells as asked, whose sides are 17/16 of the reach.
        let cloud = Cloud::square(MANY, f64::from(distance) * 2.2 * 17.0 / 16.0);
        let found = work(&cloud, &OPEN);
        assert!(found < 10.0, "{distance}: {found}");
    }
}

#[test]
fn a_cloud_that_leaves_its_first_place_costs_no_more() {
    let mut cloud = Cloud::square(MANY, 2.05);
    let mut neighbors = Neighbors::new(cloud.spheres(), &OPEN);
    let mut examined = |cloud: &Cloud| {
        OPEN.with_metric(Rebuild(cloud, &mut neighbors));
        neighbors.examined()
    };
    let at_first = examined(&cloud);
    for _ in 0..20 {
        cloud = cloud.moved(30.7, -41.3);
        assert!(examined(&cloud) < at_first * 5 / 4);
    }
}

#[test]
fn large_grains_among_small_ones_cost_no_more() {
    let small = || Cloud::square(MANY, 2.05);
    let usual = work(&small(), &OPEN);
    let with = |radii: &[f64]| {
        let large = radii
            .iter()
            .fold(Cloud::default(), |all, &r| all.with(-r, -r, r));
        work(&small().and(large), &OPEN)
    };
    // Larger ones would raise the mean radius and with it the skin.
    for radius in [10.0, 1e2, 1e3] {
        let found = with(&[radius]);
        assert!(found < usual + 2.0, "{radius}: {found} instead of {usual}");
    }
    let found = with(&[3.0, 10.0, 30.0, 100.0, 300.0]);
    assert!(found < usual + 10.0, "{found} instead of {usual}");
}

/// Radii over three decades, the smaller the more grains.
#[test]
fn the_work_per_grain_of_a_cloud_of_all_sizes_grows_slowly() {
    let cloud = |number: usize| {
        // The numbers of grains above a radius fall with its square, so that areas of all classes are equal.
        let unit = |k: usize, step: f64| (k as f64 * step).fract();
        let side = (number as f64).sqrt();
        (0..number).fold(Cloud::default(), |cloud, k| {
            let radius = 0.3 / (1e-6 + (1.0 - 1e-6) * unit(k, 0.754_877_666)).sqrt();
            let (x, y) = (unit(k, 0.618_033_989), unit(k, 0.414_213_562));
            cloud.with(x * side * 3.0, y * side * 3.0, radius)
        })
    };
    let [few, many] = [MANY, 4 * MANY].map(|number| work(&cloud(number), &OPEN));
    assert!(many < 1.5 * few && many < 100.0, "{few} {many}");
}
