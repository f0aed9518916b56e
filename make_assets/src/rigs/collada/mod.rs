//! The text of a Collada 1.4.1 file, written the way that exporters write theirs: joints with
//! oriented matrices, inverse bind matrices, the tips of bones as `<extra>`, materials by symbol.
mod numbers;
mod skin;

use super::super::text::number;
use super::model::{Bone, Rig, Up};
use glam::{DMat3, DMat4, DVec3};
use numbers::matrix;
use std::fmt::Write;

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
        skin::geometry(&mut out, rig, skin);
    }
    out.push_str("</library_geometries>\n<library_controllers>\n");
    for skin in &rig.skins {
        skin::controller(&mut out, rig, skin);
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
