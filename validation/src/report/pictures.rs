//! Pictures of the built-in scenes.

use gouge_runner::error::Error;
use gouge_runner::run::{advance, draw_picture, run_setup};
use gouge_runner::scene::{Scene, builtin};
use maud::{Markup, PreEscaped, html};
use rayon::prelude::*;

/// The picture of a built-in scene.
pub struct Picture {
    name: &'static str,
    purpose: &'static str,
    moment: String,
    svg: String,
}

/// Largest number of steps for which a scene is run to its end for its picture: a few seconds.
const MOST_STEPS: u64 = 1_500_000;
/// Largest product of grains and steps for which a scene is run to its end for its picture.
const MOST_WORK: u64 = 400_000_000;

/// Pictures of all built-in scenes, at their end, or at t = 0 if the run would take too long.
///
/// # Errors
/// States that are no longer finite.
pub fn pictures() -> Result<Vec<Picture>, Error> {
    let draw = |&(name, purpose, _): &(&'static str, &'static str, &str)| {
        let scene = Scene::load(name)?;
        let mut world = run_setup(&scene)?;
        let work = scene.steps() * world.particles().len() as u64;
        let runs = scene.steps() <= MOST_STEPS && work <= MOST_WORK;
        if runs {
            advance(&mut world, scene.steps(), "run")?;
        }
        Ok(Picture {
            name,
            purpose,
            moment: format!("t = {:.3e} s", world.time()),
            svg: draw_picture(&scene, &world).to_string(),
        })
    };
    builtin::SCENES.par_iter().map(draw).collect()
}

/// The chapter of all pictures.
pub fn chapter(pictures: &[Picture]) -> Markup {
    html! {
        section id="scenes" {
            h2 { "Built-in scenes" }
            p.about { "Fragments are coloured; single grains are white, driven and fixed grains grey." }
            div.pictures {
                @for picture in pictures {
                    figure {
                        (PreEscaped(without_size(&picture.svg)))
                        figcaption { b { (picture.name) } ": " (picture.purpose) "; " (picture.moment) }
                    }
                }
            }
        }
    }
}

/// The picture without a fixed size, so that the page can scale it.
fn without_size(svg: &str) -> String {
    let Some(end) = svg.find('>') else {
        return svg.to_owned();
    };
    let (head, rest) = svg.split_at(end);
    let sized = |word: &&str| !word.starts_with("width=") && !word.starts_with("height=");
    let kept: Vec<&str> = head.split(' ').filter(sized).collect();
    kept.join(" ") + rest
}
