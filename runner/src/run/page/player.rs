//! The animation of a page: a canvas with a slider.

use super::animation::Recording;
use super::embedded::{Motion, chosen};
use maud::{Markup, PreEscaped, html};

const SCRIPT: &str = include_str!("player.js");

/// What the motion shows of all grains.
#[derive(Clone, Copy, Debug)]
pub struct Drawn<'a> {
    /// Radii of discs or of circumscribed circles in m.
    pub radii: &'a [f64],
    /// Numbers of sides, 0 for discs; empty if there are only discs.
    pub sides: &'a [u16],
    /// What the colour that is neither speed nor pressure tells.
    pub label: &'static str,
    /// What pressure means, if grains have one. Then a line in each grain shows how it turns.
    pub pressure: Option<&'static str>,
    /// Whether that colour is a number from 0 to 255 on a scale, instead of a kind.
    pub is_scale: bool,
}

/// The motion of all grains, or why it is not shown. `time` is that of a sample in s.
pub fn show(recording: &Recording, drawn: &Drawn, time: &dyn Fn(u64) -> f64) -> Markup {
    let radii = drawn.radii;
    let (number, samples) = (recording.len(), chosen(recording, radii.len()));
    if samples.is_empty() {
        let reason = match number {
            0 => "no samples were kept for it, because the run began with --data-only",
            _ => "too many grains for a page",
        };
        return html! { p.about { "The motion is not shown: " (reason) "." } };
    }
    let times = samples.iter().map(|&sample| time(sample as u64));
    let motion = Motion::new(recording, &samples, times.collect(), drawn);
    let Ok(data) = serde_json::to_string(&motion) else {
        return html! { p.about { "The motion cannot be shown." } };
    };
    html! {
        figure #motion {
            canvas aria-label="The grains at the chosen time" {}
            div.controls {
                button type="button" { "Play" }
                input type="range" min="0" max=(samples.len() - 1) value="0" step="1" aria-label="Sample";
                output {}
                label { "Colour "
                    select {
                        option value="fragment" { (drawn.label) }
                        option value="speed" { "speed" }
                        @if drawn.pressure.is_some() { option value="pressure" { "pressure" } }
                    }
                }
            }
            div.scale hidden { span {} i {} span {} }
            figcaption { (caption(&motion, drawn, samples.len(), number)) }
        }
        noscript { p.about { "The motion needs JavaScript." } }
        script #motion-data type="application/json" { (PreEscaped(data)) }
        script { (PreEscaped(SCRIPT)) }
    }
}

fn caption(motion: &Motion, drawn: &Drawn, shown: usize, number: usize) -> Markup {
    html! {
        @if let Some(pressure) = drawn.pressure {
            "A line in each grain shows how it turns. Pressure is " (pressure) ", positive in compression; the colours cover 99.5 % of all values. "
        }
        @if shown < number {
            (shown) " of " (number) " samples are shown, so that the page stays small; " code { "trajectory/" } " has all. "
        }
        @if motion.loses_grains { "Grains that fly far away are not shown." }
    }
}
