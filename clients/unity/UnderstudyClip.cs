// A motion of Understudy (docs/motion-formats.md, "Clip JSON"), read for Unity 2021.3 or later.
// Needs the package com.unity.nuget.newtonsoft-json, for Unity's own JsonUtility reads no tables by name.

using System.Collections.Generic;
using Newtonsoft.Json;
using UnityEngine;

namespace Understudy
{
    /// <summary>A joint of the clip's body in its T-pose; offsets in metres from the parent, the hips' from the ground.</summary>
    public sealed class UnderstudyJoint
    {
        [JsonProperty("name")] public string Name;
        [JsonProperty("parent")] public string Parent;
        [JsonProperty("offset_m")] public float[] OffsetM;
    }

    /// <summary>The joints, parents before children, the hips first.</summary>
    public sealed class UnderstudySkeleton
    {
        [JsonProperty("joints")] public UnderstudyJoint[] Joints;
    }

    /// <summary>A clip: a rotation a joint and frame, and weights of ARKit's shapes. One value in a track: constant.</summary>
    public sealed class UnderstudyClip
    {
        [JsonProperty("format")] public string Format;
        [JsonProperty("version")] public int Version;
        [JsonProperty("skeleton")] public UnderstudySkeleton Skeleton;
        [JsonProperty("frames")] public int Frames;
        [JsonProperty("frame_rate_hz")] public float FrameRateHz;
        [JsonProperty("audio_offset_s")] public float AudioOffsetS;
        [JsonProperty("hips_m")] public float[][] HipsM;
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

        /// <summary>How each joint is turned from the T-pose, in the character's axes; left-handed as all of Unity's.</summary>
        public Dictionary<string, Quaternion> Turns(float timeS)
        {
            var turns = new Dictionary<string, Quaternion>();
            foreach (var joint in Skeleton.Joints)
            {
                var above = joint.Parent == null ? Quaternion.identity : turns[joint.Parent];
                turns[joint.Name] = above * Rotation(joint.Name, timeS);
            }
            return turns;
        }

        /// <summary>How far the hips have moved from where they are in the T-pose, for hips at this height.</summary>
        public Vector3 HipsMoved(float timeS, float heightM)
        {
            int before, after;
            var share = Frame(HipsM.Length, timeS, out before, out after);
            var rest = Skeleton.Joints[0].OffsetM;
            var moved = Vector3.Lerp(InUnity(HipsM[before]), InUnity(HipsM[after]), share) - InUnity(rest);
            return moved * (heightM / rest[1]);
        }

        /// <summary>The weight of a shape, 0 to 1.</summary>
        public float Weight(string shape, float timeS)
        {
            int before, after;
            var track = BlendShapes[shape];
            var share = Frame(track.Length, timeS, out before, out after);
            return Mathf.Lerp(track[before], track[after], share);
        }

        private Quaternion Rotation(string joint, float timeS)
        {
            float[][] track;
            if (!Bones.TryGetValue(joint, out track))
            {
                return Quaternion.identity;
            }
            int before, after;
            var share = Frame(track.Length, timeS, out before, out after);
            return Quaternion.Slerp(TurnInUnity(track[before]), TurnInUnity(track[after]), share);
        }

        /// <summary>The frames of a track around a time, and how far between them it is.</summary>
        private float Frame(int length, float timeS, out int before, out int after)
        {
            var at = Mathf.Clamp(timeS * FrameRateHz, 0, length - 1);
            before = Mathf.FloorToInt(at);
            after = Mathf.Min(before + 1, length - 1);
            return at - before;
        }

        /// <summary>X changes its sign, as importers of glTF do it; y and z of a rotation change theirs.</summary>
        private static Vector3 InUnity(float[] place) => new Vector3(-place[0], place[1], place[2]);

        private static Quaternion TurnInUnity(float[] turn) => new Quaternion(turn[0], -turn[1], -turn[2], turn[3]);
    }
}
