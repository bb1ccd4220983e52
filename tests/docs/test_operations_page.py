"""The statements of docs/operations.md about deploy/ and settings are true: files are well formed, every setting
exists."""

import re
from pathlib import Path

import pytest
import yaml

from understudy.settings import PREFIX, Settings

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "operations.md").read_text(encoding="utf-8")
DEPLOYED = sorted((ROOT / "deploy").iterdir())


@pytest.mark.parametrize(
    "path", [ROOT / "docs" / "operations.md", ROOT / "Dockerfile", *DEPLOYED], ids=lambda path: path.name
)
def test_every_setting_it_names_exists(path: Path) -> None:
    named = set(re.findall(rf"{PREFIX}([A-Z_]+[A-Z])", path.read_text(encoding="utf-8")))
    assert {name.lower() for name in named} <= Settings.model_fields.keys()


@pytest.mark.parametrize("path", [path for path in DEPLOYED if path.suffix == ".yaml"], ids=lambda path: path.name)
def test_it_is_yaml(path: Path) -> None:
    documents = list(yaml.safe_load_all(path.read_text(encoding="utf-8")))
    assert all(isinstance(document, dict) for document in documents)


def test_the_page_is_about_every_file_that_is_deployed() -> None:
    assert "compose" in PAGE
    assert [path.name for path in DEPLOYED] == ["compose.yaml", "kubernetes.yaml", "nginx.conf"]


def test_nginx_allows_what_the_service_does() -> None:
    nginx = (ROOT / "deploy" / "nginx.conf").read_text(encoding="utf-8")
    megabytes = int(re.findall(r"client_max_body_size (\d+)m;", nginx)[0])
    assert megabytes << 20 >= Settings.model_fields["max_body_bytes"].default
    assert int(re.findall(r"proxy_read_timeout (\d+)s;", nginx)[0]) > Settings.model_fields["deadline_s"].default
    assert int(re.findall(r"keepalive_timeout (\d+)s;", nginx)[0]) < Settings.model_fields["idle_s"].default


def test_nginx_passes_live_streams_on() -> None:
    nginx = (ROOT / "deploy" / "nginx.conf").read_text(encoding="utf-8")
    live = re.findall(r"location = /live \{(.*?)\n        \}", nginx, re.DOTALL)[0]
    assert "proxy_set_header Upgrade $http_upgrade;" in live
    assert 'proxy_set_header Connection "upgrade";' in live
    assert "proxy_set_header Host $http_host;" in live
    assert int(re.findall(r"proxy_read_timeout (\d+)s;", live)[0]) > Settings.model_fields["live_idle_s"].default


def test_behind_nginx_callers_are_known_by_an_address_that_they_cannot_make_up() -> None:
    """The service believes whoever reaches it, and only nginx does, which replaces what callers say."""
    nginx = (ROOT / "deploy" / "nginx.conf").read_text(encoding="utf-8")
    assert nginx.count("proxy_pass ") == nginx.count("proxy_set_header X-Forwarded-For $remote_addr;") > 0
    services = yaml.safe_load((ROOT / "deploy" / "compose.yaml").read_text(encoding="utf-8"))["services"]
    assert services["understudy"]["environment"]["FORWARDED_ALLOW_IPS"] == "*"
    assert "ports" not in services["understudy"]
    assert services["understudy"]["networks"] == services["nginx"]["networks"] == ["inside"]


def test_nginx_publishes_no_figures_and_limits_each_address() -> None:
    nginx = (ROOT / "deploy" / "nginx.conf").read_text(encoding="utf-8")
    assert re.search(r"location = /metrics \{\s*return 404;", nginx)
    assert re.search(r"^\s*limit_req zone=clients ", nginx, re.MULTILINE)
    assert re.search(r"^\s*limit_conn connections ", nginx, re.MULTILINE)
    assert "$request_uri" not in nginx
    assert "$args" not in nginx


def test_containers_may_write_nothing_and_become_nobody() -> None:
    service = yaml.safe_load((ROOT / "deploy" / "compose.yaml").read_text(encoding="utf-8"))["services"]["understudy"]
    assert (service["read_only"], service["cap_drop"]) == (True, ["ALL"])
    assert "no-new-privileges:true" in service["security_opt"]
    documents = list(yaml.safe_load_all((ROOT / "deploy" / "kubernetes.yaml").read_text(encoding="utf-8")))
    [pod] = [each["spec"]["template"]["spec"] for each in documents if each["kind"] == "Deployment"]
    assert pod["securityContext"]["runAsNonRoot"]
    assert not pod["automountServiceAccountToken"]
    [container] = pod["containers"]
    assert container["securityContext"] == {
        "allowPrivilegeEscalation": False,
        "readOnlyRootFilesystem": True,
        "capabilities": {"drop": ["ALL"]},
    }
    assert re.search(r"^USER (?!root\b|0\b)", (ROOT / "Dockerfile").read_text(encoding="utf-8"), re.MULTILINE)


def test_in_kubernetes_only_callers_reach_the_service_and_it_reaches_nobody() -> None:
    documents = list(yaml.safe_load_all((ROOT / "deploy" / "kubernetes.yaml").read_text(encoding="utf-8")))
    [policy] = [each["spec"] for each in documents if each["kind"] == "NetworkPolicy"]
    [deployment] = [each["spec"] for each in documents if each["kind"] == "Deployment"]
    assert policy["podSelector"]["matchLabels"].items() <= deployment["template"]["metadata"]["labels"].items()
    assert policy["policyTypes"] == ["Ingress", "Egress"]
    assert policy["egress"] == []
    assert all(rule["from"] and rule["ports"] for rule in policy["ingress"])


def test_policy_and_probes_name_ports_that_the_container_has() -> None:
    documents = list(yaml.safe_load_all((ROOT / "deploy" / "kubernetes.yaml").read_text(encoding="utf-8")))
    specs = {each["kind"]: each["spec"] for each in documents}
    [container] = specs["Deployment"]["template"]["spec"]["containers"]
    ports = {each["name"]: each["containerPort"] for each in container["ports"]}
    named = [port["port"] for rule in specs["NetworkPolicy"]["ingress"] for port in rule["ports"]]
    named += [port["targetPort"] for port in specs["Service"]["ports"]]
    named += [container[probe]["httpGet"]["port"] for probe in ("startupProbe", "livenessProbe", "readinessProbe")]
    assert set(named) == set(ports)
    assert ports["http"] == Settings.model_fields["port"].default
    set_to = {each["name"]: each["value"] for each in container["env"]}
    assert set_to[f"{PREFIX}OPERATIONS_PORT"] == str(ports["operations"])
    assert [port["port"] for port in specs["Service"]["ports"] if port["targetPort"] != "http"] == []


def test_ci_looks_for_known_holes_in_what_the_locks_install() -> None:
    assert "make audit" in (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    audit = (ROOT / ".ci" / "audit").read_text(encoding="utf-8")
    assert all(f"{lock}" in audit for lock in ("requirements.lock", "requirements-test.lock", "--require-hashes"))
