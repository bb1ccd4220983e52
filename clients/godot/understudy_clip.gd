## A motion of Understudy (docs/motion-formats.md, "Clip JSON"), read and played in Godot 4.
##
## Metres, Y up, the character faces +Z. The T-pose is the identity rotation of every joint; a skeleton's own rest may
## have any axes, but must stand in a T-pose.
class_name UnderstudyClip
extends RefCounted

var frame_rate_hz: float
var frames: int
var bones: Dictionary
var blendshapes: Dictionary
var hips_m: Array
var events: Array

## The joints, parents before children: name, parent, offset_m.
var joints: Array


## The clip in a JSON text; null, with an error in the log, where it is none.
static func read(text: String) -> UnderstudyClip:
	var written: Variant = JSON.parse_string(text)
	if not written is Dictionary or written.get("format") != "understudy-clip" or written.get("version") != 1.0:
		push_error("this is no understudy-clip of version 1")
		return null
	var clip := UnderstudyClip.new()
	clip.frame_rate_hz = written["frame_rate_hz"]
	clip.frames = int(written["frames"])
	clip.bones = written["bones"]
	clip.blendshapes = written["blendshapes"]
	clip.hips_m = written["hips_m"]
	clip.events = written["events"]
	clip.joints = written["skeleton"]["joints"]
	return clip


## The clip as an animation of a skeleton and, if given, of a face's blend shapes. Bones are called as in Godot's
## humanoid profile (LeftUpperArm), to which the importer renames those of a model; joints that the skeleton lacks turn
## what is below them. The hips move as far as the skeleton is tall.
func to_animation(skeleton: Skeleton3D, skeleton_path: NodePath, face: MeshInstance3D = null, face_path := NodePath()) -> Animation:
	var animation := Animation.new()
	animation.length = (frames - 1) / frame_rate_hz
	var turns := _turns()
	for joint: String in turns:
		var bone := skeleton.find_bone(_bone_name(joint))
		if bone >= 0:
			_add_rotations(animation, skeleton, bone, "%s:%s" % [skeleton_path, _bone_name(joint)], turns)
	var hips := skeleton.find_bone(_bone_name("hips"))
	if hips >= 0:
		_add_positions(animation, skeleton, hips, "%s:%s" % [skeleton_path, _bone_name("hips")])
	if face != null:
		for shape: String in blendshapes:
			if face.find_blend_shape_by_name(shape) >= 0:
				_add_weights(animation, "%s:%s" % [face_path, shape], blendshapes[shape])
	return animation


static func _bone_name(joint: String) -> String:
	return joint.substr(0, 1).to_upper() + joint.substr(1)


## How each joint is turned from the T-pose in the skeleton's axes, a rotation a frame.
func _turns() -> Dictionary:
	var turns := {}
	for joint: Dictionary in joints:
		var track: Array = bones.get(joint["name"], [[0.0, 0.0, 0.0, 1.0]])
		var turned: Array[Quaternion] = []
		for frame in frames:
			var turn: Array = track[mini(frame, track.size() - 1)]
			var local := Quaternion(turn[0], turn[1], turn[2], turn[3])
			turned.append(local if joint["parent"] == null else turns[joint["parent"]][frame] * local)
		turns[joint["name"]] = turned
	return turns


## A bone's rotations in its parent, which stands as the nearest joint above has turned it.
func _add_rotations(animation: Animation, skeleton: Skeleton3D, bone: int, path: String, turns: Dictionary) -> void:
	var joint := skeleton.get_bone_name(bone)
	joint = joint.substr(0, 1).to_lower() + joint.substr(1)
	var rest := skeleton.get_bone_global_rest(bone).basis.get_rotation_quaternion()
	var parent := skeleton.get_bone_parent(bone)
	var parent_rest := Quaternion.IDENTITY
	if parent >= 0:
		parent_rest = skeleton.get_bone_global_rest(parent).basis.get_rotation_quaternion()
	var above := _joint_above(skeleton, bone, turns)
	var index := animation.add_track(Animation.TYPE_ROTATION_3D)
	animation.track_set_path(index, path)
	for frame in frames:
		var parent_now := parent_rest
		if above != "":
			parent_now = turns[above][frame] * parent_rest
		animation.rotation_track_insert_key(index, frame / frame_rate_hz, parent_now.inverse() * turns[joint][frame] * rest)


## The nearest bone above that is one of the clip's joints; "" where there is none.
static func _joint_above(skeleton: Skeleton3D, bone: int, turns: Dictionary) -> String:
	var parent := skeleton.get_bone_parent(bone)
	while parent >= 0:
		var name := skeleton.get_bone_name(parent)
		name = name.substr(0, 1).to_lower() + name.substr(1)
		if turns.has(name):
			return name
		parent = skeleton.get_bone_parent(parent)
	return ""


func _add_positions(animation: Animation, skeleton: Skeleton3D, hips: int, path: String) -> void:
	var rest := skeleton.get_bone_global_rest(hips).origin
	var parent := skeleton.get_bone_parent(hips)
	var to_parent := Transform3D.IDENTITY
	if parent >= 0:
		to_parent = skeleton.get_bone_global_rest(parent).affine_inverse()
	var offset := _vector(joints[0]["offset_m"])
	var index := animation.add_track(Animation.TYPE_POSITION_3D)
	animation.track_set_path(index, path)
	for frame in hips_m.size():
		var moved := (_vector(hips_m[frame]) - offset) * (rest.y / offset.y)
		animation.position_track_insert_key(index, frame / frame_rate_hz, to_parent * (rest + moved))


static func _vector(numbers: Array) -> Vector3:
	return Vector3(numbers[0], numbers[1], numbers[2])


func _add_weights(animation: Animation, path: String, track: Array) -> void:
	var index := animation.add_track(Animation.TYPE_BLEND_SHAPE)
	animation.track_set_path(index, path)
	for frame in track.size():
		animation.blend_shape_track_insert_key(index, frame / frame_rate_hz, track[frame])
