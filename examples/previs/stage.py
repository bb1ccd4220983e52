"""The set: a floor, walls, a table with a lamp, light, and cameras."""

from collections.abc import Sequence
from typing import Any

import bpy
from mathutils import Vector

WALL, FLOOR, WOOD, BRASS = (0.62, 0.6, 0.56), (0.28, 0.22, 0.18), (0.2, 0.11, 0.06), (0.55, 0.38, 0.12)
TABLE_M = 0.75


def build_stage(prop: str, place: Sequence[float]) -> Any:
    """Everything that does not act; the prop, which does not either, but is spoken of."""
    _box("Floor", (0, 0, -0.05), (8, 8, 0.1), FLOOR)
    _box("Wall", (0, 2.2, 1.4), (8, 0.1, 3.0), WALL)
    for side in (-4.0, 4.0):
        _box("Side", (side, 0, 1.4), (0.1, 8, 3.0), WALL)
    x, y, _z = place
    _box("Table", (x, y, TABLE_M - 0.02), (0.9, 0.6, 0.04), WOOD)
    for dx in (-0.4, 0.4):
        for dy in (-0.25, 0.25):
            _box("Leg", (x + dx, y + dy, (TABLE_M - 0.04) / 2), (0.05, 0.05, TABLE_M - 0.04), WOOD)
    _light("Key", (-2.5, -3.0, 3.2), 260.0, 2.0)
    _light("Fill", (3.0, -2.5, 2.2), 90.0, 2.5)
    bpy.context.scene.world = bpy.data.worlds.new("Room")
    bpy.context.scene.world.color = (0.25, 0.26, 0.3)
    return _lamp(prop, Vector(place))


def add_camera(name: str, place: Sequence[float], at: Sequence[float], lens_mm: float) -> Any:
    """A camera that looks at a point."""
    camera = bpy.data.objects.new(name, bpy.data.cameras.new(name))
    bpy.context.scene.collection.objects.link(camera)
    camera.data.lens, camera.location = lens_mm, place
    camera.rotation_euler = (Vector(at) - Vector(place)).to_track_quat("-Z", "Y").to_euler()
    return camera


def _lamp(name: str, place: Vector) -> Any:
    """A lamp on the table: its shade, which is what is looked at, glows."""
    bpy.ops.mesh.primitive_cylinder_add(radius=0.02, depth=0.3, location=place + Vector((0, 0, 0.15)))
    bpy.context.object.data.materials.append(_material("Brass", BRASS))
    bpy.ops.mesh.primitive_cone_add(radius1=0.16, radius2=0.09, depth=0.2, location=place + Vector((0, 0, 0.38)))
    shade = bpy.context.object
    shade.name = name
    shade.data.materials.append(_material("Shade", (1.0, 0.75, 0.4), glow=1.5))
    return shade


def _box(name: str, place: Sequence[float], size: Sequence[float], colour: Sequence[float]) -> None:
    bpy.ops.mesh.primitive_cube_add(size=1, location=place)
    bpy.context.object.name, bpy.context.object.scale = name, size
    bpy.context.object.data.materials.append(_material(name, colour))


def _material(name: str, colour: Sequence[float], glow: float = 0.0) -> Any:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (*colour, 1.0)
    surface.inputs["Roughness"].default_value = 0.7
    if glow:
        surface.inputs["Emission Color"].default_value = (*colour, 1.0)
        surface.inputs["Emission Strength"].default_value = glow
    return material


def _light(name: str, place: Sequence[float], power_w: float, size_m: float) -> None:
    light = bpy.data.lights.new(name, "AREA")
    light.energy, light.size = power_w, size_m
    lamp = bpy.data.objects.new(name, light)
    bpy.context.scene.collection.objects.link(lamp)
    lamp.location = place
    lamp.rotation_euler = (Vector((0, 0, 1.2)) - Vector(place)).to_track_quat("-Z", "Y").to_euler()
