//! `<geometry>`: positions, and triangles (`<triangles>`, `<polylist>`, `<polygons>`,
//! `<tristrips>`, `<trifans>`) whose corners index positions, normals and texture coordinates.

use super::document::{Dae, Impact, Node, child, children};
use super::label;
use super::sources::{Input, Source, Sources, inputs, integers};
use crate::io::Diagnostic;
use glam::Vec3;
use std::rc::Rc;

/// A mesh as the file has it, in its own space.
pub(super) struct Geometry {
    pub name: String,
    pub positions: Vec<Vec3>,
    pub primitives: Vec<Primitive>,
}

/// `<vertices>`: inputs that share one index.
struct Vertices<'a> {
    pub id: &'a str,
    pub others: Vec<(Input<'a>, Rc<Source>)>,
}

/// Reads a `<geometry>`.
///
/// # Errors
/// If it is no mesh or has no positions. Triangles that cannot be read are warnings.
pub(super) fn read_geometry<'a>(
    dae: &Dae<'a>,
    sources: &mut Sources,
    node: Node<'a>,
) -> Result<Geometry, Diagnostic> {
    let Some(mesh) = child(node, "mesh") else {
        let message = format!(
            "expected <mesh> in {}: other kinds are not read",
            label(node)
        );
        return Err(dae.error(node, message));
    };
    let vertices = dae.child(mesh, "vertices")?;
    let mut positions = None;
    let mut others = Vec::new();
    for input in inputs(dae, vertices)? {
        match input.semantic {
            "POSITION" => positions = Some(sources.floats(dae, input.node, 3)?),
            semantic => {
                if let Some(columns) = columns(semantic)
                    && let Some(source) =
                        dae.or_warn(Impact::Color, sources.floats(dae, input.node, columns))
                {
                    others.push((input, source));
                }
            }
        }
    }
    let Some(positions) = positions else {
        return Err(dae.error(
            vertices,
            "expected an <input> with the POSITION, found none",
        ));
    };
    let positions: Vec<Vec3> = positions.rows().map(Vec3::from_array).collect();
    if positions.is_empty() {
        return Err(dae.error(node, "expected positions, found none"));
    }
    let vertices = Vertices {
        id: vertices.attribute("id").unwrap_or_default(),
        others,
    };
    let primitives = mesh
        .children()
        .filter(Node::is_element)
        .filter_map(|node| {
            dae.or_warn(
                Impact::Shape,
                read_primitive(dae, sources, node, &vertices, &positions),
            )
        })
        .flatten()
        .filter(|primitive| !primitive.positions.is_empty())
        .collect();
    let name = node.attribute("name").or(node.attribute("id"));
    Ok(Geometry {
        name: name.unwrap_or("Mesh").to_owned(),
        positions,
        primitives,
    })
}

/// Triangles with one material.
pub(super) struct Primitive {
    /// The symbol that the instance binds a material to.
    pub material: Option<String>,
    /// Position of each corner, three a triangle, below the number of positions.
    pub positions: Vec<u32>,
    /// The normals, if there are any.
    pub normals: Option<Attribute>,
    /// Texture coordinates by their set.
    pub texture: Vec<(usize, Attribute)>,
}

/// A property of corners.
pub(super) struct Attribute {
    pub source: Rc<Source>,
    /// A row of the source for each corner, below its number of rows.
    pub rows: Vec<u32>,
}

/// How many columns an input of use must have; `None` for one that is of no use.
fn columns(semantic: &str) -> Option<usize> {
    match semantic {
        "NORMAL" => Some(3),
        "TEXCOORD" => Some(2),
        _ => None,
    }
}

/// Reads `node`, a child of `<mesh>`; `None` if it has no triangles.
///
/// # Errors
/// If its indices are no numbers or have no positions.
fn read_primitive<'a>(
    dae: &Dae<'a>,
    sources: &mut Sources,
    node: Node<'a>,
    vertices: &Vertices<'a>,
    positions: &[Vec3],
) -> Result<Option<Primitive>, Diagnostic> {
    match node.tag_name().name() {
        "triangles" | "polylist" | "polygons" | "tristrips" | "trifans" => {}
        "source" | "vertices" | "extra" => return Ok(None),
        other => {
            dae.ignore(other);
            return Ok(None);
        }
    }
    let layout = Layout::read(dae, sources, node, vertices)?;
    let mut indices = Indices {
        stride: layout.stride,
        position: layout.position,
        values: Vec::new(),
        corners: Vec::new(),
    };
    indices.read(dae, node, positions)?;
    Ok(Some(layout.gather(dae, node, &indices, positions.len())))
}

/// Which index of a corner is what.
struct Layout<'a> {
    stride: usize,
    position: usize,
    normals: Option<(usize, Rc<Source>)>,
    texture: Vec<(usize, usize, Rc<Source>)>,
    material: Option<&'a str>,
}

impl<'a> Layout<'a> {
    fn read(
        dae: &Dae<'a>,
        sources: &mut Sources,
        node: Node<'a>,
        vertices: &Vertices<'a>,
    ) -> Result<Self, Diagnostic> {
        let inputs = inputs(dae, node)?;
        let stride = inputs.iter().map(|input| input.offset + 1).max();
        let vertex = inputs.iter().find(|input| input.semantic == "VERTEX");
        let (Some(stride), Some(vertex)) = (stride, vertex) else {
            return Err(dae.error(node, "expected an <input> with the VERTEX, found none"));
        };
        if vertex
            .node
            .attribute("source")
            .and_then(|url| url.strip_prefix('#'))
            != Some(vertices.id)
        {
            return Err(dae.error(
                vertex.node,
                "expected a reference to this mesh's <vertices>",
            ));
        }
        let mut layout = Self {
            stride,
            position: vertex.offset,
            normals: None,
            texture: Vec::new(),
            material: node.attribute("material"),
        };
        for (input, source) in &vertices.others {
            layout.add(input, vertex.offset, source.clone());
        }
        for input in &inputs {
            match (input.semantic, columns(input.semantic)) {
                ("VERTEX", _) => {}
                (_, Some(columns)) => {
                    if let Some(source) =
                        dae.or_warn(Impact::Color, sources.floats(dae, input.node, columns))
                    {
                        layout.add(input, input.offset, source);
                    }
                }
                (other, None) => dae.ignore(format!("input {other}")),
            }
        }
        Ok(layout)
    }

    fn add(&mut self, input: &Input, offset: usize, source: Rc<Source>) {
        if input.semantic == "NORMAL" {
            self.normals = Some((offset, source));
        } else {
            self.texture.push((input.set, offset, source));
        }
    }

    /// The corners of all triangles whose indices exist.
    fn gather(self, dae: &Dae, node: Node, indices: &Indices, positions: usize) -> Primitive {
        let limits: Vec<(usize, usize)> = std::iter::once((self.position, positions))
            .chain(
                self.normals
                    .iter()
                    .map(|(offset, source)| (*offset, source.len())),
            )
            .chain(
                self.texture
                    .iter()
                    .map(|(_, offset, source)| (*offset, source.len())),
            )
            .collect();
        let exists = |corner: &u32| {
            limits
                .iter()
                .all(|&(offset, limit)| (indices.get(*corner, offset) as usize) < limit)
        };
        let mut corners = Vec::with_capacity(indices.corners.len());
        let mut left_out = 0;
        for triangle in &indices.corners {
            if triangle.iter().all(exists) {
                corners.extend_from_slice(triangle);
            } else {
                left_out += 1;
            }
        }
        if left_out > 0 {
            let message = format!(
                "expected indices of values that exist, found others in {left_out} triangles: left out"
            );
            dae.warn(Impact::Shape, node, message);
        }
        let rows = |offset| -> Vec<u32> {
            corners
                .iter()
                .map(|&corner| indices.get(corner, offset))
                .collect()
        };
        Primitive {
            material: self.material.map(str::to_owned),
            positions: rows(self.position),
            normals: self.normals.map(|(offset, source)| Attribute {
                rows: rows(offset),
                source,
            }),
            texture: self
                .texture
                .into_iter()
                .map(|(set, offset, source)| {
                    let rows = rows(offset);
                    (set, Attribute { source, rows })
                })
                .collect(),
        }
    }
}

/// The numbers of all `<p>`, and the triangles that they make.
struct Indices {
    stride: usize,
    position: usize,
    values: Vec<u32>,
    /// Corners as numbers of vertices in `values`.
    corners: Vec<[u32; 3]>,
}

impl Indices {
    fn get(&self, corner: u32, offset: usize) -> u32 {
        self.values[corner as usize * self.stride + offset]
    }

    /// Adds the numbers of one `<p>`, whole vertices only, and says which they are.
    fn push(&mut self, dae: &Dae, p: Node) -> Result<std::ops::Range<u32>, Diagnostic> {
        let start = self.values.len() / self.stride;
        self.values.extend(integers::<u32>(dae, p)?);
        let over = self.values.len() % self.stride;
        if over != 0 {
            let stride = self.stride;
            dae.warn(
                Impact::Shape,
                p,
                format!("expected {stride} indices a vertex, found {over} left over"),
            );
            self.values.truncate(self.values.len() - over);
        }
        Ok(start as u32..(self.values.len() / self.stride) as u32)
    }

    fn read<'a>(
        &mut self,
        dae: &Dae<'a>,
        node: Node<'a>,
        positions: &[Vec3],
    ) -> Result<(), Diagnostic> {
        match node.tag_name().name() {
            "polylist" => return self.polylist(dae, node, positions),
            "polygons" => {
                for holed in children(node, "ph") {
                    dae.ignore("hole in a polygon");
                    let p = dae.child(holed, "p")?;
                    let corners = self.push(dae, p)?;
                    self.polygon(dae, corners, positions);
                }
                for p in children(node, "p") {
                    let corners = self.push(dae, p)?;
                    self.polygon(dae, corners, positions);
                }
            }
            kind => {
                for p in children(node, "p") {
                    let corners = self.push(dae, p)?;
                    self.triangles(kind, corners);
                }
            }
        }
        Ok(())
    }

    fn triangles(&mut self, kind: &str, corners: std::ops::Range<u32>) {
        let (start, count) = (corners.start, corners.end - corners.start);
        match kind {
            "tristrips" => self.corners.extend((2..count).map(|i| {
                let [a, b, c] = [start + i - 2, start + i - 1, start + i];
                if i % 2 == 0 { [a, b, c] } else { [b, a, c] }
            })),
            "trifans" => self
                .corners
                .extend((2..count).map(|i| [start, start + i - 1, start + i])),
            _ => self
                .corners
                .extend((0..count / 3).map(|i| [0, 1, 2].map(|k| start + 3 * i + k))),
        }
    }

    fn polylist<'a>(
        &mut self,
        dae: &Dae<'a>,
        node: Node<'a>,
        positions: &[Vec3],
    ) -> Result<(), Diagnostic> {
        let counts = integers::<u32>(dae, dae.child(node, "vcount")?)?;
        let Some(p) = child(node, "p") else {
            return Ok(());
        };
        let all = self.push(dae, p)?;
        let mut start = all.start;
        for count in counts {
            let Some(end) = start.checked_add(count).filter(|&end| end <= all.end) else {
                let found = all.end - all.start;
                let message =
                    format!("expected <p> as long as <vcount> says, found {found} vertices");
                dae.warn(Impact::Shape, p, message);
                break;
            };
            self.polygon(dae, start..end, positions);
            start = end;
        }
        Ok(())
    }

    fn polygon(&mut self, dae: &Dae, corners: std::ops::Range<u32>, positions: &[Vec3]) {
        let start = corners.start;
        let count = (corners.end - start) as usize;
        if count <= 3 {
            let count = count as u32;
            return self.triangles("trifans", start..start + count);
        }
        let place = |corner| {
            positions
                .get(self.get(corner, self.position) as usize)
                .copied()
        };
        let outline: Vec<Vec3> = corners.map(|c| place(c).unwrap_or_default()).collect();
        let triangles = dae.cutter.borrow_mut().cut(&outline);
        self.corners.extend(
            triangles
                .iter()
                .map(|t| t.map(|corner| start + corner as u32)),
        );
    }
}
