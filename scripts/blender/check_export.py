# Run by Blender (see check.sh): imports a GLB and a folder of BVH files, compares where all joints are with
# Muster's own list, and renders a still.
#
#   blender -b --factory-startup -P check_export.py -- --joints J.json [--glb F.glb] [--bvh FOLDER]
#       [--still PICTURE.png --time SECONDS [--width 1600] [--height 900] [--samples 48]
#        [--sun DEGREES] [--eye=X,Y,Z --target=X,Y,Z]]
#
# Prints one line per file, "OK ..." or "FAILED ...", and "DONE" at the end: Blender exits 0 whatever happens.
import argparse
import builtins
import glob
import json
import math
import os
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

LIMIT = 0.001  # Largest difference [m].


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--joints", required=True)
    parser.add_argument("--glb")
    parser.add_argument("--bvh")
    parser.add_argument("--still")
    parser.add_argument("--time", type=float, default=0.0)
    parser.add_argument("--width", type=int, default=1600)
    parser.add_argument("--height", type=int, default=900)
    parser.add_argument("--samples", type=int, default=48)
    parser.add_argument("--sun", type=float, default=145.0)
    parser.add_argument("--eye")
    parser.add_argument("--target")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:])


def patch_importers():
    """Blender 3.4's importers use what newer Python and numpy no longer have."""
    if not hasattr(numpy, "bool"):
        numpy.bool = bool
    usual = builtins.open

    def opened(file, mode="r", *rest, **named):
        return usual(file, mode.replace("U", ""), *rest, **named)

    builtins.open = opened


def bvh_rate(path):
    """Frames a second of a BVH file."""
    with open(path) as file:
        return 1.0 / next(float(line.split(":")[1]) for line in file if line.startswith("Frame Time:"))


def empty_scene(fps):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = round(fps)
    bpy.context.scene.render.fps_base = round(fps) / fps


def show(time, start=0):
    """Puts the scene to a time [s] from its first frame, which is `start`."""
    scene = bpy.context.scene
    frame = start + time * scene.render.fps / scene.render.fps_base
    scene.frame_set(math.floor(frame + 1e-6), subframe=max(0.0, frame - math.floor(frame + 1e-6)))


def armatures():
    return [o for o in bpy.data.objects if o.type == "ARMATURE"]


def compare(listed, armature_of, name, start):
    """Prints the largest distance between joints in Blender and in the list."""
    worst, where, compared = 0.0, "", 0
    for frame in listed["frames"]:
        show(frame["time"], start)
        for character in frame["characters"]:
            armature = armature_of(character["id"])
            numbers = character["positions"]
            for j, joint in enumerate(listed["joints"]):
                wanted = Vector(numbers[3 * j:3 * j + 3])
                found = armature.matrix_world @ armature.pose.bones[joint].head
                compared += 1
                distance = (found - wanted).length
                if distance > worst:
                    worst, where = distance, f"{joint} of character {character['id']} at {frame['time']:.3f} s"
    good = compared > 0 and worst <= LIMIT
    print(f"{'OK' if good else 'FAILED'} {name}: {compared} joints at {len(listed['frames'])} times, "
          f"largest difference {1000 * worst:.3f} mm{' at ' + where if where else ''}")


def check_glb(path, listed):
    empty_scene(30.0)
    bpy.ops.import_scene.gltf(filepath=path)
    # What the importer turns (Y up to Z up) leaves faces of people along -y: turned back to Muster's world.
    by_id = {}
    for armature in armatures():
        top = armature
        while top.parent:
            top = top.parent
        by_id[int(top.name.split("-")[1].split(".")[0])] = armature
    for top in [o for o in bpy.data.objects if o.parent is None]:
        holder(top)
    compare(listed, lambda i: by_id[i], "glb", 0)


def holder(top):
    """Hangs an object under an empty that turns Blender's axes into Muster's."""
    empty = bpy.data.objects.get("muster axes")
    if empty is None:
        empty = bpy.data.objects.new("muster axes", None)
        bpy.context.scene.collection.objects.link(empty)
        # glTF's (X, Y, Z) is Muster's (y, z, x); Blender reads it as (X, -Z, Y).
        empty.matrix_world = Matrix(((0, -1, 0, 0), (1, 0, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)))
    if top is not empty:
        top.parent = empty
        top.matrix_parent_inverse = Matrix.Identity(4)


def check_bvh(folder, listed):
    paths = sorted(glob.glob(os.path.join(folder, "character-*.bvh")))
    # One frame of the files is one of the scene's, the first at 1.
    empty_scene(bvh_rate(paths[0]))
    by_id = {}
    for path in paths:
        before = set(armatures())
        bpy.ops.import_anim.bvh(filepath=path, global_scale=0.01, axis_forward="-Z", axis_up="Y", frame_start=1,
                                use_fps_scale=False, update_scene_fps=False, update_scene_duration=False,
                                rotate_mode="QUATERNION")
        made = [a for a in armatures() if a not in before]
        by_id[int(os.path.basename(path)[10:14])] = made[0]
        holder(made[0])
    compare(listed, lambda i: by_id[i], "bvh", 1)


def light(turn):
    """A sun in that direction [degrees from +x, to the left], and a pale sky."""
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy = 2.1
    sun.data.angle = math.radians(1.5)
    sun.data.color = (1.0, 0.95, 0.87)
    # 52 degrees high, as in the studio.
    high, turn = math.radians(52), math.radians(turn)
    towards = Vector((math.cos(high) * math.cos(turn), math.cos(high) * math.sin(turn), math.sin(high)))
    sun.rotation_euler = towards.to_track_quat("Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(sun)
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs[0].default_value = (0.72, 0.82, 0.95, 1.0)
    background.inputs[1].default_value = 0.42
    bpy.context.scene.world = world


def aim(options):
    """The file's own camera, or one put by hand in Muster's world."""
    camera = next(o for o in bpy.data.objects if o.type == "CAMERA")
    if options.eye:
        eye, target = (Vector(float(n) for n in text.split(",")) for text in (options.eye, options.target))
        camera.parent = None
        camera.matrix_world = Matrix.Translation(eye) @ (target - eye).to_track_quat("-Z", "Y").to_matrix().to_4x4()
    bpy.context.scene.camera = camera


def render(options):
    scene = bpy.context.scene
    light(options.sun)
    aim(options)
    show(options.time)
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = options.samples
    # Debian's build has no denoiser; light that came off several surfaces is clamped instead.
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = True
    scene.cycles.adaptive_threshold = 0.02
    scene.cycles.sample_clamp_indirect = 1.5
    scene.cycles.max_bounces = 4
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y = options.width, options.height
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = os.path.abspath(options.still)
    bpy.ops.render.render(write_still=True)
    made = os.path.exists(options.still) and os.path.getsize(options.still) > 10000
    print(f"{'OK' if made else 'FAILED'} still: {os.path.basename(options.still)}")


def main():
    options = arguments()
    patch_importers()
    with open(options.joints) as file:
        listed = json.load(file)
    if options.bvh:
        check_bvh(options.bvh, listed)
    if options.glb:
        check_glb(options.glb, listed)
    if options.still:
        render(options)
    print("DONE")


main()
