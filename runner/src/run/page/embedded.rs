//! The samples of a run as few bytes, for the script of the page.

use super::animation::{Grain, Recording};
use super::player::Drawn;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde::Serialize;
use std::f32::consts::TAU;

/// Most bytes of all shown samples, before they are encoded.
const MOST: usize = 2_400_000;
/// Bytes per grain and sample: two coordinates of two bytes, and angle, colour, speed and pressure of one byte.
const WIDTH: usize = 8;
/// Largest coordinate; the one above it means that a grain is outside of the view.
const LAST: f32 = 65_534.0;
const OUTSIDE: u16 = 65_535;
/// Part of all values that a scale of colours covers.
const COVERED: f64 = 0.995;

/// What the script reads.
#[derive(Debug, Serialize)]
pub struct Motion {
    /// Number of grains.
    grains: usize,
    /// Times of the samples in s.
    times: Vec<f64>,
    /// Width and height of the view in m.
    size: [f32; 2],
    /// Length in m that the coordinates divide into 65 534 parts: the longer side of the view.
    extent: f32,
    /// Speed in m/s at the end of its scale.
    speed: f32,
    /// Pressure in Pa at the end of its scale; at its beginning it is the same tension.
    pressure: f32,
    /// Radii in parts of the extent.
    radii: String,
    /// Numbers of sides, 0 for discs; empty if there are only discs.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    sides: Vec<u16>,
    /// Whether colours are numbers from 0 to 255 on a scale.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    scale: bool,
    /// The samples, each as columns: x, y, angles, colours, speeds, pressures.
    samples: String,
    /// Whether grains are outside of the view in some sample.
    #[serde(skip)]
    pub loses_grains: bool,
}

/// The samples that fit into a page: every k-th one, and the last; none if not even two fit.
pub fn chosen(recording: &Recording, particles: usize) -> Vec<usize> {
    let (number, fitting) = (recording.len(), MOST / (WIDTH * particles.max(1)));
    if fitting < 2 || number == 0 {
        return Vec::new();
    }
    let step = number.div_ceil(fitting);
    let mut chosen: Vec<usize> = (0..number).step_by(step).collect();
    if chosen.last() != Some(&(number - 1)) {
        chosen.pop();
        chosen.push(number - 1);
    }
    chosen
}

impl Motion {
    /// The motion of grains in samples with the given times in s.
    pub fn new(recording: &Recording, samples: &[usize], times: Vec<f64>, drawn: &Drawn) -> Self {
        let radii = drawn.radii;
        let view = View::of(recording, samples, radii);
        let all = || samples.iter().flat_map(|&sample| recording.sample(sample));
        let speed = quantile(all().map(|grain| grain.numbers[3]).collect());
        let pressure = quantile(all().map(|grain| grain.numbers[4].abs()).collect());
        let mut bytes = Vec::with_capacity(samples.len() * radii.len() * WIDTH);
        for &sample in samples {
            let grains: Vec<Grain> = recording.sample(sample).collect();
            let places: Vec<[u16; 2]> = grains.iter().map(|grain| view.place(grain)).collect();
            places
                .iter()
                .for_each(|place| bytes.extend(place[0].to_le_bytes()));
            places
                .iter()
                .for_each(|place| bytes.extend(place[1].to_le_bytes()));
            bytes.extend(
                grains
                    .iter()
                    .map(|grain| part((grain.numbers[2] / TAU).rem_euclid(1.0), 256.0)),
            );
            bytes.extend(grains.iter().map(|grain| grain.colour));
            bytes.extend(
                grains
                    .iter()
                    .map(|grain| part(grain.numbers[3] / speed, 255.0)),
            );
            bytes.extend(
                grains
                    .iter()
                    .map(|grain| part(0.5 + 0.5 * grain.numbers[4] / pressure, 255.0)),
            );
        }
        let loses_grains = all().any(|grain| view.place(&grain)[0] == OUTSIDE);
        let radii = radii
            .iter()
            .map(|&r| (LAST * r as f32 / view.extent()).round() as u16);
        let radii: Vec<u8> = radii.flat_map(u16::to_le_bytes).collect();
        Self {
            grains: radii.len() / 2,
            times,
            size: view.size,
            extent: view.extent(),
            speed,
            pressure,
            radii: BASE64_STANDARD.encode(radii),
            sides: drawn.sides.to_vec(),
            scale: drawn.is_scale,
            samples: BASE64_STANDARD.encode(bytes),
            loses_grains,
        }
    }
}

/// A part of a scale as a byte.
fn part(part: f32, steps: f32) -> u8 {
    (steps * part) as u8
}

/// The value that most of some values do not exceed; one if that is not a positive number.
fn quantile(mut values: Vec<f32>) -> f32 {
    let place = (COVERED * values.len() as f64) as usize;
    let place = place.min(values.len().saturating_sub(1));
    if values.is_empty() {
        return 1.0;
    }
    let (_, &mut value, _) = values.select_nth_unstable_by(place, f32::total_cmp);
    if value > 0.0 && value.is_finite() {
        value
    } else {
        1.0
    }
}

/// The region that is shown: all grains in all samples, but at most three times the size of the first sample.
struct View {
    low: [f32; 2],
    size: [f32; 2],
}

impl View {
    fn of(recording: &Recording, samples: &[usize], radii: &[f64]) -> Self {
        let first = samples
            .first()
            .map(|&sample| Box::of(recording.sample(sample), radii));
        let all = samples
            .iter()
            .map(|&sample| Box::of(recording.sample(sample), radii));
        let (first, all) = (
            first.unwrap_or(Box::NOTHING),
            all.fold(Box::NOTHING, Box::and),
        );
        let limit = |axis: usize| {
            let size = first.high[axis] - first.low[axis];
            let low = all.low[axis].max(first.low[axis] - size);
            (low, all.high[axis].min(first.high[axis] + size) - low)
        };
        let [x, y] = [limit(0), limit(1)];
        Self {
            low: [x.0, y.0],
            size: [x.1, y.1],
        }
    }

    fn extent(&self) -> f32 {
        self.size[0].max(self.size[1])
    }

    fn place(&self, grain: &Grain) -> [u16; 2] {
        let along = |axis: usize| (grain.numbers[axis] - self.low[axis]) / self.extent();
        let (x, y) = (along(0), along(1));
        let is_inside = (0.0..=1.0).contains(&x) && (0.0..=1.0).contains(&y);
        match is_inside {
            true => [x, y].map(|part| (LAST * part).round() as u16),
            false => [OUTSIDE; 2],
        }
    }
}

/// An upright rectangle.
#[derive(Clone, Copy)]
struct Box {
    low: [f32; 2],
    high: [f32; 2],
}

impl Box {
    const NOTHING: Self = Self {
        low: [f32::INFINITY; 2],
        high: [f32::NEG_INFINITY; 2],
    };

    fn of(grains: impl Iterator<Item = Grain>, radii: &[f64]) -> Self {
        let discs = grains.zip(radii).map(|(grain, &r)| {
            let [x, y, ..] = grain.numbers;
            let r = r as f32;
            Self {
                low: [x - r, y - r],
                high: [x + r, y + r],
            }
        });
        discs.fold(Self::NOTHING, Self::and)
    }

    fn and(self, other: Self) -> Self {
        Self {
            low: [0, 1].map(|axis| self.low[axis].min(other.low[axis])),
            high: [0, 1].map(|axis| self.high[axis].max(other.high[axis])),
        }
    }
}
