//! Squared Euclidean distance, in voxels, of every voxel to a set (Felzenszwalb, Huttenlocher, Theory of Computing 8, 2012).

/// For every voxel the squared distance (whole numbers) to the nearest voxel for which `is_set` holds; `u32::MAX`
/// everywhere if there is none. `dims` with the first index fastest. Cost `O(voxels)`.
pub(super) fn squared_distance(dims: [usize; 3], is_set: impl Fn(usize) -> bool) -> Vec<u32> {
    let n: usize = dims.iter().product();
    let mut d: Vec<u32> = (0..n).map(|k| if is_set(k) { 0 } else { u32::MAX }).collect();
    let strides = [1, dims[0], dims[0] * dims[1]];
    let longest = dims.iter().copied().max().unwrap_or(0);
    let mut line = vec![0u32; longest];
    let mut envelope = Envelope { place: vec![0; longest], from: vec![0.0; longest + 1] };
    for axis in 0..3 {
        let (len, step) = (dims[axis], strides[axis]);
        for start in (0..n).filter(|k| k / step % len == 0) {
            for (k, value) in line[..len].iter_mut().enumerate() {
                *value = d[start + k * step];
            }
            envelope.fill(&line[..len], |k, value| d[start + k * step] = value);
        }
    }
    d
}

/// The lower envelope of the parabolas `line[q] + (k − q)²`.
struct Envelope {
    place: Vec<usize>,
    from: Vec<f64>,
}

impl Envelope {
    fn fill(&mut self, line: &[u32], mut put: impl FnMut(usize, u32)) {
        let value = |q: usize| f64::from(line[q]) + (q * q) as f64;
        let mut n = 0;
        for q in (0..line.len()).filter(|&q| line[q] != u32::MAX) {
            let mut start = f64::NEG_INFINITY;
            while n > 0 {
                let p = self.place[n - 1];
                start = (value(q) - value(p)) / (2.0 * (q - p) as f64);
                if start > self.from[n - 1] {
                    break;
                }
                n -= 1;
                start = f64::NEG_INFINITY;
            }
            self.place[n] = q;
            self.from[n] = start;
            n += 1;
        }
        if n == 0 {
            return;
        }
        let mut at = 0;
        for k in 0..line.len() {
            while at + 1 < n && self.from[at + 1] <= k as f64 {
                at += 1;
            }
            let q = self.place[at];
            put(k, line[q] + (k.abs_diff(q) as u32).pow(2));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::squared_distance;

    #[test]
    fn agrees_with_the_definition() {
        let dims = [7, 5, 6];
        let place = |k: usize| [k % 7, k / 7 % 5, k / 35].map(|c| c as i64);
        for salt in 1..20usize {
            let is_set = |k: usize| (k * 7919 + salt * 104_729).is_multiple_of(17 + salt);
            let fast = squared_distance(dims, is_set);
            for (k, &d) in fast.iter().enumerate() {
                let far = |q: usize| (0..3).map(|a| (place(k)[a] - place(q)[a]).pow(2)).sum::<i64>() as u32;
                assert_eq!(Some(d), (0..210).filter(|&q| is_set(q)).map(far).min());
            }
        }
    }

    #[test]
    fn nothing_is_near_an_empty_set() {
        assert!(squared_distance([3, 3, 3], |_| false).iter().all(|&d| d == u32::MAX));
    }
}
