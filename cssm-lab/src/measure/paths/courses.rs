//! Courses of a camera over the land: walk, drive, flight, into the sun, under cover, a kilometre and beyond.

use cssm_core::glam::{DQuat, DVec3};
use cssm_core::{Light, View};

use super::land::Land;
use super::{Station, Stations, ViewPath};
use crate::error::LabError;
use crate::scene::{Scene, Viewpoint};

/// Stations of a course.
const STATIONS: usize = 4;
/// Places that are tried for each station.
const TRIES: usize = 24;
/// Lens of the courses.
const FOV_Y_DEGREES: f64 = 60.0;
const NEAR_METRES: f64 = 0.2;
/// Planes of the kilometre course.
const KILOMETRE_NEAR_METRES: f64 = 0.1;
const KILOMETRE_FAR_METRES: f64 = 4000.0;
/// Heights of the eye above the ground, metres.
const WALKER_METRES: f64 = 1.7;
const DRIVER_METRES: f64 = 1.1;
/// Height of the sun that is looked into.
const LOW_SUN_DEGREES: f64 = 12.0;
/// Azimuths of the sun on the way across the view and out of it, from the view's heading.
const DUEL_AZIMUTHS_DEGREES: [f64; STATIONS] = [0.0, 18.0, 36.0, 56.0];
/// Something overhead within this distance makes a place an interior, metres.
const CEILING_METRES: f64 = 25.0;
/// Places looked at for an interior, along each side of a square grid.
const INTERIOR_GRID: i32 = 41;
/// Share of the scene's larger side that the grid covers, at most; and at most in metres.
const INTERIOR_SPREAD: f64 = 0.5;
const INTERIOR_SPREAD_METRES: f64 = 80.0;

/// All courses on a scene.
pub(super) fn paths(scene: &Scene, land: &Land<'_>, stations: Stations) -> Result<Vec<ViewPath>, LabError> {
    let first = *scene.views.first().ok_or(LabError::NoView)?;
    let second = *scene.views.get(1).unwrap_or(&first);
    let path = |name: &str, summary: &str, stations: Vec<Station>| ViewPath {
        name: name.to_owned(),
        summary: summary.to_owned(),
        stations,
    };
    let side = (land.bounds.max - land.bounds.min).max_element();
    let reach = (first.target_world - first.eye_world).length().min(side);
    let walk = Course { height: Height::Ground(WALKER_METRES), step_metres: reach / 6.0, ..Course::OF_EYE };
    let drive = Course {
        height: Height::Ground(DRIVER_METRES),
        step_metres: (side / 12.0).min(15.0),
        ..Course::OF_EYE
    };
    let altitude = (0.12 * side).clamp(8.0, 120.0);
    let flight = Course {
        height: Height::Above(altitude),
        step_metres: (side / 12.0).min(40.0),
        pitch_degrees: -22.0,
        bank_degrees: 25.0,
        ..Course::OF_EYE
    };
    let lift = (0.2 * side).clamp(12.0, 200.0);
    let kilometre = Course {
        height: Height::Above(lift),
        step_metres: -(side / 8.0).min(60.0),
        pitch_degrees: -18.0,
        planes_metres: (KILOMETRE_NEAR_METRES, KILOMETRE_FAR_METRES),
        ..Course::OF_EYE
    };
    let infinite = Course {
        height: Height::Above(0.0),
        step_metres: -(reach / 8.0),
        planes_metres: (KILOMETRE_NEAR_METRES, f64::INFINITY),
        ..Course::OF_EYE
    };
    Ok(vec![
        path("walk", "eye height, straight ahead", walk.stations(land, &first, stations)?),
        path("drive", "low and fast", drive.stations(land, &second, stations)?),
        path("flight", "high above, banking", flight.stations(land, &first, stations)?),
        path("dueling", "into a low sun that crosses the view", dueling(land, &first, stations)?),
        path("interior", "under roofs, crowns or between walls", interior(land, &first, stations)?),
        path("kilometre", "near .1 m, far 4 km", kilometre.stations(land, &first, stations)?),
        path("infinite", "near .1 m, far at infinity", infinite.stations(land, &second, stations)?),
    ])
}

/// A straight course from a viewpoint's eye towards what it looks at.
#[derive(Clone, Copy)]
struct Course {
    height: Height,
    /// From station to station; backwards if negative.
    step_metres: f64,
    /// Below the horizon if negative.
    pitch_degrees: f64,
    /// Roll of the camera, alternating from station to station.
    bank_degrees: f64,
    planes_metres: (f64, f64),
}

/// How high the eye is.
#[derive(Clone, Copy)]
enum Height {
    /// Above whatever lies below.
    Ground(f64),
    /// Above the viewpoint's own eye.
    Above(f64),
}

impl Course {
    const OF_EYE: Self = Self {
        height: Height::Above(0.0),
        step_metres: 1.0,
        pitch_degrees: -4.0,
        bank_degrees: 0.0,
        planes_metres: (NEAR_METRES, f64::INFINITY),
    };

    /// The first worthwhile places along the course and beside it.
    fn stations(
        &self,
        land: &Land<'_>,
        from: &Viewpoint,
        stations: Stations,
    ) -> Result<Vec<Station>, LabError> {
        let light = Light::directional_travelling(from.light_travels)?;
        let heading = heading(from);
        let right = heading.cross(DVec3::Y);
        let phase = phase(stations);
        let mut found = Vec::new();
        let mut last = from.eye_world;
        for try_index in 0..TRIES {
            if found.len() == STATIONS {
                break;
            }
            // Go on along the course; turn round where the scene ends, a little to the side.
            let lap = try_index / (2 * STATIONS);
            let along = (try_index % (2 * STATIONS)) as f64 + phase;
            let aside = [0.0, 0.7, -0.7][lap.min(2)];
            let mut eye = from.eye_world + (heading * along + right * aside) * self.step_metres;
            eye = match self.height {
                Height::Ground(metres) => {
                    land.above_ground(DVec3 { y: last.y.max(from.eye_world.y - 2.0), ..eye }, metres)
                }
                Height::Above(metres) => eye + DVec3::Y * metres,
            };
            let bank = if found.len() % 2 == 0 { self.bank_degrees } else { -self.bank_degrees };
            let station = Station { view: self.view(land, eye, heading, bank)?, light };
            if land.is_worthwhile(&station) {
                found.push(station);
                last = eye;
            }
        }
        Ok(found)
    }

    fn view(&self, land: &Land<'_>, eye: DVec3, heading: DVec3, bank_degrees: f64) -> Result<View, LabError> {
        let ahead = pitched(heading, self.pitch_degrees);
        let up = DQuat::from_axis_angle(ahead, bank_degrees.to_radians()) * DVec3::Y;
        let (near, far) = self.planes_metres;
        let fov = FOV_Y_DEGREES.to_radians();
        Ok(View::perspective(eye, eye + ahead, up, fov, near, far, land.size_pixels)?)
    }
}

/// A level view towards the target, with a low sun that wanders from its middle across its border.
fn dueling(land: &Land<'_>, from: &Viewpoint, stations: Stations) -> Result<Vec<Station>, LabError> {
    let heading = heading(from);
    let course = Course { pitch_degrees: 0.0, ..Course::OF_EYE };
    let view = course.view(land, from.eye_world, heading, 0.0)?;
    let shift = 9.0 * 2.0 * phase(stations);
    let station = |azimuth: &f64| {
        let toward = toward_light(heading, LOW_SUN_DEGREES + 0.3 * shift, azimuth + shift);
        Ok(Station { view, light: Light::directional_travelling(-toward)? })
    };
    DUEL_AZIMUTHS_DEGREES.iter().map(station).collect()
}

/// Places with something overhead, each looking where most is free.
fn interior(land: &Land<'_>, from: &Viewpoint, stations: Stations) -> Result<Vec<Station>, LabError> {
    let light = Light::directional_travelling(from.light_travels)?;
    let size = land.bounds.max - land.bounds.min;
    let spread = (INTERIOR_SPREAD * size.x.max(size.z)).min(INTERIOR_SPREAD_METRES);
    let course = Course { pitch_degrees: -8.0, ..Course::OF_EYE };
    let mut found = Vec::new();
    let mut passed_over = 0;
    for (column, row) in spiral(INTERIOR_GRID) {
        if found.len() == STATIONS {
            break;
        }
        // Stand on the ground where something is overhead.
        let offset = DVec3::new(f64::from(column), 0.0, f64::from(row)) * (spread / f64::from(INTERIOR_GRID));
        let over = DVec3 { y: from.eye_world.y, ..from.target_world } + offset;
        let eye = land.above_ground(over, WALKER_METRES);
        if land.distance(eye, DVec3::Y, CEILING_METRES).is_none() {
            continue;
        }

        // Look where most is free.
        let free = |turn: &f64| {
            let direction = DQuat::from_rotation_y(turn.to_radians()) * DVec3::NEG_Z;
            let distance = land.distance(eye, direction, CEILING_METRES).unwrap_or(CEILING_METRES);
            (direction, distance)
        };
        let turns = (0..8).map(|eighth| 45.0 * f64::from(eighth));
        let widest = turns.map(|turn| free(&turn)).max_by(|(_, one), (_, two)| one.total_cmp(two));
        let Some((heading, _)) = widest else { continue };
        let station = Station { view: course.view(land, eye, heading, 0.0)?, light };
        if !land.is_worthwhile(&station) {
            continue;
        }
        // Seen and unseen places take turns.
        let wanted = if stations == Stations::Seen { 0 } else { 1 };
        if passed_over % 2 == wanted {
            found.push(station);
        }
        passed_over += 1;
    }
    Ok(found)
}

/// Cells of a square grid from its middle outwards.
fn spiral(side: i32) -> Vec<(i32, i32)> {
    let half = side / 2;
    let mut cells: Vec<(i32, i32)> =
        (-half..=half).flat_map(|row| (-half..=half).map(move |column| (column, row))).collect();
    cells.sort_by_key(|(column, row)| (column.abs().max(row.abs()), *row, *column));
    cells
}

const fn phase(stations: Stations) -> f64 {
    match stations {
        Stations::Seen => 0.0,
        Stations::Unseen => 0.5,
    }
}

/// Level direction from a viewpoint's eye to what it looks at.
pub(super) fn heading(from: &Viewpoint) -> DVec3 {
    let toward = from.target_world - from.eye_world;
    DVec3 { y: 0.0, ..toward }.normalize_or(DVec3::NEG_Z)
}

/// Direction towards a light at an elevation and an azimuth from a heading; positive azimuths lie to the right.
pub(super) fn toward_light(heading: DVec3, elevation_degrees: f64, azimuth_degrees: f64) -> DVec3 {
    pitched(DQuat::from_rotation_y(-azimuth_degrees.to_radians()) * heading, elevation_degrees)
}

/// A level direction, raised.
fn pitched(heading: DVec3, degrees: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    heading * cos + DVec3::Y * sin
}
