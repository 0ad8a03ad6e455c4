//! The server loop: accepts connections up to a limit, limits the time for request headers and for reading an answer,
//! and shuts down gracefully.
//!
//! It serves HTTP/1.1, with TLS if there are certificates. It uses hyper's HTTP/1 connection and not the one that
//! detects HTTP/2, because detection reads the first bytes without a time limit.

use super::pace::{LeastRate, Pace};
use super::shares::Peer;
use crate::tls::ServerTls;
use axum::Router;
use axum::body::Body;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::io::{self, ErrorKind, IoSlice};
use std::net::IpAddr;
use std::pin::Pin;
use std::sync::Arc;
use std::task::{Context, Poll};
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Semaphore;
use tokio::task::JoinSet;
use tokio_rustls::TlsAcceptor;
use tokio_util::sync::CancellationToken;
use tower::ServiceExt;

/// Pause before the next connection is accepted when the system is out of file descriptors or memory.
const EXHAUSTED: Duration = Duration::from_millis(500);

/// Bounds on connections.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConnectionLimits {
    /// Longest time from the opening of a connection, or from its last answer, to the end of the next request's
    /// headers; this also limits how long a connection can be idle.
    pub header_timeout: Duration,
    /// Maximum number of open connections. Further ones wait in the backlog of the operating system.
    pub max_connections: usize,
    /// The least rate at which a client reads an answer; a connection whose client is slower is closed.
    pub least_rate: LeastRate,
}

/// A connection whose client has to read what is written to it.
struct PacedStream {
    stream: TcpStream,
    pace: Pace,
}

impl PacedStream {
    /// Counts the written bytes, or the time in which the client does not read.
    fn counted(&mut self, cx: &mut Context<'_>, written: Poll<io::Result<usize>>) -> Poll<io::Result<usize>> {
        match &written {
            Poll::Ready(Ok(n)) => self.pace.moved(*n),
            Poll::Ready(Err(_)) => {}
            Poll::Pending if self.pace.poll_too_slow(cx).is_ready() => {
                return Poll::Ready(Err(io::Error::new(ErrorKind::TimedOut, "the client reads too slowly")));
            }
            Poll::Pending => {}
        }
        written
    }
}

impl AsyncRead for PacedStream {
    fn poll_read(mut self: Pin<&mut Self>, cx: &mut Context<'_>, buffer: &mut ReadBuf<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_read(cx, buffer)
    }
}

impl AsyncWrite for PacedStream {
    fn poll_write(mut self: Pin<&mut Self>, cx: &mut Context<'_>, bytes: &[u8]) -> Poll<io::Result<usize>> {
        let written = Pin::new(&mut self.stream).poll_write(cx, bytes);
        self.counted(cx, written)
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        parts: &[IoSlice<'_>],
    ) -> Poll<io::Result<usize>> {
        let written = Pin::new(&mut self.stream).poll_write_vectored(cx, parts);
        self.counted(cx, written)
    }

    fn is_write_vectored(&self) -> bool {
        self.stream.is_write_vectored()
    }

    fn poll_flush(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_flush(cx)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, cx: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(cx)
    }
}

/// A server on one address.
pub struct Served {
    /// The address.
    pub listener: TcpListener,
    /// The router that answers requests.
    pub router: Router,
    /// Limits on its connections.
    pub limits: ConnectionLimits,
    /// The certificates; `None`: no TLS.
    pub tls: Option<Arc<ServerTls>>,
}

/// Serves until `stop`. Then no further connection is accepted, idle connections are closed at once, and requests in
/// progress are completed. Dropping the future closes all connections.
pub async fn serve(served: Served, stop: CancellationToken) {
    let Served { listener, router, limits, tls } = served;
    let permits = Arc::new(Semaphore::new(limits.max_connections.clamp(1, Semaphore::MAX_PERMITS)));
    let mut connections = JoinSet::new();
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new()).header_read_timeout(limits.header_timeout);
    loop {
        let accepted = tokio::select! {
            accepted = async {
                // The slot comes first: a connection that is not accepted costs this process nothing.
                let permit = Arc::clone(&permits).acquire_owned().await.ok();
                (accept(&listener).await, permit)
            } => accepted,
            () = stop.cancelled() => break,
        };
        let ((stream, address), permit) = accepted;
        // Finished tasks are removed, so that the set is no larger than the number of open connections.
        while connections.try_join_next().is_some() {}
        let (http, router, stop, tls) = (http.clone(), router.clone(), stop.clone(), tls.clone());
        connections.spawn(async move {
            let _permit = permit;
            let stream = PacedStream { stream, pace: Pace::new(limits.least_rate) };
            let Some(tls) = tls else { return serve_connection(stream, address, &http, router, stop).await };
            // Limited by the time for headers, so that a client that begins no handshake holds its place no longer than
            // one that sends no request.
            let handshake = TlsAcceptor::from(tls.config()).accept(stream);
            match tokio::time::timeout(limits.header_timeout, handshake).await {
                Ok(Ok(stream)) => serve_connection(stream, address, &http, router, stop).await,
                Ok(Err(error)) => tracing::debug!(%error, "a TLS handshake failed"),
                Err(_) => tracing::debug!("a TLS handshake took too long"),
            }
        });
    }
    drop(listener);
    while connections.join_next().await.is_some() {}
}

/// The next connection. Errors of a single connection do not stop the listener.
async fn accept(listener: &TcpListener) -> (TcpStream, IpAddr) {
    loop {
        match listener.accept().await {
            Ok((stream, peer)) => {
                // Answers are written in one piece, so Nagle's algorithm would only delay them. Failing to set this is
                // harmless.
                let _ = stream.set_nodelay(true);
                return (stream, peer.ip().to_canonical());
            }
            Err(error) => match error.kind() {
                ErrorKind::ConnectionRefused | ErrorKind::ConnectionAborted | ErrorKind::ConnectionReset => {}
                _ => {
                    tracing::error!(%error, "cannot accept connections");
                    tokio::time::sleep(EXHAUSTED).await;
                }
            },
        }
    }
}

/// Serves one connection until it is closed.
async fn serve_connection(
    stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
    address: IpAddr,
    http: &http1::Builder,
    router: Router,
    stop: CancellationToken,
) {
    let service = router.map_request(move |mut request: hyper::Request<hyper::body::Incoming>| {
        request.extensions_mut().insert(Peer(address));
        request.map(Body::new)
    });
    let connection = http.serve_connection(TokioIo::new(stream), TowerToHyperService::new(service));
    let mut connection = std::pin::pin!(connection);
    let ended = tokio::select! {
        ended = connection.as_mut() => ended,
        () = stop.cancelled() => {
            connection.as_mut().graceful_shutdown();
            connection.await
        }
    };
    if let Err(error) = ended {
        // Clients disconnect all the time; the address is kept out of the log.
        tracing::debug!(%error, "a connection was closed early");
    }
}
