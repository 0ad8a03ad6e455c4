//! What other modules will provide, under the names that the commands use; each becomes a `use` when it exists.

use super::error::CliError;
use crate::intake::{InputReport, IntakeError, IntakeLimits, prepare_surface};
use crate::matching::parameters::InputParameters;
use crate::mesh::SurfaceMesh;
use crate::phantom::PhantomVolume;
use std::io::Write;

/// Becomes `crate::intake::inspect`.
pub(super) fn inspect(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<InputReport, IntakeError> {
    prepare_surface(bytes, file_name, parameters, limits).map(|prepared| prepared.report)
}

/// Becomes `crate::formats::ply::write_ply`: binary, little-endian, double coordinates.
pub(super) fn write_ply(mesh: &SurfaceMesh) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\ncomment millimeters\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.n_vertices(),
        mesh.n_faces()
    )
    .into_bytes();
    for p in mesh.vertices() {
        for c in p.iter() {
            bytes.extend(c.to_le_bytes());
        }
    }
    for face in mesh.faces() {
        bytes.push(face.len() as u8);
        for &v in face {
            bytes.extend(v.to_le_bytes());
        }
    }
    bytes
}

/// Becomes `crate::formats::nifti::write_nifti`: NIfTI-1, unsigned bytes, gzip, the affine as sform.
pub(super) fn write_nifti(volume: &PhantomVolume) -> Result<Vec<u8>, CliError> {
    let mut header = vec![0u8; 352];
    let mut put = |at: usize, bytes: &[u8]| header[at..at + bytes.len()].copy_from_slice(bytes);
    put(0, &348i32.to_le_bytes());
    for (k, n) in [3, volume.shape[0], volume.shape[1], volume.shape[2], 1, 1, 1, 1].into_iter().enumerate() {
        put(40 + 2 * k, &(n as i16).to_le_bytes());
    }
    put(70, &2i16.to_le_bytes());
    put(72, &8i16.to_le_bytes());
    for k in 0..4 {
        put(76 + 4 * k, &(if k == 0 { 1.0 } else { volume.spacing_mm as f32 }).to_le_bytes());
    }
    put(108, &352f32.to_le_bytes());
    put(112, &1f32.to_le_bytes());
    put(123, &[2]);
    put(254, &1i16.to_le_bytes());
    for row in 0..3 {
        let mut values = [0f32; 4];
        values[row] = volume.spacing_mm as f32;
        values[3] = volume.origin_mm[row] as f32;
        for (k, value) in values.iter().enumerate() {
            put(280 + 16 * row + 4 * k, &value.to_le_bytes());
        }
    }
    put(344, b"n+1\0");
    let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    gzip.write_all(&header)
        .and_then(|()| gzip.write_all(&volume.labels))
        .and_then(|()| gzip.finish())
        .map_err(|e| CliError::Failed(format!("the volume cannot be compressed: {e}")))
}

/// Becomes `super::serve`, a file of its own.
pub(super) mod serve {
    use std::process::ExitCode;

    /// Arguments of `homolog serve`.
    #[derive(Debug, Clone, clap::Args)]
    pub struct ServeArgs {
        /// Address to listen on
        #[arg(long, default_value = "127.0.0.1:8080")]
        pub listen: std::net::SocketAddr,
        /// Folder of the database and the files
        #[arg(long, value_name = "DIR")]
        pub data_dir: Option<std::path::PathBuf>,
    }

    /// Arguments of `homolog worker`.
    #[derive(Debug, Clone, clap::Args)]
    pub struct WorkerArgs {}

    pub fn serve(_args: ServeArgs) -> ExitCode {
        missing()
    }

    pub fn worker(_args: WorkerArgs) -> ExitCode {
        missing()
    }

    pub fn print_openapi() -> ExitCode {
        missing()
    }

    pub fn print_problems() -> ExitCode {
        missing()
    }

    fn missing() -> ExitCode {
        crate::cli::output::note("homolog: this build has no service");
        ExitCode::FAILURE
    }
}
