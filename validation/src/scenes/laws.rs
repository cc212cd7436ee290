//! Laws as a scene names them.

use gouge_dem::laws::{
    AdjustedKelvinVoigt, Bshp, CundallStrackTruncated, EulerBernoulli, HaffWerner, KelvinVoigt,
    ZhangEckert,
};
use gouge_dem::model::Yielding;
use toml::{Table, Value};

/// A law that a scene chooses by a table of its own.
pub trait Law {
    /// The dotted key of the table.
    const KEY: &'static str;

    /// The keys of the table and their values.
    fn entries(&self) -> Vec<(&'static str, Value)>;

    /// The table.
    fn table(&self) -> Value {
        let entry = |(key, value): (&str, Value)| (key.to_owned(), value);
        Value::Table(self.entries().into_iter().map(entry).collect::<Table>())
    }
}

impl Law for KelvinVoigt {
    const KEY: &'static str = "contact.normal";

    fn entries(&self) -> Vec<(&'static str, Value)> {
        vec![
            ("law", "kelvin-voigt".into()),
            ("stiffness", self.stiffness.into()),
            ("damping", self.damping.into()),
        ]
    }
}

impl Law for Bshp {
    const KEY: &'static str = "contact.normal";

    fn entries(&self) -> Vec<(&'static str, Value)> {
        vec![
            ("law", "bshp".into()),
            ("youngs_modulus", self.youngs_modulus.into()),
            ("poissons_ratio", self.poissons_ratio.into()),
            ("dissipative_constant", self.dissipative_constant.into()),
        ]
    }
}

impl Law for HaffWerner {
    const KEY: &'static str = "contact.tangential";

    fn entries(&self) -> Vec<(&'static str, Value)> {
        friction("haff-werner", self.friction, self.damping)
    }
}

impl Law for CundallStrackTruncated {
    const KEY: &'static str = "contact.tangential";

    fn entries(&self) -> Vec<(&'static str, Value)> {
        friction("cundall-strack-truncated", self.friction, self.stiffness)
    }
}

/// Friction by the name of its law, its coefficient, and its damping in kg/s or its stiffness in kg/s^2.
pub fn friction(law: &str, friction: f64, constant: f64) -> Vec<(&'static str, Value)> {
    let name = match law {
        "haff-werner" => "damping",
        _ => "stiffness",
    };
    vec![
        ("law", law.into()),
        ("friction", friction.into()),
        (name, constant.into()),
    ]
}

impl Law for AdjustedKelvinVoigt {
    const KEY: &'static str = "bond.normal";

    fn entries(&self) -> Vec<(&'static str, Value)> {
        vec![
            ("stiffness", self.stiffness.into()),
            ("damping", self.damping.into()),
        ]
    }
}

impl Law for EulerBernoulli {
    const KEY: &'static str = "bond.tangential";

    fn entries(&self) -> Vec<(&'static str, Value)> {
        vec![
            ("law", "euler-bernoulli".into()),
            ("stiffness", self.stiffness.into()),
            ("damping", self.damping.into()),
        ]
    }
}

impl Law for ZhangEckert {
    const KEY: &'static str = "bond.yielding";

    fn entries(&self) -> Vec<(&'static str, Value)> {
        vec![
            ("law", "zhang-eckert".into()),
            ("normal_strength", self.normal_strength.into()),
            ("tangential_strength", self.tangential_strength.into()),
        ]
    }
}

impl Law for Yielding {
    const KEY: &'static str = "bond.yielding";

    fn entries(&self) -> Vec<(&'static str, Value)> {
        let mut entries = self.law.entries();
        let tensile = self.tensile_strength.map(Value::from);
        entries.extend(tensile.map(|strength| ("tensile_strength", strength)));
        entries.push(("unbreakable_edges", self.unbreakable_edges.into()));
        entries
    }
}
