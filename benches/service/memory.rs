//! Resident memory of the program: idle, and while it receives a large file.

use crate::Scale;
use crate::http::Client;
use crate::node::Node;
use crate::place::Place;
use crate::s3::S3Server;
use std::time::{Duration, Instant};

pub(crate) async fn idle(scale: Scale) {
    println!("\n## Memory of an idle `homolog serve`\n");
    println!(
        "VmRSS of the process {:?} after its start, and after a request for each of six read-only resources.\n",
        wait(scale)
    );
    println!("| store | at rest MiB | after requests MiB | target 50 MiB |\n|---|---|---|---|");
    for place in Place::all() {
        let node = Node::program(&place.environment());
        tokio::time::sleep(wait(scale)).await;
        let at_rest = node.status_mib("VmRSS");
        let mut client = Client::connect(&node.address).await;
        for path in ["/healthz", "/readyz", "/metrics", "/v1/jobs", "/v1/methods", "/v1/openapi.json"] {
            client.request("GET", path, "", b"").await;
        }
        let after = node.status_mib("VmRSS");
        let verdict = if at_rest.max(after) < 50.0 { "met" } else { "missed" };
        println!("| {} | {at_rest:.1} | {after:.1} | {verdict} |", place.name());
    }
}

fn wait(scale: Scale) -> Duration {
    scale.pick(Duration::from_millis(500), Duration::from_secs(10))
}

pub(crate) async fn upload(scale: Scale) {
    let mib = scale.pick(20, 200);
    println!("\n## An upload of {mib} MiB\n");
    println!(
        "`POST /v1/meshes?inspect=false`; peak resident memory (VmHWM) of the process before and after. S3: s3s-fs"
    );
    println!("in the benchmark's process, on the same disk, without fsync.\n");
    println!("| files in | before MiB | after MiB | seconds | MiB/s |\n|---|---|---|---|---|");
    for in_s3 in [false, true] {
        let s3 = in_s3.then(S3Server::start);
        let place = Place::sqlite();
        let mut environment = place.environment();
        environment.push(("HOMOLOG_MAX_FILE_BYTES", (512 << 20).to_string()));
        environment.extend(s3.iter().flat_map(|s3| S3Server::environment(s3.port())));
        let node = Node::program(&environment);
        let mut client = Client::connect(&node.address).await;
        client.request("GET", "/readyz", "", b"").await;
        let before = node.status_mib("VmHWM");
        let part: Vec<u8> = (0..1_u32 << 20).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        let began = Instant::now();
        let path = "/v1/meshes?inspect=false&file_name=large.ply";
        let (status, answer) = client.send_parts(path, &part, mib).await;
        let seconds = began.elapsed().as_secs_f64();
        assert_eq!(status, 201, "{}", String::from_utf8_lossy(&answer));
        let after = node.status_mib("VmHWM");
        let name = if in_s3 { "S3" } else { "a folder" };
        println!("| {name} | {before:.1} | {after:.1} | {seconds:.1} | {:.0} |", mib as f64 / seconds);
    }
}
