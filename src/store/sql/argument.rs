//! The values that are bound to the parameters of a statement.

use std::time::Duration;

/// A value bound to a parameter of a statement.
#[derive(Debug, Clone)]
pub(super) enum Argument {
    Text(Option<String>),
    Integer(Option<i64>),
    Real(Option<f64>),
    Flag(bool),
}

macro_rules! arguments_from {
    ($($type:ty => |$value:ident| $argument:expr;)*) => {
        $(impl From<$type> for Argument {
            fn from($value: $type) -> Self {
                $argument
            }
        })*
    };
}

arguments_from! {
    &str => |v| Argument::Text(Some(v.to_owned()));
    &String => |v| Argument::Text(Some(v.clone()));
    String => |v| Argument::Text(Some(v));
    Option<String> => |v| Argument::Text(v);
    &Option<String> => |v| Argument::Text(v.clone());
    Option<&str> => |v| Argument::Text(v.map(str::to_owned));
    i64 => |v| Argument::Integer(Some(v));
    i32 => |v| Argument::Integer(Some(v.into()));
    u32 => |v| Argument::Integer(Some(v.into()));
    u64 => |v| Argument::Integer(Some(i64::try_from(v).unwrap_or(i64::MAX)));
    Option<i64> => |v| Argument::Integer(v);
    Option<u64> => |v| Argument::Integer(v.map(|v| i64::try_from(v).unwrap_or(i64::MAX)));
    Option<u32> => |v| Argument::Integer(v.map(i64::from));
    f64 => |v| Argument::Real(Some(v));
    Option<f64> => |v| Argument::Real(v);
    bool => |v| Argument::Flag(v);
    Duration => |v| Argument::Integer(Some(milliseconds(v)));
    Option<Duration> => |v| Argument::Integer(v.map(milliseconds));
    crate::jobs::JobId => |v| Argument::Text(Some(v.to_string()));
    Option<crate::jobs::JobId> => |v| Argument::Text(v.map(|id| id.to_string()));
    crate::jobs::BatchId => |v| Argument::Text(Some(v.to_string()));
    Option<crate::jobs::BatchId> => |v| Argument::Text(v.map(|id| id.to_string()));
    crate::jobs::StudyId => |v| Argument::Text(Some(v.to_string()));
    Option<crate::jobs::StudyId> => |v| Argument::Text(v.map(|id| id.to_string()));
    crate::jobs::JobState => |v| Argument::Text(Some(v.name().to_owned()));
    &crate::jobs::Tenant => |v| Argument::Text(Some(v.name().to_owned()));
    Option<jiff::Timestamp> => |v| Argument::Integer(v.map(jiff::Timestamp::as_millisecond));
}

/// A duration in ms, as stored in the database.
fn milliseconds(duration: Duration) -> i64 {
    i64::try_from(duration.as_millis()).unwrap_or(i64::MAX / 4)
}

/// The parameters of a statement, in order.
macro_rules! bind {
    ($($value:expr),* $(,)?) => {
        vec![$($crate::store::sql::argument::Argument::from($value)),*]
    };
}
pub(super) use bind;
