//! Eight `f32` in a register, and the operations of the dense kernel on them.
//!
//! An instruction set is a token ([`Simd`]): [`Plain`] for any machine, [`Avx2`] for machines with AVX2, which [`Avx2::new`] checks. Only tokens create vectors, so the existence of a vector proves its instruction set and its
//! methods are safe. Loops are written once, over any token, and [`dispatch!`] compiles them for both.
//!
//! Each operation rounds at most once on both, so both give the same bits; a test holds them equal. Intrinsics are used
//! because of the transposes, which the compiler would route through memory, number by number.

use wide::f32x4;

/// Numbers in a vector.
pub(super) const WIDTH: usize = 8;

/// An instruction set that this machine has.
pub(super) trait Simd: Copy {
    /// Eight numbers in its registers.
    type Vector: Vector;
    /// A vector with the same number eight times.
    fn splat(self, value: f32) -> Self::Vector;
    /// Loads from memory, at any address.
    fn load(self, from: &[f32; WIDTH]) -> Self::Vector;
    /// The transpose of eight rows of four numbers: for every `k` the column of numbers `k`.
    fn columns(self, rows: [&[f32; 4]; WIDTH]) -> [Self::Vector; 4];
    /// Prefetches the cache line of `values[at]`, if `at` is in range, into the first-level cache.
    fn prefetch<T>(self, values: &[T], at: usize);
    /// Prefetches the cache line of `values[at]`, if `at` is in range, into the second-level cache.
    fn prefetch_far<T>(self, values: &[T], at: usize);
}

/// Eight numbers; all operations are elementwise.
pub(super) trait Vector: Copy {
    /// Stores to memory, at any address.
    fn store(self, to: &mut [f32; WIDTH]);
    /// `self + other`.
    fn add(self, other: Self) -> Self;
    /// `self − other`.
    fn sub(self, other: Self) -> Self;
    /// `self · other`.
    fn mul(self, other: Self) -> Self;
    /// `self` where it is larger, else `other`.
    fn max(self, other: Self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// `a` where `self` is larger than `other`, else `b`.
    fn choose_if_above(self, other: Self, a: Self, b: Self) -> Self;
}

/// Defines a function that calls the generic `$body` with the best token of this machine as its first argument.
///
/// `$body` has to be `#[inline(always)]`: it is compiled for AVX2 by being inlined into a function with that feature.
macro_rules! dispatch {
    (
        $(#[$attribute:meta])*
        $vis:vis fn $name:ident $(<$generic:ident: $bound:path>)? ($($argument:ident: $type:ty),* $(,)?) $(-> $result:ty)?
            = $body:ident
    ) => {
        $(#[$attribute])*
        $vis fn $name $(<$generic: $bound>)? ($($argument: $type),*) $(-> $result)? {
            #[cfg(target_arch = "x86_64")]
            {
                use $crate::inference::vector::Avx2;

                #[target_feature(enable = "avx2")]
                fn with_avx2 $(<$generic: $bound>)? (avx2: Avx2, $($argument: $type),*) $(-> $result)? {
                    $body(avx2, $($argument),*)
                }

                if let Some(avx2) = Avx2::new() {
                    // SAFETY: the token proves that the machine has AVX2.
                    #[allow(unsafe_code)]
                    return unsafe { with_avx2(avx2, $($argument),*) };
                }
            }
            $body($crate::inference::vector::Plain, $($argument),*)
        }
    };
}
pub(super) use dispatch;

/// The portable instruction set.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plain;

/// Eight numbers on any machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PlainVector([f32; WIDTH]);

impl Simd for Plain {
    type Vector = PlainVector;

    #[inline(always)]
    fn splat(self, value: f32) -> PlainVector {
        PlainVector([value; WIDTH])
    }

    #[inline(always)]
    fn load(self, from: &[f32; WIDTH]) -> PlainVector {
        PlainVector(*from)
    }

    #[inline(always)]
    fn columns(self, rows: [&[f32; 4]; WIDTH]) -> [PlainVector; 4] {
        let transposed = |first: usize| f32x4::transpose(std::array::from_fn(|k| f32x4::from(*rows[first + k])));
        let (low, high) = (transposed(0), transposed(4));
        std::array::from_fn(|x| {
            let ([a, b, c, d], [e, f, g, h]) = (low[x].to_array(), high[x].to_array());
            PlainVector([a, b, c, d, e, f, g, h])
        })
    }

    #[inline(always)]
    fn prefetch<T>(self, _: &[T], _: usize) {}

    #[inline(always)]
    fn prefetch_far<T>(self, _: &[T], _: usize) {}
}

impl PlainVector {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f32, f32) -> f32) -> Self {
        PlainVector(std::array::from_fn(|k| f(self.0[k], other.0[k])))
    }
}

impl Vector for PlainVector {
    #[inline(always)]
    fn store(self, to: &mut [f32; WIDTH]) {
        *to = self.0;
    }

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| if a > b { a } else { b })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        PlainVector(self.0.map(f32::abs))
    }

    #[inline(always)]
    fn choose_if_above(self, other: Self, a: Self, b: Self) -> Self {
        PlainVector(std::array::from_fn(|k| if self.0[k] > other.0[k] { a.0[k] } else { b.0[k] }))
    }
}

#[cfg(target_arch = "x86_64")]
pub(super) use avx2::Avx2;

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use super::{Simd, Vector, WIDTH};
    use std::arch::x86_64::*;

    /// A machine with AVX2.
    #[derive(Debug, Clone, Copy)]
    pub(in super::super) struct Avx2(());

    /// Eight numbers in a register of such a machine. Only [`Avx2`] creates the first one.
    #[derive(Debug, Clone, Copy)]
    pub(in super::super) struct Avx2Vector(__m256);

    impl Avx2 {
        /// The token, if this machine has AVX2.
        #[inline(always)]
        pub(in super::super) fn new() -> Option<Self> {
            is_x86_feature_detected!("avx2").then_some(Avx2(()))
        }
    }

    #[allow(unsafe_code, reason = "intrinsics are unsafe outside functions that are compiled for their instructions")]
    impl Simd for Avx2 {
        type Vector = Avx2Vector;

        #[inline(always)]
        fn splat(self, value: f32) -> Avx2Vector {
            // SAFETY: `self` proves AVX2.
            Avx2Vector(unsafe { _mm256_set1_ps(value) })
        }

        #[inline(always)]
        fn load(self, from: &[f32; WIDTH]) -> Avx2Vector {
            // SAFETY: `self` proves AVX2; 32 bytes are borrowed, and no alignment is required.
            Avx2Vector(unsafe { _mm256_loadu_ps(from.as_ptr()) })
        }

        #[inline(always)]
        fn columns(self, [a, b, c, d, e, f, g, h]: [&[f32; 4]; WIDTH]) -> [Avx2Vector; 4] {
            // SAFETY: `self` proves AVX2; 16 bytes of each row are borrowed, and no alignment is required.
            unsafe {
                // Two rows in one register are two loads and no shuffle.
                let two = |x: &[f32; 4], y: &[f32; 4]| _mm256_loadu2_m128(y.as_ptr(), x.as_ptr());
                let (a, b, c, d) = (two(a, e), two(b, f), two(c, g), two(d, h));
                // The transposes of four rows in both halves of a register.
                let (p, q) = (_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b));
                let (r, s) = (_mm256_unpacklo_ps(c, d), _mm256_unpackhi_ps(c, d));
                [
                    Avx2Vector(_mm256_shuffle_ps::<0x44>(p, r)),
                    Avx2Vector(_mm256_shuffle_ps::<0xee>(p, r)),
                    Avx2Vector(_mm256_shuffle_ps::<0x44>(q, s)),
                    Avx2Vector(_mm256_shuffle_ps::<0xee>(q, s)),
                ]
            }
        }

        #[inline(always)]
        fn prefetch<T>(self, values: &[T], at: usize) {
            // SAFETY: a prefetch accepts any address; past the end nothing is read.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(values.as_ptr().wrapping_add(at).cast()) }
        }

        #[inline(always)]
        fn prefetch_far<T>(self, values: &[T], at: usize) {
            // SAFETY: a prefetch accepts any address; past the end nothing is read.
            unsafe { _mm_prefetch::<_MM_HINT_T1>(values.as_ptr().wrapping_add(at).cast()) }
        }
    }

    #[allow(unsafe_code, reason = "intrinsics are unsafe outside functions that are compiled for their instructions")]
    impl Vector for Avx2Vector {
        #[inline(always)]
        fn store(self, to: &mut [f32; WIDTH]) {
            // SAFETY: a vector proves AVX2; 32 bytes are borrowed, and no alignment is required.
            unsafe { _mm256_storeu_ps(to.as_mut_ptr(), self.0) }
        }

        #[inline(always)]
        fn add(self, other: Self) -> Self {
            // SAFETY: a vector proves AVX2.
            Avx2Vector(unsafe { _mm256_add_ps(self.0, other.0) })
        }

        #[inline(always)]
        fn sub(self, other: Self) -> Self {
            // SAFETY: a vector proves AVX2.
            Avx2Vector(unsafe { _mm256_sub_ps(self.0, other.0) })
        }

        #[inline(always)]
        fn mul(self, other: Self) -> Self {
            // SAFETY: a vector proves AVX2.
            Avx2Vector(unsafe { _mm256_mul_ps(self.0, other.0) })
        }

        #[inline(always)]
        fn max(self, other: Self) -> Self {
            // SAFETY: a vector proves AVX2.
            Avx2Vector(unsafe { _mm256_max_ps(self.0, other.0) })
        }

        #[inline(always)]
        fn abs(self) -> Self {
            // SAFETY: a vector proves AVX2.
            Avx2Vector(unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0) })
        }

        #[inline(always)]
        fn choose_if_above(self, other: Self, a: Self, b: Self) -> Self {
            // SAFETY: a vector proves AVX2.
            Avx2Vector(unsafe { _mm256_blendv_ps(b.0, a.0, _mm256_cmp_ps::<_CMP_GT_OQ>(self.0, other.0)) })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A half of each row.
    fn quads(rows: &[[f32; WIDTH]; WIDTH], half: usize) -> [&[f32; 4]; WIDTH] {
        std::array::from_fn(|k| &rows[k].as_chunks().0[half])
    }

    /// The results of every operation on two vectors, and on eight rows.
    #[inline(always)]
    fn everything<S: Simd>(simd: S, rows: &[[f32; WIDTH]; WIDTH]) -> Vec<[u32; WIDTH]> {
        let loaded: [S::Vector; WIDTH] = std::array::from_fn(|k| simd.load(&rows[k]));
        let (a, b) = (loaded[0], loaded[1]);
        simd.prefetch(&rows[0], 3);
        simd.prefetch_far(&rows[0], 99);
        let mut made = vec![simd.splat(rows[0][0]), a.add(b), a.sub(b), a.mul(b), a.max(b), b.max(a), a.abs()];
        made.push(a.choose_if_above(b, loaded[2], loaded[3]));
        made.extend(simd.columns(quads(rows, 0)).into_iter().chain(simd.columns(quads(rows, 1))));
        let bits = |vector: S::Vector| {
            let mut numbers = [0.0; WIDTH];
            vector.store(&mut numbers);
            numbers.map(f32::to_bits)
        };
        made.into_iter().map(bits).collect()
    }

    dispatch! {
        fn on_this_machine(rows: &[[f32; WIDTH]; WIDTH]) -> Vec<[u32; WIDTH]> = everything
    }

    proptest! {
        #[test]
        fn both_kinds_of_vector_give_the_same_bits(entropy in prop::collection::vec(-2.0f32..2.0, 64), same in any::<bool>()) {
            let mut rows = [[0.0; WIDTH]; WIDTH];
            rows.as_flattened_mut().copy_from_slice(&entropy);
            if same {
                rows[1][3] = rows[0][3];
                rows[1][4] = -0.0;
                rows[0][4] = 0.0;
            }
            prop_assert_eq!(on_this_machine(&rows), everything(Plain, &rows));
        }

        #[test]
        fn columns_are_those_of_the_rows(entropy in prop::collection::vec(-2.0f32..2.0, 64), half in 0usize..2) {
            let mut rows = [[0.0; WIDTH]; WIDTH];
            rows.as_flattened_mut().copy_from_slice(&entropy);
            for (x, column) in (4 * half..).zip(Plain.columns(quads(&rows, half))) {
                prop_assert!((0..WIDTH).all(|k| column.0[k] == rows[k][x]));
            }
        }
    }
}
