//! A stock that requests share: slots, bytes of memory, streams. Each owner holds at most a share of it, so that no
//! client can exhaust it.

use super::auth_mode::AuthMode;
use crate::jobs::Tenant;
use axum::http::Extensions;
use parking_lot::Mutex;
use std::collections::HashMap;
use std::net::IpAddr;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::Notify;

/// The address of the client, which the server loop adds to each request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Peer(pub(super) IpAddr);

/// The origin of a request; unknown without a server loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Origin(pub(super) Option<IpAddr>);

impl Origin {
    pub(super) fn address(self) -> Option<IpAddr> {
        self.0
    }

    pub(super) fn of(extensions: &Extensions) -> Self {
        Origin(extensions.get::<Peer>().map(|peer| peer.0))
    }
}

/// The owner of a request's share: its tenant, or its address if requests are not authenticated.
pub(super) fn owner(auth: AuthMode, tenant: &Tenant, origin: Origin) -> String {
    match (auth, origin.0) {
        (AuthMode::None, Some(address)) => address.to_string(),
        _ => tenant.name().to_owned(),
    }
}

/// The stock.
#[derive(Debug)]
pub(super) struct Shares {
    total: u64,
    each: u64,
    taken: Mutex<HashMap<String, u64>>,
    returned: Notify,
}

/// A part of the stock, which is returned when dropped.
#[derive(Debug)]
pub(super) struct SharePermit {
    shares: Arc<Shares>,
    owner: String,
    n: u64,
}

impl Shares {
    /// A stock of `total`, of which each owner may hold `each`.
    pub(super) fn new(total: u64, each: u64) -> Arc<Self> {
        Arc::new(Shares { total, each, taken: Mutex::default(), returned: Notify::new() })
    }

    fn add(&self, owner: &str, n: u64) -> bool {
        let mut taken = self.taken.lock();
        let own = taken.get(owner).copied().unwrap_or(0);
        let all: u64 = taken.values().sum();
        let fits = own.saturating_add(n) <= self.each && all.saturating_add(n) <= self.total;
        if fits {
            taken.insert(owner.to_owned(), own + n);
        }
        fits
    }

    /// Takes `n` of the stock, if this owner may have so much and it is free.
    pub(super) fn try_take(self: &Arc<Self>, owner: &str, n: u64) -> Option<SharePermit> {
        self.add(owner, n).then(|| SharePermit { shares: Arc::clone(self), owner: owner.to_owned(), n })
    }

    /// Takes `n` of the stock; `None` if this owner cannot have so much within `wait`.
    pub(super) async fn take(self: &Arc<Self>, owner: &str, n: u64, wait: Duration) -> Option<SharePermit> {
        let taking = async {
            loop {
                let returned = self.returned.notified();
                if let Some(taken) = self.try_take(owner, n) {
                    return taken;
                }
                returned.await;
            }
        };
        tokio::time::timeout(wait, taking).await.ok()
    }

    /// Returns when something was returned, or after `wait`.
    pub(super) async fn returned(self: Arc<Self>, wait: Duration) {
        let _ = tokio::time::timeout(wait, self.returned.notified()).await;
    }
}

impl SharePermit {
    /// Takes `n` more, if so much is available.
    pub(super) fn grow(&mut self, n: u64) -> bool {
        let grown = self.shares.add(&self.owner, n);
        self.n += if grown { n } else { 0 };
        grown
    }

    pub(super) fn shares(&self) -> Arc<Shares> {
        Arc::clone(&self.shares)
    }
}

impl Drop for SharePermit {
    fn drop(&mut self) {
        let mut taken = self.shares.taken.lock();
        if let Some(own) = taken.get_mut(&self.owner) {
            *own = own.saturating_sub(self.n);
            if *own == 0 {
                taken.remove(&self.owner);
            }
        }
        drop(taken);
        self.shares.returned.notify_waiters();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn no_owner_takes_more_than_its_share_and_what_is_returned_is_taken_again() {
        let shares = Shares::new(10, 6);
        let mut first = shares.try_take("a", 4).unwrap();
        assert!(first.grow(2) && !first.grow(1), "its share is 6");
        assert!(shares.try_take("a", 1).is_none());
        let second = shares.try_take("b", 4).unwrap();
        assert!(shares.try_take("c", 1).is_none(), "nothing is left");
        assert!(shares.take("c", 5, Duration::from_millis(20)).await.is_none());
        let waiting = tokio::spawn({
            let shares = Arc::clone(&shares);
            async move { shares.take("c", 5, Duration::from_secs(5)).await.is_some() }
        });
        tokio::time::sleep(Duration::from_millis(50)).await;
        drop(first);
        assert!(waiting.await.unwrap());
        drop(second);
        assert!(shares.taken.lock().is_empty(), "owners without a part are forgotten");
    }
}
