//! Scenes put together as tables are the scenes of their texts, and what cannot be done to them is said.

use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, CundallStrackTruncated, EulerBernoulli, KelvinVoigt, ZhangEckert,
};
use gouge_dem::model::Yielding;
use gouge_runner::scene::{Output, Scene, builtin};
use gouge_validation::scenes::{Bond, Draft, Grain};
use proptest::prelude::*;
use std::path::Path;

fn parsed(text: &str) -> Scene {
    Scene::parse("scene.toml", text.as_bytes(), Path::new(".")).expect("a scene")
}

/// All that a scene says, without where it says it.
fn meaning(scene: &Scene) -> String {
    let bonds: Vec<_> = scene.bonds.iter().map(|(bond, _)| bond).collect();
    let contacts: Vec<_> = scene.contacts.iter().map(|(contact, _)| contact).collect();
    let output = Output {
        // It knows the line of the file.
        region_refusal: None,
        ..scene.output.clone()
    };
    format!(
        "{} {:?} {:?} {} {} {:?} {:?} {:?} {:?} {:?} {:?} {:?} {:?} {bonds:?} {contacts:?} {:?} {output:?}",
        scene.title,
        scene.reading,
        scene.integrator,
        scene.step,
        scene.end,
        scene.domain,
        scene.material,
        scene.contact,
        scene.bond,
        scene.ambient,
        scene.external,
        scene.driving,
        scene.particles,
        scene.setup,
    )
}

/// Three grains with laws of every kind.
fn draft() -> Draft {
    Draft::open_box(Integrator::Beeman, 2e-9)
        .reading("thesis")
        .ending_at(3e-6)
        .with("contact.distance", "focal")
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 10.0,
        })
        .law(CundallStrackTruncated {
            friction: 0.7,
            stiffness: 1e8,
        })
        .law(AdjustedKelvinVoigt {
            stiffness: 2e7,
            damping: 3.0,
        })
        .law(EulerBernoulli {
            stiffness: 4e7,
            damping: 5.0,
        })
        .law(Yielding {
            law: ZhangEckert {
                normal_strength: 280e6,
                tangential_strength: 168e6,
            },
            tensile_strength: None,
            unbreakable_edges: false,
        })
        .gravity(9.81)
        .correlation_drag(18e-6, 1.2)
        .grain(
            Grain::at([0.0, 0.0], 1e-3)
                .moving([1.0, -2.0])
                .spinning(300.0),
        )
        .grain(
            Grain::at([2e-3, 0.0], 1.1e-3)
                .turned(0.3)
                .of_density(2600.0),
        )
        .grain(Grain::at([0.0, 2e-3], 1.2e-3).fixed())
        .bond(
            Bond::between(0, 1)
                .of_length(2.1e-3)
                .since([0.1, 3.0])
                .of_strength(1.1),
        )
        .touching_since(0, 2, [1.5, -1.5])
}

/// The same, as a user writes it.
const WRITTEN: &str = r#"
reading = "thesis"
[time]
step = 2e-9
end = 3e-6
integrator = "beeman"
[material]
density = 2700.0
[contact]
distance = "focal"
[contact.normal]
law = "kelvin-voigt"
stiffness = 1e7
damping = 10.0
[contact.tangential]
law = "cundall-strack-truncated"
friction = 0.7
stiffness = 1e8
[bond.normal]
stiffness = 2e7
damping = 3.0
[bond.tangential]
law = "euler-bernoulli"
stiffness = 4e7
damping = 5.0
[bond.yielding]
law = "zhang-eckert"
normal_strength = 280e6
tangential_strength = 168e6
unbreakable_edges = false
[external]
law = "gravity"
acceleration = 9.81
[ambient]
law = "correlation"
viscosity = 18e-6
density = 1.2
[[particles]]
position = [0.0, 0.0]
velocity = [1.0, -2.0]
angular_velocity = 300.0
radius = 1e-3
[[particles]]
position = [2e-3, 0.0]
angle = 0.3
density = 2600.0
radius = 1.1e-3
[[particles]]
position = [0.0, 2e-3]
radius = 1.2e-3
role = "fixed"
[[bonds]]
between = [0, 1]
strength_factor = 1.1
initial_distance = 2.1e-3
initial_angles = [0.1, 3.0]
[[contacts]]
between = [0, 2]
initial_angles = [1.5, -1.5]
"#;

#[test]
fn a_draft_is_the_scene_that_a_user_writes() {
    let scene = draft().scene().expect("a scene");
    assert_eq!(meaning(&scene), meaning(&parsed(WRITTEN)));
    let text = draft().text().expect("a text");
    assert_eq!(meaning(&scene), meaning(&parsed(&text)));
    assert_eq!(Draft::parse(&text), draft());
}

#[test]
fn built_in_scenes_keep_their_meaning() {
    for name in builtin::names_of_dem() {
        let text = builtin::text(name).expect("built in");
        let scene = Draft::builtin(name).scene().expect("a scene");
        assert_eq!(meaning(&scene), meaning(&parsed(text)), "{name}");
    }
}

#[test]
fn what_is_not_there_cannot_be_replaced() {
    type Change = fn(Draft) -> Draft;
    let mistakes: [(Change, &str); 8] = [
        (|d| d.replacing("time.stop", 1.0), "time.stop"),
        (|d| d.replacing("driving.speed", 1.0), "driving.speed"),
        (|d| d.replacing("particles.3.radius", 1.0), "particles.3"),
        (|d| d.replacing("time.step.size", 1.0), "time.step.size"),
        (|d| d.without("output"), "output"),
        (|d| d.with("time.step.size", 1.0), "time.step.size"),
        (|d| d.with("particles.3.radius", 1.0), "particles.3"),
        (
            |d| d.and(&Draft::empty().with("time.step", 1.0)),
            "time.step",
        ),
    ];
    for (change, expected) in mistakes {
        // Later steps that can be made do not hide the mistake.
        let changed = change(draft()).replacing("time.end", 1e-6);
        for said in [
            changed.text().map(drop).expect_err("a mistake").to_string(),
            changed
                .scene()
                .map(drop)
                .expect_err("a mistake")
                .to_string(),
            changed
                .world()
                .map(drop)
                .expect_err("a mistake")
                .to_string(),
        ] {
            assert!(said.contains(expected), "{expected}: {said}");
        }
    }
    assert!(Draft::builtin("no-such-scene").scene().is_err());
}

#[test]
fn what_is_there_is_replaced() {
    let changed = draft()
        .replacing("time.step", 5e-9)
        .replacing("particles.1.position.0", 2.5e-3)
        .without("contact.tangential")
        .without("contacts");
    let scene = changed.scene().expect("a scene");
    assert_eq!((scene.step, scene.particles[1].position.x), (5e-9, 2.5e-3));
    assert!(
        scene
            .contact
            .is_some_and(|contact| contact.tangential.is_none())
    );
    assert!(draft().has("contact.tangential.law") && !changed.has("contact.tangential.law"));
}

proptest! {
    #[test]
    fn numbers_keep_their_bits(x in any::<f64>(), speed in prop::num::f64::NORMAL) {
        prop_assume!(x.is_finite());
        let draft = Draft::open_box(Integrator::Euler, 1e-3)
            .grain(Grain::at([x, 0.0], 1e-3).moving([speed, -0.0]));
        let found = draft.scene().expect("a scene").particles[0];
        let numbers = [found.position.x, found.velocity.x, found.velocity.y];
        prop_assert_eq!(numbers.map(f64::to_bits), [x, speed, -0.0].map(f64::to_bits));
    }
}

#[test]
fn the_world_of_a_draft_is_that_of_its_text() {
    let mut worlds: [World; 2] = [
        draft().world().expect("a world"),
        parsed(WRITTEN).initial_world().expect("a world"),
    ];
    for world in &mut worlds {
        (0..100).for_each(|_| world.step().expect("finite"));
    }
    assert!(worlds[0].to_words() == worlds[1].to_words());
}
