//! Which ranges of a mesh are worth a draw of their own.

use std::ops::Range;

use crate::clusters::Cluster;

/// What a draw costs, in triangles that could be drawn instead: recording it, switching to it, and the last wave that it
/// leaves half empty.
pub(super) const DRAW_TRIANGLES: u32 = 256;

/// What to draw of an instance of which a facet is reached in part.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Parts {
    /// All of it, in a draw that it may share.
    Whole,
    /// These ranges of the list, each in a draw of its own; none where no cluster reaches.
    Ranges(Range<usize>),
}

/// Appends the cheapest ranges of corners that hold all clusters that reach. Gaps that cost less than a draw are drawn
/// along; where the ranges cost as much as the whole mesh, they are taken back. `is_shared` says that a draw of the whole
/// mesh costs nothing extra, because other instances may take part in it.
pub(super) fn merge(
    clusters: &[Cluster],
    is_shared: bool,
    reaches: impl Fn(&Cluster) -> bool,
    ranges: &mut Vec<Range<u32>>,
) -> Parts {
    // Every gap decides for itself: its triangles against one more draw.
    let start = ranges.len();
    for cluster in clusters.iter().filter(|cluster| reaches(cluster)) {
        let end = cluster.first.saturating_add(cluster.count);
        match ranges[start..].last_mut() {
            Some(last) if cluster.first.saturating_sub(last.end) <= 3 * DRAW_TRIANGLES => last.end = end,
            _ => ranges.push(cluster.first..end),
        }
    }

    // Compare with the whole mesh.
    let corners = |range: &Range<u32>| u64::from(range.end.saturating_sub(range.start));
    let draw = 3 * u64::from(DRAW_TRIANGLES);
    let apart: u64 = ranges[start..].iter().map(|range| corners(range) + draw).sum();
    let all = clusters.last().map_or(0, |last| u64::from(last.first.saturating_add(last.count)));
    let whole = all + if is_shared { 0 } else { draw };
    if apart >= whole && ranges.len() > start {
        ranges.truncate(start);
        return Parts::Whole;
    }
    Parts::Ranges(start..ranges.len())
}
