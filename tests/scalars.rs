//! Number types besides `f64`.

use approx::abs_diff_eq;
use gouge_common::scalar::Real;
use gouge_scalars::{DoubleDouble, Dual};

#[test]
fn functions_of_double_doubles_invert_each_other_to_thirty_digits() {
    for step in 1..200 {
        let x = DoubleDouble::from_f64(f64::from(step)) * (1.0 / 201.0);
        let inverses = [
            DoubleDouble(x.asin().0.sin()),
            x.sqrt() * x.sqrt(),
            x / (x + x) * x * 2.0 / x * x,
        ];
        for inverse in inverses {
            let error = ((inverse - x) / x).abs().to_f64();
            assert!(error < 1e-30, "{step}: {error:e}");
        }
    }
}

#[test]
fn an_angle_turns_by_the_cross_product_over_the_square_everywhere() {
    for (y, x) in [(2.0, 0.0), (-2.0, 0.0), (0.0, -2.0), (1.0, 3.0)] {
        let moved = Dual::new(y, 0.5).atan2(Dual::new(x, -0.25));
        let slope = (0.5 * x + 0.25 * y) / (x * x + y * y);
        assert_eq!(moved.value(), f64::atan2(y, x));
        assert!(
            abs_diff_eq!(moved.slope(), slope, epsilon = 1e-15),
            "{y} {x}"
        );
    }
}
