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
	return clip


## The clip as an animation of a skeleton and, if given, of a face's blend shapes. Bones are called as in Godot's
## humanoid profile (LeftUpperArm), to which the importer renames those of a model.
func to_animation(skeleton: Skeleton3D, skeleton_path: NodePath, face: MeshInstance3D = null, face_path := NodePath()) -> Animation:
	var animation := Animation.new()
	animation.length = (frames - 1) / frame_rate_hz
	for joint: String in bones:
		var bone := skeleton.find_bone(joint.substr(0, 1).to_upper() + joint.substr(1))
		if bone >= 0:
			_add_rotations(animation, skeleton, bone, skeleton_path, bones[joint])
	if face != null:
		for shape: String in blendshapes:
			if face.find_blend_shape_by_name(shape) >= 0:
				_add_weights(animation, "%s:%s" % [face_path, shape], blendshapes[shape])
	return animation


func _add_rotations(animation: Animation, skeleton: Skeleton3D, bone: int, path: NodePath, track: Array) -> void:
	var rest := skeleton.get_bone_global_rest(bone).basis.get_rotation_quaternion()
	var parent := skeleton.get_bone_parent(bone)
	var above := Quaternion.IDENTITY
	if parent >= 0:
		above = skeleton.get_bone_global_rest(parent).basis.get_rotation_quaternion()
	var index := animation.add_track(Animation.TYPE_ROTATION_3D)
	animation.track_set_path(index, "%s:%s" % [path, skeleton.get_bone_name(bone)])
	for frame in track.size():
		var turn: Array = track[frame]
		var local := Quaternion(turn[0], turn[1], turn[2], turn[3])
		animation.rotation_track_insert_key(index, frame / frame_rate_hz, above.inverse() * local * rest)


func _add_weights(animation: Animation, path: String, track: Array) -> void:
	var index := animation.add_track(Animation.TYPE_BLEND_SHAPE)
	animation.track_set_path(index, path)
	for frame in track.size():
		animation.blend_shape_track_insert_key(index, frame / frame_rate_hz, track[frame])
