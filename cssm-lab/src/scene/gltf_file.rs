//! Scenes from glTF 2.0 files: every mesh of the default scene, one instance for each node that names it.

use std::path::{Path, PathBuf};

use base64::Engine as _;
use cssm_core::glam::{DAffine3, DMat4, DVec3};
use gltf::accessor::Dimensions;
use gltf::mesh::Mode;

use super::gltf_mask::read_mask;
use super::gltf_read::read;
use super::{BUILT_IN, Instance, Mesh, Scene, Viewpoint};

/// Required extensions that do not change which triangles a file holds, or that are read.
const SUPPORTED_EXTENSIONS: &[&str] = &[
    "KHR_mesh_quantization",
    "KHR_materials_unlit",
    "KHR_texture_transform",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_lights_punctual",
];

/// Most triangles, instances counted, that a scene may have.
const MOST_TRIANGLES: usize = 50_000_000;

const PLAIN: [f32; 3] = [0.55, 0.55, 0.55];

/// A file that is not a scene.
#[derive(Debug, thiserror::Error)]
pub enum SceneFileError {
    /// Not a built-in name and not a glTF file name.
    #[error("there is no scene {name}; name {}, or a .gltf or .glb file", BUILT_IN.join(", "))]
    Unknown {
        /// What was asked for.
        name: String,
    },
    /// A file cannot be read.
    #[error("cannot read {}: {source}; check the path", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The document is malformed.
    #[error("{} is not a valid glTF 2.0 document: {source}; re-export it", path.display())]
    Document {
        /// The file.
        path: PathBuf,
        /// What the parser said.
        source: Box<gltf::Error>,
    },
    /// The document needs extensions that are not supported.
    #[error("the document requires {}, which is not supported; export it without {}", extensions.join(", "), if extensions.len() == 1 { "this extension" } else { "these extensions" })]
    RequiredExtensions {
        /// Names of the extensions, in the document's order.
        extensions: Vec<String>,
    },
    /// A buffer is missing or malformed.
    #[error("buffer {buffer} cannot be used: {why}; re-export the document with its buffers")]
    Buffer {
        /// Index of the buffer.
        buffer: usize,
        /// What is wrong.
        why: String,
    },
    /// An accessor is malformed.
    #[error("accessor {accessor} cannot be read: {why}; re-export the document")]
    Accessor {
        /// Index of the accessor.
        accessor: usize,
        /// What is wrong.
        why: String,
    },
    /// An image cannot be decoded.
    #[error("image {image} cannot be used as an alpha mask: {why}; re-export it as PNG")]
    Image {
        /// Index of the image.
        image: usize,
        /// What is wrong.
        why: String,
    },
    /// A primitive is not made of triangles.
    #[error("primitive {primitive} of mesh {mesh} is made of {mode}; triangulate it or remove it")]
    NotTriangles {
        /// Index of the mesh.
        mesh: usize,
        /// Index of the primitive.
        primitive: usize,
        /// What it is made of.
        mode: &'static str,
    },
    /// A primitive has no positions.
    #[error(
        "primitive {primitive} of mesh {mesh} has no POSITION attribute; re-export it with vertex positions"
    )]
    NoPositions {
        /// Index of the mesh.
        mesh: usize,
        /// Index of the primitive.
        primitive: usize,
    },
    /// A primitive is inconsistent.
    #[error("primitive {primitive} of mesh {mesh} {why}; re-export it")]
    Primitive {
        /// Index of the mesh.
        mesh: usize,
        /// Index of the primitive.
        primitive: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// A node is inconsistent.
    #[error("node {node} {why}; re-export the document")]
    Node {
        /// Index of the node.
        node: usize,
        /// What is wrong.
        why: &'static str,
    },
    /// Nothing to draw.
    #[error("{} holds no triangles in its scene; add meshes to the scene's nodes", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// Too much to trace.
    #[error("the scene has more than {MOST_TRIANGLES} triangles; thin it out")]
    TooLarge,
}

pub(super) fn load(path: &Path) -> Result<Scene, SceneFileError> {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    if !matches!(extension.as_deref(), Some("gltf" | "glb")) {
        return Err(SceneFileError::Unknown { name: path.display().to_string() });
    }
    let bytes =
        std::fs::read(path).map_err(|source| SceneFileError::Read { path: path.to_owned(), source })?;
    let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    parse(&bytes, path, name)
}

fn parse(bytes: &[u8], path: &Path, name: String) -> Result<Scene, SceneFileError> {
    let malformed = |source| SceneFileError::Document { path: path.to_owned(), source: Box::new(source) };

    // Name unsupported extensions before the validator refuses them without a name.
    let gltf::Gltf { document, blob } =
        gltf::Gltf::from_slice_without_validation(bytes).map_err(malformed)?;
    let unsupported: Vec<String> = document
        .extensions_required()
        .filter(|extension| !SUPPORTED_EXTENSIONS.contains(extension))
        .map(str::to_owned)
        .collect();
    if !unsupported.is_empty() {
        return Err(SceneFileError::RequiredExtensions { extensions: unsupported });
    }
    let mut root = document.into_json();
    root.extensions_required.clear();
    // Name primitives without positions before the validator refuses them less clearly.
    let positions = gltf::json::validation::Checked::Valid(gltf::Semantic::Positions);
    for (mesh, primitives) in root.meshes.iter().map(|mesh| &mesh.primitives).enumerate() {
        if let Some(primitive) = primitives.iter().position(|p| !p.attributes.contains_key(&positions)) {
            return Err(SceneFileError::NoPositions { mesh, primitive });
        }
    }
    let document = gltf::Document::from_json(root).map_err(malformed)?;

    let buffers = load_buffers(&document, blob, path)?;
    let mut meshes = Vec::new();
    let mut mesh_primitives = Vec::new();
    for mesh in document.meshes() {
        let first = meshes.len();
        for primitive in mesh.primitives() {
            meshes.push(read_primitive(&mesh, &primitive, &buffers, path)?);
        }
        mesh_primitives.push(first..meshes.len());
    }
    let colours: Vec<_> = document
        .meshes()
        .flat_map(|mesh| mesh.primitives().map(|p| colour(&p)).collect::<Vec<_>>())
        .collect();

    // Walk the default scene, or the first, without recursion.
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let mut instances = Vec::new();
    let mut triangles = 0_usize;
    let mut open: Vec<_> =
        scene.iter().flat_map(gltf::Scene::nodes).map(|node| (node, DMat4::IDENTITY)).collect();
    open.reverse();
    let mut seen = vec![false; document.nodes().len()];
    while let Some((node, world_from_parent)) = open.pop() {
        if std::mem::replace(&mut seen[node.index()], true) {
            return Err(SceneFileError::Node {
                node: node.index(),
                why: "has two parents or contains itself",
            });
        }
        let world_from_node = world_from_parent * local_transform(&node);
        if !world_from_node.is_finite() {
            return Err(SceneFileError::Node {
                node: node.index(),
                why: "has a transform that is not finite",
            });
        }
        let primitives = node.mesh().and_then(|mesh| mesh_primitives.get(mesh.index()).cloned());
        for mesh in primitives.into_iter().flatten() {
            let world_from_object = DAffine3::from_mat4(world_from_node);
            instances.push(Instance { mesh, world_from_object, colour: colours[mesh] });
            triangles += meshes[mesh].triangles();
            if triangles > MOST_TRIANGLES || instances.len() > MOST_TRIANGLES {
                return Err(SceneFileError::TooLarge);
            }
        }
        let children: Vec<_> = node.children().collect();
        open.extend(children.into_iter().rev().map(|child| (child, world_from_node)));
    }
    if triangles == 0 {
        return Err(SceneFileError::Empty { path: path.to_owned() });
    }
    let mut scene = Scene { name, meshes, instances, views: Vec::new(), lamps: Vec::new() };
    scene.views = surrounding_views(&scene);
    Ok(scene)
}

/// Three views from the sides of the scene towards its middle.
fn surrounding_views(scene: &Scene) -> Vec<Viewpoint> {
    let Some(bounds) = scene.bounds_world() else {
        return Vec::new();
    };
    let centre = (bounds.min + bounds.max) * 0.5;
    let reach = 0.35 * (bounds.max - bounds.min).max_element();
    [(1.0, 0.6, [-0.5, -0.75, -0.3]), (-0.8, 1.0, [0.6, -0.7, 0.2]), (0.1, -1.0, [0.3, -0.6, 0.7])]
        .map(|(x, z, light)| Viewpoint {
            eye_world: centre + DVec3::new(x, 0.35, z) * reach,
            target_world: centre,
            light_travels: light.into(),
        })
        .to_vec()
}

fn load_buffers(
    document: &gltf::Document,
    mut blob: Option<Vec<u8>>,
    path: &Path,
) -> Result<Vec<Vec<u8>>, SceneFileError> {
    document
        .buffers()
        .map(|buffer| {
            let fail = |why: String| SceneFileError::Buffer { buffer: buffer.index(), why };
            let bytes = match buffer.source() {
                gltf::buffer::Source::Bin => {
                    blob.take().ok_or_else(|| fail("the file has no binary chunk".to_owned()))?
                }
                gltf::buffer::Source::Uri(uri) => read_uri(uri, path).map_err(fail)?,
            };
            if bytes.len() < buffer.length() {
                return Err(fail(format!("it holds {} bytes of {}", bytes.len(), buffer.length())));
            }
            Ok(bytes)
        })
        .collect()
}

/// Bytes of a data address or of a file beside the document.
pub(super) fn read_uri(uri: &str, document_path: &Path) -> Result<Vec<u8>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data.split_once(";base64,").ok_or("its data address is not base64")?;
        return base64::engine::general_purpose::STANDARD.decode(text).map_err(|error| error.to_string());
    }
    if uri.contains("://") {
        return Err(format!("{uri} is not a local file"));
    }
    let relative = percent_decoded(uri).ok_or_else(|| format!("{uri} is not a valid address"))?;
    let path = document_path.parent().unwrap_or(Path::new("")).join(&relative);
    std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
}

fn percent_decoded(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&byte, tail)) = rest.split_first() {
        rest = tail;
        if byte == b'%' {
            let digits = std::str::from_utf8(rest.get(..2)?).ok()?;
            bytes.push(u8::from_str_radix(digits, 16).ok()?);
            rest = &rest[2..];
        } else {
            bytes.push(byte);
        }
    }
    String::from_utf8(bytes).ok()
}

fn read_primitive(
    mesh: &gltf::Mesh<'_>,
    primitive: &gltf::Primitive<'_>,
    buffers: &[Vec<u8>],
    document_path: &Path,
) -> Result<Mesh, SceneFileError> {
    let (mesh_index, index) = (mesh.index(), primitive.index());
    let fail = |why| SceneFileError::Primitive { mesh: mesh_index, primitive: index, why };
    let accessor = primitive
        .get(&gltf::Semantic::Positions)
        .ok_or(SceneFileError::NoPositions { mesh: mesh_index, primitive: index })?;
    let positions: Vec<[f32; 3]> = read::<3>(&accessor, Dimensions::Vec3, buffers)?
        .into_iter()
        .map(|point| point.map(|v| v as f32))
        .collect();
    if positions.iter().flatten().any(|value| !value.is_finite()) {
        return Err(fail("has a position that is not finite"));
    }
    let vertices =
        u32::try_from(positions.len()).map_err(|_| fail("has more vertices than an index can name"))?;
    let indices: Vec<u32> = match primitive.indices() {
        Some(accessor) => read::<1>(&accessor, Dimensions::Scalar, buffers)?
            .into_iter()
            .map(|[value]| value as u32)
            .collect(),
        None => (0..vertices).collect(),
    };
    if indices.iter().any(|index| *index >= vertices) {
        return Err(fail("has an index past its last vertex"));
    }
    let mode = |mode| SceneFileError::NotTriangles { mesh: mesh_index, primitive: index, mode };
    let indices = match primitive.mode() {
        Mode::Triangles if !indices.len().is_multiple_of(3) => {
            return Err(fail("has an index count that is no multiple of 3"));
        }
        Mode::Triangles => indices,
        Mode::TriangleStrip => (2..indices.len())
            .flat_map(|last| {
                let odd = last % 2;
                [indices[last - 2], indices[last - 1 + odd], indices[last - odd]]
            })
            .collect(),
        Mode::TriangleFan => {
            (2..indices.len()).flat_map(|last| [indices[0], indices[last - 1], indices[last]]).collect()
        }
        Mode::Points => return Err(mode("points")),
        Mode::Lines | Mode::LineLoop | Mode::LineStrip => return Err(mode("lines")),
    };
    let mask = read_mask(mesh_index, primitive, positions.len(), buffers, document_path)?;
    Ok(Mesh { name: mesh.name().unwrap_or("mesh").to_owned(), positions, indices, mask })
}

fn colour(primitive: &gltf::Primitive<'_>) -> [f32; 3] {
    let material = primitive.material();
    if material.index().is_none() {
        return PLAIN;
    }
    let [red, green, blue, _] = material.pbr_metallic_roughness().base_color_factor();
    // A textured material usually leaves its factor white; a mid grey shows shadows better.
    if red.min(green).min(blue) > 0.95 { PLAIN } else { [red, green, blue] }
}

fn local_transform(node: &gltf::Node<'_>) -> DMat4 {
    DMat4::from_cols_array_2d(&node.transform().matrix().map(|column| column.map(f64::from)))
}

#[cfg(test)]
mod tests;
