//! The 3D lobe as a mesh for other programs: Wavefront OBJ and glTF 2.0.
//!
//! A vertex stands at its direction times the luminance of f in 1/sr (times the cosine, where that is shown): a unit of
//! length is 1/sr, x along s, y along t, z along n. glTF has y upwards, so that its nodes turn the lobe there.

use std::fmt::Write as _;
use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::DVec3;
use serde_json::{Value, json};

use super::names::Names;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::lobe::Arrow;
use bxdf_lab::analysis::lobe3d::{Mesh, Vertex};

/// A lobe with the name of its material.
pub struct Named {
    /// The name.
    pub name: String,
    /// The colour of the material, linear.
    pub color: [f32; 3],
    /// The mesh.
    pub mesh: Arc<Mesh>,
    /// Whether lengths carry |cos(theta)|.
    pub with_cosine: bool,
    /// What lengths are called.
    pub names: Names,
    /// The Dirac deltas, which the mesh does not have.
    pub deltas: Arc<Vec<Arrow>>,
}

impl Named {
    /// Whether there is a mesh: light that is all in deltas has none.
    #[must_use]
    pub fn has_mesh(&self) -> bool {
        !self.mesh.triangles.is_empty()
    }

    /// What a length is: the column of the luminance in the view's table.
    fn length(&self) -> String {
        self.names.column("luminance")
    }

    /// Where the vertices stand.
    fn places(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.mesh
            .vertices
            .iter()
            .map(|Vertex { direction, value }| {
                let cosine = if self.with_cosine {
                    direction.z.abs()
                } else {
                    1.0
                };
                *direction * (Channel::Luminance.of(*value) * cosine)
            })
    }
}

/// The lobes as an OBJ file, an object each; its numbers have all their digits.
#[must_use]
pub fn obj(lobes: &[Named]) -> String {
    let mut text = String::new();
    let length = lobes.first().map_or_else(String::new, Named::length);
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "# Lobes: direction times {length}, a unit of length is 1/sr; x = s, y = t, z = n"
    );
    for lobe in lobes {
        for arrow in lobe.deltas.iter() {
            let (w, [r, g, b]) = (arrow.direction, arrow.flux);
            // A name may not end the comment.
            let name = lobe.name.replace(char::is_control, " ");
            let _ = writeln!(
                text,
                "# Delta of {name}: direction {} {} {}, share of the flux {r} {g} {b}",
                w.x, w.y, w.z
            );
        }
    }
    // Indices count from 1 through the whole file.
    let mut first = 1;
    for lobe in lobes.iter().filter(|lobe| lobe.has_mesh()) {
        let _ = writeln!(text, "o {}", lobe.name.replace(char::is_whitespace, "_"));
        for place in lobe.places() {
            let _ = writeln!(text, "v {} {} {}", place.x, place.y, place.z);
        }
        for [a, b, c] in &lobe.mesh.triangles {
            let _ = writeln!(text, "f {} {} {}", a + first, b + first, c + first);
        }
        first += lobe.mesh.vertices.len() as u32;
    }
    text
}

/// What glTF calls a component of 32 bits: floating-point, and an unsigned integer.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;

/// A turn about x that brings n upwards: a quaternion x, y, z, w.
const N_UPWARDS: [f64; 4] = [
    -std::f64::consts::FRAC_1_SQRT_2,
    0.0,
    0.0,
    std::f64::consts::FRAC_1_SQRT_2,
];

/// The lobes as a glTF file that holds its buffer, a node each.
#[must_use]
pub fn gltf(lobes: &[Named]) -> String {
    let mut bytes: Vec<u8> = Vec::new();
    let (mut views, mut accessors) = (Vec::new(), Vec::new());
    let (mut meshes, mut materials, mut nodes) = (Vec::new(), Vec::new(), Vec::new());
    for lobe in lobes {
        let deltas = lobe
            .deltas
            .iter()
            .map(|arrow| json!({ "direction": arrow.direction.to_array(), "share": arrow.flux }));
        let extras = json!({
            "length": lobe.length(), "unit": "1/sr", "deltas": deltas.collect::<Vec<_>>(),
        });
        if !lobe.has_mesh() {
            nodes.push(json!({ "name": lobe.name, "extras": extras }));
            continue;
        }
        let index = meshes.len();
        let start = bytes.len();
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for place in lobe.places() {
            let place = [place.x as f32, place.y as f32, place.z as f32];
            for ((low, high), x) in low.iter_mut().zip(&mut high).zip(place) {
                (*low, *high) = (low.min(x), high.max(x));
                bytes.extend(x.to_le_bytes());
            }
        }
        views.push(view(start, bytes.len()));
        accessors.push(json!({
            "bufferView": 2 * index, "componentType": FLOAT, "count": lobe.mesh.vertices.len(),
            "type": "VEC3", "min": low, "max": high,
        }));
        let start = bytes.len();
        for corner in lobe.mesh.triangles.iter().flatten() {
            bytes.extend(corner.to_le_bytes());
        }
        views.push(view(start, bytes.len()));
        accessors.push(json!({
            "bufferView": 2 * index + 1, "componentType": UNSIGNED_INT,
            "count": 3 * lobe.mesh.triangles.len(), "type": "SCALAR",
        }));
        let [r, g, b] = lobe.color;
        materials.push(json!({
            "name": lobe.name, "doubleSided": true,
            "pbrMetallicRoughness": { "baseColorFactor": [r, g, b, 1.0], "metallicFactor": 0.0 },
        }));
        let primitive = json!({
            "attributes": { "POSITION": 2 * index }, "indices": 2 * index + 1, "material": index,
        });
        meshes.push(json!({ "name": lobe.name, "primitives": [primitive] }));
        nodes.push(json!({
            "name": lobe.name, "mesh": index, "rotation": N_UPWARDS, "extras": extras,
        }));
    }
    let uri = format!(
        "data:application/octet-stream;base64,{}",
        STANDARD.encode(&bytes)
    );
    let scene: Vec<usize> = (0..lobes.len()).collect();
    json!({
        "asset": { "version": "2.0", "generator": "BRDF Explorer" },
        "scene": 0,
        "scenes": [{ "nodes": scene }],
        "nodes": nodes, "meshes": meshes, "materials": materials,
        "accessors": accessors, "bufferViews": views,
        "buffers": [{ "byteLength": bytes.len(), "uri": uri }],
    })
    .to_string()
}

fn view(start: usize, end: usize) -> Value {
    json!({ "buffer": 0, "byteOffset": start, "byteLength": end - start })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Session;
    use crate::views::Scale;

    fn lobe() -> Named {
        let vertex = |direction, value| Vertex {
            direction,
            value: [value; 3],
        };
        Named {
            name: "Two words".to_owned(),
            color: [0.5; 3],
            mesh: Arc::new(Mesh {
                vertices: vec![
                    vertex(DVec3::X, 0.1),
                    vertex(DVec3::Y, 0.2),
                    vertex(DVec3::Z, 0.3),
                ],
                triangles: vec![[0, 1, 2]],
                ..Mesh::default()
            }),
            with_cosine: false,
            names: Names::of_lobe(&Session::default(), Scale::default()),
            deltas: Arc::default(),
        }
    }

    #[test]
    fn objects_count_their_vertices_through_the_file() {
        let text = obj(&[lobe(), lobe()]);
        assert!(text.contains("o Two_words\nv "));
        let faces: Vec<&str> = text.lines().filter(|line| line.starts_with('f')).collect();
        assert_eq!(faces, ["f 1 2 3", "f 4 5 6"]);
        let third = text
            .lines()
            .filter(|line| line.starts_with('v'))
            .nth(2)
            .unwrap();
        let z: f64 = third.rsplit(' ').next().unwrap().parse().unwrap();
        assert!((z - 0.3).abs() < 1e-15);
    }

    #[test]
    fn the_buffer_of_a_gltf_file_holds_what_its_accessors_say() {
        let file: Value = serde_json::from_str(&gltf(&[lobe(), lobe()])).unwrap();
        let uri = file["buffers"][0]["uri"].as_str().unwrap();
        let bytes = STANDARD.decode(uri.split_once(',').unwrap().1).unwrap();
        assert_eq!(file["buffers"][0]["byteLength"], bytes.len());
        // Three places and three indices of four bytes each, twice.
        assert_eq!(bytes.len(), 2 * (3 * 3 * 4 + 3 * 4));
        let last = &file["bufferViews"][3];
        let end = last["byteOffset"].as_u64().unwrap() + last["byteLength"].as_u64().unwrap();
        assert_eq!(end, bytes.len() as u64);
        assert_eq!(file["accessors"][0]["max"][2].as_f64().unwrap() as f32, 0.3);
        assert_eq!(file["nodes"].as_array().unwrap().len(), 2);
    }
}
