// Runs the client without Unity. `show CLIP RIG TIME_S` prints how an avatar's bones stand in the world; `perform URL AUDIO TEXT` asks a
// service, and prints the number of frames or what was refused.

using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Newtonsoft.Json;
using UnityEngine;

namespace Understudy.Tests
{
    public sealed class RigBone
    {
        public string name, parent;
        public float[] position, rotation;
    }

    public static class Program
    {
        public static int Main(string[] arguments)
        {
            System.Threading.Thread.CurrentThread.CurrentCulture = System.Globalization.CultureInfo.InvariantCulture;
            if (arguments[0] == "show") { Show(File.ReadAllText(arguments[1]), File.ReadAllText(arguments[2]), float.Parse(arguments[3])); }
            else { Perform(arguments[1], File.ReadAllBytes(arguments[2]), arguments[3]); }
            return 0;
        }

        private static void Show(string clip, string rig, float timeS)
        {
            var performer = new UnderstudyPerformer();
            performer.transform.localPosition = new Vector3(2, 0, -1);
            performer.transform.localRotation = new Quaternion(0, 0.6f, 0, 0.8f);
            var animator = new Animator();
            performer.components.Add(animator);
            var bones = Bones(JsonConvert.DeserializeObject<RigBone[]>(rig), performer.transform);
            foreach (HumanBodyBones body in Enum.GetValues(typeof(HumanBodyBones)))
            {
                if (bones.ContainsKey(body.ToString())) { animator.bones[body] = bones[body.ToString()]; }
            }
            var face = new SkinnedMeshRenderer();
            face.sharedMesh.shapes.Add("jawOpen");
            var voice = new AudioSource();
            Set(performer, "voice", voice);
            Set(performer, "face", face);
            Call(performer, "Awake");
            var read = UnderstudyClip.Read(clip);
            performer.Play(read, new AudioClip());
            voice.time = timeS + read.AudioOffsetS;
            Call(performer, "LateUpdate");
            var told = bones.ToDictionary(each => each.Key, each => Numbers(each.Value));
            told["jawOpen"] = new[] { face.weights[0] };
            Console.WriteLine(JsonConvert.SerializeObject(told));
        }

        private static Dictionary<string, Transform> Bones(RigBone[] rig, Transform root)
        {
            var bones = new Dictionary<string, Transform>();
            foreach (var bone in rig)
            {
                bones[bone.name] = new Transform
                {
                    parent = bone.parent == null ? root : bones[bone.parent],
                    localPosition = new Vector3(bone.position[0], bone.position[1], bone.position[2]),
                    localRotation = new Quaternion(bone.rotation[0], bone.rotation[1], bone.rotation[2], bone.rotation[3]),
                };
            }
            return bones;
        }

        private static float[] Numbers(Transform bone)
        {
            Quaternion turn = bone.rotation;
            Vector3 place = bone.position;
            return new[] { turn.x, turn.y, turn.z, turn.w, place.x, place.y, place.z };
        }

        private static void Perform(string url, byte[] audio, string text)
        {
            var made = new UnderstudyService(url).Perform(
                audio, text, clip => Console.WriteLine("frames " + clip.Frames), told => Console.WriteLine("refused: " + told));
            Run(made);
        }

        // As Unity runs coroutines: what is yielded is run to its end first.
        private static void Run(IEnumerator routine)
        {
            while (routine.MoveNext())
            {
                var inner = routine.Current as IEnumerator;
                if (inner != null) { Run(inner); }
            }
        }

        private const BindingFlags Hidden = BindingFlags.Instance | BindingFlags.NonPublic;
        private static void Set(object of, string field, object value) => of.GetType().GetField(field, Hidden).SetValue(of, value);
        private static void Call(object of, string method) => of.GetType().GetMethod(method, Hidden).Invoke(of, null);
    }
}
