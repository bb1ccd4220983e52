// A motion of Understudy (docs/motion-formats.md, "Clip JSON"), read and played in Unity 2021.3 or later.
// Needs the package com.unity.nuget.newtonsoft-json, for Unity's own JsonUtility reads no tables by name.

using System.Collections.Generic;
using Newtonsoft.Json;
using UnityEngine;

namespace Understudy
{
    /// <summary>A clip: a rotation a joint and frame, and weights of ARKit's shapes. One value in a track: constant.</summary>
    public sealed class UnderstudyClip
    {
        [JsonProperty("format")] public string Format;
        [JsonProperty("version")] public int Version;
        [JsonProperty("frames")] public int Frames;
        [JsonProperty("frame_rate_hz")] public float FrameRateHz;
        [JsonProperty("audio_offset_s")] public float AudioOffsetS;
        [JsonProperty("bones")] public Dictionary<string, float[][]> Bones;
        [JsonProperty("blendshapes")] public Dictionary<string, float[]> BlendShapes;

        /// <summary>Throws JsonException for what is no clip of version 1.</summary>
        public static UnderstudyClip Read(string json)
        {
            var clip = JsonConvert.DeserializeObject<UnderstudyClip>(json);
            if (clip == null || clip.Format != "understudy-clip" || clip.Version != 1)
            {
                throw new JsonException("this is no understudy-clip of version 1");
            }
            return clip;
        }

        /// <summary>A joint's rotation to its parent from the T-pose, in Unity's left-handed axes.</summary>
        public Quaternion Rotation(string joint, float timeS)
        {
            var track = Bones[joint];
            var at = Mathf.Clamp(timeS * FrameRateHz, 0, track.Length - 1);
            var before = Mathf.FloorToInt(at);
            var after = Mathf.Min(before + 1, track.Length - 1);
            return Quaternion.Slerp(InUnity(track[before]), InUnity(track[after]), at - before);
        }

        /// <summary>The weight of a shape, 0 to 1.</summary>
        public float Weight(string shape, float timeS)
        {
            var track = BlendShapes[shape];
            return track[Mathf.RoundToInt(Mathf.Clamp(timeS * FrameRateHz, 0, track.Length - 1))];
        }

        /// <summary>X changes its sign, as importers of glTF do it: y and z of a rotation change theirs.</summary>
        private static Quaternion InUnity(IReadOnlyList<float> turn) => new(turn[0], -turn[1], -turn[2], turn[3]);
    }
}
