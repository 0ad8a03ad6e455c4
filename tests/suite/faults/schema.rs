//! A12: concurrent migrations, and a schema from a newer program.

use super::client::steps;
use super::site::{Backend, SOON, Site};
use super::{node::NotStarted, on_both};

on_both!(a12_eight_processes_migrate_one_database, a12_an_older_program_refuses_a_newer_schema);

async fn a12_eight_processes_migrate_one_database(backend: Backend) {
    let site = Site::open(backend);
    let starting: Vec<_> = (0..8).map(|_| site.begin_node("worker", &[], &[])).collect();
    let mut nodes = Vec::new();
    for node in starting {
        nodes.push(node.ready().unwrap_or_else(|NotStarted(log)| panic!("{log}")));
    }
    let database = site.database().await;
    let applied = database.number("SELECT COUNT(*) FROM _sqlx_migrations").await;
    let distinct = database.number("SELECT COUNT(DISTINCT version) FROM _sqlx_migrations WHERE success").await;
    assert!(applied > 0);
    assert_eq!(applied, distinct);
    let front = site.serve(&["--workers", "0"]);
    let client = site.client(&front);
    let id = client.submit(steps(3, 10)).await;
    client.until_succeeded(&id, SOON).await;
}

async fn a12_an_older_program_refuses_a_newer_schema(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--workers", "0"]);
    let id = site.client(&node).submit(steps(1, 1)).await;
    drop(node);
    let database = site.database().await;
    database
        .execute(
            "INSERT INTO _sqlx_migrations (version, description, installed_on, success, checksum, execution_time)
             SELECT 99999999, 'of the future', installed_on, success, checksum, execution_time
             FROM _sqlx_migrations ORDER BY version LIMIT 1",
        )
        .await;
    for role in ["serve", "worker"] {
        let Err(NotStarted(log)) = site.node(role, &[], &[]) else { panic!("an old program runs on newer tables") };
        assert!(log.contains("newer release (migration 99999999)"), "it says why: {log}");
    }
    // Nothing was changed: the newer program continues to work.
    database.execute("DELETE FROM _sqlx_migrations WHERE version = 99999999").await;
    let node = site.serve(&[]);
    site.client(&node).until_succeeded(&id, SOON).await;
}
