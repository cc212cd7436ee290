//! Fragments and cracks in final states made by hand.

use approx::assert_relative_eq;
use gouge_studies::final_state::FinalState;
use std::path::Path;

/// Grains of diameter 1 in a box with period 10: a row of fixed ones (0 to 9) at y = 0; a row that is bonded to them
/// (10 to 19) at y = 1; debris (20 to 29) at y = 2, of which two are bonded and the last one flew up to y = 5.2; driven
/// ones (30 to 39) at y = 6.
fn state(folder: &Path, breaks: &[(usize, usize)]) -> FinalState {
    let mut particles = "id,x,y,vx,vy,angle,angular_velocity,radius,role\n".to_owned();
    for grain in 0..40 {
        let y = match grain {
            29 => 5.2,
            30.. => 6.0,
            _ => f64::from(grain / 10),
        };
        let role = ["fixed", "free", "free", "driven"][grain as usize / 10];
        particles += &format!("{grain},{},{y},0,0,0,0,0.5,{role}\n", grain % 10);
    }
    let mut bonds = "i,j,strength_factor\n20,21,1.0\n".to_owned();
    bonds.extend((0..10).map(|k| format!("{k},{},1.0\n", 10 + k)));
    let mut broken = "time,i,j\n".to_owned();
    broken.extend(breaks.iter().map(|(i, j)| format!("1e-3,{i},{j}\n")));
    for (name, text) in [
        ("particles", particles),
        ("bonds", bonds),
        ("breaks", broken),
    ] {
        std::fs::write(folder.join(format!("{name}.csv")), text).expect("a file");
    }
    FinalState::read(folder, 10.0).expect("a state")
}

#[test]
fn debris_is_counted_by_fragments_and_by_depth() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = state(folder.path(), &[]);
    assert_eq!(state.debris_fragments(), 9);
    assert_relative_eq!(state.debris_depth(), 1.0);
    assert_eq!(state.edge_debris(), 1);
    assert_eq!(state.longest_crack(), 0.0);
    assert_eq!(state.crack_gap(), f64::INFINITY);
}

#[test]
fn cracks_are_followed_across_the_period_and_only_within_a_block() {
    let folder = tempfile::tempdir().expect("a folder");
    // A chain over the boundary, a shorter one elsewhere, and a break within the debris.
    let chain = [(18, 19), (10, 19), (10, 11), (11, 12), (14, 15), (22, 23)];
    // Neither row is bonded sideways, so that each column of the lower block is a fragment of its own.
    let apart = state(folder.path(), &chain);
    assert_eq!(apart.longest_crack(), 0.0);
    let bonds = folder.path().join("bonds.csv");
    let mut text = std::fs::read_to_string(&bonds).expect("bonds");
    text.extend((0..9).map(|k| format!("{k},{},1.0\n", k + 1)));
    std::fs::write(&bonds, text).expect("a file");
    let block = FinalState::read(folder.path(), 10.0).expect("a state");
    assert_relative_eq!(block.longest_crack(), 4.0, epsilon = 1e-12);
    // The break in the debris is two rows above the fixed grains.
    assert_relative_eq!(block.crack_gap(), 2.0, epsilon = 1e-12);
}

#[test]
fn a_crack_from_the_debris_comes_as_near_to_the_edge_as_its_nearest_grain() {
    let folder = tempfile::tempdir().expect("a folder");
    let joined = state(folder.path(), &[(11, 12), (12, 22)]);
    assert_relative_eq!(joined.crack_gap(), 1.0, epsilon = 1e-12);
    let apart = state(folder.path(), &[(11, 12), (22, 23)]);
    assert_relative_eq!(apart.crack_gap(), 2.0, epsilon = 1e-12);
}

#[test]
fn files_that_do_not_fit_each_other_are_no_state() {
    let folder = tempfile::tempdir().expect("a folder");
    state(folder.path(), &[]);
    std::fs::write(folder.path().join("breaks.csv"), "time,i,j\n0.0,3,77\n").expect("a file");
    assert!(FinalState::read(folder.path(), 10.0).is_none());
    std::fs::remove_file(folder.path().join("bonds.csv")).expect("it is there");
    assert!(FinalState::read(folder.path(), 10.0).is_none());
}
