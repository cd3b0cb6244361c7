//! Directions of light that footprints are scored under.

use cssm_core::View;
use cssm_core::glam::DVec3;

/// Direction towards the light in camera space, degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direction {
    /// Angle above the horizon of a level camera.
    pub elevation_degrees: f64,
    /// 0 ahead, 90 right, 180 behind.
    pub azimuth_degrees: f64,
}

/// Where the light stands to the view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// 45 degrees and higher.
    General,
    /// Just outside the view or its opposite.
    Border,
    /// In or opposite the view.
    Dueling,
    /// Low, from elsewhere.
    Side,
}

impl Class {
    /// Every class.
    pub const ALL: [Self; 4] = [Self::General, Self::Border, Self::Dueling, Self::Side];

    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::General => "general",
            Self::Border => "border",
            Self::Dueling => "dueling",
            Self::Side => "side",
        }
    }
}

impl Direction {
    /// Unit vector towards the light, camera space.
    pub fn unit(&self) -> DVec3 {
        let (elevation, azimuth) = (self.elevation_degrees.to_radians(), self.azimuth_degrees.to_radians());
        let level = elevation.cos();
        DVec3::new(level * azimuth.sin(), elevation.sin(), -level * azimuth.cos())
    }

    /// Where the light stands to a view.
    pub fn class(&self, view: &View) -> Class {
        let unit = self.unit();
        let (x, y) = (unit.x / unit.z.abs(), unit.y / unit.z.abs());
        let inside = x > view.left && x < view.right && y > view.bottom && y < view.top;
        match (inside, self.elevation_degrees) {
            (true, _) => Class::Dueling,
            (_, elevation) if elevation >= 45.0 => Class::General,
            (_, elevation) if elevation >= 30.0 && unit.x.abs() < 1e-9 => Class::Border,
            _ => Class::Side,
        }
    }
}

/// The grid of metrics: eight elevations, five azimuths, the zenith once.
pub fn light_grid() -> Vec<Direction> {
    let mut grid = Vec::new();
    for elevation_degrees in [5.0, 15.0, 25.0, 35.0, 45.0, 60.0, 75.0] {
        for azimuth_degrees in [0.0, 45.0, 90.0, 135.0, 180.0] {
            grid.push(Direction { elevation_degrees, azimuth_degrees });
        }
    }
    grid.push(Direction { elevation_degrees: 90.0, azimuth_degrees: 0.0 });
    grid
}

/// `elevation,azimuth` in degrees.
///
/// # Errors
/// What to write instead.
pub fn parse_direction(text: &str) -> Result<Direction, String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some([elevation, azimuth]) if elevation.is_finite() && azimuth.is_finite() => {
            Ok(Direction { elevation_degrees: *elevation, azimuth_degrees: *azimuth })
        }
        _ => Err("write elevation,azimuth in degrees, such as 45,180".into()),
    }
}
