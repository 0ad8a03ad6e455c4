//! The scheduling rule against its definition, and simulations of a process that follows it.

use super::schedule::{Candidate, Room, startable};
use proptest::prelude::*;
use std::time::Duration;

const BUDGET: Room = Room { cores: 4, memory_bytes: 100 };

fn seconds(s: u64) -> Duration {
    Duration::from_secs(s)
}

fn room(cores: usize, memory_bytes: u64) -> Room {
    Room { cores, memory_bytes }
}

fn candidate(cores: usize, memory_bytes: u64, waited: u64) -> Candidate {
    Candidate { need: room(cores, memory_bytes), waited: seconds(waited) }
}

#[test]
fn small_jobs_start_in_queue_order() {
    let waiting = [candidate(1, 10, 3), candidate(1, 10, 2), candidate(1, 10, 1)];
    assert_eq!(startable(BUDGET, &waiting, seconds(5)), [0, 1, 2]);
    assert_eq!(startable(Room::NONE, &waiting, seconds(5)), [0; 0]);
}

#[test]
fn a_large_job_is_overtaken_until_it_has_waited_for_the_patience() {
    let waiting = |waited| [candidate(4, 10, waited), candidate(1, 10, 1)];
    assert_eq!(startable(room(3, 100), &waiting(4), seconds(5)), [1]);
    assert_eq!(startable(room(3, 100), &waiting(5), seconds(5)), [0; 0]);
    assert_eq!(startable(BUDGET, &waiting(5), seconds(5)), [0, 1]);
}

#[test]
fn memory_limits_a_job_as_cores_do() {
    let waiting = [candidate(1, 60, 0), candidate(1, 40, 0)];
    assert_eq!(startable(room(4, 50), &waiting, seconds(5)), [1]);
}

fn candidates() -> impl Strategy<Value = Vec<Candidate>> {
    prop::collection::vec((1..=4usize, 0..=100u64, 0..10u64).prop_map(|(c, m, w)| candidate(c, m, w)), 0..12)
}

/// A job of the simulation: its arrival time, its need, its run time.
#[derive(Debug, Clone, Copy)]
struct Arrival {
    at: u64,
    need: Room,
    takes: u64,
}

fn arrivals() -> impl Strategy<Value = Vec<Arrival>> {
    let job = (0..30u64, prop_oneof![3 => 1..=1usize, 1 => 2..=4usize], 0..=100u64, 1..6u64);
    let job = job.prop_map(|(at, cores, memory, takes)| Arrival { at, need: room(cores, memory), takes });
    prop::collection::vec(job, 1..40).prop_map(|mut jobs| {
        jobs.sort_by_key(|job| job.at);
        jobs
    })
}

/// A start: which job, and when.
#[derive(Debug, Clone, Copy)]
struct Start {
    job: usize,
    at: u64,
}

/// Simulates a process that follows the rule, in discrete time. When no further job starts in a step, `check` gets the
/// time, the free resources, and the waiting jobs.
fn simulate(jobs: &[Arrival], patience: u64, mut check: impl FnMut(u64, Room, &[usize])) -> Vec<Start> {
    let (mut waiting, mut running): (Vec<usize>, Vec<(usize, u64)>) = (Vec::new(), Vec::new());
    let (mut starts, mut next, mut now) = (Vec::new(), 0, 0);
    while starts.len() < jobs.len() {
        running.retain(|(_, end)| *end > now);
        while next < jobs.len() && jobs[next].at <= now {
            waiting.push(next);
            next += 1;
        }
        loop {
            let used = running.iter().fold(Room::NONE, |sum, (job, _)| sum.plus(jobs[*job].need));
            assert!(BUDGET.holds(used), "at {now} jobs have {used:?} of {BUDGET:?}");
            let candidates: Vec<_> = waiting
                .iter()
                .map(|&job| Candidate { need: jobs[job].need, waited: seconds(now - jobs[job].at) })
                .collect();
            let Some(&position) = startable(BUDGET.minus(used), &candidates, seconds(patience)).first() else {
                check(now, BUDGET.minus(used), &waiting);
                break;
            };
            let job = waiting.remove(position);
            running.push((job, now + jobs[job].takes));
            starts.push(Start { job, at: now });
        }
        now += 1;
        assert!(now < 10_000, "a job never starts");
    }
    starts
}

proptest! {
    #[test]
    fn the_rule_equals_its_definition(free_cores in 0..=4usize, free_memory in 0..=100u64, waiting in candidates(), patience in 0..10u64) {
        let free = room(free_cores, free_memory);
        let fits = |c: &Candidate| c.need.cores <= free_cores && c.need.memory_bytes <= free_memory;
        let blocks = |c: &Candidate| !fits(c) && c.waited >= seconds(patience);
        let expected: Vec<usize> =
            (0..waiting.len()).filter(|&i| fits(&waiting[i]) && !waiting[..i].iter().any(blocks)).collect();
        prop_assert_eq!(startable(free, &waiting, seconds(patience)), expected);
    }

    #[test]
    fn an_idle_process_starts_the_first_job_whatever_it_needs(cores in 0..10usize, memory in 0..1000u64, waited in 0..10u64) {
        let need = room(cores, memory).at_most(BUDGET);
        let first = Candidate { need, waited: seconds(waited) };
        prop_assert_eq!(startable(BUDGET, &[first], seconds(5)), [0]);
    }

    #[test]
    fn running_jobs_stay_within_the_budget_and_every_job_runs(jobs in arrivals(), patience in 0..20u64) {
        let mut ran: Vec<_> = simulate(&jobs, patience, |_, _, _| {}).iter().map(|start| start.job).collect();
        ran.sort_unstable();
        prop_assert_eq!(ran, (0..jobs.len()).collect::<Vec<_>>());
    }

    #[test]
    fn a_job_that_fits_waits_only_for_an_older_one_that_has_waited_for_the_patience(jobs in arrivals(), patience in 0..20u64) {
        simulate(&jobs, patience, |now, free, waiting| {
            let Some(fitting) = waiting.iter().position(|&job| free.holds(jobs[job].need)) else { return };
            let is_held = waiting[..fitting].iter().any(|&job| now - jobs[job].at >= patience);
            assert!(is_held, "at {now} job {} could run on {free:?}", waiting[fitting]);
        });
    }

    #[test]
    fn no_later_job_overtakes_one_that_has_waited_for_the_patience(jobs in arrivals(), patience in 0..20u64) {
        let starts = simulate(&jobs, patience, |_, _, _| {});
        for (position, late) in starts.iter().enumerate() {
            for early in &starts[..position] {
                let passed = early.job > late.job && early.at >= jobs[late.job].at;
                prop_assert!(!passed || early.at < jobs[late.job].at + patience, "{:?} passed {:?}", early, late);
            }
        }
    }

    #[test]
    fn the_oldest_job_waits_at_most_for_the_patience_and_the_longest_running_job(jobs in arrivals(), patience in 0..20u64) {
        let starts = simulate(&jobs, patience, |_, _, _| {});
        let longest = jobs.iter().map(|job| job.takes).max().unwrap();
        for start in &starts {
            // The job is the oldest waiting job once all older ones have started.
            let older = starts.iter().filter(|other| other.job < start.job).map(|other| other.at).max().unwrap_or(0);
            let begins = older.max(jobs[start.job].at + patience);
            prop_assert!(start.at <= begins + longest, "{:?} waited past {}", start, begins + longest);
        }
    }
}
