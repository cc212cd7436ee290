//! Pictures of the built-in scenes.

use super::fold::{Fold, counted};
use gouge_runner::any_scene::AnyScene;
use gouge_runner::contact_dynamics;
use gouge_runner::error::Error;
use gouge_runner::peridem;
use gouge_runner::run::{Shown, advance, draw_picture, run_setup};
use gouge_runner::scene::{Overrides, Scene, builtin};
use maud::{Markup, PreEscaped, html};
use rayon::prelude::*;

/// The picture of a built-in scene.
pub struct Picture {
    name: &'static str,
    purpose: &'static str,
    moment: String,
    svg: String,
}

/// Largest number of steps that a scene is run for its picture: a few seconds.
const MOST_STEPS: u64 = 1_500_000;
/// Largest product of grains and steps of such a run: about twenty seconds.
const MOST_WORK: u64 = 900_000_000;

/// Largest picture in bytes that the page holds.
const LARGEST: usize = 200_000;

/// The number of steps that a scene is run for its picture.
fn steps_of(scene: &Scene, particles: usize) -> u64 {
    let affordable = MOST_WORK / particles.max(1) as u64;
    scene.steps().min(MOST_STEPS).min(affordable)
}

/// Largest number of steps of a scene of another model: a few seconds.
const MOST_STEPS_OF_OTHERS: u64 = 4000;

/// Pictures of all built-in scenes, at their end, or as far as a short run gets.
///
/// # Errors
/// States that are no longer finite.
pub fn pictures() -> Result<Vec<Picture>, Error> {
    let draw = |&(name, purpose, _): &(&'static str, &'static str, &str)| match AnyScene::load_with(
        name,
        &Overrides::default(),
    )? {
        AnyScene::Dem(scene) => of_dem(name, purpose, &scene),
        AnyScene::ContactDynamics(scene) => {
            let shown = contact_dynamics::shown(&scene, MOST_STEPS_OF_OTHERS)?;
            Ok(of_shown(name, purpose, shown, scene.steps()))
        }
        AnyScene::Peridem(scene) => {
            let shown = peridem::shown(&scene, MOST_STEPS_OF_OTHERS)?;
            Ok(of_shown(name, purpose, shown, scene.schedule().steps()))
        }
    };
    builtin::SCENES.par_iter().map(draw).collect()
}

fn of_shown(name: &'static str, purpose: &'static str, shown: Shown, steps: u64) -> Picture {
    Picture {
        name,
        purpose,
        moment: moment(shown.steps, steps, shown.time),
        svg: shown.svg,
    }
}

fn of_dem(name: &'static str, purpose: &'static str, scene: &Scene) -> Result<Picture, Error> {
    let mut world = run_setup(scene)?;
    let steps = steps_of(scene, world.particles().len());
    advance(&mut world, steps, "run")?;
    Ok(Picture {
        name,
        purpose,
        moment: moment(steps, scene.steps(), world.time()),
        svg: draw_picture(scene, &world).to_string(),
    })
}

/// The time of a picture, and what part of the scene that is.
fn moment(steps: u64, all: u64, time: f64) -> String {
    let part = steps as f64 / all.max(1) as f64;
    match part {
        1.0 => format!("at the end, t = {:.3} ms", 1e3 * time),
        part => format!(
            "at t = {:.3} ms, {:.0} % of the scene",
            1e3 * time,
            100.0 * part
        ),
    }
}

/// The chapter of all pictures.
pub fn chapter(pictures: &[Picture]) -> Markup {
    Fold {
        id: "scenes",
        title: "Built-in scenes",
        count: &counted(pictures.len(), "picture"),
        class: "other",
    }
    .around(gallery(pictures))
}

fn gallery(pictures: &[Picture]) -> Markup {
    html! {
        p.about { "Fragments are coloured; single grains are white, driven and fixed grains grey. Each picture has its scale below it. "
            "For rigid bodies, lines between centres are as wide as the normal force is large, orange for contacts with one point and green for those with two; bodies with fewer than two contacts are light grey." }
        div.pictures {
            @for picture in pictures {
                figure {
                    @if picture.svg.len() <= LARGEST {
                        (PreEscaped(without_size(&picture.svg)))
                    } @else {
                        p.about { "A picture of " (picture.svg.len() / 1000) " kB, too large for this page: " code { "gouge run " (picture.name) } " draws it." }
                    }
                    figcaption { b { (picture.name) } ": " (picture.purpose) "; " (picture.moment) "." }
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

#[cfg(test)]
mod tests {
    use super::{moment, steps_of};
    use gouge_runner::any_scene::AnyScene;
    use gouge_runner::contact_dynamics::shown;
    use gouge_runner::run::{draw_picture, run_setup};
    use gouge_runner::scene::{Overrides, Scene};

    /// The numbers of an attribute, in the order of the elements.
    fn numbers(svg: &str, attribute: &str) -> Vec<f64> {
        let start = format!(" {attribute}=\"");
        let parts = svg.split(&start).skip(1);
        let values = parts.filter_map(|part| part.split('"').next()?.parse().ok());
        values.collect()
    }

    #[test]
    fn the_scale_bar_has_the_scale_of_the_grains() -> Result<(), Box<dyn std::error::Error>> {
        for (name, label) in [("head-on", "1 mm"), ("three-point-bend", "10 mm")] {
            let scene = Scene::load(name)?;
            let world = run_setup(&scene)?;
            let svg = draw_picture(&scene, &world).to_string();
            let (grains, bar) = svg.split_once("class=\"scale\"").ok_or("no scale bar")?;
            assert!(bar.contains(label), "{name}: {bar}");
            let millimetres: f64 = label.trim_end_matches(" mm").parse()?;
            let (ends, starts) = (numbers(bar, "x2"), numbers(bar, "x1"));
            let per_millimetre = (ends[0] - starts[0]) / millimetres;
            let radius = 1e3 * world.particles().radius[0];
            let drawn = numbers(grains, "r")[0] / radius;
            assert!((per_millimetre / drawn - 1.0).abs() < 1e-3, "{name}");
        }
        Ok(())
    }

    #[test]
    fn long_scenes_are_run_long_enough_to_shear() -> Result<(), Box<dyn std::error::Error>> {
        let fault = Scene::load("granite-fault")?;
        let steps = steps_of(&fault, 2_700);
        assert!(steps < fault.steps());
        assert!(
            3e-3 <= steps as f64 * fault.step,
            "6 mm at 2 m/s, more than the jags are high"
        );
        let short = Scene::load("head-on")?;
        assert_eq!(steps_of(&short, 2), short.steps());
        Ok(())
    }

    #[test]
    fn scenes_of_contact_dynamics_are_drawn() -> Result<(), Box<dyn std::error::Error>> {
        let scene = AnyScene::load_with("square-on-incline", &Overrides::default())?;
        let AnyScene::ContactDynamics(scene) = scene else {
            return Err("it is a scene of contact dynamics".into());
        };
        let drawn = shown(&scene, 10)?;
        assert_eq!(drawn.svg.matches("<polygon").count(), 1);
        assert_eq!(drawn.steps, 10);
        let words = moment(drawn.steps, scene.steps(), drawn.time);
        assert_eq!(words, "at t = 10.000 ms, 1 % of the scene");
        Ok(())
    }
}
