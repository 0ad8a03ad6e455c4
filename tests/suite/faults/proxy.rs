//! A network that fails: a TCP proxy on a loopback port that forwards, refuses, cuts, or swallows.

use std::net::SocketAddr;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpListener, TcpStream};
use tokio::runtime::Runtime;
use tokio::sync::watch;

/// State of the network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Network {
    /// Bytes and new connections are forwarded.
    Up,
    /// New connections are refused; existing ones are unaffected.
    Refusing,
    /// Half-open: connections are accepted, and no byte is forwarded until the network is up again.
    Silent,
}

#[derive(Debug, Clone, Copy)]
struct State {
    network: Network,
    n_cuts: u64,
}

/// A proxy in front of a port; it ends when this is dropped.
pub(super) struct Proxy {
    port: u16,
    state: watch::Sender<State>,
    runtime: Option<Runtime>,
}

impl Proxy {
    /// A proxy in front of `target`.
    pub(super) fn to(target: u16) -> Self {
        let (state, seen) = watch::channel(State { network: Network::Up, n_cuts: 0 });
        let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(1).enable_all().build().unwrap();
        let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
        listener.set_nonblocking(true).unwrap();
        let address = listener.local_addr().unwrap();
        runtime.spawn(listen(listener, address, target, seen));
        Proxy { port: address.port(), state, runtime: Some(runtime) }
    }

    pub(super) fn port(&self) -> u16 {
        self.port
    }

    /// Sets the state of the network.
    pub(super) fn set(&self, network: Network) {
        self.state.send_modify(|state| state.network = network);
    }

    /// Resets all existing connections.
    pub(super) fn cut(&self) {
        self.state.send_modify(|state| state.n_cuts += 1);
    }
}

impl Drop for Proxy {
    fn drop(&mut self) {
        if let Some(runtime) = self.runtime.take() {
            runtime.shutdown_background();
        }
    }
}

async fn listen(first: std::net::TcpListener, address: SocketAddr, target: u16, mut state: watch::Receiver<State>) {
    let mut listener = Some(TcpListener::from_std(first).unwrap());
    loop {
        let network = state.borrow_and_update().network;
        if network == Network::Refusing {
            listener = None;
        } else if listener.is_none() {
            listener = TcpListener::bind(address).await.ok();
        }
        let accepted = async {
            match &listener {
                Some(listener) => listener.accept().await,
                None => std::future::pending().await,
            }
        };
        tokio::select! {
            changed = state.changed() => if changed.is_err() { return },
            stream = accepted => if let Ok((stream, _)) = stream {
                tokio::spawn(connect(stream, target, state.clone()));
            },
        }
    }
}

async fn connect(near: TcpStream, target: u16, mut state: watch::Receiver<State>) {
    let n_cuts = state.borrow().n_cuts;
    // Closed by a reset, as by a router that has lost its connection table.
    let _ = near.set_zero_linger();
    let mut moving = state.clone();
    let carry = async {
        let _ = moving.wait_for(|state| state.network == Network::Up).await.is_ok();
        let Ok(far) = TcpStream::connect(("127.0.0.1", target)).await else { return };
        let _ = (near.set_nodelay(true), far.set_nodelay(true));
        let (near_out, near_in) = near.into_split();
        let (far_out, far_in) = far.into_split();
        tokio::select! {
            () = pump(near_out, far_in, moving.clone()) => {}
            () = pump(far_out, near_in, moving) => {}
        }
    };
    tokio::select! {
        () = carry => {}
        _ = state.wait_for(|state| state.n_cuts != n_cuts) => {}
    }
}

/// Forwards bytes in one direction while the network is up; bytes in transit when it goes down are delivered later.
async fn pump(
    mut from: tokio::net::tcp::OwnedReadHalf,
    mut to: tokio::net::tcp::OwnedWriteHalf,
    mut state: watch::Receiver<State>,
) {
    let mut buffer = vec![0; 16 << 10];
    loop {
        let n = match from.read(&mut buffer).await {
            Ok(n) if n > 0 => n,
            _ => return,
        };
        let passes = state.wait_for(|state| state.network != Network::Silent).await.is_ok();
        if !passes || to.write_all(&buffer[..n]).await.is_err() {
            return;
        }
    }
}

#[tokio::test]
async fn a_proxy_passes_swallows_cuts_and_refuses() {
    let server = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let proxy = Proxy::to(server.local_addr().unwrap().port());
    tokio::spawn(async move {
        while let Ok((mut stream, _)) = server.accept().await {
            tokio::spawn(async move {
                let (mut from, mut to) = stream.split();
                let _ = tokio::io::copy(&mut from, &mut to).await;
            });
        }
    });
    let short = std::time::Duration::from_millis(200);
    let mut answer = [0; 2];
    let mut client = TcpStream::connect(("127.0.0.1", proxy.port())).await.unwrap();
    client.write_all(b"hi").await.unwrap();
    client.read_exact(&mut answer).await.unwrap();
    assert_eq!(&answer, b"hi");

    proxy.set(Network::Silent);
    tokio::time::sleep(short).await;
    client.write_all(b"ho").await.unwrap();
    assert!(tokio::time::timeout(short, client.read_exact(&mut answer)).await.is_err(), "swallowed");
    let late = TcpStream::connect(("127.0.0.1", proxy.port())).await;
    assert!(late.is_ok(), "half-open");
    proxy.set(Network::Up);
    client.read_exact(&mut answer).await.unwrap();
    assert_eq!(&answer, b"ho");

    proxy.cut();
    assert!(matches!(client.read(&mut answer).await, Err(_) | Ok(0)));
    proxy.set(Network::Refusing);
    tokio::time::sleep(short).await;
    assert!(TcpStream::connect(("127.0.0.1", proxy.port())).await.is_err());
    proxy.set(Network::Up);
    tokio::time::sleep(short).await;
    assert!(TcpStream::connect(("127.0.0.1", proxy.port())).await.is_ok());
}
