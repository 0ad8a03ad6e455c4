//! glTF 2.0 binary (`.glb`): surfaces with colors, for browsers, Blender, PowerPoint and other programs. Hand-written:
//! existing crates only read files or only describe their JSON.
//!
//! Source: Khronos Group, glTF 2.0 specification. Its unit is the meter and its `y` axis points up; a node rotates and
//! scales millimeters with `z` up (superior). Positions are stored in single precision, without an offset.

use homolog_mesh::SurfaceMesh;
use std::fmt::Write;

/// A surface of a scene.
#[derive(Debug, Clone, Copy)]
pub struct ColoredSurface<'a> {
    /// Name of its node: ASCII letters, digits and `_`.
    pub name: &'static str,
    /// The surface, mm; quads are split.
    pub mesh: &'a SurfaceMesh,
    /// Red, green and blue (sRGB) of each vertex, one after the other; empty for white.
    pub colors: &'a [u8],
}

const MAGIC: u32 = 0x4654_6c67;
const JSON_CHUNK: u32 = 0x4e4f_534a;
const BINARY_CHUNK: u32 = 0x004e_4942;
/// Component types and buffer targets of the specification.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const UNSIGNED_BYTE: u32 = 5121;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// The surfaces as one scene.
pub fn write_glb(surfaces: &[ColoredSurface<'_>]) -> Vec<u8> {
    let mut scene = Scene::default();
    for surface in surfaces {
        scene.add(surface);
    }
    scene.file()
}

#[derive(Default)]
struct Scene {
    binary: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
    meshes: Vec<String>,
    nodes: Vec<String>,
}

impl Scene {
    fn add(&mut self, surface: &ColoredSurface<'_>) {
        let n = surface.mesh.n_vertices();
        let positions: Vec<[f32; 3]> =
            surface.mesh.vertices().iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect();
        let normals = surface.mesh.vertex_normals();
        let triangles = surface.mesh.triangles();
        let bounds = |pick: fn(f32, f32) -> f32, start: f32| {
            let ends = positions.iter().fold([start; 3], |ends, p| std::array::from_fn(|k| pick(ends[k], p[k])));
            format!("[{},{},{}]", ends[0], ends[1], ends[2])
        };
        let limits =
            format!(",\"min\":{},\"max\":{}", bounds(f32::min, f32::INFINITY), bounds(f32::max, f32::NEG_INFINITY));
        let bytes = |numbers: &[[f32; 3]]| numbers.iter().flatten().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
        // Vertices without area have no normal; glTF requires unit vectors.
        let unit = |v: &nalgebra::Vector3<f64>| {
            if v.norm() > 0.5 { [v.x as f32, v.y as f32, v.z as f32] } else { [0.0, 0.0, 1.0] }
        };
        let normals: Vec<[f32; 3]> = normals.iter().map(unit).collect();
        let position = self.accessor(bytes(&positions), n, (FLOAT, "VEC3"), VERTICES, &limits);
        let normal = self.accessor(bytes(&normals), n, (FLOAT, "VEC3"), VERTICES, "");
        let mut attributes = format!("\"POSITION\":{position},\"NORMAL\":{normal}");
        if surface.colors.len() == 3 * n {
            let rgba = surface.colors.chunks_exact(3).flat_map(|c| [linear(c[0]), linear(c[1]), linear(c[2]), 255]);
            let color = self.accessor(rgba.collect(), n, (UNSIGNED_BYTE, "VEC4"), VERTICES, ",\"normalized\":true");
            let _ = write!(attributes, ",\"COLOR_0\":{color}");
        }
        let corners = triangles.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
        let indices = self.accessor(corners, 3 * triangles.len(), (UNSIGNED_INT, "SCALAR"), INDICES, "");
        let name = surface.name;
        self.nodes.push(format!("{{\"name\":\"{name}\",\"mesh\":{}}}", self.meshes.len()));
        self.meshes.push(format!(
            "{{\"name\":\"{name}\",\"primitives\":[{{\"attributes\":{{{attributes}}},\"indices\":{indices},\"material\":0}}]}}"
        ));
    }

    /// Adds data with its description; returns its number. Every piece is a multiple of four bytes long.
    fn accessor(
        &mut self,
        data: Vec<u8>,
        count: usize,
        (component, kind): (u32, &str),
        target: u32,
        more: &str,
    ) -> usize {
        let (offset, length) = (self.binary.len(), data.len());
        self.binary.extend(data);
        self.views
            .push(format!("{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{length},\"target\":{target}}}"));
        self.accessors.push(format!(
            "{{\"bufferView\":{},\"componentType\":{component},\"count\":{count},\"type\":\"{kind}\"{more}}}",
            self.views.len() - 1
        ));
        self.accessors.len() - 1
    }

    fn file(self) -> Vec<u8> {
        let Scene { binary, views, accessors, meshes, nodes } = self;
        let children: Vec<String> = (1..=nodes.len()).map(|k| k.to_string()).collect();
        // A quarter turn about x maps z up to y up.
        let mut json = format!(
            "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"homolog\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\
             \"nodes\":[{{\"name\":\"millimeters_RAS\",\"rotation\":[-0.7071067811865476,0,0,0.7071067811865476],\
             \"scale\":[0.001,0.001,0.001],\"children\":[{}]}},{}],\"meshes\":[{}],\
             \"materials\":[{{\"doubleSided\":true,\"pbrMetallicRoughness\":{{\"metallicFactor\":0,\"roughnessFactor\":0.9}}}}],\
             \"accessors\":[{}],\"bufferViews\":[{}],\"buffers\":[{{\"byteLength\":{}}}]}}",
            children.join(","),
            nodes.join(","),
            meshes.join(","),
            accessors.join(","),
            views.join(","),
            binary.len()
        );
        while json.len() % 4 != 0 {
            json.push(' ');
        }
        let total = 12 + 8 + json.len() + 8 + binary.len();
        let mut file = Vec::with_capacity(total);
        for word in [MAGIC, 2, total as u32, json.len() as u32, JSON_CHUNK] {
            file.extend(word.to_le_bytes());
        }
        file.extend(json.into_bytes());
        file.extend((binary.len() as u32).to_le_bytes());
        file.extend(BINARY_CHUNK.to_le_bytes());
        file.extend(binary);
        file
    }
}

/// A component of sRGB as a linear one, the color space of vertices in glTF.
fn linear(component: u8) -> u8 {
    let share = f64::from(component) / 255.0;
    let linear = if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) };
    (255.0 * linear).round() as u8
}
