//! Where units are, and how wide strips may be.

/// Number of bins in which points are counted.
const BINS: usize = 1024;

/// Horizontal places of units.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    /// Place per unit in m; not finite for a unit that is not in one place.
    pub x: Vec<f64>,
    /// Period in m, if x is periodic.
    pub period: Option<f64>,
}

impl Places {
    /// Horizontal distance in m of two units within the same period.
    fn distance(&self, [one, other]: [u32; 2]) -> f64 {
        let d = self.x[one as usize] - self.x[other as usize];
        match self.period {
            Some(period) => d.abs().min((period - d.abs()).abs()),
            None => d.abs(),
        }
    }
}

/// Bins of equal width, of which strips are made.
pub(super) struct Grid<'a> {
    places: &'a Places,
    first: f64,
    length: f64,
    /// Smallest number of bins per strip: more than the largest distance of two units that touch.
    narrowest: usize,
}

impl<'a> Grid<'a> {
    /// Bins for all units; `None` if there is no width to divide.
    pub fn new(places: &'a Places, pairs: impl Iterator<Item = [u32; 2]>) -> Option<Self> {
        let finite = places.x.iter().filter(|x| x.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &x| {
            (low.min(x), high.max(x))
        });
        let (first, length) = match places.period {
            Some(period) => (0.0, period),
            None => (low, high - low),
        };
        if !(length.is_finite() && length > 0.0) {
            return None;
        }
        let distances = pairs.map(|pair| places.distance(pair));
        // Distances to units that are not in one place are not numbers.
        let reach = distances.fold(0.0, f64::max);
        let narrowest = (reach / length * BINS as f64).ceil() as usize + 1;
        Some(Self {
            places,
            first,
            length,
            narrowest,
        })
    }

    /// Largest number of strips.
    pub fn most_strips(&self) -> usize {
        BINS / self.narrowest
    }

    /// The bin of a place.
    pub fn bin(&self, x: f64) -> usize {
        let part = (x - self.first) / self.length;
        let part = match self.places.period {
            Some(_) if !(0.0..1.0).contains(&part) => part - part.floor(),
            _ => part,
        };
        ((part * BINS as f64) as usize).min(BINS - 1)
    }

    /// The strip of each bin, so that strips have about as many points each.
    pub fn strips(&self, pairs: impl Iterator<Item = [u32; 2]>, number: usize) -> [u8; BINS] {
        let mut counts = [0usize; BINS];
        let mut total = 0;
        for pair in pairs {
            let x = pair.map(|unit| self.places.x[unit as usize]);
            if let Some(x) = x.into_iter().find(|x| x.is_finite()) {
                counts[self.bin(x)] += 1;
                total += 1;
            }
        }
        let mut strips = [0; BINS];
        let (mut strip, mut begin, mut sum) = (0, 0, 0);
        for (bin, count) in counts.into_iter().enumerate() {
            let is_wide = bin - begin >= self.narrowest;
            let is_full = sum * number >= (strip + 1) * total;
            let is_last_chance = BINS - bin <= (number - 1 - strip) * self.narrowest;
            if strip + 1 < number && is_wide && (is_full || is_last_chance) {
                (strip, begin) = (strip + 1, bin);
            }
            strips[bin] = strip as u8;
            sum += count;
        }
        strips
    }
}
