//! OpenTelemetry spans: from the request of a submission over the queue to the phases of its job, across processes.
//!
//! The context of a span is passed on as a `traceparent` (W3C Trace Context): with the request, with the job in the
//! database, and with deliveries of webhooks. The receiver of a context begins child spans. Without `--otlp-endpoint`
//! nothing is recorded, and a context is passed on unchanged.
//!
//! Invariant: names and attributes are constants of this program, ids that it made, and numbers ([`Fact`]); no text
//! from a client or about a patient can be recorded.

use opentelemetry::trace::{
    Span as _, SpanBuilder, SpanContext, SpanId, SpanKind, Status, TraceContextExt as _, TraceFlags, TraceId,
    TraceState, Tracer as _, TracerProvider as _,
};
use opentelemetry::{Context, KeyValue, Value};
use opentelemetry_otlp::{Protocol, WithExportConfig as _, WithHttpConfig as _};
use opentelemetry_sdk::Resource;
use opentelemetry_sdk::error::OTelSdkResult;
use opentelemetry_sdk::trace::{SdkTracer, SdkTracerProvider, SpanData, SpanExporter};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, SystemTime};

/// Time limit of a request to the collector.
const SEND_TIMEOUT: Duration = Duration::from_secs(5);
/// How long the end of the process waits until the last spans are sent.
const FLUSH_TIMEOUT: Duration = Duration::from_secs(3);
/// The path of spans below the endpoint.
const TRACES: &str = "v1/traces";

/// Creates spans and sends them; unset until [`start`].
static SENDING: OnceLock<(SdkTracerProvider, SdkTracer)> = OnceLock::new();

/// The value of a span's attribute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fact {
    /// A number.
    Number(u64),
    /// A constant of this program.
    Word(&'static str),
    /// An id that this program made.
    Id(uuid::Uuid),
}

/// Sends the spans of this process to the collector at the base address `endpoint`. Further calls have no effect. Must
/// not be called within a runtime.
///
/// # Errors
/// If `endpoint` is not an HTTP address, or the client cannot be created.
pub fn start(endpoint: &str) -> Result<(), String> {
    if SENDING.get().is_some() {
        return Ok(());
    }
    crate::tls::prepare();
    let client = reqwest::blocking::Client::builder().timeout(SEND_TIMEOUT).no_proxy();
    let client = client.build().map_err(|_| "the client of the collector cannot be made".to_owned())?;
    let exporter = opentelemetry_otlp::SpanExporter::builder()
        .with_http()
        .with_http_client(client)
        .with_protocol(Protocol::HttpBinary)
        .with_timeout(SEND_TIMEOUT)
        .with_endpoint(traces_url(endpoint)?)
        .build()
        .map_err(|error| format!("spans cannot be sent: {error}"))?;
    let version = KeyValue::new("service.version", env!("CARGO_PKG_VERSION"));
    let provider = SdkTracerProvider::builder()
        .with_batch_exporter(Watched { exporter, is_failing: AtomicBool::new(false) })
        .with_resource(Resource::builder().with_service_name("homolog").with_attribute(version).build())
        .build();
    let tracer = provider.tracer("homolog");
    let _ = SENDING.set((provider, tracer));
    Ok(())
}

/// Sends the spans that have ended and were not sent yet, for a limited time. Must not be called within a runtime.
pub fn finish() {
    if let Some((provider, _)) = SENDING.get() {
        let _ = provider.shutdown_with_timeout(FLUSH_TIMEOUT);
    }
}

/// The URL below this endpoint that receives spans.
///
/// # Errors
/// If `endpoint` is not an HTTP address.
pub(crate) fn traces_url(endpoint: &str) -> Result<String, String> {
    let url = url::Url::parse(endpoint).ok().filter(|url| ["http", "https"].contains(&url.scheme()) && url.has_host());
    let url =
        url.ok_or_else(|| "the address of a collector is needed here, such as http://collector:4318".to_owned())?;
    Ok(format!("{}/{TRACES}", url.as_str().trim_end_matches('/')))
}

/// Sends spans. Logs once when sending begins to fail, and once when it works again.
#[derive(Debug)]
struct Watched {
    exporter: opentelemetry_otlp::SpanExporter,
    is_failing: AtomicBool,
}

impl SpanExporter for Watched {
    async fn export(&self, batch: Vec<SpanData>) -> OTelSdkResult {
        let sent = self.exporter.export(batch).await;
        let was_failing = self.is_failing.swap(sent.is_err(), Ordering::Relaxed);
        match (was_failing, sent.is_err()) {
            (false, true) => tracing::warn!("spans cannot be sent to the collector; they are dropped"),
            (true, false) => tracing::info!("spans are sent to the collector again"),
            _ => {}
        }
        sent
    }

    fn set_resource(&mut self, resource: &Resource) {
        self.exporter.set_resource(resource);
    }
}

/// A span, which ends when dropped. Empty if spans are not sent.
#[derive(Debug, Default)]
pub(crate) struct Span(Option<opentelemetry_sdk::trace::Span>);

impl Span {
    /// The span of a request. `method` and `route` are the labels of metrics, from closed sets.
    pub(crate) fn of_request(method: &'static str, route: &str, parent: Option<&str>) -> Self {
        let Some((_, tracer)) = SENDING.get() else { return Span(None) };
        let attributes = [KeyValue::new("http.request.method", method), KeyValue::new("http.route", route.to_owned())];
        let builder = tracer.span_builder(format!("{method} {route}")).with_kind(SpanKind::Server);
        Span(Some(begin(tracer, builder.with_attributes(attributes), parent)))
    }

    /// The span of the run of a job that waited in a queue.
    pub(crate) fn of_job(parent: Option<&str>) -> Self {
        Span::new("run job", SpanKind::Consumer, parent, None)
    }

    /// The span of an attempt to send an event to its receiver.
    pub(crate) fn of_delivery(parent: Option<&str>) -> Self {
        Span::new("deliver webhook", SpanKind::Client, parent, None)
    }

    /// The span of a part of another span's work.
    pub(crate) fn part(name: &'static str, parent: Option<&str>) -> Self {
        Span::new(name, SpanKind::Internal, parent, None)
    }

    /// The span of a part that began earlier.
    pub(crate) fn part_since(name: &'static str, parent: Option<&str>, began: SystemTime) -> Self {
        // Times of the database's clock may be ahead of this machine's.
        Span::new(name, SpanKind::Internal, parent, Some(began.min(SystemTime::now())))
    }

    fn new(name: &'static str, kind: SpanKind, parent: Option<&str>, began: Option<SystemTime>) -> Self {
        let Some((_, tracer)) = SENDING.get() else { return Span(None) };
        let mut builder = tracer.span_builder(name).with_kind(kind);
        builder.start_time = began;
        Span(Some(begin(tracer, builder, parent)))
    }

    /// The context of the span, for children in this or another process; `None` if spans are not sent.
    pub(crate) fn traceparent(&self) -> Option<String> {
        let context = self.0.as_ref()?.span_context();
        Some(format!("00-{}-{}-{:02x}", context.trace_id(), context.span_id(), context.trace_flags()))
    }

    /// Adds an attribute.
    pub(crate) fn set(&mut self, key: &'static str, fact: Fact) {
        let Some(span) = &mut self.0 else { return };
        let value: Value = match fact {
            Fact::Number(number) => i64::try_from(number).unwrap_or(i64::MAX).into(),
            Fact::Word(word) => word.into(),
            Fact::Id(id) => id.to_string().into(),
        };
        span.set_attribute(KeyValue::new(key, value));
    }

    /// Marks the span as failed.
    pub(crate) fn fail(&mut self) {
        if let Some(span) = &mut self.0 {
            span.set_status(Status::error(""));
        }
    }
}

fn begin(tracer: &SdkTracer, builder: SpanBuilder, parent: Option<&str>) -> opentelemetry_sdk::trace::Span {
    let parent = parent.and_then(context);
    let parent = parent.map_or_else(Context::new, |parent| Context::new().with_remote_span_context(parent));
    builder.start_with_context(tracer, &parent)
}

/// The context in a valid `traceparent`.
fn context(traceparent: &str) -> Option<SpanContext> {
    let mut parts = traceparent.split('-').skip(1);
    let (trace, span, flags) = (parts.next()?, parts.next()?, parts.next()?);
    if (trace.len(), span.len()) != (32, 16) {
        return None;
    }
    let flags = TraceFlags::new(u8::from_str_radix(flags, 16).ok()?) & TraceFlags::SAMPLED;
    let (trace, span) = (TraceId::from_hex(trace).ok()?, SpanId::from_hex(span).ok()?);
    let context = SpanContext::new(trace, span, flags, true, TraceState::NONE);
    context.is_valid().then_some(context)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contexts_are_read_and_damaged_ones_begin_a_trace_of_their_own() {
        let whole = context("00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01").unwrap();
        assert_eq!(whole.trace_id().to_string(), "0af7651916cd43dd8448eb211c80319c");
        assert_eq!((whole.span_id().to_string(), whole.is_sampled()), ("b7ad6b7169203331".to_owned(), true));
        for damaged in ["", "00", "00-0af7-b7ad-01", "00-00000000000000000000000000000000-b7ad6b7169203331-01"] {
            assert!(context(damaged).is_none(), "{damaged}");
        }
    }

    #[test]
    fn nothing_is_recorded_without_an_endpoint() {
        let mut span = Span::of_job(Some("00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01"));
        span.set("homolog.attempt", Fact::Number(1));
        span.fail();
        assert_eq!(span.traceparent(), None);
    }

    #[test]
    fn spans_go_below_the_endpoint() {
        assert_eq!(traces_url("http://collector:4318").unwrap(), "http://collector:4318/v1/traces");
        assert_eq!(traces_url("https://x/otlp/").unwrap(), "https://x/otlp/v1/traces");
        for wrong in ["collector:4318", "ftp://x", "http://", ""] {
            assert!(traces_url(wrong).is_err(), "{wrong}");
        }
    }
}
