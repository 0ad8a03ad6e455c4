# The service in a container.
#
#   docker build --build-arg HOMOLOG_COMMIT="$(git rev-parse --short=12 HEAD)" -t homolog .
#   docker run --rm -v homolog-data:/data homolog keys create --init --tenant default --scope submit,read
#   docker run --rm -p 127.0.0.1:8080:8080 -v homolog-data:/data homolog
#
# In a container the service listens on 0.0.0.0, or nobody outside it could reach it; on any address but a loopback one it
# requires an API key. The second line creates the database and a key, and prints the key, once. Without authentication, on
# a machine of your own, append `serve --auth none --insecure` to the third line. deploy/ has complete set-ups: one machine,
# separate processes, Kubernetes.

FROM rust:1.95-slim-bookworm AS build
WORKDIR /build
# The official image holds a C compiler, which the bundled SQLite needs.
COPY Cargo.toml Cargo.lock build.rs ./
COPY crates crates
COPY src src
COPY api api
# No checkout in here: the commit comes from outside, or is "unknown".
ARG HOMOLOG_COMMIT=""
RUN cargo build --release --locked --bin homolog && mkdir /data

FROM debian:bookworm-slim
COPY --from=build /build/target/release/homolog /usr/local/bin/homolog
# Whose certificates are believed: PostgreSQL, the object store and webhooks are reached over TLS. For an authority of
# one's own, mount its certificates and name the file in SSL_CERT_FILE.
COPY --from=build /etc/ssl/certs/ca-certificates.crt /etc/ssl/certs/ca-certificates.crt
# A number and no name, so that Kubernetes can see that it is not root.
COPY --from=build --chown=65532:65532 /data /data
USER 65532:65532
# As variables and not as arguments of serve: keys, purge, migrate and worker need them too.
ENV HOMOLOG_DATA_DIR=/data HOMOLOG_LISTEN=0.0.0.0:8080
VOLUME /data
EXPOSE 8080
# For `serve`; a worker answers only where it is told to, see deploy/compose.scale-out.yaml.
HEALTHCHECK --interval=10s --timeout=4s --start-period=20s CMD ["homolog", "health"]
# The first asks to end, a second one insists; `docker stop` kills 10 s after the first, so give it more time than
# HOMOLOG_SHUTDOWN_GRACE_MS (3 s unless set) and 5 s.
STOPSIGNAL SIGTERM
ENTRYPOINT ["homolog"]
CMD ["serve"]
