//! Random local moves at one variable: a label is proposed, then accepted or rejected.
//!
//! Source: Metropolis and others, J. Chem. Phys. 21, 1953; Hastings, Biometrika 57, 1970.
//!
//! With a truncated pairwise potential a label drawn at random almost never agrees with any neighbor. The proposal is
//! therefore a mixture: any label, a label near the present one, or a label near the label of a random neighboring
//! variable. Near means within `N_r`. Proposals are asymmetric, since neighborhoods have different sizes and the third
//! kind depends on the neighbors. The acceptance is corrected by the Hastings ratio of the whole mixture, so that the
//! chain keeps `p(x) ∝ exp(−E(x)/T)` exactly.

use super::draws::Draws;
use super::energy::SearchEnergy;
use super::state::SiteMove;

/// Shares of the three kinds of proposals.
struct Mixture {
    any: f64,
    near_own: f64,
    near_neighbor: f64,
}

/// Shares for a variable with neighbors. Occasional proposals of any label make every labeling reachable; most
/// proposals follow the neighbors, since only those mend a broken edge.
const MIXTURE: Mixture = Mixture { any: 0.1, near_own: 0.3, near_neighbor: 0.6 };
/// Shares for a variable without neighbors.
const MIXTURE_ALONE: Mixture = Mixture { any: 0.7, near_own: 0.3, near_neighbor: 0.0 };

fn mixture(degree: usize) -> Mixture {
    if degree == 0 { MIXTURE_ALONE } else { MIXTURE }
}

/// A proposed change of one variable.
struct Proposal {
    change: SiteMove,
    /// `q(y → x) / q(x → y)` for the present label `x` and the proposed `y`.
    ratio: f64,
}

/// One Metropolis step of variable `i` at `temperature`: accepted with `min(1, exp(−ΔE/T) · ratio)`. `None` if the
/// label stays. Cost `O(degree · log k̄)`.
pub(super) fn metropolis_step(
    energy: &SearchEnergy<'_>,
    labels: &[u32],
    i: usize,
    temperature: f64,
    draws: &mut Draws,
) -> Option<SiteMove> {
    let Proposal { change, ratio } = propose(energy, labels, i, draws)?;
    let accepted = draws.unit() < (-change.delta.total() / temperature).exp() * ratio;
    accepted.then_some(change)
}

/// One step of descent: accepts the proposal if it lowers the energy.
pub(super) fn descent_step(energy: &SearchEnergy<'_>, labels: &[u32], i: usize, draws: &mut Draws) -> Option<SiteMove> {
    propose(energy, labels, i, draws).map(|p| p.change).filter(|change| change.delta.total() < 0.0)
}

/// A proposal for variable `i`, `None` if it is the present label.
fn propose(energy: &SearchEnergy<'_>, labels: &[u32], i: usize, draws: &mut Draws) -> Option<Proposal> {
    let model = energy.model;
    let neighbors = model.variables.neighbors(i);
    let shares = mixture(neighbors.len());
    let size = |x: u32| model.labels.members(x as usize).len() as f64;
    let old = labels[i];
    let kind = draws.unit();
    let new = if kind < shares.any {
        draws.below(model.n_labels() as u64) as u32
    } else {
        let follows = kind >= shares.any + shares.near_own && !neighbors.is_empty();
        let center =
            if follows { labels[neighbors[draws.below(neighbors.len() as u64) as usize] as usize] } else { old };
        let members = model.labels.members(center as usize);
        members[draws.below(members.len() as u64) as usize]
    };
    if new == old {
        return None;
    }
    let mut delta = energy.unary(i, new).minus(&energy.unary(i, old));
    // Probabilities of the third kind, in both directions.
    let (mut forward, mut backward) = (0.0, 0.0);
    for edge in model.variables.row(i) {
        let y = labels[model.variables.head(edge)];
        let (before, after) = (energy.distance(old, y), energy.distance(new, y));
        delta.pairwise += energy.potential(edge, after) - energy.potential(edge, before);
        let chance = 1.0 / size(y);
        forward += if after.is_some() { chance } else { 0.0 };
        backward += if before.is_some() { chance } else { 0.0 };
    }
    let any = shares.any / model.n_labels() as f64;
    let own = if energy.distance(old, new).is_some() { shares.near_own } else { 0.0 };
    let each = shares.near_neighbor / neighbors.len().max(1) as f64;
    let ratio = (any + own / size(new) + each * backward) / (any + own / size(old) + each * forward);
    Some(Proposal { change: SiteMove { variable: i as u32, label: new, delta }, ratio })
}
