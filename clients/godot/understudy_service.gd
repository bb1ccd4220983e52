## Asks an Understudy service (`understudy serve`) for a line: first the performance, then its motion.
class_name UnderstudyService
extends Node

signal performed(bml: String, clip: UnderstudyClip)
signal refused(detail: String)

const BOUNDARY := "understudy-godot-0d2f9c"

@export var url := "http://127.0.0.1:8000"
@export var api_key := ""


## Performs a recording (bytes of WAV, FLAC or OGG); answers by one of the signals.
func perform(audio: PackedByteArray, text: String, options := {}) -> void:
	var answer: Variant = await _posted("/perform", [["text", text], ["options", JSON.stringify(options)]], audio)
	if answer is Dictionary:
		var bml: String = answer["bml"]
		var motion: Variant = await _posted("/realize", [["bml", bml]], audio)
		if motion is Dictionary:
			performed.emit(bml, UnderstudyClip.read(JSON.stringify(motion)))


func _posted(path: String, fields: Array, audio: PackedByteArray) -> Variant:
	var request := HTTPRequest.new()
	add_child(request)
	var headers := ["Accept: application/json", "Content-Type: multipart/form-data; boundary=" + BOUNDARY]
	if api_key != "":
		headers.append("Authorization: Bearer " + api_key)
	request.request_raw(url + path, headers, HTTPClient.METHOD_POST, form(fields, audio))
	var answer: Array = await request.request_completed
	request.queue_free()
	var body: Variant = JSON.parse_string((answer[3] as PackedByteArray).get_string_from_utf8())
	if answer[1] == 200 and body is Dictionary:
		return body
	refused.emit(body.get("detail", "") if body is Dictionary else "no service answers at " + url)
	return null


## The parts of a request as one body.
static func form(fields: Array, audio: PackedByteArray) -> PackedByteArray:
	var body := PackedByteArray()
	for field: Array in fields:
		var head := "--%s\r\nContent-Disposition: form-data; name=\"%s\"\r\n\r\n" % [BOUNDARY, field[0]]
		body.append_array((head + str(field[1]) + "\r\n").to_utf8_buffer())
	var file := "--%s\r\nContent-Disposition: form-data; name=\"audio\"; filename=\"line.wav\"\r\n\r\n" % BOUNDARY
	body.append_array(file.to_utf8_buffer())
	body.append_array(audio)
	body.append_array(("\r\n--%s--\r\n" % BOUNDARY).to_utf8_buffer())
	return body
