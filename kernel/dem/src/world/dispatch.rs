//! The only place where the choices of a model are matched: once a pass, never in a loop.

/// Evaluate an expression with `$metric` bound to the metric of the model.
macro_rules! with_metric {
    ($model:expr, $metric:ident => $body:expr) => {
        match $model.period() {
            Some(length) => {
                let $metric = gouge_common::geometry::PeriodicX { length };
                $body
            }
            None => {
                let $metric = gouge_common::geometry::Open;
                $body
            }
        }
    };
}

/// Evaluate an expression with `$pass` bound to the pass over strong links that the model asks for.
macro_rules! with_strong_pass {
    ($model:expr, $bond:expr, $pass:ident => $body:expr) => {
        $crate::world::dispatch::with_metric!($model, metric => match $bond.yielding {
            Some($crate::model::Yielding { law, .. }) => {
                $crate::world::dispatch::with_strong_pass!(@beam $model, $bond, metric, law, $pass => $body)
            }
            None => {
                $crate::world::dispatch::with_strong_pass!(@beam $model, $bond, metric, $crate::laws::Unbreakable, $pass => $body)
            }
        })
    };
    (@beam $model:expr, $bond:expr, $metric:ident, $yielding:expr, $pass:ident => $body:expr) => {
        match $bond.tangential {
            Some(beam) => {
                $crate::world::dispatch::with_strong_pass!(@pass $model, $bond, $metric, $yielding, beam, $pass => $body)
            }
            None => {
                $crate::world::dispatch::with_strong_pass!(@pass $model, $bond, $metric, $yielding, $crate::laws::NoBending, $pass => $body)
            }
        }
    };
    (@pass $model:expr, $bond:expr, $metric:ident, $yielding:expr, $beam:expr, $pass:ident => $body:expr) => {{
        let $pass = $crate::forces::BondPass {
            metric: $metric,
            normal: $bond.normal,
            beam: $beam,
            yielding: $yielding,
            wraps: $model.reading == $crate::model::Reading::Thesis,
        };
        $body
    }};
}

/// Evaluate an expression with `$pass` bound to the pass over weak links that the model asks for.
macro_rules! with_weak_pass {
    ($model:expr, $contact:expr, $pass:ident => $body:expr) => {
        $crate::world::dispatch::with_metric!($model, metric => $crate::world::dispatch::with_weak_pass!(@normal $model, $contact, metric, $pass => $body))
    };
    (@normal $model:expr, $contact:expr, $metric:ident, $pass:ident => $body:expr) => {
        match $contact.normal {
            $crate::model::ContactNormal::KelvinVoigt(normal) => {
                $crate::world::dispatch::with_weak_pass!(@tangential $model, $contact, $metric, normal, $pass => $body)
            }
            $crate::model::ContactNormal::Bshp(normal) => {
                $crate::world::dispatch::with_weak_pass!(@tangential $model, $contact, $metric, normal, $pass => $body)
            }
        }
    };
    (@tangential $model:expr, $contact:expr, $metric:ident, $normal:ident, $pass:ident => $body:expr) => {
        match $contact.tangential {
            None => $crate::world::dispatch::with_weak_pass!(
                @pass $model, $metric, $crate::geometry::RadiusArm, $normal, $crate::laws::Frictionless, $pass => $body
            ),
            Some($crate::model::ContactTangential::HaffWerner(law)) => {
                $crate::world::dispatch::with_weak_pass!(@arm $model, $contact, $metric, $normal, law, $pass => $body)
            }
            Some($crate::model::ContactTangential::CundallStrack(law)) => {
                $crate::world::dispatch::with_weak_pass!(@arm $model, $contact, $metric, $normal, law, $pass => $body)
            }
            Some($crate::model::ContactTangential::CundallStrackTruncated(law)) => {
                $crate::world::dispatch::with_weak_pass!(@arm $model, $contact, $metric, $normal, law, $pass => $body)
            }
        }
    };
    (@arm $model:expr, $contact:expr, $metric:ident, $normal:ident, $law:ident, $pass:ident => $body:expr) => {
        match $contact.distance {
            $crate::geometry::ContactDistance::Radius => {
                $crate::world::dispatch::with_weak_pass!(@pass $model, $metric, $crate::geometry::RadiusArm, $normal, $law, $pass => $body)
            }
            $crate::geometry::ContactDistance::Focal => {
                $crate::world::dispatch::with_weak_pass!(@pass $model, $metric, $crate::geometry::FocalArm, $normal, $law, $pass => $body)
            }
            $crate::geometry::ContactDistance::Mean => {
                $crate::world::dispatch::with_weak_pass!(@pass $model, $metric, $crate::geometry::MeanArm, $normal, $law, $pass => $body)
            }
            $crate::geometry::ContactDistance::Mixed(arms) => {
                $crate::world::dispatch::with_weak_pass!(@pass $model, $metric, arms, $normal, $law, $pass => $body)
            }
        }
    };
    (@pass $model:expr, $metric:ident, $arm:expr, $normal:ident, $law:expr, $pass:ident => $body:expr) => {{
        let $pass = $crate::forces::ContactPass {
            metric: $metric,
            arm: $arm,
            normal: $normal,
            tangential: $law,
            reading: $model.reading,
            elapsed: 0.0,
        };
        $body
    }};
}

pub(crate) use {with_metric, with_strong_pass, with_weak_pass};
