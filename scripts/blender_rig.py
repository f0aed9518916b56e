"""Builds a lizard from nothing in Blender and exports it as assets/rigs/lizard.dae.

The file holds what a real exporter writes: bones in Blender's axes with +Z up, several skins on
one armature, quantities of its own in <extra>. Blender 5 has no Collada exporter any more; with
the last one that has:

    pip install bpy==4.2.0      # Python 3.11
    python scripts/blender_rig.py [OUT.dae]
"""

import math
import re
import sys
from pathlib import Path

import bpy  # before what it brings along
import bmesh
from mathutils import Matrix, Vector

OUT = Path(__file__).resolve().parent.parent / "assets" / "rigs" / "lizard.dae"

# The lizard looks along -Y, as characters do in Blender; lengths in meters, its left is +X.
SPINE = [  # name of the bone that starts here, place, half width, half height
    ("Tail 6", (0.10, 1.42, 0.020), 0.006, 0.006),
    ("Tail 5", (0.17, 1.24, 0.032), 0.018, 0.018),
    ("Tail 4", (0.13, 1.02, 0.045), 0.030, 0.030),
    ("Tail 3", (0.00, 0.82, 0.062), 0.044, 0.043),
    ("Tail 2", (-0.09, 0.62, 0.085), 0.060, 0.058),
    ("Tail 1", (-0.06, 0.42, 0.112), 0.078, 0.072),
    ("Hips", (0.00, 0.24, 0.135), 0.098, 0.084),
    ("Back 1", (0.03, 0.06, 0.145), 0.118, 0.094),
    ("Back 2", (0.02, -0.14, 0.150), 0.120, 0.094),
    ("Back 3", (-0.01, -0.32, 0.155), 0.104, 0.084),
    ("Neck", (-0.02, -0.46, 0.172), 0.078, 0.068),
    ("Head", (-0.01, -0.57, 0.196), 0.086, 0.070),
    ("Snout", (0.01, -0.70, 0.190), 0.070, 0.048),
    ("Nose", (0.02, -0.79, 0.180), 0.040, 0.028),
]
LEGS = {  # from where, then knee or elbow, ankle or wrist, sole
    "front": ("Back 3", [(0.06, -0.30, 0.140), (0.215, -0.235, 0.135), (0.245, -0.395, 0.040), (0.262, -0.455, 0.020)]),
    "hind": ("Hips", [(0.06, 0.22, 0.125), (0.225, 0.130, 0.140), (0.275, 0.300, 0.040), (0.300, 0.235, 0.020)]),
}
LEG_RADII = [0.058, 0.044, 0.028, 0.026]
TOES = [-58, -18, 20, 64]  # degrees from where the foot points
COLORS = {
    "Back": (0.10, 0.36, 0.24),
    "Flank": (0.50, 0.70, 0.16),
    "Belly": (0.86, 0.83, 0.58),
    "Eye": (0.95, 0.58, 0.10),
    "Pupil": (0.03, 0.03, 0.03),
}


def material(name):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*COLORS[name], 1)
    return made


def mirrored(place):
    return Vector((-place[0], place[1], place[2]))


def body_mesh():
    """Edges with radii, made solid by the skin modifier."""
    points, edges, radii = [], [], []

    def add(place, radius, before=None):
        points.append(Vector(place))
        radii.append(radius)
        if before is not None:
            edges.append((before, len(points) - 1))
        return len(points) - 1

    before, spine = None, {}
    for name, place, wide, high in SPINE:
        before = add(place, (wide, high), before)
        spine[name] = before
    for start, places in LEGS.values():
        for flip in (Vector, mirrored):
            before = spine[start]
            for place, radius in zip(places[1:], LEG_RADII[1:]):
                before = add(flip(place), (radius, radius), before)
            along = Vector(places[3]) - Vector(places[2])
            outward = math.atan2(along.x, -along.y)
            for degrees in TOES:
                turn = outward + math.radians(degrees)
                out = Vector((math.sin(turn), -math.cos(turn), 0))
                side = flip if flip is mirrored else Vector
                foot = Vector(places[3])
                add(side(foot + out * 0.098 - Vector((0, 0, 0.009))), (0.0095, 0.0095), before)
    mesh = bpy.data.meshes.new("Body")
    mesh.from_pydata(points, edges, [])
    body = bpy.data.objects.new("Body", mesh)
    bpy.context.collection.objects.link(body)
    bpy.context.view_layer.objects.active = body
    body.select_set(True)
    skin = body.modifiers.new("Skin", "SKIN")
    skin.branch_smoothing = 0.6
    for vertex, radius in zip(mesh.skin_vertices[0].data, radii):
        vertex.radius = radius
    mesh.skin_vertices[0].data[spine["Hips"]].use_root = True
    bpy.ops.object.modifier_apply(modifier="Skin")
    return body


def subdivide(body):
    body.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.object.modifier_apply(modifier="Subdivision")


def paint(body):
    """A dark back, bright flanks, a pale belly, by where faces look. Of eight faces round the body
    each is one or the other, so that their borders run along it and further subdivision rounds
    them."""
    for name in ("Back", "Flank", "Belly"):
        body.data.materials.append(material(name))
    for face in body.data.polygons:
        face.use_smooth = True
        up = face.normal.z
        face.material_index = 0 if up > 0.66 else 1 if up > 0.0 else 2


def armature():
    data = bpy.data.armatures.new("Lizard")
    rig = bpy.data.objects.new("Lizard", data)
    bpy.context.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    places = {name: Vector(place) for name, place, _, _ in SPINE}

    def bone(name, head, tail, parent=None, connected=True):
        made = data.edit_bones.new(name)
        made.head, made.tail = head, tail
        if parent is not None:
            made.parent = data.edit_bones[parent]
            made.use_connect = connected and (made.head - made.parent.tail).length < 1e-6
        return name

    # Two chains from the hips: one to the nose, one to the tip of the tail.
    forward = ["Hips", "Back 1", "Back 2", "Back 3", "Neck", "Head"]
    parent = None
    for name, after in zip(forward, forward[1:] + ["Nose"]):
        parent = bone(name, places[name], places[after], parent)
    backward = ["Hips", "Tail 1", "Tail 2", "Tail 3", "Tail 4", "Tail 5", "Tail 6"]
    parent = "Hips"
    for name, start, end in zip(backward[1:], backward, backward[1:]):
        parent = bone(name, places[start], places[end], parent)
    for which, (start, points) in LEGS.items():
        for side, flip in (("Left", Vector), ("Right", mirrored)):
            parent = start
            for part, head, tail in zip(("upper", "lower", "foot"), points, points[1:]):
                if part == "foot":
                    out = Vector(tail) - Vector(head)
                    tail = Vector(head) + out * 1.9
                parent = bone(f"{side} {which} {part}", flip(head), flip(tail), parent)
    bpy.ops.object.mode_set(mode="OBJECT")
    return rig


def bind(body, rig):
    """Blender's automatic weights: heat from the bones, as far as they see the skin."""
    bpy.ops.object.select_all(action="DESELECT")
    body.select_set(True)
    rig.select_set(True)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.parent_set(type="ARMATURE_AUTO")
    bpy.context.view_layer.objects.active = body
    bpy.ops.object.vertex_group_clean(group_select_mode="ALL", limit=0.01)
    bpy.ops.object.vertex_group_normalize_all(lock_active=False)


def eyes(rig):
    """Two balls with slit pupils: a skin of their own, which follows the head alone."""
    mesh = bpy.data.meshes.new("Eyes")
    shape = bmesh.new()
    head = Vector(SPINE[11][1])
    for side in (-1, 1):
        out = Vector((side * 0.80, -0.34, 0.50)).normalized()
        center = head + Vector((side * 0.060, -0.040, 0.040))
        turn = out.to_track_quat("Z", "X").to_matrix().to_4x4()
        turn.translation = center
        slit = Matrix.Translation((0, 0, 0.0185)) @ Matrix.Diagonal((0.30, 0.72, 0.45, 1))
        for index, matrix in enumerate((turn, turn @ slit)):
            ball = {"u_segments": 16, "v_segments": 12, "radius": 0.030}
            made = bmesh.ops.create_uvsphere(shape, matrix=matrix, **ball)
            for face in {face for vertex in made["verts"] for face in vertex.link_faces}:
                face.smooth = True
                face.material_index = index
    shape.to_mesh(mesh)
    shape.free()
    for name in ("Eye", "Pupil"):
        mesh.materials.append(material(name))
    made = bpy.data.objects.new("Eyes", mesh)
    bpy.context.collection.objects.link(made)
    made.parent = rig
    made.modifiers.new("Armature", "ARMATURE").object = rig
    group = made.vertex_groups.new(name="Head")
    group.add(range(len(mesh.vertices)), 1.0, "REPLACE")


def export(path):
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.wm.collada_export(
        filepath=str(path),
        selected=True,
        include_armatures=True,
        triangulate=False,
        keep_bind_info=False,
        sort_by_name=True,
    )
    # The dates are all that differs from run to run.
    text = path.read_text()
    text = re.sub(r"<(created|modified)>[^<]*<", r"<\1>2026-01-01T00:00:00<", text)
    path.write_text(text)


def main():
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else OUT
    bpy.ops.wm.read_factory_settings(use_empty=True)
    body = body_mesh()
    subdivide(body)
    paint(body)
    subdivide(body)
    rig = armature()
    bind(body, rig)
    eyes(rig)
    export(path.resolve())


main()
