# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a bundle is made of: the licence of every part, and a list of them as SPDX 2.3."""

import datetime
import hashlib
import json
import os
import re
import subprocess
import uuid
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
DOC = Path("/usr/share/doc")
COMMON = Path("/usr/share/common-licenses")
# Compiled into the program, from headers: no library that could be followed to its package.
HEADERS = (
    "libboost-dev",
    "libcli11-dev",
    "libeigen3-dev",
    "libexpected-dev",
    "libfmt-dev",
    "libspdlog-dev",
    "nlohmann-json3-dev",
)


def owner(file):
    """The Debian package that a library came with; since /usr is merged, under either name."""
    names = [str(file), str(file).removeprefix("/usr")]
    for name in names:
        done = subprocess.run(
            ["dpkg", "-S", name], check=False, capture_output=True, text=True
        )
        if done.returncode == 0:
            return done.stdout.split(":")[0]
    raise SystemExit(f"bundle: no package has {file}, so its licence is not known")


def installed(package):
    """A package's version, source and home page."""
    form = "${Version}\t${source:Package}\t${source:Version}\t${Homepage}\n"
    text = subprocess.run(
        ["dpkg-query", "-W", "-f", form, package], check=True, capture_output=True, text=True
    ).stdout
    return dict(zip(("version", "source", "source_version", "home"), text.splitlines()[0].split("\t")))


def node_packages(build):
    """What the report's script holds: name, version and licence file of each npm package."""
    lock = json.loads((SOURCE / "step_io/report/web/package-lock.json").read_text())
    for place, entry in lock["packages"].items():
        if place and not entry.get("dev") and not entry.get("optional"):
            folder = build / "step_io/report/node" / place
            yield place.rpartition("node_modules/")[2], entry["version"], folder / "LICENSE", entry["license"]


def version():
    text = (SOURCE / "CMakeLists.txt").read_text()
    return re.search(r"project\(Suture VERSION ([\d.]+)", text)[1]


def write(build, folder, libraries):
    """Writes share/doc/suture/licenses and share/doc/suture/suture.spdx.json.

    libraries   the originals of those that were copied
    """
    doc = folder / "share/doc/suture"
    licences = doc / "licenses"
    licences.mkdir(parents=True)
    packages = sorted({*map(owner, libraries), *HEADERS})
    common = set()
    entries = []
    for package in packages:
        text = (DOC / package / "copyright").read_text(encoding="utf-8", errors="replace")
        (licences / f"{package}.txt").write_text(text, encoding="utf-8")
        common.update(re.findall(rf"{COMMON}/([\w.-]*\w)", text))
        entries.append(_debian(package, text))
    for name, number, licence, spdx in node_packages(build):
        (licences / f"npm-{name}.txt").write_text(licence.read_text(encoding="utf-8"), encoding="utf-8")
        entries.append(_package(f"npm-{name}", number, f"pkg:npm/{name}@{number}", spdx))
    for name in common:
        if (COMMON / name).exists():
            (licences / name).write_bytes((COMMON / name).read_bytes())
    (licences / "suture.txt").write_bytes((SOURCE / "LICENSE").read_bytes())
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    document = _document(entries, [(path, folder) for path in files])
    (doc / "suture.spdx.json").write_text(json.dumps(document, indent=1) + "\n")


def _identifier(text):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", text)


def _package(name, number, url, licence, comment=None):
    entry = {
        "SPDXID": _identifier(f"Package-{name}"),
        "name": name,
        "versionInfo": number,
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": licence,
        "copyrightText": "NOASSERTION",
        "externalRefs": [
            {
                "referenceCategory": "PACKAGE-MANAGER",
                "referenceType": "purl",
                "referenceLocator": url,
            }
        ],
    }
    if comment:
        entry["comment"] = comment
    return entry


def _debian(package, text):
    """Debian's names of licences are not SPDX's, so they stand in a comment."""
    about = installed(package)
    names = sorted({name.strip() for name in re.findall(r"^License: *(\S.*)$", text, re.MULTILINE)})
    comment = f"source package {about['source']} {about['source_version']}"
    if names:
        comment += "; licences as its copyright file names them: " + ", ".join(names)
    url = f"pkg:deb/debian/{package}@{about['version'].replace('+', '%2B')}"
    return _package(package, about["version"], url, "NOASSERTION", comment)


def _document(entries, files):
    own = _package("suture", version(), f"pkg:generic/suture@{version()}", "LGPL-2.1-or-later")
    listed = []
    for path, folder in files:
        content = path.read_bytes()
        name = str(path.relative_to(folder))
        listed.append(
            {
                "SPDXID": _identifier(f"File-{hashlib.sha1(name.encode()).hexdigest()[:12]}"),
                "fileName": f"./{name}",
                "checksums": [
                    {"algorithm": "SHA1", "checksumValue": hashlib.sha1(content).hexdigest()},
                    {"algorithm": "SHA256", "checksumValue": hashlib.sha256(content).hexdigest()},
                ],
                "licenseConcluded": "NOASSERTION",
                "copyrightText": "NOASSERTION",
            }
        )
    digest = hashlib.sha256("".join(f["checksums"][1]["checksumValue"] for f in listed).encode())
    when = datetime.datetime.fromtimestamp(
        int(os.environ.get("SOURCE_DATE_EPOCH", 0)), datetime.timezone.utc
    )
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", own["SPDXID"])]
    relations += [(own["SPDXID"], "CONTAINS", file["SPDXID"]) for file in listed]
    relations += [(own["SPDXID"], "DEPENDS_ON", entry["SPDXID"]) for entry in entries]
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"suture-{version()}-linux-x86_64",
        "documentNamespace": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_OID, digest.hexdigest())}",
        "creationInfo": {
            "created": when.strftime("%Y-%m-%dT%H:%M:%SZ"),
            "creators": [f"Tool: suture-bundle-{version()}"],
        },
        "packages": [own, *entries],
        "files": listed,
        "relationships": [
            {"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b}
            for a, kind, b in relations
        ],
    }
