//! Quantities that a scene asks for: columns of the series after all others.

use super::series::Value;
use crate::scene::Measure;
use gouge_dem::World;
use gouge_dem::estimators::rolling_and_slip;

/// The columns of a quantity.
pub fn measured(measure: Measure, world: &World) -> Vec<(&'static str, Value)> {
    let numbers = match measure {
        Measure::Rolling => {
            let [rolling, slip] = rolling_and_slip(world);
            vec![("rolling_speed", rolling), ("slip_speed", slip)]
        }
    };
    let value = |(name, number)| (name, Value::Number(number));
    numbers.into_iter().map(value).collect()
}
