// Asks an Understudy service (`understudy serve`) for a line.

using System;
using System.Collections;
using System.Collections.Generic;
using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using UnityEngine.Networking;

namespace Understudy
{
    /// <summary>A service; its methods are coroutines.</summary>
    public sealed class UnderstudyService
    {
        private readonly string _url, _apiKey;

        public UnderstudyService(string url = "http://127.0.0.1:8000", string apiKey = "") => (_url, _apiKey) = (url, apiKey);

        /// <summary>Performs a recording (bytes of WAV, FLAC or OGG) and makes its motion; `refused` is told why not.</summary>
        public IEnumerator Perform(byte[] audio, string text, Action<UnderstudyClip> performed, Action<string> refused)
        {
            string bml = null, clip = null;
            yield return Post("/perform", "text", text, audio, body => bml = (string)JObject.Parse(body)["bml"], refused);
            if (bml == null)
            {
                yield break;
            }
            yield return Post("/realize", "bml", bml, audio, body => clip = body, refused);
            if (clip != null)
            {
                performed(UnderstudyClip.Read(clip));
            }
        }

        private IEnumerator Post(string path, string field, string value, byte[] audio, Action<string> done, Action<string> refused)
        {
            var form = new List<IMultipartFormSection>
            {
                new MultipartFormDataSection(field, Encoding.UTF8.GetBytes(value)),
                new MultipartFormFileSection("audio", audio, "line.wav", "application/octet-stream"),
            };
            using (var request = UnityWebRequest.Post(_url + path, form))
            {
                request.SetRequestHeader("Accept", "application/json");
                if (_apiKey != "")
                {
                    request.SetRequestHeader("Authorization", "Bearer " + _apiKey);
                }
                yield return request.SendWebRequest();
                if (request.result == UnityWebRequest.Result.Success)
                {
                    done(request.downloadHandler.text);
                }
                else
                {
                    refused(Detail(request.downloadHandler.text) ?? request.error);
                }
            }
        }

        /// <summary>What the service says is wrong; null where the answer is not the service's.</summary>
        private static string Detail(string body)
        {
            try
            {
                return (string)JObject.Parse(body ?? "")["detail"];
            }
            catch (JsonException)
            {
                return null;
            }
        }
    }
}
