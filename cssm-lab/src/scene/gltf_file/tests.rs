use base64::Engine as _;

use super::*;

/// A document with one triangle; the closure edits its parts before they are joined.
fn document(edit: impl Fn(&mut serde_json::Value)) -> Vec<u8> {
    let mut bytes = Vec::new();
    for value in [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0] {
        bytes.extend(value.to_le_bytes());
    }
    for index in [0_u16, 1, 2] {
        bytes.extend(index.to_le_bytes());
    }
    let data = base64::engine::general_purpose::STANDARD.encode(&bytes);
    let mut json = serde_json::json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0, 1] }],
        "nodes": [{ "mesh": 0 }, { "mesh": 0, "translation": [5.0, 0.0, 0.0], "children": [2] }, { "mesh": 0, "scale": [2.0, 2.0, 2.0] }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0.0, 0.0, 0.0], "max": [1.0, 1.0, 0.0] },
            { "bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR" },
        ],
        "bufferViews": [{ "buffer": 0, "byteLength": 36 }, { "buffer": 0, "byteOffset": 36, "byteLength": 6 }],
        "buffers": [{ "byteLength": 42, "uri": format!("data:application/octet-stream;base64,{data}") }],
    });
    edit(&mut json);
    json.to_string().into_bytes()
}

fn parsed(edit: impl Fn(&mut serde_json::Value)) -> Result<Scene, SceneFileError> {
    parse(&document(edit), Path::new("made.gltf"), "made".to_owned())
}

fn message(edit: impl Fn(&mut serde_json::Value)) -> String {
    parsed(edit).expect_err("the document must be refused").to_string()
}

#[test]
fn nodes_place_their_mesh() {
    let scene = parsed(|_| {}).unwrap();
    assert_eq!((scene.meshes.len(), scene.instances.len(), scene.triangles()), (1, 3, 3));
    let bounds = scene.bounds_world().unwrap();
    assert_eq!((bounds.min, bounds.max), (DVec3::ZERO, DVec3::new(7.0, 2.0, 0.0)));
    assert_eq!(scene.views.len(), 3);
}

#[test]
fn strips_and_fans_keep_their_winding() {
    let four = |json: &mut serde_json::Value, mode: u32| {
        json["meshes"][0]["primitives"][0]["mode"] = mode.into();
        json["accessors"][1]["sparse"] = serde_json::Value::Null;
        let mut bytes = Vec::new();
        for value in [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0] {
            bytes.extend(value.to_le_bytes());
        }
        for index in if mode == 5 { [0_u16, 1, 2, 3] } else { [0, 1, 3, 2] } {
            bytes.extend(index.to_le_bytes());
        }
        json["buffers"][0]["byteLength"] = bytes.len().into();
        let data = base64::engine::general_purpose::STANDARD.encode(&bytes);
        json["buffers"][0]["uri"] = format!("data:;base64,{data}").into();
        json["bufferViews"][0]["byteLength"] = 48.into();
        json["bufferViews"][1]["byteOffset"] = 48.into();
        json["bufferViews"][1]["byteLength"] = 8.into();
        json["accessors"][0]["count"] = 4.into();
        json["accessors"][1]["count"] = 4.into();
    };
    for mode in [5, 6] {
        let scene = parsed(|json| four(json, mode)).unwrap();
        let mesh = &scene.meshes[0];
        assert_eq!(mesh.triangles(), 2);
        for triangle in mesh.indices.chunks_exact(3) {
            let [a, b, c] =
                [0, 1, 2].map(|i| DVec3::from_array(mesh.positions[triangle[i] as usize].map(f64::from)));
            assert!((b - a).cross(c - a).z > 0.5, "mode {mode}");
        }
    }
}

#[test]
fn unsupported_required_extensions_are_named() {
    let text = message(|json| {
        json["extensionsUsed"] = serde_json::json!(["KHR_draco_mesh_compression", "EXT_meshopt_compression"]);
        json["extensionsRequired"] =
            serde_json::json!(["KHR_draco_mesh_compression", "EXT_meshopt_compression"]);
    });
    assert!(text.contains("KHR_draco_mesh_compression, EXT_meshopt_compression"), "{text}");
}

#[test]
fn broken_documents_are_typed_errors() {
    type Edit = fn(&mut serde_json::Value);
    let cases: [(&str, Edit); 10] = [
        ("made of lines", |json| json["meshes"][0]["primitives"][0]["mode"] = 1.into()),
        ("made of points", |json| json["meshes"][0]["primitives"][0]["mode"] = 0.into()),
        ("has no POSITION", |json| {
            json["meshes"][0]["primitives"][0]["attributes"] = serde_json::json!({ "NORMAL": 0 });
        }),
        ("reads past the end", |json| json["accessors"][0]["count"] = 4_000_000_000_u32.into()),
        ("leaves the buffer", |json| json["bufferViews"][0]["byteOffset"] = 4_000_000_000_u32.into()),
        ("holds 42 bytes of 43", |json| json["buffers"][0]["byteLength"] = 43.into()),
        ("not base64", |json| json["buffers"][0]["uri"] = "data:,hello".into()),
        ("made-up.bin", |json| json["buffers"][0]["uri"] = "made%2Dup.bin".into()),
        ("contains itself", |json| json["nodes"][2]["children"] = serde_json::json!([1])),
        ("holds no triangles", |json| json["nodes"] = serde_json::json!([{}, {}])),
    ];
    for (expected, edit) in cases {
        let text = message(edit);
        assert!(text.contains(expected), "expected {expected:?} in {text:?}");
    }
}

#[test]
fn hostile_bytes_do_not_panic() {
    let good = document(|_| {});
    for length in 0..good.len() {
        assert!(parse(&good[..length], Path::new("cut.gltf"), String::new()).is_err(), "cut at {length}");
    }
    assert!(
        parse(b"glTF\x02\0\0\0\xff\xff\xff\xff\xff\xff\xff\xffJSON", Path::new("cut.glb"), String::new())
            .is_err()
    );
}

#[test]
fn other_names_are_refused_with_the_remedy() {
    let text = Scene::load("jungle").expect_err("no such scene").to_string();
    assert_eq!(text, "there is no scene jungle; name palm, city, pavilion, forest, or a .gltf or .glb file");
}

/// Gives the triangle a material with a mask of two columns, the left one a hole, and texture coordinates that equal
/// its x and y.
fn masked(json: &mut serde_json::Value) {
    let mut image = Vec::new();
    let mut encoder = png::Encoder::new(&mut image, 2, 1);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header().unwrap().write_image_data(&[9, 9, 9, 100, 9, 9, 9, 200]).unwrap();
    let base64 = &base64::engine::general_purpose::STANDARD;
    json["images"] =
        serde_json::json!([{ "uri": format!("data:image/png;base64,{}", base64.encode(&image)) }]);
    json["textures"] = serde_json::json!([{ "source": 0 }]);
    json["materials"] = serde_json::json!([{
        "alphaMode": "MASK",
        "pbrMetallicRoughness": { "baseColorTexture": { "index": 0, "texCoord": 1 } },
    }]);
    let bytes: Vec<u8> = [0.0_f32, 0.0, 1.0, 0.0, 0.0, 1.0].iter().flat_map(|uv| uv.to_le_bytes()).collect();
    json["buffers"].as_array_mut().unwrap().push(serde_json::json!(
        { "byteLength": 24, "uri": format!("data:;base64,{}", base64.encode(&bytes)) }
    ));
    json["bufferViews"].as_array_mut().unwrap().push(serde_json::json!({ "buffer": 1, "byteLength": 24 }));
    json["accessors"].as_array_mut().unwrap().push(serde_json::json!(
        { "bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2" }
    ));
    let primitive = &mut json["meshes"][0]["primitives"][0];
    primitive["material"] = 0.into();
    primitive["attributes"]["TEXCOORD_1"] = 2.into();
}

fn mask(edit: impl Fn(&mut serde_json::Value)) -> Option<super::super::AlphaMask> {
    let scene = parsed(|json| {
        masked(json);
        edit(json);
    });
    scene.unwrap().meshes.swap_remove(0).mask
}

#[test]
fn masks_are_read_with_their_own_texture_coordinates() {
    let found = mask(|_| {}).unwrap();
    assert_eq!((found.width, found.height, found.cutoff), (2, 1, 0.5));
    assert_eq!(found.alpha, [100, 200]);
    assert_eq!(found.uvs, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    assert!(found.is_hole(0.25, 0.5) && !found.is_hole(0.75, 0.5));

    // The material's cutoff and alpha count; a mask without holes is none.
    assert_eq!(mask(|json| json["materials"][0]["alphaCutoff"] = 0.2.into()), None);
    assert_eq!(mask(|json| json["materials"][0]["alphaMode"] = "OPAQUE".into()), None);
    let faint = |json: &mut serde_json::Value| {
        json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = serde_json::json!([1, 1, 1, 0.5]);
    };
    assert_eq!(mask(faint).unwrap().hole_share(), 1.0);
    let untextured = |json: &mut serde_json::Value| {
        json["materials"][0]["pbrMetallicRoughness"] = serde_json::json!({});
    };
    assert_eq!(mask(untextured), None);
}

#[test]
fn texture_transforms_move_masks() {
    let moved = mask(|json| {
        json["extensionsUsed"] = serde_json::json!(["KHR_texture_transform"]);
        json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = serde_json::json!({
            "KHR_texture_transform": { "offset": [0.5, 0.0], "scale": [2.0, 1.0], "rotation": std::f64::consts::FRAC_PI_2 }
        });
    });
    // Scaled first, then turned counter-clockwise seen with v down, then moved.
    let uvs = moved.unwrap().uvs;
    for (found, expected) in uvs.iter().zip([[0.5, 0.0], [0.5, -2.0], [1.5, 0.0]]) {
        assert!((found[0] - expected[0]).abs() + (found[1] - expected[1]).abs() < 1e-6, "{uvs:?}");
    }
}

#[test]
fn broken_masks_are_typed_errors() {
    type Edit = fn(&mut serde_json::Value);
    let cases: [(&str, Edit); 5] = [
        ("image 0 cannot be used as an alpha mask: leaf.png", |json| {
            json["images"][0]["uri"] = "leaf.png".into();
        }),
        ("no PNG or JPEG", |json| json["images"][0]["uri"] = "data:;base64,AAAA".into()),
        ("but not its texture coordinates", |json| {
            json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 0.into();
        }),
        ("another number of texture coordinates", |json| json["accessors"][2]["count"] = 2.into()),
        ("it holds Vec3 where Vec2", |json| {
            json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = 0.into();
        }),
    ];
    for (expected, edit) in cases {
        let text = message(|json| {
            masked(json);
            edit(json);
        });
        assert!(text.contains(expected), "expected {expected:?} in {text:?}");
    }
}
