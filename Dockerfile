# The service in a container.
#
#   docker build --build-arg HOMOLOG_COMMIT="$(git rev-parse --short=12 HEAD)" -t homolog .
#   docker run --rm -v homolog-data:/data homolog keys create --init --tenant default --role submitter
#   docker run --rm -p 127.0.0.1:8080:8080 -v homolog-data:/data homolog
#
# In a container the service listens on 0.0.0.0, so that it can be reached from outside, and therefore requires an API
# key; the second line creates the database and a key, and prints the key once. To run it without keys on your own machine,
# append `serve --auth none --insecure` to the third line. deploy/ has complete setups: one machine, separate services,
# Kubernetes.

# Tags, which get security updates. No digest is given here: none has been checked against the registry yet, and a wrong
# digest is worse than a tag. For an image that can be built again to the byte, pass the same images with the digests
# that `docker buildx imagetools inspect rust:1.95-slim-bookworm` prints: --build-arg BUILD_IMAGE=rust@sha256:...
ARG BUILD_IMAGE=rust:1.95-slim-bookworm
ARG RUN_IMAGE=debian:bookworm-slim

FROM ${BUILD_IMAGE} AS build
WORKDIR /build
# The official image includes a C compiler, which the bundled SQLite needs.
COPY Cargo.toml Cargo.lock build.rs ./
COPY crates crates
COPY src src
COPY api api
COPY dashboard/dist dashboard/dist
# The build has no git checkout: the commit is passed in, or is "unknown".
ARG HOMOLOG_COMMIT=""
RUN cargo build --release --locked --bin homolog && mkdir /data

FROM ${RUN_IMAGE}
COPY --from=build /build/target/release/homolog /usr/local/bin/homolog
# Trusted certificate authorities, for PostgreSQL, the object store and webhooks over TLS. For a private authority, mount
# its certificates and name the file in SSL_CERT_FILE.
COPY --from=build /etc/ssl/certs/ca-certificates.crt /etc/ssl/certs/ca-certificates.crt
# A number instead of a name, so that Kubernetes can verify that it is not root.
COPY --from=build --chown=65532:65532 /data /data
USER 65532:65532
# Variables instead of arguments of serve, because keys, purge, migrate and worker need them too.
ENV HOMOLOG_DATA_DIR=/data HOMOLOG_LISTEN=0.0.0.0:8080
VOLUME /data
EXPOSE 8080
# For `serve`; a worker serves probes only with --probe-listen, see deploy/compose.scale-out.yaml.
HEALTHCHECK --interval=10s --timeout=4s --start-period=20s CMD ["homolog", "health"]
# The first signal starts the grace period, a second one ends it. `docker stop` kills the process after 10 s: allow more
# than HOMOLOG_SHUTDOWN_GRACE_MS (3 s by default) plus 5 s.
STOPSIGNAL SIGTERM
ENTRYPOINT ["homolog"]
CMD ["serve"]
