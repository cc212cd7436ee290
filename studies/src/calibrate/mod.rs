//! Calibration: which parameters of scenes agree with what was measured.
//!
//! Read `calibration` for what a calibration consists of, `waves` for where runs are made, `likelihood` and
//! `posterior` for what they tell about the parameters, and `identify` for what of it is determined.

mod account;
mod builtin;
mod claim;
mod climb;
mod closed_form;
mod emulator;
mod file;
mod file_check;
mod file_keys;
mod gaussian_process;
mod identify;
mod likelihood;
mod outcome;
mod output;
mod page;
mod parameter;
mod posterior;
mod recover;
mod region;
mod results;
mod sobol;
mod calibration;
mod truths;
mod waves;

pub use account::{account, account_of_trial};
pub use builtin::{load, names, text};
pub use calibration::Calibration;
pub use emulator::{Emulator, Form, Prediction, Sample};
pub use gaussian_process::{GaussianProcess, Normal, Observed};
pub use likelihood::{Measured, log_likelihood};
pub use outcome::{Answer, Outcome, calibrate};
pub use posterior::Posterior;
pub use recover::{Recovered, Recovery, Repetition};
pub use results::{Results, Runner};
pub use truths::{Trial, recover};
