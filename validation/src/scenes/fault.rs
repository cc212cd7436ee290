//! The small granite fault, made smaller, weaker and shorter.

use super::draft::Draft;

/// The built-in small granite fault of a side of 15 mm, with a set-up of a fraction of its length: settling of 600
/// and 600 steps, relaxing and pressing of 800.
pub fn brief() -> Draft {
    let draft = Draft::builtin("granite-fault-small")
        .replacing("box.width", 15e-3)
        .replacing("box.height", 15e-3)
        .replacing("setup.roles.driven_above", 11e-3);
    lasting(draft, 60e-6, 8e-6)
}

/// The same with bonds of a hundredth of the strength, which break within 20 us of shear.
pub fn weak() -> Draft {
    brief()
        .replacing("bond.yielding.normal_strength", 280e4)
        .replacing("bond.yielding.tangential_strength", 168e4)
}

/// The built-in small granite fault in its full size, with short phases before its shear and bonds of a 14th of the
/// normal strength.
pub fn sheared() -> Draft {
    let draft =
        Draft::builtin("granite-fault-small").replacing("bond.yielding.normal_strength", 20e6);
    lasting(draft, 0.2e-3, 2e-6)
}

/// With other durations in s of both settling phases, and of relaxing and pressing.
fn lasting(draft: Draft, settling: f64, others: f64) -> Draft {
    draft
        .replacing("setup.settle.0.duration", settling)
        .replacing("setup.settle.1.duration", settling)
        .replacing("setup.relax.0.duration", others)
        .replacing("setup.press.0.duration", others)
}
