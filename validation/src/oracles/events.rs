//! Motions with one event, in closed form: position and velocity.

/// A sphere that hits a damped spring at unit speed at time zero and moves freely once the force
/// vanishes: x'' = -x - 2 zeta x' for zeta below one, from x = 0.
pub fn bounced(time: f64, zeta: f64) -> [f64; 2] {
    let w = (1.0 - zeta * zeta).sqrt();
    let inside = |t: f64| {
        let (sine, cosine) = (w * t).sin_cos();
        let decay = (-zeta * t).exp();
        [decay * sine / w, decay * (cosine - zeta / w * sine)]
    };
    let end = (2.0 * zeta * w).atan2(zeta * zeta - w * w) / w;
    if time < end {
        return inside(time);
    }
    let [x, v] = inside(end);
    [x + v * (time - end), v]
}

/// Behaviour of a slipped spring when the motion reverses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Return {
    /// The truncated spring relaxes at once.
    Springs,
    /// The limiting force opposes the motion, so that there is no reversal.
    Stays,
}

/// A spinning body on a spring of unit frequency that slips at unit stretch, initially unstretched with
/// a speed above one: it sticks, slips under unit deceleration, and stops.
pub fn slipped(time: f64, speed: f64, back: Return) -> [f64; 2] {
    let begins = (1.0 / speed).asin();
    if time < begins {
        return [speed * time.sin(), speed * time.cos()];
    }
    let left = (speed * speed - 1.0).sqrt();
    let since = time - begins;
    if since < left {
        return [1.0 + left * since - 0.5 * since * since, left - since];
    }
    let furthest = 1.0 + 0.5 * left * left;
    match back {
        Return::Stays => [furthest, 0.0],
        Return::Springs => {
            let (sine, cosine) = (since - left).sin_cos();
            [furthest - 1.0 + cosine, -sine]
        }
    }
}

/// A body with an initial speed above one, slowed by a force equal to its speed but at most one.
pub fn rubbed(time: f64, speed: f64) -> [f64; 2] {
    let slides = speed - 1.0;
    if time < slides {
        return [speed * time - 0.5 * time * time, speed - time];
    }
    let decay = (slides - time).exp();
    [speed * slides - 0.5 * slides * slides + 1.0 - decay, decay]
}

#[cfg(test)]
mod tests {
    use super::{Return, bounced, rubbed, slipped};
    use approx::{abs_diff_eq, assert_abs_diff_eq};

    /// Position and velocity are continuous where the formula changes, and the velocity is the
    /// derivative of the position.
    fn is_smooth(motion: impl Fn(f64) -> [f64; 2], end: f64) {
        for n in 1..400 {
            let t = end * f64::from(n) / 400.0;
            let h = 1e-5;
            let slope = (motion(t + h)[0] - motion(t - h)[0]) / (2.0 * h);
            assert!(abs_diff_eq!(slope, motion(t)[1], epsilon = 1e-4), "{t}");
        }
    }

    #[test]
    fn motions_are_continuous() {
        is_smooth(|t| bounced(t, 0.0), 5.0);
        is_smooth(|t| bounced(t, 0.4), 5.0);
        is_smooth(|t| slipped(t, 2.0, Return::Springs), 4.0);
        is_smooth(|t| slipped(t, 2.0, Return::Stays), 4.0);
        is_smooth(|t| rubbed(t, 3.0), 5.0);
        assert_abs_diff_eq!(bounced(4.0, 0.0)[1], -1.0, epsilon = 1e-15);
    }
}
