//! The profile of velocities of sheared cells.

use crate::cells::loose;
use gouge_contact_dynamics::observables::Profile;

/// Bodies at the heights and velocities of homogeneous shear have a straight profile; a band that stands still does not.
#[test]
fn a_linear_profile_has_no_deviation() {
    let cell = loose(Some(4), 400, 7);
    let (assembly, mut configuration) = (cell.assembly, cell.state.configuration);
    let height = 40.0;
    let place = |body: usize| (body as f64 + 0.5) / 400.0;
    for still in [false, true] {
        for (body, &unit) in assembly.unit.iter().enumerate() {
            configuration.position[body].y = place(body) * height;
            let is_still = still && (0.4..0.5).contains(&place(body));
            let part = if is_still { 0.0 } else { place(body) };
            configuration.velocity[unit as usize].linear.x = 3.0 * part;
        }
        let mut profile = Profile::new();
        profile.add(&assembly, &configuration, height, 3.0);
        let twice = Profile::from_values(&profile.values()).unwrap();
        assert_eq!(twice, profile);
        // Within a layer, areas are not spread evenly.
        let expected = if still { 0.45 } else { 0.0 };
        assert!((profile.deviation() - expected).abs() < 0.01, "{profile:?}");
    }
    assert_eq!(Profile::names().len(), Profile::new().values().len());
    assert!(Profile::from_values(&[0.0; 19]).is_none());
}
