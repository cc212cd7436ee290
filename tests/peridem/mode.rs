//! The readings of the source.

use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::contact_law::ContactReading;
use gouge_peridem::mode::Mode;
use gouge_peridem::wall_law::WallReading;
use gouge_peridem::world::Beginning;

#[test]
fn modes_have_different_names() {
    for (name, mode) in Mode::ALL {
        assert_eq!(mode.name(), name);
        assert_eq!(Mode::ALL.iter().filter(|one| one.0 == name).count(), 1);
    }
    assert_eq!(Mode::default().name(), "corrected");
}

#[test]
fn only_the_printed_mode_breaks_compressed_bonds() {
    let rules = Mode::ALL.map(|(_, mode)| (mode == Mode::Paper, mode.breaking()));
    for (is_printed, rule) in rules {
        assert_eq!(rule == BreakingRule::TwoSided, is_printed);
    }
}

#[test]
fn modes_of_the_authors_begin_and_break_like_their_program() {
    for (_, mode) in Mode::ALL {
        let is_of_authors = mode == Mode::Authors || mode == Mode::TwoFixes;
        assert_eq!(mode.is_of_authors(), is_of_authors);
        assert_eq!(mode.break_order() == BreakOrder::ForceFirst, is_of_authors);
        assert_eq!(mode.beginning() == Beginning::Given, is_of_authors);
        let walls_of_authors = [WallReading::Authors, WallReading::TwoFixes];
        assert_eq!(walls_of_authors.contains(&mode.walls()), is_of_authors);
    }
}

#[test]
fn the_two_fixes_repair_the_centroid_and_the_sticking_of_the_authors() {
    assert_eq!(Mode::Authors.walls(), WallReading::Authors);
    assert_eq!(Mode::Authors.contact(), ContactReading::Authors);
    assert_eq!(Mode::TwoFixes.walls(), WallReading::TwoFixes);
    assert_eq!(Mode::TwoFixes.contact(), ContactReading::OneSided);
    assert_eq!(Mode::Corrected.contact(), ContactReading::Symmetric);
    assert_eq!(Mode::Paper.contact(), ContactReading::Printed);
}
