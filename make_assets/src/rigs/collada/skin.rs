//! A skin: its mesh, and the weights that bind it to the joints.
use super::super::super::text::number;
use super::super::model::{Bone, Rig, Skin};
use super::id;
use super::numbers::{Distinct, float_source, lines, matrix, vector};
use glam::DVec3;
use std::fmt::Write;

/// `<geometry>`: places, normals and what of the picture lies on each corner.
pub fn geometry(out: &mut String, rig: &Rig, skin: &Skin) {
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

/// `<controller>`: who moves each place, and where the joints are at rest.
pub fn controller(out: &mut String, rig: &Rig, skin: &Skin) {
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
