# The service in a container.
#
#   docker build --build-arg HOMOLOG_COMMIT="$(git rev-parse --short=12 HEAD)" -t homolog .
#   docker run --rm -p 127.0.0.1:8080:8080 -v homolog-data:/data homolog
#
# In a container the service listens on 0.0.0.0, or nobody outside it could reach it. Any address but a loopback one
# demands authentication or an explicit --insecure; the command below says --insecure, which is right only while the
# port is published on a trusted network, as on 127.0.0.1 above.

FROM rust:1.95-slim-bookworm AS build
WORKDIR /build
# The official image holds a C compiler, which the bundled SQLite needs.
COPY Cargo.toml Cargo.lock build.rs ./
COPY src src
COPY api api
# No checkout in here: the commit comes from outside, or is "unknown".
ARG HOMOLOG_COMMIT=""
RUN cargo build --release --locked --bin homolog && mkdir /data

FROM debian:bookworm-slim
COPY --from=build /build/target/release/homolog /usr/local/bin/homolog
# A number and no name, so that Kubernetes can see that it is not root.
COPY --from=build --chown=65532:65532 /data /data
USER 65532:65532
VOLUME /data
EXPOSE 8080
HEALTHCHECK --interval=10s --timeout=4s --start-period=20s CMD ["homolog", "health"]
STOPSIGNAL SIGTERM
ENTRYPOINT ["homolog"]
CMD ["serve", "--listen", "0.0.0.0:8080", "--data-dir", "/data", "--insecure"]
