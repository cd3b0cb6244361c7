//! The viewing camera: any projection becomes one internal view at the door.
//!
//! Camera space is right-handed, x right, y up, looking along -z; depth = -z in metres. All planning happens
//! relative to the eye, so the world position appears only as [`View::eye_world`], in f64.

use glam::{DMat3, DMat4, DVec3, DVec4};

mod lattice;
mod widen;

pub use self::lattice::ViewLattice;

/// A perspective view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Eye position in world space, metres.
    pub eye_world: DVec3,
    /// Rotation (or reflection, for left-handed worlds) from world axes to camera axes.
    pub camera_from_world: DMat3,
    /// x / depth of the left edge.
    pub left: f64,
    /// x / depth of the right edge; greater than `left`.
    pub right: f64,
    /// y / depth of the bottom edge.
    pub bottom: f64,
    /// y / depth of the top edge; greater than `bottom`.
    pub top: f64,
    /// Depth of the near plane, metres, positive.
    pub near_metres: f64,
    /// Depth of the far plane, metres; may be infinite.
    pub far_metres: f64,
    /// Width and height of the image in pixels.
    pub size_pixels: (u32, u32),
}

/// Range of clip-space depth that a projection matrix was built for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ClipDepth {
    /// z/w in [0, 1]: Vulkan, Metal, Direct3D, WebGPU; reversed or not.
    ZeroToOne,
    /// z/w in [-1, 1]: OpenGL.
    NegativeOneToOne,
}

/// A view that makes no sense.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ViewError {
    /// A number is NaN or infinite where it must be finite.
    #[error("{what} is not finite; give finite numbers")]
    NotFinite {
        /// The input at fault.
        what: &'static str,
    },
    /// The view direction or the up vector is degenerate.
    #[error(
        "the view direction and the up vector do not span a plane; give an up vector that is not parallel to the view"
    )]
    Degenerate,
    /// The near plane is not positive or not before the far plane.
    #[error(
        "the near plane at {near_metres} m must lie at a positive depth before the far plane at {far_metres} m"
    )]
    Depths {
        /// Depth of the near plane.
        near_metres: f64,
        /// Depth of the far plane.
        far_metres: f64,
    },
    /// The field of view is empty or reaches 180 degrees.
    #[error(
        "the field of view is empty or reaches 180 degrees; give an angle between 0 and 180 degrees and a positive aspect ratio"
    )]
    FieldOfView,
    /// The matrix is not a perspective projection.
    #[error(
        "the matrix is not a perspective projection ({why}); orthographic and oblique projections have no camera space map"
    )]
    NotPerspective {
        /// What gives it away.
        why: &'static str,
    },
    /// The view matrix is not rigid.
    #[error("the view matrix is not a rotation and a translation; remove scale and shear")]
    NotRigid,
    /// The image has no pixels.
    #[error("the image has no pixels; give a width and a height of at least 1")]
    NoPixels,
}

/// Largest deviation of a view matrix from a rigid one; wide enough for matrices that were built in f32.
const RIGID_TOLERANCE: f64 = 1e-4;

impl View {
    /// A symmetric perspective view from `eye_world` to `target_world`; `far_metres` may be infinite.
    ///
    /// # Errors
    /// A [`ViewError`] that names the argument at fault.
    #[allow(
        clippy::too_many_arguments,
        reason = "the field's customary camera arguments, each with its unit in the name"
    )]
    pub fn perspective(
        eye_world: DVec3,
        target_world: DVec3,
        up_world: DVec3,
        fov_y_radians: f64,
        near_metres: f64,
        far_metres: f64,
        size_pixels: (u32, u32),
    ) -> Result<Self, ViewError> {
        if size_pixels.0 == 0 || size_pixels.1 == 0 {
            return Err(ViewError::NoPixels);
        }
        if !(fov_y_radians > 0.0 && fov_y_radians < std::f64::consts::PI) {
            return Err(ViewError::FieldOfView);
        }
        let top = libm::tan(0.5 * fov_y_radians);
        let right = top * f64::from(size_pixels.0) / f64::from(size_pixels.1);
        let camera_from_world = look_rotation(eye_world, target_world, up_world)?;
        Self {
            eye_world,
            camera_from_world,
            left: -right,
            right,
            bottom: -top,
            top,
            near_metres,
            far_metres,
            size_pixels,
        }
        .checked()
    }

    /// The view behind a view matrix (world to camera) and a projection matrix (camera to clip), as engines have
    /// them: symmetric or off-centre, jittered, finite or infinite far, reversed-z or not, right- or left-handed
    /// (told from the sign of the projection's w row), y up or down.
    ///
    /// # Errors
    /// A [`ViewError`] that names what is not a rigid view or not a perspective projection.
    pub fn from_matrices(
        camera_from_world: DMat4,
        clip_from_camera: DMat4,
        clip_depth: ClipDepth,
        size_pixels: (u32, u32),
    ) -> Result<Self, ViewError> {
        if !camera_from_world.is_finite() || !clip_from_camera.is_finite() {
            return Err(ViewError::NotFinite { what: "a matrix" });
        }

        // Bring the projection to w = depth: flip z of left-handed cameras, scale by the w row.
        let w_row = clip_from_camera.row(3);
        if w_row.x != 0.0 || w_row.y != 0.0 || w_row.w != 0.0 || w_row.z == 0.0 {
            return Err(ViewError::NotPerspective { why: "its last row is not (0, 0, s, 0)" });
        }
        let flip = if w_row.z > 0.0 { -1.0 } else { 1.0 };
        let scale = 1.0 / w_row.z.abs();
        let row = |index: usize| {
            let row = clip_from_camera.row(index) * scale;
            DVec4::new(row.x, row.y, flip * row.z, row.w)
        };

        // Read the side planes: x_clip = +-w on x = edge * depth, z = -depth.
        let (x_row, y_row, z_row) = (row(0), row(1), row(2));
        if x_row.y != 0.0
            || x_row.w != 0.0
            || y_row.x != 0.0
            || y_row.w != 0.0
            || x_row.x == 0.0
            || y_row.y == 0.0
        {
            return Err(ViewError::NotPerspective { why: "its x and y rows shear or translate" });
        }
        let edges = |slope: f64, shift: f64| {
            let (one, two) = ((shift - 1.0) / slope, (shift + 1.0) / slope);
            (one.min(two), one.max(two))
        };
        let (left, right) = edges(x_row.x, x_row.z);
        let (bottom, top) = edges(y_row.y, y_row.z);

        // Read the near and far planes: z_clip = z.z * -depth + z.w equals the range's ends times depth.
        if z_row.x != 0.0 || z_row.y != 0.0 {
            return Err(ViewError::NotPerspective { why: "its z row is oblique" });
        }
        let start = match clip_depth {
            ClipDepth::ZeroToOne => 0.0,
            ClipDepth::NegativeOneToOne => -1.0,
        };
        let depth_at = |end: f64| {
            let slope = end + z_row.z;
            // An f32 projection cannot tell a far plane beyond 1e7 near distances from infinity.
            if slope.abs() < 1e-9 { f64::INFINITY } else { z_row.w / slope }
        };
        let (one, two) = (depth_at(start), depth_at(1.0));
        let (near_metres, far_metres) = (one.min(two), one.max(two));

        // Read the rigid part: rotation (or reflection) and eye.
        let handed = DMat4::from_cols(DVec4::X, DVec4::Y, DVec4::new(0.0, 0.0, flip, 0.0), DVec4::W);
        let rigid = handed * camera_from_world;
        let rotation = DMat3::from_mat4(rigid);
        let residual = rotation * rotation.transpose() - DMat3::IDENTITY;
        if residual.to_cols_array().iter().any(|value| value.abs() > RIGID_TOLERANCE)
            || rigid.row(3) != DVec4::W
        {
            return Err(ViewError::NotRigid);
        }
        let eye_world = rotation.transpose() * -rigid.w_axis.truncate();
        Self {
            eye_world,
            camera_from_world: rotation,
            left,
            right,
            bottom,
            top,
            near_metres,
            far_metres,
            size_pixels,
        }
        .checked()
    }

    /// The view with another near plane; engines that know how close the nearest visible surface is pass it here.
    ///
    /// # Errors
    /// [`ViewError::Depths`] when the plane is not before the far plane.
    pub fn with_near(self, near_metres: f64) -> Result<Self, ViewError> {
        Self { near_metres, ..self }.checked()
    }

    /// Screen pixels per unit of tangent, at the image's centre: height / (top - bottom).
    pub fn pixels_per_tangent(&self) -> f64 {
        f64::from(self.size_pixels.1) / (self.top - self.bottom)
    }

    /// Metres that a screen pixel spans at a point's depth: a functional on points relative to the eye, world axes.
    pub fn pixel_metres(&self) -> DVec4 {
        let depth = self.camera_from_world.transpose() * DVec3::NEG_Z;
        (depth / self.pixels_per_tangent()).extend(0.0)
    }

    /// Tangents (x, y at depth 1) of the four corners: left bottom, right bottom, right top, left top.
    pub fn corner_tangents(&self) -> [(f64, f64); 4] {
        [(self.left, self.bottom), (self.right, self.bottom), (self.right, self.top), (self.left, self.top)]
    }

    /// Ray through a pixel position (fractional, y down): direction relative to the eye in world axes whose depth
    /// is 1, so that `ray * depth` is the visible point.
    pub fn ray_world(&self, x_pixels: f64, y_pixels: f64) -> DVec3 {
        let x = self.left + (self.right - self.left) * x_pixels / f64::from(self.size_pixels.0);
        let y = self.top + (self.bottom - self.top) * y_pixels / f64::from(self.size_pixels.1);
        self.camera_from_world.transpose() * DVec3::new(x, y, -1.0)
    }

    /// Depth along the view axis of a point relative to the eye, world axes.
    pub fn depth_metres(&self, point_from_eye: DVec3) -> f64 {
        -(self.camera_from_world.row(2).dot(point_from_eye))
    }

    fn checked(self) -> Result<Self, ViewError> {
        if self.size_pixels.0 == 0 || self.size_pixels.1 == 0 {
            return Err(ViewError::NoPixels);
        }
        if !self.eye_world.is_finite() {
            return Err(ViewError::NotFinite { what: "the eye position" });
        }
        if !self.camera_from_world.is_finite() {
            return Err(ViewError::NotFinite { what: "the view rotation" });
        }
        let edges = [self.left, self.right, self.bottom, self.top];
        if edges.iter().any(|edge| !edge.is_finite()) || self.right <= self.left || self.top <= self.bottom {
            return Err(ViewError::FieldOfView);
        }
        if !(self.near_metres > 0.0 && self.near_metres.is_finite() && self.far_metres > self.near_metres) {
            return Err(ViewError::Depths { near_metres: self.near_metres, far_metres: self.far_metres });
        }
        Ok(self)
    }
}

fn look_rotation(eye: DVec3, target: DVec3, up: DVec3) -> Result<DMat3, ViewError> {
    if !eye.is_finite() || !target.is_finite() || !up.is_finite() {
        return Err(ViewError::NotFinite { what: "the eye, target or up vector" });
    }
    let back = (eye - target).try_normalize().ok_or(ViewError::Degenerate)?;
    let right = up.normalize_or_zero().cross(back).try_normalize().ok_or(ViewError::Degenerate)?;
    let camera_up = back.cross(right);
    Ok(DMat3::from_cols(right, camera_up, back).transpose())
}
