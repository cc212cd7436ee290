//! Sums as named numbers, for tables.

use super::{AngularSums, Bin, Connectivity, Harmonic, KindSums, MOST_CONTACTS, Profile, Sums};
use gouge_common::estimators::Tensor;

/// Numbers of a kind of contacts.
const OF_KIND: usize = 22;

/// Names of the numbers of a kind of contacts, without the kind.
const NAMES: [&str; OF_KIND] = [
    "contacts",
    "contacts_cos",
    "contacts_sin",
    "normal_force",
    "normal_force_cos",
    "normal_force_sin",
    "tangential_force",
    "tangential_force_cos",
    "tangential_force_sin",
    "normal_branch",
    "normal_branch_cos",
    "normal_branch_sin",
    "tangential_branch",
    "tangential_branch_cos",
    "tangential_branch_sin",
    "abs_tangential_force",
    "sliding",
    "unequal",
    "stress_xx",
    "stress_xy",
    "stress_yx",
    "stress_yy",
];

impl Sums {
    /// Names of the numbers: side-vertex contacts first, then side-side contacts, then the number of steps.
    pub fn names() -> Vec<String> {
        let of = |kind: &'static str| NAMES.map(|name| format!("{kind}_{name}"));
        let steps = ["steps".to_owned()];
        of("sv").into_iter().chain(of("ss")).chain(steps).collect()
    }

    /// The numbers, in the order of [`Self::names`].
    pub fn values(&self) -> Vec<f64> {
        let kinds = [self.side_vertex, self.side_side].map(|sums| values(&sums));
        let steps = [self.steps];
        kinds.into_iter().flatten().chain(steps).collect()
    }

    /// The sums from their numbers; none if their number is wrong.
    pub fn from_values(numbers: &[f64]) -> Option<Self> {
        let (kinds, rest) = numbers.as_chunks::<OF_KIND>();
        let ([side_vertex, side_side], &[steps]) = (kinds, rest) else {
            return None;
        };
        Some(Self {
            side_vertex: sums(side_vertex),
            side_side: sums(side_side),
            steps,
        })
    }
}

fn values(sums: &KindSums) -> [f64; OF_KIND] {
    let Harmonic { sum, cos, sin } = sums.contacts;
    let [fn_, ft, ln, lt] = [
        sums.normal_force,
        sums.tangential_force,
        sums.normal_branch,
        sums.tangential_branch,
    ];
    let s = sums.stress;
    [
        sum,
        cos,
        sin,
        fn_.sum,
        fn_.cos,
        fn_.sin,
        ft.sum,
        ft.cos,
        ft.sin,
        ln.sum,
        ln.cos,
        ln.sin,
        lt.sum,
        lt.cos,
        lt.sin,
        sums.friction,
        sums.sliding,
        sums.unequal,
        s.xx,
        s.xy,
        s.yx,
        s.yy,
    ]
}

fn sums(numbers: &[f64; OF_KIND]) -> KindSums {
    let harmonic = |at: usize| Harmonic {
        sum: numbers[at],
        cos: numbers[at + 1],
        sin: numbers[at + 2],
    };
    KindSums {
        contacts: harmonic(0),
        normal_force: harmonic(3),
        tangential_force: harmonic(6),
        normal_branch: harmonic(9),
        tangential_branch: harmonic(12),
        friction: numbers[15],
        sliding: numbers[16],
        unequal: numbers[17],
        stress: Tensor {
            xx: numbers[18],
            xy: numbers[19],
            yx: numbers[20],
            yy: numbers[21],
        },
    }
}

impl Connectivity {
    /// Names of the numbers.
    pub fn names() -> Vec<String> {
        let counts = (0..=MOST_CONTACTS).map(|count| format!("bodies_with_{count}"));
        let sums = ["bodies", "connected", "contacts"].map(str::to_owned);
        sums.into_iter().chain(counts).collect()
    }

    /// The numbers, in the order of [`Self::names`].
    pub fn values(&self) -> Vec<f64> {
        let sums = [self.bodies, self.connected, self.contacts];
        sums.into_iter().chain(self.by_contacts).collect()
    }

    /// The counts from their numbers; none if their number is wrong.
    pub fn from_values(numbers: &[f64]) -> Option<Self> {
        let (&[bodies, connected, contacts], counts) = numbers.split_first_chunk()?;
        Some(Self {
            bodies,
            connected,
            contacts,
            by_contacts: counts.try_into().ok()?,
        })
    }
}

impl Profile {
    /// Names of the numbers.
    pub fn names() -> Vec<String> {
        let of = |name: &'static str| (0..Self::LAYERS).map(move |layer| format!("{name}_{layer}"));
        of("layer_area").chain(of("layer_flow")).collect()
    }

    /// The numbers, in the order of [`Self::names`].
    pub fn values(&self) -> Vec<f64> {
        self.area.into_iter().chain(self.flow).collect()
    }

    /// The sums from their numbers; none if their number is wrong.
    pub fn from_values(numbers: &[f64]) -> Option<Self> {
        let (&area, flow) = numbers.split_first_chunk()?;
        let flow = flow.try_into().ok()?;
        Some(Self { area, flow })
    }
}

impl AngularSums {
    /// Names of the numbers: the bins of the first half-turn, with the angles in degrees at which they begin. Those of the
    /// second one are the same.
    pub fn names() -> Vec<String> {
        let of = |bin: usize| {
            let degrees = bin * 360 / Self::BINS;
            Bin::NAMES.map(|name| format!("from_{degrees}_{name}"))
        };
        (0..Self::BINS / 2).flat_map(of).collect()
    }

    /// The numbers, in the order of [`Self::names`].
    pub fn values(&self) -> Vec<f64> {
        let bins = self.bins()[..Self::BINS / 2].iter();
        bins.flat_map(|bin| {
            [
                bin.contacts,
                bin.normal_force,
                bin.tangential_force,
                bin.normal_branch,
                bin.tangential_branch,
            ]
        })
        .collect()
    }

    /// The sums from their numbers; none if their number is wrong.
    pub fn from_values(numbers: &[f64]) -> Option<Self> {
        let (bins, []) = numbers.as_chunks::<5>() else {
            return None;
        };
        let bin = |&[
            contacts,
            normal_force,
            tangential_force,
            normal_branch,
            tangential_branch,
        ]: &[f64; 5]| Bin {
            contacts,
            normal_force,
            tangential_force,
            normal_branch,
            tangential_branch,
        };
        let half: Vec<Bin> = bins.iter().map(bin).collect();
        let all = half.iter().chain(&half).copied().collect::<Vec<Bin>>();
        all.try_into().ok().map(Self::of_bins)
    }
}
