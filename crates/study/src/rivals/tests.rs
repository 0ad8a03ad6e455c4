//! Made-up groups: ellipsoids that vary smoothly along their normals, with a bump that they have in common and that alone says
//! which of four poses is right. A wrong pose is the right map after a symmetry of the template.

use super::*;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::shapes::ellipsoid;
use nalgebra::{Point3, Rotation3, Vector3};
use proptest::prelude::*;
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use std::sync::LazyLock;

const AXES: [f64; 3] = [12.0, 7.0, 5.0];
/// Width of the bump and of the parts of the variation, mm.
const WIDTH_MM: f64 = 3.0;
/// Standard deviation of the parts of the variation between subjects, and of what a match adds, mm.
const VARIES_MM: f64 = 0.3;
const MATCH_MM: f64 = 0.05;

static TEMPLATE: LazyLock<SurfaceMesh> = LazyLock::new(|| ellipsoid(Vector3::from(AXES), 3));

/// The symmetries of the template: for each half turn, the vertex to which each goes; the identity first.
static SYMMETRIES: LazyLock<Vec<Vec<usize>>> = LazyLock::new(|| {
    let vertices = TEMPLATE.vertices();
    let image = |signs: [f64; 3]| -> Vec<usize> {
        let nearest = |p: &Point3<f64>| {
            let q = Point3::new(signs[0] * p.x, signs[1] * p.y, signs[2] * p.z);
            let apart = |k: &usize| (vertices[*k] - q).norm_squared();
            (0..vertices.len()).min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap()
        };
        vertices.iter().map(nearest).collect()
    };
    [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]].map(image).to_vec()
});

/// Smooth fields over the template, about one for each independent direction.
static PARTS: LazyLock<Vec<Vec<f64>>> =
    LazyLock::new(|| ellipsoid(Vector3::from(AXES), 1).vertices().iter().map(heights).collect());

fn heights(center: &Point3<f64>) -> Vec<f64> {
    TEMPLATE.vertices().iter().map(|p| (-(p - center).norm_squared() / (2.0 * WIDTH_MM * WIDTH_MM)).exp()).collect()
}

struct Random(Xoshiro256PlusPlus);

impl Random {
    fn uniform(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }
    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
    fn field(&mut self, size_mm: f64) -> Vec<f64> {
        let mut field = vec![0.0; TEMPLATE.n_vertices()];
        for part in &*PARTS {
            let weight = size_mm * self.normal();
            field.iter_mut().zip(part).for_each(|(sum, value)| *sum += weight * value);
        }
        field
    }
}

/// The template's vertices on a subject, mm.
type Map = Vec<[f32; 3]>;

/// A group: maps of reliable subjects, and those of the candidates of ambiguous ones, with the place of the right one.
#[derive(Clone)]
struct Group {
    reliable: Vec<Map>,
    ambiguous: Vec<(Vec<Map>, Option<usize>)>,
}

#[derive(Debug, Clone, Copy)]
struct Made {
    reliable: usize,
    ambiguous: usize,
    candidates: usize,
    bump_mm: f64,
    match_mm: f64,
    /// Whether the right pose is among the candidates.
    has_right: bool,
    /// Whether every subject has the symmetries of the template, besides the bump.
    is_symmetric: bool,
    seed: u64,
}

impl Default for Made {
    fn default() -> Self {
        let (bump_mm, match_mm) = (4.0, MATCH_MM);
        Made {
            reliable: 10,
            ambiguous: 5,
            candidates: 2,
            bump_mm,
            match_mm,
            has_right: true,
            is_symmetric: false,
            seed: 0,
        }
    }
}

/// The mean of a field over the symmetries.
fn symmetrized(field: &[f64]) -> Vec<f64> {
    let n = SYMMETRIES.len() as f64;
    (0..field.len()).map(|v| SYMMETRIES.iter().map(|to| field[to[v]]).sum::<f64>() / n).collect()
}

impl Made {
    fn group(&self) -> Group {
        let mut random = Random(Xoshiro256PlusPlus::seed_from_u64(self.seed));
        let normals = TEMPLATE.vertex_normals();
        let bump = heights(&Point3::new(7.0, 4.0, 3.0));
        let anatomy = |random: &mut Random| {
            let field = random.field(VARIES_MM);
            if self.is_symmetric { symmetrized(&field) } else { field }
        };
        // A map of a subject of this anatomy, by a match with errors of its own, in any place.
        let mapped = |random: &mut Random, anatomy: &[f64], symmetry: &[usize]| {
            let errors = random.field(self.match_mm);
            let turn = Rotation3::from_euler_angles(random.normal(), random.normal(), random.normal());
            let shift = 9.0 * Vector3::new(random.normal(), random.normal(), random.normal());
            let at = |v: usize| {
                let to = symmetry[v];
                let p = TEMPLATE.vertices()[to] + (self.bump_mm * bump[to] + anatomy[to] + errors[v]) * normals[to];
                <[f64; 3]>::from((turn * p + shift).coords).map(|x| x as f32)
            };
            (0..TEMPLATE.n_vertices()).map(at).collect::<Vec<_>>()
        };
        let reliable = (0..self.reliable)
            .map(|_| {
                let anatomy = anatomy(&mut random);
                mapped(&mut random, &anatomy, &SYMMETRIES[0])
            })
            .collect();
        let ambiguous = (0..self.ambiguous)
            .map(|_| {
                let anatomy = anatomy(&mut random);
                let mut order: Vec<usize> = (usize::from(!self.has_right)..SYMMETRIES.len()).collect();
                order.truncate(self.candidates);
                for k in (1..order.len()).rev() {
                    order.swap(k, (random.uniform() * (k + 1) as f64) as usize);
                }
                let shapes = order.iter().map(|&of| mapped(&mut random, &anatomy, &SYMMETRIES[of])).collect();
                (shapes, order.iter().position(|&of| of == 0))
            })
            .collect();
        Group { reliable, ambiguous }
    }
}

static NO_RIVALS: SubjectRivals = SubjectRivals { subject: 0, rotations: Vec::new(), keys: Vec::new() };

impl Group {
    fn observed(&self) -> Option<Observed> {
        Observed::new(&TEMPLATE, &self.reliable, &GroupSettings::default())
    }

    fn shapes(&self, observed: &Observed) -> Vec<Vec<Shape>> {
        let shapes = |(maps, _): &(Vec<Map>, _)| maps.iter().map(|map| observed.frame.shape(map).unwrap()).collect();
        self.ambiguous.iter().map(shapes).collect()
    }

    fn decisions(&self) -> Vec<(GroupDecision, Option<usize>)> {
        let Some(observed) = self.observed() else { return Vec::new() };
        let variable = |shapes: Vec<Shape>| Variable {
            rows: Vec::new(),
            rivals: &NO_RIVALS,
            candidates: shapes.into_iter().enumerate().collect(),
        };
        let variables: Vec<Variable<'_>> = self.shapes(&observed).into_iter().map(variable).collect();
        let silent = &homolog_primitives::observe::Silent;
        let found = decisions_of(&variables, &observed, &GroupSettings::default(), silent).unwrap();
        found.into_iter().zip(self.ambiguous.iter().map(|(_, right)| *right)).collect()
    }

    fn energy(&self) -> GroupEnergy {
        let observed = self.observed().unwrap();
        let shapes = self.shapes(&observed);
        let shapes: Vec<Vec<&Shape>> = shapes.iter().map(|of| of.iter().collect()).collect();
        energy(&shapes, &observed, &homolog_primitives::observe::Silent).unwrap().0
    }
}

/// The marginals by enumeration of all labelings: the slow oracle.
fn enumerated(energy: &GroupEnergy) -> Vec<Vec<f64>> {
    let sizes: Vec<usize> = energy.unary.iter().map(Vec::len).collect();
    let of = |labels: &[usize]| {
        let unary: f64 = energy.unary.iter().zip(labels).map(|(row, &x)| row[x]).sum();
        let pair = |([i, j], table): &([usize; 2], Vec<f64>)| table[labels[*i] * sizes[*j] + labels[*j]];
        unary + energy.pairwise.iter().map(pair).sum::<f64>()
    };
    let labelings: Vec<Vec<usize>> = (0..sizes.iter().product())
        .map(|mut code: usize| {
            sizes
                .iter()
                .map(|size| {
                    let label = code % size;
                    code /= size;
                    label
                })
                .collect()
        })
        .collect();
    let energies: Vec<f64> = labelings.iter().map(|labels| of(labels)).collect();
    let least = energies.iter().copied().fold(f64::INFINITY, f64::min);
    let mut marginals: Vec<Vec<f64>> = sizes.iter().map(|&size| vec![0.0; size]).collect();
    for (labels, energy) in labelings.iter().zip(energies) {
        labels.iter().zip(&mut marginals).for_each(|(&x, of)| of[x] += (least - energy).exp());
    }
    for of in &mut marginals {
        let sum: f64 = of.iter().sum();
        of.iter_mut().for_each(|p| *p /= sum);
    }
    marginals
}

fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn made() -> impl Strategy<Value = Made> {
    let counts = (3..14usize, 1..6usize, 2..5usize);
    (counts, prop::sample::select(vec![0.0, 0.5, 1.0, 2.0, 4.0]), 0.0..0.2f64, any::<u64>()).prop_map(
        |((reliable, ambiguous, candidates), bump_mm, match_mm, seed)| Made {
            reliable,
            ambiguous,
            candidates,
            bump_mm,
            match_mm,
            seed,
            ..Made::default()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn belief_propagation_finds_the_marginals_of_all_labelings(made in made()) {
        let energy = made.group().energy();
        let (found, exact) = (energy.marginals(&GroupSettings::default()), enumerated(&energy));
        prop_assert_eq!(found.iter().map(Vec::len).collect::<Vec<_>>(), vec![made.candidates; made.ambiguous]);
        // Exact without loops.
        let tolerance = if made.ambiguous < 3 { 1e-4 } else { 0.03 };
        let apart = apart(&found, &exact);
        prop_assert!(apart < tolerance, "{apart}: {found:?} {exact:?}");
    }

    #[test]
    fn variables_with_unequal_numbers_of_candidates_have_their_marginals(
        sizes in prop::collection::vec(1..5usize, 1..3), potentials in prop::collection::vec(0.0..25.0f64, 28),
    ) {
        // One or two variables, so that propagation is exact.
        let mut numbers = potentials.into_iter();
        let mut take = |n: usize| numbers.by_ref().take(n).collect::<Vec<f64>>();
        let unary: Vec<Vec<f64>> = sizes.iter().map(|&n| take(n)).collect();
        let pairwise = match sizes[..] { [a, b] => vec![([0, 1], take(a * b))], _ => Vec::new() };
        let energy = GroupEnergy { unary, pairwise };
        let (found, exact) = (energy.marginals(&GroupSettings::default()), enumerated(&energy));
        prop_assert!(apart(&found, &exact) < 1e-3, "{found:?} {exact:?}");
    }

    #[test]
    fn a_clear_asymmetry_is_followed_and_never_against_the_truth(made in made()) {
        for (decision, right) in (Made { bump_mm: 4.0, ..made }).group().decisions() {
            prop_assert!(!decision.decided || right == Some(decision.candidate), "{decision:?} {right:?}");
        }
    }

    #[test]
    fn where_all_poses_are_right_nothing_is_decided(made in made()) {
        let made = Made { bump_mm: 0.0, is_symmetric: true, match_mm: 0.0, ..made };
        for (decision, _) in made.group().decisions() {
            let even = 1.0 / decision.candidates as f64;
            prop_assert!(!decision.decided && (decision.marginal - even).abs() < 0.02, "{decision:?}");
        }
    }

    #[test]
    fn the_order_of_subjects_and_of_candidates_permutes_the_answer(made in made()) {
        let group = made.group();
        let mut turned = group.clone();
        turned.ambiguous.reverse();
        turned.reliable.reverse();
        turned.ambiguous.iter_mut().for_each(|(shapes, _)| shapes.reverse());
        let mut found = turned.energy().marginals(&GroupSettings::default());
        found.iter_mut().for_each(|of| of.reverse());
        found.reverse();
        let expected = group.energy().marginals(&GroupSettings::default());
        prop_assert!(apart(&found, &expected) < 1e-3, "{found:?} {expected:?}");
    }

    #[test]
    fn too_few_reliable_subjects_or_copies_of_one_decide_nothing(made in made(), few in 0..3usize) {
        let fewer = Made { reliable: few, ..made }.group().decisions();
        prop_assert!(fewer.is_empty());
        let mut group = made.group();
        let first = group.reliable[0].clone();
        group.reliable.iter_mut().for_each(|shape| shape.clone_from(&first));
        prop_assert!(group.decisions().is_empty());
    }
}

/// How many decisions over a hundred groups were right, wrong, and left open.
fn counted(made: Made) -> [usize; 3] {
    let mut counts = [0; 3];
    for (decision, right) in (0..100).flat_map(|seed| Made { seed, ..made }.group().decisions()) {
        let at = if !decision.decided { 2 } else { usize::from(right != Some(decision.candidate)) };
        counts[at] += 1;
    }
    counts
}

#[test]
fn groups_decide_what_they_determine_and_little_else() {
    let of = |reliable: usize, bump_mm: f64, has_right: bool| Made { reliable, bump_mm, has_right, ..Made::default() };
    for (made, least_right, most_wrong) in [
        (of(5, 4.0, true), 350, 0),
        (of(10, 4.0, true), 400, 0),
        (of(20, 4.0, true), 450, 0),
        (of(20, 2.0, true), 100, 2),
        (Made { candidates: 4, ..of(20, 4.0, true) }, 450, 0),
        // No candidate is right.
        (of(10, 4.0, false), 0, 0),
        (of(20, 2.0, false), 0, 15),
        // No pose is better than another.
        (of(10, 0.0, true), 0, 5),
        (Made { match_mm: 0.2, ..of(20, 0.0, true) }, 0, 15),
    ] {
        let [right, wrong, open] = counted(made);
        println!("{made:?}: {right} right, {wrong} wrong, {open} open");
        let wrong = if made.bump_mm == 0.0 { right + wrong } else { wrong };
        assert!(right >= least_right && wrong <= most_wrong, "{made:?}: {right} right, {wrong} wrong, {open} open");
    }
}
