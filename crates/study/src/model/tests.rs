//! The model compared with slow, obvious ones: a thin SVD of all coordinates, and models made anew without each
//! subject.

use super::*;
use crate::align::{align, rms};
use crate::settings::Size;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use homolog_primitives::observe::Silent;
use homolog_registration::SimilarityTransform;
use nalgebra::Matrix3;

/// Ellipsoids that differ in two ways and a little noise.
fn group(n: usize) -> (SurfaceMesh, Vec<Vec<[f32; 3]>>) {
    let mesh = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 3);
    let mut random = Xoshiro256PlusPlus::seed_from_u64(5);
    let mut draw = move || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
    let shapes = (0..n).map(|_| {
        let (long, bend) = (draw(), draw());
        let shape = mesh.vertices().iter().map(|p| {
            let moved = Point3::new(p.x * (1.0 + 0.3 * long), p.y + 0.05 * bend * p.x * p.x, p.z);
            (moved.coords + Vector3::new(draw(), draw(), draw()) * 0.1).map(|x| x as f32).into()
        });
        shape.collect()
    });
    let shapes = shapes.collect();
    (mesh, shapes)
}

fn rows(shapes: &[Vec<[f32; 3]>], alignment: &Alignment) -> Mat<f64> {
    let v = alignment.mean.len();
    Mat::from_fn(shapes.len(), 3 * v, |i, k| {
        let p = alignment.onto_mean[i].apply(&points(&shapes[i])[k / 3]);
        (p - alignment.mean[k / 3])[k % 3] * alignment.weights[k / 3].sqrt()
    })
}

#[test]
fn components_are_those_of_a_thin_svd_of_all_coordinates() {
    let (mesh, shapes) = group(12);
    let alignment = align(&shapes, &mesh, Size::Kept).unwrap();
    let model = ShapeModel::new(&shapes, &alignment, 1, &Silent).unwrap();
    let svd = rows(&shapes, &alignment).thin_svd().unwrap();
    let singular = svd.S().column_vector();
    for k in 0..11 {
        let variance = singular[k] * singular[k] / 11.0;
        assert!((model.variances[k] - variance).abs() < 1e-9 * model.variances[0], "component {k}");
    }
    for (k, mode) in model.modes.iter().enumerate() {
        let other: f64 =
            (0..3 * mode.len()).map(|c| mode[c / 3][c % 3] * alignment.weights[c / 3].sqrt() * svd.V()[(c, k)]).sum();
        assert!((other.abs() - 1.0).abs() < 1e-6, "mode {k}: {other}");
    }
    // Two ways to differ explain nearly everything.
    assert!(model.quality.compactness[1] > 0.9, "{:?}", model.quality.compactness);
    // A subject is the mean and its modes.
    let kept = model.modes.len();
    let rebuilt: Vec<_> = (0..alignment.mean.len())
        .map(|v| (0..kept).fold(alignment.mean[v], |p, k| p + model.scores[3][k] * model.modes[k][v]))
        .collect();
    let own: Vec<_> = points(&shapes[3]).iter().map(|p| alignment.onto_mean[3].apply(p)).collect();
    let rest: f64 = model.scores[3][kept..].iter().map(|score| score * score).sum();
    assert!((rms(&rebuilt, &own, &alignment.weights) - rest.sqrt()).abs() < 1e-6);
    let (scores, _) = model.score(&alignment, &own);
    assert!(scores.iter().zip(&model.scores[3]).all(|(a, b)| (a - b).abs() < 1e-6));
}

#[test]
fn leaving_out_is_a_model_of_the_others() {
    let (mesh, shapes) = group(9);
    let alignment = align(&shapes, &mesh, Size::Kept).unwrap();
    let model = ShapeModel::new(&shapes, &alignment, 1, &Silent).unwrap();
    let data = rows(&shapes, &alignment);
    let mut errors = vec![0.0; model.modes.len()];
    for left in 0..9 {
        let others: Vec<usize> = (0..9).filter(|&i| i != left).collect();
        let mean: Vec<f64> =
            (0..data.ncols()).map(|c| others.iter().map(|&i| data[(i, c)]).sum::<f64>() / 8.0).collect();
        let centered = Mat::from_fn(8, data.ncols(), |i, c| data[(others[i], c)] - mean[c]);
        let svd = centered.thin_svd().unwrap();
        let mut rest: Vec<f64> = (0..data.ncols()).map(|c| data[(left, c)] - mean[c]).collect();
        let mut distance = 0.0;
        for k in 0..7 {
            let score: f64 = (0..rest.len()).map(|c| rest[c] * svd.V()[(c, k)]).sum();
            let singular = svd.S().column_vector()[k];
            if k < model.distance_modes {
                distance += score * score / (singular * singular / 7.0);
            }
            rest.iter_mut().enumerate().for_each(|(c, x)| *x -= score * svd.V()[(c, k)]);
            if k < errors.len() {
                errors[k] += rest.iter().map(|x| x * x).sum::<f64>().sqrt() / 9.0;
            }
            if k + 1 == model.distance_modes {
                let mean = (k + 1..7).map(|j| svd.S().column_vector()[j].powi(2) / 7.0).sum::<f64>() / (6 - k) as f64;
                distance += rest.iter().map(|x| x * x).sum::<f64>() / mean;
            }
        }
        assert!((model.left_out[left] / distance - 1.0).abs() < 1e-6, "{} {distance}", model.left_out[left]);
    }
    for (ours, slow) in model.quality.generalization_mm.iter().zip(&errors) {
        assert!((ours - slow).abs() < 1e-7, "{ours} {slow}");
    }
}

#[test]
fn an_unusual_shape_is_noticed_and_specificity_is_a_distance_of_shapes() {
    let (mesh, shapes) = group(40);
    let alignment = align(&shapes, &mesh, Size::Kept).unwrap();
    let bulge: Vec<_> =
        alignment.mean.iter().map(|p| if p.x > 6.0 { p + Vector3::new(0.0, 0.0, 1.5) } else { *p }).collect();
    let mut all = shapes.clone();
    all.extend(
        [&bulge, &alignment.mean].map(|shape| shape.iter().map(|p| p.coords.map(|x| x as f32).into()).collect()),
    );
    let mut frame = alignment.clone();
    let here = SimilarityTransform { rotation: Matrix3::identity(), translation: Vector3::zeros(), scale: 1.0 };
    frame.onto_mean.extend([here, here]);
    let model = ShapeModel::with_others(&all, &frame, 40, 1, &Silent).unwrap();
    assert!((model.others_p[0] - 1.0 / 41.0).abs() < 1e-12, "{:?}", model.others_p);
    assert!(model.others_p[1] > 0.99);
    // The model is that of the first 40 alone.
    let alone = ShapeModel::new(&shapes, &alignment, 1, &Silent).unwrap();
    assert_eq!(ShapeModel { others_p: Vec::new(), ..model.clone() }, alone);
    // With one mode: the mean moved along it, compared with all subjects.
    let nearest = |length: f64| {
        let shape: Vec<_> = alignment.mean.iter().zip(&model.modes[0]).map(|(p, mode)| p + length * mode).collect();
        (0..40)
            .map(|i| {
                let own: Vec<_> = points(&shapes[i]).iter().map(|p| alignment.onto_mean[i].apply(p)).collect();
                rms(&shape, &own, &alignment.weights)
            })
            .fold(f64::INFINITY, f64::min)
    };
    // The mean over a normal distribution of the length, by equal steps.
    let deviation = model.variances[0].sqrt();
    let (mut sum, mut weights) = (0.0, 0.0);
    for k in -40..=40 {
        let z = 0.1 * f64::from(k);
        let weight = (-z * z / 2.0).exp();
        sum += weight * nearest(z * deviation);
        weights += weight;
    }
    let expected = sum / weights;
    assert!(
        (model.quality.specificity_mm[0] / expected - 1.0).abs() < 0.05,
        "{} {expected}",
        model.quality.specificity_mm[0]
    );
}

#[test]
fn blocks_and_threads_do_not_matter() {
    let (mesh, shapes) = group(10);
    assert!(mesh.n_vertices() > BLOCK, "several blocks");
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let alignment = align(&shapes, &mesh, Size::Removed).unwrap();
            ShapeModel::new(&shapes, &alignment, 3, &Silent).unwrap()
        })
    };
    assert_eq!(with(1), with(4));
}

/// The model of a group by [`many`] from some directions.
fn of_many(shapes: &Vec<Vec<[f32; 3]>>, alignment: &Alignment, n: usize, components: usize) -> ShapeModel {
    let n_folds = if components + 1 == n { n } else { many::FOLDS };
    many::model(&Group { shapes, alignment, observer: &Silent }, n, components, n_folds, 1).unwrap()
}

#[test]
fn the_first_components_of_a_large_group_are_all_of_them_where_there_are_no_more() {
    for n in [9, 40] {
        let (mesh, mut shapes) = group(n + 2);
        let all = align(&shapes, &mesh, Size::Kept).unwrap();
        shapes.truncate(n);
        let alignment = Alignment { onto_mean: all.onto_mean[..n].to_vec(), ..all };
        let (whole, many) =
            (ShapeModel::new(&shapes, &alignment, 1, &Silent).unwrap(), of_many(&shapes, &alignment, n, n - 1));
        let near = |a: f64, b: f64, scale: f64| (a - b).abs() <= 1e-6 * scale;
        assert_eq!(many.distance_modes, whole.distance_modes);
        for k in 0..n - 1 {
            assert!(near(many.variances[k], whole.variances[k], whole.variances[0]), "component {k} of {n}");
        }
        for (k, (a, b)) in many.modes.iter().zip(&whole.modes).enumerate().take(2) {
            let along: f64 = (0..a.len()).map(|v| alignment.weights[v] * a[v].dot(&b[v])).sum();
            assert!(near(along, 1.0, 1.0), "mode {k} of {n}: {along}");
        }
        for (a, b) in many.left_out.iter().zip(&whole.left_out) {
            assert!((a / b - 1.0).abs() < 1e-4, "{a} {b}");
        }
        let (a, b) = (&many.quality, &whole.quality);
        for (a, b) in [(&a.compactness, &b.compactness), (&a.generalization_mm, &b.generalization_mm)] {
            assert!(a.iter().zip(b).all(|(a, b)| near(*a, *b, 1.0)), "{a:?} {b:?}");
        }
    }
}

#[test]
fn few_components_of_a_large_group_say_what_all_say() {
    const FEW: usize = 80;
    let (mesh, shapes) = group(150);
    let alignment = align(&shapes, &mesh, Size::Kept).unwrap();
    let n = 140;
    let members = Alignment { onto_mean: alignment.onto_mean[..n].to_vec(), ..alignment.clone() };
    let first: Vec<_> = shapes[..n].to_vec();
    let whole = ShapeModel::with_others(&shapes, &alignment, n, 1, &Silent).unwrap();
    let many = of_many(&shapes, &alignment, n, FEW);
    assert_eq!(many.distance_modes, whole.distance_modes);
    for k in 0..2 {
        assert!((many.variances[k] / whole.variances[k] - 1.0).abs() < 1e-6, "component {k}");
        // Modes of fewer directions have less of the noise of 140 shapes in them.
        let (a, b) = (many.quality.generalization_mm[k], whole.quality.generalization_mm[k]);
        assert!((a / b - 1.0).abs() < 0.03, "generalization with {} modes: {a} {b}", k + 1);
        let (a, b) = (many.quality.specificity_mm[k], whole.quality.specificity_mm[k]);
        assert!((a / b - 1.0).abs() < 0.01, "specificity with {} modes: {a} {b}", k + 1);
        assert!((many.quality.compactness[k] - whole.quality.compactness[k]).abs() < 1e-6);
    }
    assert!((many.variances.iter().sum::<f64>() / whole.variances.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    assert_eq!(many.variances.len(), whole.variances.len());
    // The same subjects are unusual, and others as unusual, by either.
    let order = |of: &[f64]| {
        let mut ranks: Vec<usize> = (0..of.len()).collect();
        ranks.sort_by(|&a, &b| of[b].total_cmp(&of[a]));
        ranks[..14].to_vec()
    };
    let (few, all) = (order(&many.left_out), order(&whole.left_out));
    assert!(few.iter().filter(|i| all.contains(i)).count() >= 10, "{few:?} {all:?}");
    for (a, b) in many.others_p.iter().zip(&whole.others_p) {
        assert!((a - b).abs() < 0.15, "{a} {b}");
    }
    // The others change nothing.
    assert_eq!(ShapeModel { others_p: Vec::new(), ..many.clone() }, of_many(&first, &members, n, FEW));
    let on_threads = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| of_many(&shapes, &alignment, n, FEW))
    };
    assert_eq!(on_threads(1), many);
    assert_eq!(on_threads(3), many);
}
