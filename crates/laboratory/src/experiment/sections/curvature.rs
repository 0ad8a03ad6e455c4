//! Curvature estimators against closed-form curvature of spheres, ellipsoids and tori.

use super::{About, Body, Experiment, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::draws::Draws;
use crate::experiment::results::{Metric, Results};
use crate::experiment::study::Study;
use crate::experiment::units::{Measurement, Unit};
use homolog_geometry::curvature::{Estimator, curvatures, default_radius_mm};
use homolog_mesh::shapes::{ellipsoid, torus};
use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::observe::Silent;
use nalgebra::{Point3, Vector3};
use serde_json::json;

pub(in crate::experiment) struct Curvature;

const CLEAN: &str = "clean";
const NOISY: &str = "noisy";
/// Standard deviation of the noise per axis, in mean edge lengths.
const NOISE_EDGES: f64 = 0.03;
/// Semi-axes of the ellipsoid, and radii of sphere and torus, mm.
const AXES: [f64; 3] = [12.0, 8.0, 6.0];
const SPHERE_MM: f64 = 10.0;
const TORUS_MM: (f64, f64) = (10.0, 4.0);

const ESTIMATORS: [&str; 3] = ["angle defect", "covariance", "quadric"];

/// A surface whose curvatures have a closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    Sphere,
    Ellipsoid,
    Torus,
}

impl Shape {
    const ALL: [Shape; 3] = [Shape::Sphere, Shape::Ellipsoid, Shape::Torus];

    fn name(self) -> &'static str {
        match self {
            Shape::Sphere => "sphere",
            Shape::Ellipsoid => "ellipsoid",
            Shape::Torus => "torus",
        }
    }

    /// The mesh at a refinement level; each level has about four times as many vertices as the previous one.
    fn mesh(self, level: u32) -> SurfaceMesh {
        match self {
            Shape::Sphere => ellipsoid(Vector3::repeat(SPHERE_MM), level),
            Shape::Ellipsoid => ellipsoid(Vector3::from(AXES), level),
            Shape::Torus => {
                let (around, across) = (10 << (level - 1), 5 << (level - 1));
                torus(TORUS_MM.0, TORUS_MM.1, around, across, FaceArity::Triangle)
            }
        }
    }

    /// Gaussian curvature, 1/mm², and mean curvature, 1/mm, at a point of the surface.
    fn exact(self, p: &Point3<f64>) -> (f64, f64) {
        let of_ellipsoid = |axes: Vector3<f64>| {
            let squares = axes.component_mul(&axes);
            let weight = p.coords.component_div(&squares).norm_squared();
            let product = squares.product();
            let mean = (squares.sum() - p.coords.norm_squared()) / (2.0 * product * weight.powf(1.5));
            (1.0 / (product * weight * weight), mean)
        };
        match self {
            Shape::Sphere => of_ellipsoid(Vector3::repeat(SPHERE_MM)),
            Shape::Ellipsoid => of_ellipsoid(Vector3::from(AXES)),
            Shape::Torus => {
                let (radius, tube) = TORUS_MM;
                let ring = p.x.hypot(p.y);
                let cosine = (ring - radius) / tube;
                (cosine / (tube * ring), (radius + 2.0 * tube * cosine) / (2.0 * tube * ring))
            }
        }
    }
}

fn name(shape: Shape, estimator: &str, level: u32) -> String {
    format!("{}, {estimator}, level {level}", shape.name())
}

/// Root mean square error of both curvatures, divided by the root mean square of the true curvature.
fn measure(shape: Shape, estimator: &str, level: u32, noise: Option<u64>) -> Result<Measurement, String> {
    let clean = shape.mesh(level);
    let edge_mm = clean.mean_edge_length();
    let mesh = match noise {
        None => clean.clone(),
        Some(seed) => {
            let moved = Draws::new(seed).jitter(clean.vertices(), NOISE_EDGES * edge_mm);
            clean.with_vertices(moved).map_err(|e| e.to_string())?
        }
    };
    let radius_mm = default_radius_mm(&clean);
    let found = curvatures(
        &mesh,
        match estimator {
            "covariance" => Estimator::Covariance { radius_mm },
            "quadric" => Estimator::Quadric { radius_mm },
            _ => Estimator::AngleDefect,
        },
        &Silent,
    )
    .map_err(|e| e.to_string())?;
    let exact: Vec<(f64, f64)> = clean.vertices().iter().map(|p| shape.exact(p)).collect();
    let relative = |found: &[f64], exact: &dyn Fn(usize) -> f64| {
        let squares: f64 = (0..found.len()).map(|i| (found[i] - exact(i)).powi(2)).sum();
        let size: f64 = (0..found.len()).map(|i| exact(i).powi(2)).sum();
        (squares / size).sqrt()
    };
    Ok(Measurement::default()
        .with("vertices", clean.n_vertices() as f64)
        .with("edge_mm", edge_mm)
        .with("gaussian_error", relative(&found.gaussian, &|i| exact[i].0))
        .with("mean_error", relative(&found.mean, &|i| exact[i].1)))
}

fn levels(study: &Study<'_>) -> std::ops::RangeInclusive<u32> {
    study.either(2..=4, 2..=5)
}

impl Experiment for Curvature {
    fn about(&self) -> About {
        About {
            id: "curvature",
            title: "Accuracy of the curvature estimators",
            question: "How accurate are the three curvature estimators, do they converge under refinement, and how sensitive are they to noise?",
            varied: "The estimator (angle defect; covariance of normals and quadric in a ball of 2.5 mean edges), the \
                     refinement level, and Gaussian noise with a standard deviation of 3 % of the mean edge length per axis. \
                     Surfaces with closed-form curvature: a sphere of radius 10 mm, an ellipsoid with semi-axes 12, 8 and \
                     6 mm, a torus with radii 10 and 4 mm.",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        for shape in Shape::ALL {
            for estimator in ESTIMATORS {
                for level in levels(study) {
                    let mut add = |group: &str, noise: Option<u64>| {
                        units.push(Unit {
                            group: group.to_owned(),
                            configuration: name(shape, estimator, level),
                            case: noise.map_or("without noise".to_owned(), |seed| format!("noise {seed}")),
                            inputs: json!([shape.name(), estimator, level, noise]),
                            work: Box::new(move || measure(shape, estimator, level, noise)),
                        });
                    };
                    add(CLEAN, None);
                    for seed in 1..=study.either(2, 5) {
                        add(NOISY, Some(seed));
                    }
                }
            }
        }
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let (clean, noisy) = (results.group(CLEAN), results.group(NOISY));
        let gaussian = Metric::percent("gaussian_error", "relative error of K");
        let metrics = [
            Metric::number("vertices", "vertices", "", 0),
            Metric::number("edge_mm", "mean edge length", "mm", 2),
            gaussian,
            Metric::percent("mean_error", "relative error of H"),
        ];
        let finest = *levels(study).end();
        let finding = || {
            let mut parts = Vec::new();
            for estimator in ESTIMATORS {
                let of = |shape| name(shape, estimator, finest);
                let percent = |group: &crate::experiment::results::Group<'_>, shape| {
                    Some(format!("{:.1}", 100.0 * group.mean(&of(shape), gaussian.key)?))
                };
                parts.push(format!(
                    "{estimator} {} % on the ellipsoid and {} % on the torus ({} % and {} % with noise)",
                    percent(&clean, Shape::Ellipsoid)?,
                    percent(&clean, Shape::Torus)?,
                    percent(&noisy, Shape::Ellipsoid)?,
                    percent(&noisy, Shape::Torus)?,
                ));
            }
            Some(format!("Relative error of Gaussian curvature at the finest refinement level: {}.", parts.join("; ")))
        };
        let plot = |group: &crate::experiment::results::Group<'_>, title: &str| Plot {
            title: title.to_owned(),
            kind: PlotKind::Lines,
            x: Axis::logarithmic("mean edge length", "mm"),
            y: Axis::logarithmic("relative error of K", "%"),
            categories: Vec::new(),
            series: ESTIMATORS
                .iter()
                .map(|estimator| {
                    let edge = |setting: &str| {
                        let level = levels(study).find(|&l| name(Shape::Ellipsoid, estimator, l) == setting)?;
                        group.mean(&name(Shape::Ellipsoid, estimator, level), "edge_mm")
                    };
                    group.series(estimator, &gaussian, edge)
                })
                .collect(),
        };
        Body {
            pairs: format!("{} surfaces, {} noise realizations each", Shape::ALL.len(), noisy.cases().len()),
            finding: sentences([finding()]),
            notes: vec!["Relative error: root mean square error over the vertices, divided by the root mean square of the true curvature.".to_owned()],
            tables: vec![
                clean.table("clean", "Without noise", "surface and estimator", &metrics),
                noisy.table("noisy", "With noise of 3 % of the mean edge length", "surface and estimator", &metrics),
            ],
            plots: vec![plot(&clean, "Ellipsoid without noise: error versus edge length"), plot(&noisy, "Ellipsoid with noise: error versus edge length")],
        }
    }
}
