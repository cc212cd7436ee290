//! Scenes of peridynamic grains that are refused when they begin, stopped, or doubted.

use crate::grains::{OPTIONS, WALLED, pair, summary};
use crate::program::{run, stderr, write_scene};
use gouge_runner::any_scene::AnyScene;
use gouge_runner::run::{Event, RunOptions};
use gouge_runner::scene::Overrides;

#[test]
fn an_unsafe_step_or_radius_is_refused_unless_forced() {
    let folder = tempfile::tempdir().unwrap();
    let attempt = |keys: &[&str]| {
        let out = folder.path().join(keys.concat());
        let scene = pair(&[keys, &["time.end=2e-6"]].concat());
        let result = scene.run(&out, OPTIONS, &mut |_: Event<'_>| {});
        result.map(drop).map_err(|error| error.to_string())
    };
    let said = attempt(&["time.step=1e-6"]).unwrap_err();
    assert!(
        said.contains("--set time.step=1e-6: the time step of") && said.contains("time.forced")
    );
    attempt(&["time.step=1e-6", "time.forced=true"]).unwrap();
    let said = attempt(&["contact.radius=1e-4"]).unwrap_err();
    assert!(
        said.contains("--set contact.radius=1e-4: the contact radius of"),
        "{said}"
    );
    attempt(&["contact.radius=1e-4", "contact.forced=true"]).unwrap();
}

#[test]
fn grains_too_fast_for_the_step_are_refused_unless_forced() {
    let folder = tempfile::tempdir().unwrap();
    let attempt = |keys: &[&str]| {
        let out = folder.path().join(keys.concat());
        let scene = pair(&[keys, &["time.end=2e-6"]].concat());
        let result = scene.run(&out, OPTIONS, &mut |_: Event<'_>| {});
        result
            .map(|run| run.status)
            .map_err(|error| error.to_string())
    };
    // Half of the contact radius in 5e-8 s is 2500 m/s, and the other grain comes along with 20 m/s.
    assert!(attempt(&["grains.0.velocity=[2479.0, 0.0]"]).is_ok());
    let said = attempt(&["grains.0.velocity=[2481.0, 0.0]"]).unwrap_err();
    let begins = "--set grains.0.velocity=[2481.0, 0.0]: node ";
    assert!(
        said.starts_with(begins) && said.contains("of grain 0 has a speed of 2.4810e3 m/s"),
        "{said}"
    );
    assert!(
        said.contains("the time step must be at most 4.99")
            && said.contains("contact.forced = true")
    );
    let said = attempt(&["grains.1.angular_velocity=4e6"]).unwrap_err();
    assert!(
        said.starts_with("--set grains.1.angular_velocity=4e6: node "),
        "{said}"
    );
    attempt(&["grains.0.velocity=[1e5, 0.0]", "contact.forced=true"]).unwrap();
    // Alone, or without contact, it may have any speed.
    attempt(&["grains.0.velocity=[1e5, 0.0]", "contact={}"]).unwrap();
    attempt(&[
        "grains.0.velocity=[1e5, 7.0]",
        "grains.1.velocity=[1e5, 0.0]",
    ])
    .unwrap();
    // Drawn into each other until they are too fast.
    let load = "grains.0.loads=[{ box = [-1.0, -1.0, 1.0, 1.0], force = [2e7, 0.0] }]";
    let out = folder.path().join("drawn");
    let ignore = &mut |_: Event<'_>| {};
    let said = pair(&[load])
        .run(&out, OPTIONS, ignore)
        .unwrap_err()
        .to_string();
    assert!(
        said.contains("the run stopped in phase 'run': at ")
            && said.contains("of grain 0 has a speed of"),
        "{said}"
    );
    assert!(
        summary(&out)["status"]
            .as_str()
            .unwrap()
            .contains("so that contacts could be missed")
    );
}

#[test]
fn what_only_meshing_shows_is_refused_with_its_key() {
    let scene = |grain: &str| {
        let text = "model = \"peridem\"\n[time]\nstep = 1e-8\nend = 1e-7\n\
            [materials.a]\nyoung_modulus = 1e9\ndensity = 1200.0\n\
            [bonds]\nhorizon = 6e-4\nbreaking = \"none\"\n[mesh]\nsize = 2e-4\n[[grains]]\n";
        let folder = tempfile::tempdir().unwrap();
        let scene = write_scene(folder.path(), &format!("{text}{grain}"));
        stderr(&run(&["links", scene.to_str().unwrap()]))
    };
    let thin = "shape = \"polygon\"\nvertices = [[0, 0], [1e-3, 0], [5e-4, 1e-12]]\n";
    let said = scene(thin);
    let expected = ":15: grains[0].vertices = [[array of 2], [array of 2], [array of 2]]: the mesh of size 0.0002 m has an area";
    assert!(
        said.contains(expected) && said.contains("it is too thin"),
        "{said}"
    );
    let held = "shape = \"square\"\nradius = 1e-3\nclamped = [[-1.0, -1.0, 1.0, 1.0]]\n";
    assert_eq!(scene(held), "");
    let load = "loads = [{ box = [-1.0, -1.0, 1.0, 1.0], force = [1.0, 0.0] }]\n";
    for useless in ["velocity = [1.0, 0.0]\n", "angular_velocity = 1.0\n", load] {
        let said = scene(&format!("{held}{useless}"));
        let expected = ":16: grains[0].clamped = [[array of 4]]: holds all nodes of the grain";
        assert!(said.contains(expected), "{said}");
    }
}

#[test]
fn grains_in_walls_are_doubted_and_grains_behind_walls_and_nodes_on_cuts_refused() {
    let folder = tempfile::tempdir().unwrap();
    let scene = write_scene(folder.path(), WALLED);
    let said = |key: &str| {
        let out = folder.path().join("out");
        let [scene, out] = [&scene, &out].map(|path| path.to_str().unwrap());
        let end = "time.end=1e-6";
        let all = [
            "run",
            scene,
            "--out",
            out,
            "--overwrite",
            "--set",
            end,
            "--set",
            key,
        ];
        stderr(&run(&all))
    };
    let warning = "grains are nearer to walls than contact.radius from the beginning";
    assert!(!said("time.end=1e-6").contains(warning));
    assert!(said("grains.0.position=[0.0, 1e-4]").contains(warning));
    let refused = said("grains.0.position=[0.0, 7e-4]");
    for part in [
        "grains.0.position=[0.0, 7e-4]: node ",
        "behind the top wall",
    ] {
        assert!(refused.contains(part), "{refused}");
    }
    let crossing = said("walls.velocity={bottom=2e4}");
    let expected = "walls.velocity={bottom=2e4}: at time.end, distance of walls is ";
    assert!(crossing.contains(expected), "{crossing}");
    let refused = said("grains.0.cuts=[[-5e-4, 1e-4, 5e-4, 1e-4]]");
    for part in ["grains.0.cuts=", "lies on cut 0: move the cut"] {
        assert!(refused.contains(part), "{refused}");
    }
}

#[test]
fn a_checkpoint_of_another_model_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let scenes = [
        ("two-grains", "time.end=1e-6", "peridem"),
        ("head-on", "time.end=1e-6", "dem"),
        ("square-on-incline", "time.end=1e-2", "contact-dynamics"),
    ];
    let load = |name: &str, end: &str| {
        AnyScene::load_with(name, &Overrides::parse(&[end]).unwrap()).unwrap()
    };
    let ignore = &mut |_: Event<'_>| {};
    for (name, end, model) in scenes {
        let out = folder.path().join(model);
        load(name, end).run(&out, OPTIONS, ignore).unwrap();
        for (other, end, _) in scenes.iter().filter(|(other, ..)| *other != name) {
            let resumed = RunOptions {
                resume: true,
                ..OPTIONS
            };
            let said = load(other, end)
                .run(&out, resumed, ignore)
                .unwrap_err()
                .to_string();
            let expected = format!("it is of a scene with model = \"{model}\"");
            assert!(said.contains(&expected), "{name} {other}: {said}");
        }
    }
}

#[test]
fn grains_without_bonds_and_forced_steps_are_doubted() {
    let folder = tempfile::tempdir().unwrap();
    let warnings = |keys: &[&str]| {
        let scene = AnyScene::load_with("two-grains", &Overrides::parse(keys).unwrap()).unwrap();
        let options = RunOptions {
            overwrite: true,
            ..OPTIONS
        };
        let ignore = &mut |_: Event<'_>| {};
        scene
            .run(folder.path(), options, ignore)
            .unwrap()
            .warnings
            .join("\n")
    };
    assert_eq!(warnings(&["time.end=1e-6"]), "");
    let forced = ["time.end=1e-6", "time.step=1e-7", "time.forced=true"];
    assert!(warnings(&forced).contains("time.step = 1e-7: above the estimated stability bound"));
    let ratio = ["time.end=1e-6", "materials.glass.poisson_ratio=0.25"];
    let said = warnings(&ratio);
    let expected = "materials.glass.poisson_ratio = 0.25: bonds have 0.3333, whatever is given";
    // 1.23e9 Pa times 2/3 over 3/4.
    assert!(
        said.contains(expected) && said.contains("1.0933e9 Pa"),
        "{said}"
    );
    assert_eq!(
        warnings(&["time.end=1e-6", "materials.glass.poisson_ratio=0.333"]),
        ""
    );
    let loose = [&forced[..], &["bonds.horizon=1e-5"]].concat();
    assert!(warnings(&loose).contains("grains[0] has no bonds"));
}
