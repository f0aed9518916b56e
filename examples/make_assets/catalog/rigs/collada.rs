//! The text of a Collada 1.4.1 file, written the way that exporters write theirs: joints with
//! oriented matrices, inverse bind matrices, the tips of bones as `<extra>`, materials by symbol.
use super::super::text::number;
use super::model::{Bone, Rig, Skin, Up};
use glam::{DMat3, DMat4, DVec3};
use std::collections::HashMap;
use std::fmt::{Display, Write};

/// Where lists of numbers are broken into lines.
const LINE: usize = 110;

/// The whole file.
pub fn text(rig: &Rig) -> String {
    let up = if rig.up == Up::Z { "Z_UP" } else { "Y_UP" };
    let unit = if rig.unit == 0.01 {
        "centimeter"
    } else {
        "meter"
    };
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n");
    let _ = write!(
        out,
        r#"<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>
<contributor><authoring_tool>editor make_assets</authoring_tool></contributor>
<created>2026-01-01T00:00:00</created>
<modified>2026-01-01T00:00:00</modified>
<unit name="{unit}" meter="{}"/>
<up_axis>{up}</up_axis>
</asset>
"#,
        rig.unit
    );
    materials(&mut out, rig);
    out.push_str("<library_geometries>\n");
    for skin in &rig.skins {
        geometry(&mut out, rig, skin);
    }
    out.push_str("</library_geometries>\n<library_controllers>\n");
    for skin in &rig.skins {
        controller(&mut out, rig, skin);
    }
    out.push_str("</library_controllers>\n");
    scene(&mut out, rig);
    out.push_str("</COLLADA>\n");
    out
}

/// What a name is where no blanks may be.
fn id(name: &str) -> String {
    name.replace(' ', "_")
}

impl Rig {
    /// A direction or place of ours in the file's axes and unit.
    fn to_file(&self, p: DVec3) -> DVec3 {
        let p = p / self.unit;
        match self.up {
            Up::Y => p,
            Up::Z => DVec3::new(p.x, -p.z, p.y),
        }
    }

    /// Decimals that carry tenths of a millimeter.
    fn decimals(&self) -> usize {
        if self.unit < 0.1 { 2 } else { 4 }
    }

    /// Where a bone's joint lies in the file, its +Y along the bone.
    fn file_from_joint(&self, bone: &Bone) -> DMat4 {
        let head = self.to_file(bone.head);
        let y = (self.to_file(bone.tail) - head).normalize_or(DVec3::Y);
        let helper = if y.z.abs() > 0.9 { DVec3::X } else { DVec3::Z };
        let x = y.cross(helper).normalize_or(DVec3::X);
        let mut matrix = DMat4::from_mat3(DMat3::from_cols(x, y, x.cross(y)));
        matrix.w_axis = head.extend(1.0);
        matrix
    }
}

/// A 4×4 matrix by rows.
fn matrix(m: DMat4) -> String {
    let rows = m.transpose().to_cols_array();
    rows.map(|x| number(x, 7)).join(" ")
}

/// Words in lines that are not too long.
fn lines<T: Display>(words: impl IntoIterator<Item = T>) -> String {
    let mut out = String::new();
    let mut length = 0;
    for word in words {
        let word = word.to_string();
        if length + word.len() >= LINE {
            out.push('\n');
            length = 0;
        } else if !out.is_empty() {
            out.push(' ');
        }
        length += word.len() + 1;
        out.push_str(&word);
    }
    out
}

fn vector(v: DVec3, decimals: usize) -> String {
    v.to_array().map(|x| number(x, decimals)).join(" ")
}

/// A `<source>` of rows of numbers.
fn float_source(out: &mut String, id: &str, columns: &[&str], rows: &[String]) {
    let count = rows.len() * columns.len();
    let kind = |name: &&str| {
        if *name == "TRANSFORM" {
            "float4x4"
        } else {
            "float"
        }
    };
    let stride = if columns == ["TRANSFORM"] {
        16
    } else {
        columns.len()
    };
    let count = if stride == 16 { rows.len() * 16 } else { count };
    let params: String = columns
        .iter()
        .map(|name| format!(r#"<param name="{name}" type="{}"/>"#, kind(name)))
        .collect();
    let _ = writeln!(
        out,
        r##"<source id="{id}">
<float_array id="{id}-array" count="{count}">{}</float_array>
<technique_common><accessor source="#{id}-array" count="{}" stride="{stride}">{params}</accessor></technique_common>
</source>"##,
        lines(rows),
        rows.len(),
    );
}

/// Rows that are written once each, and the index of each that was asked for.
#[derive(Default)]
struct Distinct {
    rows: Vec<String>,
    known: HashMap<String, usize>,
}

impl Distinct {
    fn index(&mut self, row: String) -> usize {
        let rows = &mut self.rows;
        *self.known.entry(row).or_insert_with_key(|row| {
            rows.push(row.clone());
            rows.len() - 1
        })
    }
}

fn materials(out: &mut String, rig: &Rig) {
    let textures = || rig.materials.iter().filter_map(|m| Some((m, m.texture?)));
    if textures().next().is_some() {
        out.push_str("<library_images>\n");
        for (material, file) in textures() {
            let id = id(material.name);
            let _ = writeln!(
                out,
                r#"<image id="{id}-image" name="{id}"><init_from>{file}</init_from></image>"#
            );
        }
        out.push_str("</library_images>\n");
    }
    out.push_str("<library_effects>\n");
    for material in &rig.materials {
        let id = id(material.name);
        let (parameters, diffuse) = if material.texture.is_some() {
            (
                format!(
                    r#"<newparam sid="{id}-surface"><surface type="2D"><init_from>{id}-image</init_from></surface></newparam>
<newparam sid="{id}-sampler"><sampler2D><source>{id}-surface</source></sampler2D></newparam>
"#
                ),
                format!(r#"<texture texture="{id}-sampler" texcoord="UVMap"/>"#),
            )
        } else {
            let [r, g, b] = material.color.map(|c| number(c, 4));
            (
                String::new(),
                format!(r#"<color sid="diffuse">{r} {g} {b} 1</color>"#),
            )
        };
        let _ = writeln!(
            out,
            r#"<effect id="{id}-effect"><profile_COMMON>
{parameters}<technique sid="common"><lambert><diffuse>{diffuse}</diffuse></lambert></technique>
</profile_COMMON></effect>"#
        );
    }
    out.push_str("</library_effects>\n<library_materials>\n");
    for material in &rig.materials {
        let (id, name) = (id(material.name), material.name);
        let _ = writeln!(
            out,
            r##"<material id="{id}-material" name="{name}"><instance_effect url="#{id}-effect"/></material>"##
        );
    }
    out.push_str("</library_materials>\n");
}

fn geometry(out: &mut String, rig: &Rig, skin: &Skin) {
    let id = id(skin.name);
    let place = |&p: &DVec3| vector(rig.to_file(p), rig.decimals());
    let positions: Vec<String> = skin.positions.iter().map(place).collect();
    let (mut normals, mut pictures) = (Distinct::default(), Distinct::default());
    let has_picture = skin.faces.iter().any(|face| face.picture.is_some());
    let mut indices: Vec<Vec<String>> = rig.materials.iter().map(|_| Vec::new()).collect();
    for (face, normal) in skin.faces.iter().zip(skin.normals()) {
        for corner in 0..3 {
            let direction = rig.to_file(normal[corner]).normalize_or(DVec3::Y);
            let n = normals.index(vector(direction, 3));
            let mut word = format!("{} {n}", face.corners[corner]);
            if has_picture {
                let at = face.picture.map_or_else(Default::default, |p| p[corner]);
                let row = at.to_array().map(|x| number(x, 5)).join(" ");
                let _ = write!(word, " {}", pictures.index(row));
            }
            indices[face.material].push(word);
        }
    }
    let _ = writeln!(
        out,
        r#"<geometry id="{id}-mesh" name="{}"><mesh>"#,
        skin.name
    );
    let axes = ["X", "Y", "Z"];
    float_source(out, &format!("{id}-positions"), &axes, &positions);
    float_source(out, &format!("{id}-normals"), &axes, &normals.rows);
    if has_picture {
        float_source(out, &format!("{id}-map"), &["S", "T"], &pictures.rows);
    }
    let _ = writeln!(
        out,
        r##"<vertices id="{id}-vertices"><input semantic="POSITION" source="#{id}-positions"/></vertices>"##
    );
    for (material, words) in rig.materials.iter().zip(&indices) {
        if words.is_empty() {
            continue;
        }
        let map = if has_picture {
            format!(r##"<input semantic="TEXCOORD" source="#{id}-map" offset="2" set="0"/>"##)
        } else {
            String::new()
        };
        let _ = writeln!(
            out,
            r##"<triangles material="{}" count="{}">
<input semantic="VERTEX" source="#{id}-vertices" offset="0"/><input semantic="NORMAL" source="#{id}-normals" offset="1"/>{map}
<p>{}</p>
</triangles>"##,
            self::id(material.name),
            words.len() / 3,
            lines(words),
        );
    }
    out.push_str("</mesh></geometry>\n");
}

fn controller(out: &mut String, rig: &Rig, skin: &Skin) {
    let id = id(skin.name);
    let sids: Vec<String> = rig.bones.iter().map(|bone| self::id(&bone.name)).collect();
    let inverse = |bone: &Bone| matrix(rig.file_from_joint(bone).inverse());
    let inverse_binds: Vec<String> = rig.bones.iter().map(inverse).collect();
    let mut weights = Distinct::default();
    let mut pairs = Vec::new();
    for row in &skin.weights {
        for (joint, weight) in thousandths(row) {
            let weight = weights.index(number(f64::from(weight) / 1e3, 3));
            pairs.push(format!("{joint} {weight}"));
        }
    }
    let counts = skin.weights.iter().map(|row| thousandths(row).len());
    let _ = writeln!(
        out,
        r##"<controller id="{id}-skin" name="{}"><skin source="#{id}-mesh">
<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>
<source id="{id}-joints">
<Name_array id="{id}-joints-array" count="{count}">{}</Name_array>
<technique_common><accessor source="#{id}-joints-array" count="{count}" stride="1"><param name="JOINT" type="name"/></accessor></technique_common>
</source>"##,
        rig.name,
        lines(&sids),
        count = sids.len(),
    );
    float_source(out, &format!("{id}-binds"), &["TRANSFORM"], &inverse_binds);
    float_source(out, &format!("{id}-weights"), &["WEIGHT"], &weights.rows);
    let _ = writeln!(
        out,
        r##"<joints><input semantic="JOINT" source="#{id}-joints"/><input semantic="INV_BIND_MATRIX" source="#{id}-binds"/></joints>
<vertex_weights count="{}">
<input semantic="JOINT" source="#{id}-joints" offset="0"/><input semantic="WEIGHT" source="#{id}-weights" offset="1"/>
<vcount>{}</vcount>
<v>{}</v>
</vertex_weights>
</skin></controller>"##,
        skin.weights.len(),
        lines(counts),
        lines(pairs),
    );
}

/// Weights as whole thousandths that sum to exactly 1; what is missing goes to the largest.
fn thousandths(row: &[(usize, f64)]) -> Vec<(usize, i32)> {
    let round = |&(joint, weight): &(usize, f64)| (joint, (weight * 1e3).round() as i32);
    let mut rounded: Vec<(usize, i32)> = row.iter().map(round).filter(|w| w.1 > 0).collect();
    let missing = 1000 - rounded.iter().map(|w| w.1).sum::<i32>();
    if let Some(largest) = rounded.iter_mut().max_by_key(|w| w.1) {
        largest.1 += missing;
    }
    rounded
}

fn scene(out: &mut String, rig: &Rig) {
    let armature = id(rig.name);
    let _ = writeln!(
        out,
        r#"<library_visual_scenes><visual_scene id="Scene" name="Scene">
<node id="{armature}" name="{}" type="NODE">"#,
        rig.name
    );
    for (at, bone) in rig.bones.iter().enumerate() {
        if bone.parent.is_none() {
            joint(out, rig, at);
        }
    }
    let roots: String = rig
        .bones
        .iter()
        .filter(|bone| bone.parent.is_none())
        .map(|bone| format!("<skeleton>#{armature}-{}</skeleton>", id(&bone.name)))
        .collect();
    for skin in &rig.skins {
        let id = id(skin.name);
        let _ = writeln!(
            out,
            r##"<node id="{id}" name="{}" type="NODE"><instance_controller url="#{id}-skin">{roots}
<bind_material><technique_common>"##,
            skin.name
        );
        for (index, material) in rig.materials.iter().enumerate() {
            if skin.faces.iter().any(|face| face.material == index) {
                let id = self::id(material.name);
                let inside = match material.texture {
                    Some(_) => {
                        r#"<bind_vertex_input semantic="UVMap" input_semantic="TEXCOORD" input_set="0"/>"#
                    }
                    None => "",
                };
                let _ = writeln!(
                    out,
                    r##"<instance_material symbol="{id}" target="#{id}-material">{inside}</instance_material>"##
                );
            }
        }
        out.push_str("</technique_common></bind_material></instance_controller></node>\n");
    }
    out.push_str(
        "</node>\n</visual_scene></library_visual_scenes>\n\
         <scene><instance_visual_scene url=\"#Scene\"/></scene>\n",
    );
}

/// A joint and all below it.
fn joint(out: &mut String, rig: &Rig, at: usize) {
    let bone = &rig.bones[at];
    let world = rig.file_from_joint(bone);
    let local = bone.parent.map_or(world, |parent| {
        rig.file_from_joint(&rig.bones[parent]).inverse() * world
    });
    let (armature, sid) = (id(rig.name), id(&bone.name));
    let _ = writeln!(
        out,
        r#"<node id="{armature}-{sid}" name="{}" sid="{sid}" type="JOINT">
<matrix sid="transform">{}</matrix>"#,
        bone.name,
        matrix(local)
    );
    for (child, _) in rig
        .bones
        .iter()
        .enumerate()
        .filter(|(_, b)| b.parent == Some(at))
    {
        joint(out, rig, child);
    }
    let tip = rig.to_file(bone.tail) - rig.to_file(bone.head);
    let [x, y, z] = tip.to_array().map(|c| number(c, 6));
    let _ = writeln!(
        out,
        r#"<extra><technique profile="blender"><tip_x sid="tip_x" type="float">{x}</tip_x><tip_y sid="tip_y" type="float">{y}</tip_y><tip_z sid="tip_z" type="float">{z}</tip_z></technique></extra>
</node>"#
    );
}
