//! Instances of meshes and skins in the scene, and the joints that skins name.

use super::document::{Dae, Impact, MOST_BOUND, MOST_INSTANCES, Node, children};
use super::meshes::Geometry;
use super::quoted;
use super::skin::{self, Controller, Geometries, Skin};
use super::sources::text;
use super::visual_scene::{SceneNode, subtree};
use crate::io::Diagnostic;
use crate::steps::Pace;
use roxmltree::NodeId;
use std::collections::HashMap;
use std::rc::Rc;

/// A mesh in the scene.
pub(super) struct Instance<'a> {
    /// Its node, in the flat list.
    pub node: usize,
    /// `<instance_geometry>` or `<instance_controller>`.
    pub xml: Node<'a>,
    pub geometry: Rc<Geometry>,
    pub binding: Option<Binding<'a>>,
}

/// Bytes that a position with its corners takes in a file, about.
const BYTES: usize = 64;

impl Instance<'_> {
    /// Estimate of the bytes that were read for it.
    pub fn bytes(&self) -> usize {
        BYTES * self.geometry.positions.len()
    }

    /// How much it binds to the mesh, whose own size is counted elsewhere.
    fn bound(&self) -> usize {
        let skin = self.binding.as_ref().map(|binding| &binding.skin);
        let of_skin = skin.map_or(0, |skin| skin.joints.len() + skin.weights.len());
        self.xml.descendants().count() + of_skin
    }
}

/// Binding of a skin to nodes of the scene.
pub(super) struct Binding<'a> {
    pub skin: Rc<Skin<'a>>,
    /// The nodes that `<skeleton>` names.
    pub skeletons: Vec<usize>,
    /// The node of each joint of the skin's list, where there is one.
    pub joints: Vec<Option<usize>>,
}

impl Binding<'_> {
    /// The joint of a rig that each of the skin's list is, with the rig's joint of each node; `None` for what is none.
    pub fn rig_joints(&self, joint_of_node: &HashMap<usize, u32>) -> Vec<Option<u32>> {
        let nodes = self.joints.iter();
        nodes
            .map(|node| joint_of_node.get(&(*node)?).copied())
            .collect()
    }
}

/// All meshes of the scene, in the order of the document. Nodes that a skin calls its joints
/// become joints.
///
/// # Errors
/// If there are too many, or too much is bound by them.
pub(super) async fn collect<'a>(
    dae: &Dae<'a>,
    nodes: &mut [SceneNode<'a>],
    pace: &Pace,
) -> Result<Vec<Instance<'a>>, Diagnostic> {
    let mut reader = Reader {
        dae,
        geometries: Geometries::default(),
        controllers: HashMap::new(),
        lookup: Lookup::new(nodes),
    };
    let mut instances: Vec<Instance> = Vec::new();
    let mut bound = 0;
    for (at, node) in nodes.iter().enumerate() {
        for xml in node.xml.children().filter(Node::is_element) {
            let Some(instance) = reader.instance(nodes, at, xml) else {
                continue;
            };
            pace.tell(at as f32 / nodes.len() as f32);
            pace.after(instance.bytes()).await;
            bound += instance.bound();
            instances.push(instance);
            if instances.len() > MOST_INSTANCES {
                let message =
                    format!("expected at most {MOST_INSTANCES} meshes in a scene, found more");
                return Err(dae.error(xml, message));
            }
            if bound > MOST_BOUND {
                let message =
                    format!("expected at most {MOST_BOUND} joints and weights, found more");
                return Err(dae.error(xml, message));
            }
        }
    }
    let bindings = instances
        .iter()
        .filter_map(|instance| instance.binding.as_ref());
    for &joint in bindings.flat_map(|binding| &binding.joints).flatten() {
        nodes[joint].is_joint = true;
    }
    Ok(instances)
}

struct Reader<'d, 'a> {
    dae: &'d Dae<'a>,
    geometries: Geometries,
    controllers: HashMap<NodeId, Option<Controller<'a>>>,
    lookup: Lookup<'a>,
}

impl<'a> Reader<'_, 'a> {
    fn instance(
        &mut self,
        nodes: &[SceneNode<'a>],
        node: usize,
        xml: Node<'a>,
    ) -> Option<Instance<'a>> {
        let dae = self.dae;
        let (geometry, binding) = match xml.tag_name().name() {
            "instance_geometry" => {
                let target =
                    dae.or_warn(Impact::Shape, dae.target_called(xml, "url", "geometry"))?;
                (self.geometries.get(dae, target)?, None)
            }
            "instance_controller" => {
                let target =
                    dae.or_warn(Impact::Shape, dae.target_called(xml, "url", "controller"))?;
                match self.controller(target)? {
                    Controller::Morph(geometry) => (geometry, None),
                    Controller::Skin(skin) => {
                        let binding = self.lookup.bind(dae, nodes, xml, &skin);
                        (skin.geometry.clone(), Some(binding))
                    }
                }
            }
            _ => return None,
        };
        Some(Instance {
            node,
            xml,
            geometry,
            binding,
        })
    }

    fn controller(&mut self, node: Node<'a>) -> Option<Controller<'a>> {
        if let Some(known) = self.controllers.get(&node.id()) {
            return known.clone();
        }
        let read = skin::read(self.dae, &mut self.geometries, node);
        let controller = self.dae.or_warn(Impact::Shape, read).flatten();
        self.controllers.insert(node.id(), controller.clone());
        controller
    }
}

/// Finds nodes of the scene by element and by sid.
struct Lookup<'a> {
    by_element: HashMap<NodeId, usize>,
    by_sid: HashMap<&'a str, Vec<usize>>,
    /// Joints by sid below the skeletons last asked for: most skins of a file share them.
    scope: (Vec<usize>, HashMap<&'a str, usize>),
}

impl<'a> Lookup<'a> {
    fn new(nodes: &[SceneNode<'a>]) -> Self {
        let mut lookup = Self {
            by_element: HashMap::new(),
            by_sid: HashMap::new(),
            scope: (Vec::new(), HashMap::new()),
        };
        for (at, node) in nodes.iter().enumerate() {
            lookup.by_element.entry(node.xml.id()).or_insert(at);
            if let Some(sid) = node.xml.attribute("sid") {
                lookup.by_sid.entry(sid).or_default().push(at);
            }
        }
        lookup
    }

    fn bind(
        &mut self,
        dae: &Dae<'a>,
        nodes: &[SceneNode<'a>],
        instance: Node<'a>,
        skin: &Rc<Skin<'a>>,
    ) -> Binding<'a> {
        let mut skeletons = Vec::new();
        // A skeleton that is not there changes nothing: joints that are missing for it are told.
        for skeleton in children(instance, "skeleton") {
            let target = dae.or_warn(Impact::None, dae.by_url(skeleton, text(skeleton)));
            match target.map(|target| self.by_element.get(&target.id())) {
                Some(Some(&node)) => skeletons.push(node),
                Some(None) => dae.warn(
                    Impact::None,
                    skeleton,
                    "expected a node of the scene, found none",
                ),
                None => {}
            }
        }
        self.look_below(nodes, &skeletons);
        let mut elsewhere = 0;
        let joints = skin
            .joints
            .iter()
            .map(|&name| {
                let in_scope = if skin.joints_are_ids {
                    self.by_id(dae, name)
                } else {
                    self.in_scope(name, &skeletons)
                };
                let found = in_scope.or_else(|| {
                    let found = self.anywhere(dae, name);
                    elsewhere += usize::from(found.is_some());
                    found
                });
                if found.is_none() {
                    let name = quoted(name);
                    dae.warn(Impact::Shape, instance, format!("expected the joint {name} below <skeleton>, found none: its weights are left out"));
                }
                found
            })
            .collect();
        if elsewhere > 0 {
            dae.warn(
                Impact::None,
                instance,
                format!("expected all joints below <skeleton>, found {elsewhere} elsewhere"),
            );
        }
        Binding {
            skin: skin.clone(),
            skeletons,
            joints,
        }
    }

    fn look_below(&mut self, nodes: &[SceneNode<'a>], skeletons: &[usize]) {
        if self.scope.0 == skeletons {
            return;
        }
        let mut sids = HashMap::new();
        for node in skeletons.iter().flat_map(|&root| subtree(nodes, root)) {
            if let Some(sid) = nodes[node].xml.attribute("sid") {
                sids.entry(sid).or_insert(node);
            }
        }
        self.scope = (skeletons.to_vec(), sids);
    }

    /// The node with this sid below the skeletons; in a file without `<skeleton>` the first.
    fn in_scope(&self, sid: &str, skeletons: &[usize]) -> Option<usize> {
        if skeletons.is_empty() {
            return self.by_sid.get(sid)?.first().copied();
        }
        self.scope.1.get(sid).copied()
    }

    fn by_id(&self, dae: &Dae<'a>, id: &str) -> Option<usize> {
        self.by_element.get(&dae.by_id(id)?.id()).copied()
    }

    /// Where a file means a joint in a wrong way: a sid outside the skeleton that only one node
    /// has, an id where a sid belongs, or the other way round.
    fn anywhere(&self, dae: &Dae<'a>, name: &str) -> Option<usize> {
        match self.by_sid.get(name).map(Vec::as_slice) {
            Some([only]) => Some(*only),
            _ => self.by_id(dae, name),
        }
    }
}
