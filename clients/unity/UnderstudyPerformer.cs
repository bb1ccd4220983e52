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

        private readonly Dictionary<string, Bone> _bones = new Dictionary<string, Bone>();
        private UnderstudyClip _clip;

        private void Awake()
        {
            var animator = GetComponent<Animator>();
            animator.enabled = false;
            foreach (HumanBodyBones body in Enum.GetValues(typeof(HumanBodyBones)))
            {
                var bone = body == HumanBodyBones.LastBone ? null : animator.GetBoneTransform(body);
                if (bone != null)
                {
                    _bones[JointName(body)] = new Bone(bone, transform);
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
            if (_clip != null)
            {
                Show(_clip, voice.time - _clip.AudioOffsetS);
            }
        }

        /// <summary>Shows the clip's pose at a time of the clip. Joints that the avatar lacks turn what is below them.</summary>
        public void Show(UnderstudyClip clip, float timeS)
        {
            var turns = clip.Turns(timeS);
            foreach (var joint in clip.Skeleton.Joints)
            {
                Bone bone;
                if (_bones.TryGetValue(joint.Name, out bone))
                {
                    bone.Place.rotation = transform.rotation * turns[joint.Name] * bone.Rest;
                }
            }
            Bone hips;
            if (_bones.TryGetValue("hips", out hips))
            {
                hips.Place.position = transform.TransformPoint(hips.RestPlace + clip.HipsMoved(timeS, hips.RestPlace.y));
            }
            ShowFace(clip, timeS);
        }

        private void ShowFace(UnderstudyClip clip, float timeS)
        {
            if (face == null)
            {
                return;
            }
            foreach (var shape in clip.BlendShapes.Keys)
            {
                var index = face.sharedMesh.GetBlendShapeIndex(shape);
                if (index >= 0)
                {
                    face.SetBlendShapeWeight(index, 100 * clip.Weight(shape, timeS));
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

        /// <summary>A bone, and how it is turned and where it is in the T-pose, in the character's axes.</summary>
        private struct Bone
        {
            public readonly Transform Place;
            public readonly Quaternion Rest;
            public readonly Vector3 RestPlace;

            public Bone(Transform place, Transform character)
            {
                Place = place;
                Rest = Quaternion.Inverse(character.rotation) * place.rotation;
                RestPlace = character.InverseTransformPoint(place.position);
            }
        }
    }
}
