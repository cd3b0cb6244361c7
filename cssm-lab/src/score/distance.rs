//! Exact Euclidean distance to the nearest mark.

use rayon::prelude::*;

use super::edges::Marks;

/// Distance in pixels from every place of the lattice to the nearest mark (Felzenszwalb and Huttenlocher,
/// "Distance Transforms of Sampled Functions", 2012: lower envelopes of parabolas, columns then rows). Without
/// marks it is the lattice's diagonal, which no distance exceeds.
pub(super) fn transform(marks: &Marks) -> Vec<f64> {
    let (width, height) = (marks.lattice.width, marks.lattice.height);
    let farthest = (width * width + height * height) as f64;

    // Find the nearest mark in each column by two sweeps, all columns side by side.
    let mut squared = vec![farthest; width * height];
    let mut steps = vec![f64::INFINITY; width];
    for y in (0..height).chain((0..height).rev()) {
        let row = y * width..(y + 1) * width;
        for ((squared, marked), steps) in
            squared[row.clone()].iter_mut().zip(&marks.marked[row]).zip(&mut steps)
        {
            *steps = if *marked { 0.0 } else { *steps + 1.0 };
            *squared = squared.min(*steps * *steps);
        }
    }

    // Combine the columns along each row.
    squared.par_chunks_mut(width).for_each_init(Envelope::default, |envelope, row| envelope.lower(row));
    // Two places make a pixel.
    squared.par_iter().map(|squared| 0.5 * squared.min(farthest).sqrt()).collect()
}

/// Lower envelope of parabolas x -> value + (x - apex)^2; kept between rows for its memory.
#[derive(Default)]
struct Envelope {
    apexes: Vec<(f64, f64)>,
    starts: Vec<f64>,
}

impl Envelope {
    fn lower(&mut self, row: &mut [f64]) {
        self.apexes.clear();
        self.starts.clear();
        for (x, value) in row.iter().enumerate() {
            let (x, value) = (x as f64, *value);
            // Drop parabolas that the new one undercuts from their start on.
            let start = loop {
                let Some(&(apex, low)) = self.apexes.last() else {
                    break f64::NEG_INFINITY;
                };
                let crossing = 0.5 * ((value + x * x) - (low + apex * apex)) / (x - apex);
                if self.starts.last().is_some_and(|start| crossing <= *start) {
                    self.apexes.pop();
                    self.starts.pop();
                } else {
                    break crossing;
                }
            };
            self.apexes.push((x, value));
            self.starts.push(start);
        }
        let mut current = 0;
        for (x, value) in row.iter_mut().enumerate() {
            let x = x as f64;
            while self.starts.get(current + 1).is_some_and(|start| *start < x) {
                current += 1;
            }
            let (apex, low) = self.apexes[current];
            *value = low + (x - apex) * (x - apex);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::edges::Lattice;
    use super::*;

    #[test]
    fn distances_equal_those_of_trying_every_mark() {
        let lattice = Lattice { width: 23, height: 17 };
        let mut marks = Marks { lattice, marked: vec![false; 23 * 17] };
        for place in [0, 45, 123, 124, 200, 390] {
            marks.marked[place] = true;
        }
        let found = transform(&marks);
        for (place, distance) in found.iter().enumerate() {
            let tried = marks.places().map(|mark| {
                let (x, y) =
                    ((place % 23).abs_diff(mark % 23) as f64, (place / 23).abs_diff(mark / 23) as f64);
                0.5 * x.hypot(y)
            });
            assert!((distance - tried.fold(f64::INFINITY, f64::min)).abs() < 1e-12, "place {place}");
        }
    }

    #[test]
    fn nothing_marked_is_as_far_as_the_diagonal() {
        let lattice = Lattice { width: 9, height: 13 };
        let found = transform(&Marks { lattice, marked: vec![false; 9 * 13] });
        assert!(found.iter().all(|distance| *distance == 0.5 * 250.0_f64.sqrt()));
    }
}
