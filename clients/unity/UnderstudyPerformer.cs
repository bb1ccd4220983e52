// Plays a clip on a humanoid avatar by the clock of its AudioSource.

using System;
using System.Collections.Generic;
using UnityEngine;

namespace Understudy
{
    /// <summary>Beside an Animator with a humanoid avatar, which must be in a T-pose when this awakes.</summary>
    [RequireComponent(typeof(Animator))]
    public sealed class UnderstudyPerformer : MonoBehaviour
    {
        [SerializeField] private AudioSource voice;
        [SerializeField] private SkinnedMeshRenderer face;

        private readonly Dictionary<string, Bone> _bones = new();
        private UnderstudyClip _clip;

        private void Awake()
        {
            var animator = GetComponent<Animator>();
            animator.enabled = false;
            var root = Quaternion.Inverse(transform.rotation);
            foreach (HumanBodyBones body in Enum.GetValues(typeof(HumanBodyBones)))
            {
                var bone = body == HumanBodyBones.LastBone ? null : animator.GetBoneTransform(body);
                if (bone != null)
                {
                    var above = bone.parent == null ? Quaternion.identity : root * bone.parent.rotation;
                    _bones[JointName(body)] = new Bone(bone, above, root * bone.rotation);
                }
            }
        }

        /// <summary>Plays a clip with its sound.</summary>
        public void Play(UnderstudyClip clip, AudioClip sound)
        {
            _clip = clip;
            voice.clip = sound;
            voice.Play();
        }

        private void LateUpdate()
        {
            if (_clip == null)
            {
                return;
            }
            var timeS = voice.time - _clip.AudioOffsetS;
            foreach (var joint in _clip.Bones.Keys)
            {
                if (_bones.TryGetValue(joint, out var bone))
                {
                    bone.Place.localRotation = Quaternion.Inverse(bone.Above) * _clip.Rotation(joint, timeS) * bone.Rest;
                }
            }
            foreach (var shape in face == null ? new List<string>() : new List<string>(_clip.BlendShapes.Keys))
            {
                var index = face.sharedMesh.GetBlendShapeIndex(shape);
                if (index >= 0)
                {
                    face.SetBlendShapeWeight(index, 100 * _clip.Weight(shape, timeS));
                }
            }
        }

        /// <summary>VRM's name, which clips have: LeftUpperArm is leftUpperArm; thumbs count from the hand.</summary>
        private static string JointName(HumanBodyBones body)
        {
            var name = body.ToString();
            name = name.Replace("ThumbProximal", "ThumbMetacarpal").Replace("ThumbIntermediate", "ThumbProximal");
            return char.ToLowerInvariant(name[0]) + name.Substring(1);
        }

        /// <summary>A bone, and how its parent and it are turned in the T-pose, in the character's axes.</summary>
        private readonly struct Bone
        {
            public readonly Transform Place;
            public readonly Quaternion Above, Rest;

            public Bone(Transform place, Quaternion above, Quaternion rest) => (Place, Above, Rest) = (place, above, rest);
        }
    }
}
