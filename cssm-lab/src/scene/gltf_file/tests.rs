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
    let text = Scene::load("forest").expect_err("no such scene").to_string();
    assert_eq!(text, "there is no scene forest; name palm, city, or a .gltf or .glb file");
}
