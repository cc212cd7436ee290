//! Wall times of a run.

use std::time::Instant;

/// The times at which a run and the scene proper began, and when it was last saved.
pub struct Clock {
    /// Wall time in s before the run was resumed: of the whole run and of the scene proper.
    pub earlier: [f64; 2],
    run_began: Instant,
    main_began: Instant,
    saved: Instant,
}

impl Clock {
    /// A run that begins now.
    pub fn start() -> Self {
        let now = Instant::now();
        Self {
            earlier: [0.0; 2],
            run_began: now,
            main_began: now,
            saved: now,
        }
    }

    /// The scene proper begins, or goes on, now.
    pub fn begin_main(&mut self) {
        self.main_began = Instant::now();
    }

    /// The run was saved now.
    pub fn save(&mut self) {
        self.saved = Instant::now();
    }

    /// Wall time in s since the run was saved.
    pub fn since_saved(&self) -> f64 {
        self.saved.elapsed().as_secs_f64()
    }

    /// Wall time so far in s: of the whole run and, if it has begun, of the scene proper.
    pub fn seconds(&self, is_main: bool) -> [f64; 2] {
        let main = match is_main {
            true => self.main_began.elapsed().as_secs_f64(),
            false => 0.0,
        };
        let [run, earlier_main] = self.earlier;
        [
            run + self.run_began.elapsed().as_secs_f64(),
            earlier_main + main,
        ]
    }
}
