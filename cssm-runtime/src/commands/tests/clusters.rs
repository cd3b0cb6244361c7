//! Instances drawn in part.

use super::*;
use crate::commands::ranges::DRAW_TRIANGLES;

/// A row of clusters along x, each a metre long with a number of triangles.
fn row(clusters: u32, triangles: u32) -> Vec<Cluster> {
    let metre = |at: u32| f64::from(at);
    let cluster = |at: u32| Cluster {
        first: at * 3 * triangles,
        count: 3 * triangles,
        bounds_object: BoundingBox {
            min: DVec3::new(metre(at), 0.0, 0.0),
            max: DVec3::new(metre(at) + 1.0, 1.0, 1.0),
        },
    };
    (0..clusters).map(cluster).collect()
}

fn facts_of(clusters: &[Cluster]) -> MeshFacts<'_> {
    let (first, last) = (clusters.first().unwrap(), clusters.last().unwrap());
    let min = clusters.iter().fold(first.bounds_object.min, |min, one| min.min(one.bounds_object.min));
    let max = clusters.iter().fold(first.bounds_object.max, |max, one| max.max(one.bounds_object.max));
    MeshFacts {
        pipeline: PipelineHandle(0),
        corners: last.first + last.count,
        indexed: true,
        first_index: 0,
        bounds_object: BoundingBox { min, max },
        clusters,
        drawing: Drawing::Plain,
    }
}

/// First corner, corners and rows of every draw.
fn draws(frame: &FrameCommands) -> Vec<(u32, u32, Range<u32>)> {
    let draw = |command: &Command| match command {
        Command::Draw { first, count, instances, .. } => Some((*first, *count, instances.clone())),
        _ => None,
    };
    frame.commands.iter().filter_map(draw).collect()
}

fn built(facets: Vec<Facet>, casters: &[CasterInstance], clusters: &[Cluster]) -> FrameCommands {
    FrameCommands::build(&plan(facets), casters, |_| Some(facts_of(clusters))).unwrap().0
}

#[test]
fn facets_draw_the_clusters_that_reach_them() {
    // Facets over metres 3 to 5, all of it, none of it.
    let clusters = row(20, 100);
    let facets = vec![facet(0, 3.5, 4.5), facet(1, -1.0, 30.0), facet(2, 20.5, 30.0)];
    let (frame, statistics) =
        FrameCommands::build(&plan(facets), &[at(0, 0.0)], |_| Some(facts_of(&clusters))).unwrap();
    assert_eq!(draws(&frame), [(900, 600, 0..1), (0, 6000, 1..2)]);
    let triangles: Vec<_> =
        statistics.facets.iter().map(|facet| (facet.instances, facet.triangles)).collect();
    assert_eq!(triangles, [(1, 200), (1, 2000), (0, 0)]);
    assert_eq!(statistics.triangles, 2200);

    // Without clusters the same instance is drawn whole.
    let whole = |_| Some(MeshFacts { clusters: &[], ..facts_of(&clusters) });
    let (frame, _) = FrameCommands::build(&plan(vec![facet(0, 3.5, 4.5)]), &[at(0, 0.0)], whole).unwrap();
    assert_eq!(draws(&frame), [(0, 6000, 0..1)]);
}

#[test]
fn gaps_cheaper_than_a_draw_are_drawn_along() {
    // Six clusters; those at both ends reach the facet, four in the middle do not.
    let reaching = |triangles: u32| {
        let mut clusters = row(6, triangles);
        for cluster in &mut clusters[1..5] {
            cluster.bounds_object.min.x += 100.0;
            cluster.bounds_object.max.x += 100.0;
        }
        draws(&built(vec![facet(0, -1.0, 50.0)], &[at(0, 0.0)], &clusters))
    };
    let bridged = DRAW_TRIANGLES / 4;
    assert_eq!(reaching(bridged), [(0, 18 * bridged, 0..1)]);
    let apart = bridged + 1;
    assert_eq!(reaching(apart), [(0, 3 * apart, 0..1), (15 * apart, 3 * apart, 0..1)]);
}

#[test]
fn an_instance_joins_the_others_where_that_is_cheaper() {
    // Half of the second instance reaches; its own draw would cost as much as its other half.
    let half = |triangles: u32| {
        let casters = [at(0, 10.0), at(0, 0.0)];
        draws(&built(vec![facet(0, 1.5, 50.0)], &casters, &row(2, triangles)))
    };
    assert_eq!(half(DRAW_TRIANGLES), [(0, 6 * DRAW_TRIANGLES, 0..2)]);
    let more = DRAW_TRIANGLES + 1;
    assert_eq!(half(more), [(0, 6 * more, 0..1), (3 * more, 3 * more, 1..2)]);

    // Alone it needs a draw anyway, so half a draw is always better.
    let alone = draws(&built(vec![facet(0, 1.5, 50.0)], &[at(0, 0.0)], &row(2, 1)));
    assert_eq!(alone, [(3, 3, 0..1)]);
}

#[test]
fn a_box_that_reaches_without_a_cluster_draws_nothing() {
    // Two clusters far apart: the facet lies in the hole between them.
    let mut clusters = row(2, 1000);
    clusters[1].bounds_object.min.x += 50.0;
    clusters[1].bounds_object.max.x += 50.0;
    assert_eq!(built(vec![facet(0, 10.0, 20.0)], &[at(0, 0.0)], &clusters), FrameCommands::default());
}

/// Numbers in [0, 1) that look random.
fn noise(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1u64 << 53) as f64
}

#[test]
fn no_point_inside_a_facet_is_ever_refused() {
    let mut state = 4;
    let (mut inside, mut drawn, mut all) = (0, 0, 0);
    for _ in 0..300 {
        // Clusters anywhere in a mesh, a few turned and sheared instances, facets of slanted planes.
        let mut vector = |scale: f64| {
            let mut one = || scale * (2.0 * noise(&mut state) - 1.0);
            DVec3::new(one(), one(), one())
        };
        let cluster = |number: u32, centre: DVec3, half: DVec3| Cluster {
            first: number * 900,
            count: 900,
            bounds_object: BoundingBox { min: centre - half.abs(), max: centre + half.abs() },
        };
        let clusters: Vec<_> = (0..12).map(|number| cluster(number, vector(20.0), vector(2.0))).collect();
        let casters: Vec<_> = (0..3)
            .map(|_| CasterInstance {
                mesh: handle(0),
                world_from_object: DAffine3 {
                    matrix3: DMat3::from_cols(vector(1.0), vector(1.0), vector(1.0)),
                    translation: EYE + vector(20.0),
                },
            })
            .collect();
        let mut slanted = facet(0, 0.0, 1.0);
        slanted.casters = (0..6).map(|_| vector(1.0).extend(6.0)).collect();
        let planes = slanted.casters.clone();
        let (frame, statistics) =
            FrameCommands::build(&plan(vec![slanted]), &casters, |_| Some(facts_of(&clusters))).unwrap();
        drawn += statistics.triangles;
        all += 3 * 12 * 300;

        // Every point of a cluster that lies in the facet must be drawn, with its own instance's row.
        for caster in &casters {
            let mut moved = caster.world_from_object;
            moved.translation -= EYE;
            let row = InstanceRows::rounded(&moved).unwrap();
            for cluster in &clusters {
                let bounds = cluster.bounds_object;
                for _ in 0..20 {
                    let share = (vector(0.5) + 0.5).clamp(DVec3::ZERO, DVec3::ONE);
                    let point = moved.transform_point3(bounds.min + (bounds.max - bounds.min) * share);
                    if planes.iter().any(|plane| plane.dot(point.extend(1.0)) < 0.0) {
                        continue;
                    }
                    inside += 1;
                    let holds = |(first, count, rows): &(u32, u32, Range<u32>)| {
                        *first <= cluster.first
                            && cluster.first + cluster.count <= first + count
                            && rows.clone().any(|at| frame.rows[at as usize] == row)
                    };
                    assert!(draws(&frame).iter().any(holds), "{cluster:?} is missing");
                }
            }
        }
    }
    assert!(inside > 10_000, "only {inside} points lie in a facet");
    assert!(drawn < all * 6 / 10, "{drawn} of {all} triangles are drawn");
}
