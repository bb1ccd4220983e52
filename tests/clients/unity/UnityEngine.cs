// As much of UnityEngine as the client uses, so that it can be compiled and run without Unity. Left-handed axes, Hamilton's product,
// and transforms without scale, as Unity documents them.

using System;
using System.Collections.Generic;
using System.IO;
using System.Net;
using System.Text;

namespace UnityEngine
{
    [AttributeUsage(AttributeTargets.Field)] public sealed class SerializeField : Attribute { }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class RequireComponent : Attribute { public RequireComponent(Type needed) { } }

    public static class Mathf
    {
        public static float Clamp(float value, float least, float most) => Math.Max(least, Math.Min(most, value));
        public static int FloorToInt(float value) => (int)Math.Floor(value);
        public static int Min(int a, int b) => Math.Min(a, b);
        public static float Lerp(float a, float b, float share) => a + (b - a) * share;
    }

    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);
        public static Vector3 operator *(Vector3 a, float by) => new Vector3(a.x * by, a.y * by, a.z * by);
        public static Vector3 Lerp(Vector3 a, Vector3 b, float share) => a + (b - a) * share;
    }

    public struct Quaternion
    {
        public float x, y, z, w;
        public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        public static Quaternion identity => new Quaternion(0, 0, 0, 1);
        public static Quaternion Inverse(Quaternion q) => new Quaternion(-q.x, -q.y, -q.z, q.w);

        public static Quaternion operator *(Quaternion a, Quaternion b) => new Quaternion(
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
            a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z);

        public static Vector3 operator *(Quaternion q, Vector3 v)
        {
            var turned = q * new Quaternion(v.x, v.y, v.z, 0) * Inverse(q);
            return new Vector3(turned.x, turned.y, turned.z);
        }

        public static Quaternion Slerp(Quaternion a, Quaternion b, float share)
        {
            var cosine = (double)a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
            var side = cosine < 0 ? -1 : 1;
            var angle = Math.Acos(Math.Min(1, Math.Abs(cosine)));
            var from = angle < 1e-6 ? 1 - share : Math.Sin((1 - share) * angle) / Math.Sin(angle);
            var to = side * (angle < 1e-6 ? share : Math.Sin(share * angle) / Math.Sin(angle));
            return new Quaternion(
                (float)(from * a.x + to * b.x), (float)(from * a.y + to * b.y),
                (float)(from * a.z + to * b.z), (float)(from * a.w + to * b.w));
        }
    }

    public sealed class Transform
    {
        public Transform parent;
        public Vector3 localPosition;
        public Quaternion localRotation = Quaternion.identity;

        public Quaternion rotation
        {
            get => parent == null ? localRotation : parent.rotation * localRotation;
            set => localRotation = parent == null ? value : Quaternion.Inverse(parent.rotation) * value;
        }

        public Vector3 position
        {
            get => parent == null ? localPosition : parent.TransformPoint(localPosition);
            set => localPosition = parent == null ? value : parent.InverseTransformPoint(value);
        }

        public Vector3 TransformPoint(Vector3 point) => position + rotation * point;
        public Vector3 InverseTransformPoint(Vector3 point) => Quaternion.Inverse(rotation) * (point - position);
    }

    public class MonoBehaviour
    {
        public readonly List<object> components = new List<object>();
        public Transform transform = new Transform();
        public T GetComponent<T>() => (T)components.Find(each => each is T);
    }

    public sealed class AudioClip { }

    public sealed class AudioSource
    {
        public AudioClip clip;
        public float time;
        public void Play() => time = 0;
    }

    public sealed class Mesh
    {
        public List<string> shapes = new List<string>();
        public int GetBlendShapeIndex(string name) => shapes.IndexOf(name);
    }

    public sealed class SkinnedMeshRenderer
    {
        public Mesh sharedMesh = new Mesh();
        public Dictionary<int, float> weights = new Dictionary<int, float>();
        public void SetBlendShapeWeight(int index, float weight) => weights[index] = weight;
    }

    public sealed class Animator
    {
        public bool enabled = true;
        public Dictionary<HumanBodyBones, Transform> bones = new Dictionary<HumanBodyBones, Transform>();
        public Transform GetBoneTransform(HumanBodyBones bone) { Transform found; return bones.TryGetValue(bone, out found) ? found : null; }
    }

    public enum HumanBodyBones
    {
        Hips, LeftUpperLeg, RightUpperLeg, LeftLowerLeg, RightLowerLeg, LeftFoot, RightFoot, Spine, Chest, UpperChest, Neck, Head,
        LeftShoulder, RightShoulder, LeftUpperArm, RightUpperArm, LeftLowerArm, RightLowerArm, LeftHand, RightHand,
        LeftThumbProximal, LeftThumbIntermediate, LeftThumbDistal, RightIndexProximal, LastBone,
    }
}

namespace UnityEngine.Networking
{
    public interface IMultipartFormSection { }

    public sealed class MultipartFormDataSection : IMultipartFormSection
    {
        public readonly string Name;
        public readonly byte[] Data;
        public MultipartFormDataSection(string name, byte[] data) { Name = name; Data = data; }
    }

    public sealed class MultipartFormFileSection : IMultipartFormSection
    {
        public readonly string Name, FileName, ContentType;
        public readonly byte[] Data;

        public MultipartFormFileSection(string name, byte[] data, string fileName, string contentType)
        {
            Name = name;
            Data = data;
            FileName = fileName;
            ContentType = contentType;
        }
    }

    public sealed class DownloadHandler { public string text = ""; }

    public sealed class UnityWebRequest : IDisposable
    {
        public enum Result { InProgress, Success, ConnectionError, ProtocolError }

        public readonly DownloadHandler downloadHandler = new DownloadHandler();
        public Result result;
        public string error;
        private readonly HttpWebRequest _request;
        private readonly MemoryStream _body = new MemoryStream();

        private UnityWebRequest(string url) { _request = WebRequest.CreateHttp(url); }

        public static UnityWebRequest Post(string url, List<IMultipartFormSection> form)
        {
            const string Boundary = "unity-boundary";
            var made = new UnityWebRequest(url);
            made._request.Method = "POST";
            made._request.ContentType = "multipart/form-data; boundary=" + Boundary;
            foreach (var section in form)
            {
                var file = section as MultipartFormFileSection;
                var field = section as MultipartFormDataSection;
                made.Add($"--{Boundary}\r\nContent-Disposition: form-data; name=\"{file?.Name ?? field.Name}\"");
                made.Add(file == null ? "\r\n\r\n" : $"; filename=\"{file.FileName}\"\r\nContent-Type: {file.ContentType}\r\n\r\n");
                made.Add(file?.Data ?? field.Data);
                made.Add("\r\n");
            }
            made.Add($"--{Boundary}--\r\n");
            return made;
        }

        private void Add(string text) => Add(Encoding.UTF8.GetBytes(text));
        private void Add(byte[] part) => _body.Write(part, 0, part.Length);

        public void SetRequestHeader(string name, string value)
        {
            if (name == "Accept") { _request.Accept = value; } else { _request.Headers[name] = value; }
        }

        public object SendWebRequest()
        {
            try
            {
                using (var stream = _request.GetRequestStream()) { _body.WriteTo(stream); }
                Read(_request.GetResponse(), Result.Success);
            }
            catch (WebException failed)
            {
                error = failed.Message;
                result = Result.ConnectionError;
                if (failed.Response != null) { Read(failed.Response, Result.ProtocolError); }
            }
            return null;
        }

        private void Read(WebResponse response, Result read)
        {
            result = read;
            using (var reader = new StreamReader(response.GetResponseStream(), Encoding.UTF8)) { downloadHandler.text = reader.ReadToEnd(); }
        }

        public void Dispose() { }
    }
}
