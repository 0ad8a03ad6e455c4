//! Turns between tenants: how many one gets for each of another.

use std::collections::HashMap;
use std::str::FromStr;

/// Largest weight.
const MAX_WEIGHT: u32 = 1_000;

/// The weights of tenants; 1 for those that are not named. A tenant of weight 3 starts three jobs for each one of a tenant of
/// weight 1, as long as both wait.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct TenantWeights(HashMap<String, u32>);

impl TenantWeights {
    /// The weight of a tenant.
    pub fn of(&self, tenant: &str) -> u32 {
        self.0.get(tenant).copied().unwrap_or(1)
    }

    /// These weights; if a tenant is given twice, its last weight counts.
    pub fn new(weights: impl IntoIterator<Item = TenantWeight>) -> Self {
        TenantWeights(weights.into_iter().map(|TenantWeight(tenant, weight)| (tenant, weight)).collect())
    }
}

/// The weight of one tenant, written `tenant=weight`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TenantWeight(String, u32);

impl FromStr for TenantWeight {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parsed = text.split_once('=').and_then(|(tenant, weight)| {
            let weight = weight.trim().parse().ok().filter(|weight| (1..=MAX_WEIGHT).contains(weight))?;
            Some(TenantWeight(super::Tenant::new(tenant.trim())?.name().to_owned(), weight))
        });
        parsed.ok_or_else(|| format!("TENANT=WEIGHT is needed here, with a weight from 1 to {MAX_WEIGHT}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_parsed() {
        let weights = TenantWeights::new(["clinic-a=3", "b = 1000"].map(|text| text.parse().unwrap()));
        assert_eq!([weights.of("clinic-a"), weights.of("b"), weights.of("other")], [3, 1000, 1]);
        for wrong in ["", "a", "a=", "a=0", "a=1001", "a=x", "A=1", "=1"] {
            assert!(wrong.parse::<TenantWeight>().is_err(), "{wrong}");
        }
    }
}
