"""Sites on this machine that speak the wire formats of Poly Haven and Sketchfab."""

from __future__ import annotations

import hashlib
import io
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from tests.model_files import box_gltf, tile
from tests.services.site import Hit, Reply, Site, said

Size = tuple[float, float, float]
CHAIR: Size = (0.5, 0.5, 0.9)


@dataclass(frozen=True)
class Haven:
    """An asset of Poly Haven.

    Attributes:
        id: Its slug.
        name: What it is called.
        tags: Of it.
        kind: ``models``, ``textures`` or ``hdris``.
        files: Of a model, the .gltf first.
        pictures: Of a texture by the name of the map, ``Diffuse``; of a panorama as ``hdr``.
        metres: Width of a texture; 0 where it is not told.
        thumbnail: Address of its small picture, where it is not the usual one.
    """

    id: str
    name: str
    tags: tuple[str, ...] = ()
    kind: str = "models"
    files: Mapping[str, bytes] = field(default_factory=lambda: box_gltf(CHAIR))
    authors: tuple[str, ...] = ("Rico Cilliers", "Greg Zaal")
    pictures: Mapping[str, bytes] = field(default_factory=dict[str, bytes])
    metres: float = 0.0
    thumbnail: str = ""


def record_of(asset: Haven) -> dict[str, Any]:
    """Return what the list of assets says of one."""
    told = {"dimensions": [1000 * asset.metres] * 2} if asset.metres else {}
    return {
        "name": asset.name,
        "type": ("hdris", "textures", "models").index(asset.kind),
        "date_published": 1634860800,
        "download_count": 12345,
        "files_hash": "8746a9a941bebe5743d0a710e11cb91beb225ca6",
        "authors": dict.fromkeys(asset.authors, "All"),
        "categories": ["furniture", "seating"],
        "category": "Furniture/Seating",
        "tags": list(asset.tags),
        "attributes": {"material": ["wood"]},
        "polycount": 5626,
        "dimensions": [848, 766, 1065],
        "max_resolution": [8192, 8192],
        "thumbnail_url": asset.thumbnail
        or f"https://cdn.polyhaven.com/asset_img/thumbs/{asset.id}.png?width=256&height=256",
    } | told


def _file(site: Site, path: str, content: bytes) -> dict[str, Any]:
    site.pages[path] = Reply(content)
    md5 = hashlib.md5(content, usedforsecurity=False).hexdigest()
    return {"url": f"{site.address}{path}", "md5": md5, "size": len(content)}


def open_poly_haven(site: Site, assets: Sequence[Haven]) -> None:
    """Let a site answer as api.polyhaven.com does, and as the host of its files."""

    def listed(hit: Hit) -> Reply:
        if not hit.headers.get("user-agent", "").startswith("StoryBlender/"):
            return Reply(b"who are you", 403)
        if hit.headers.get("if-none-match") == 'W/"1"':
            return Reply(status=304)
        found = {asset.id: record_of(asset) for asset in assets if hit.query["t"] == asset.kind}
        return said(found, etag='W/"1"')

    site.pages["/assets"] = listed
    for asset in assets:
        site.pages[f"/files/{asset.id}"] = said(_tree(site, asset))


def _tree(site: Site, asset: Haven) -> dict[str, Any]:
    """Return the tree of files of an asset."""
    if asset.kind == "hdris":
        return {"hdri": {size: {"hdr": _hdr(site, asset, size), "exr": {}} for size in ("1k", "2k", "4k")}}
    if asset.kind == "textures":
        return {
            name: {
                size: {
                    "png": _file(
                        site, f"/dl/{asset.id}_{name}_{size}.png", asset.pictures.get(name, tile(len(name + size)))
                    )
                }
                for size in ("1k", "2k", "8k")
            }
            for name in ("Diffuse", "nor_gl", "nor_dx", "Rough", "AO")
        }
    (main, text), *others = asset.files.items()
    tree = {}
    for size in ("1k", "2k"):
        include = {name: _file(site, f"/dl/{size}/{asset.id}/{name}", content) for name, content in others}
        tree[size] = {"gltf": {**_file(site, f"/dl/{size}/{asset.id}/{main}", text), "include": include}}
    return {"gltf": tree, "blend": {}, "Diffuse": {}}


def _hdr(site: Site, asset: Haven, size: str) -> dict[str, Any]:
    return _file(site, f"/dl/{asset.id}_{size}.hdr", asset.pictures.get("hdr", b"#?RADIANCE\n" + size.encode()))


@dataclass(frozen=True)
class Fab:
    """A model of Sketchfab.

    Attributes:
        uid: Its id.
        name: What it is called.
        licence: Its slug and label.
        words: What it is found by.
        files: Of its archive.
        more: Further fields of its record.
    """

    uid: str
    name: str
    licence: tuple[str, str] = ("by", "CC Attribution")
    words: tuple[str, ...] = ()
    files: Mapping[str, bytes] = field(default_factory=lambda: box_gltf(CHAIR))
    more: Mapping[str, Any] = field(default_factory=dict)


def result_of(model: Fab) -> dict[str, Any]:
    """Return a model as a search lists it."""
    archive = {"faceCount": 12, "textureCount": 1, "size": 2000, "vertexCount": 8, "textureMaxResolution": 1024}
    return {
        "uri": f"https://api.sketchfab.com/v3/models/{model.uid}",
        "uid": model.uid,
        "name": model.name,
        "viewerUrl": f"https://sketchfab.com/3d-models/thing-{model.uid}",
        "isDownloadable": True,
        "isAgeRestricted": False,
        "faceCount": 12,
        "vertexCount": 8,
        "animationCount": 0,
        "license": {"uid": "322a749bcfa841b29dff1e8a1bb74b0b", "label": model.licence[1], "slug": model.licence[0]},
        "user": {"uid": "u", "username": "maker", "displayName": "A. Maker", "profileUrl": "https://sketchfab.com/maker"},
        "tags": [{"slug": word, "name": word, "uri": ""} for word in model.words],
        "categories": [{"name": "Furniture & Home"}],
        "archives": {"source": archive, "gltf": archive, "glb": archive, "usdz": archive},
        "thumbnails": {"images": [{"url": "https://media.sketchfab.com/t.jpeg", "width": 256, "height": 144}]},
        **model.more,
    }  # fmt: skip


def zipped(files: Mapping[str, bytes]) -> bytes:
    """Return a zip archive of files by name."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return out.getvalue()


def open_sketchfab(site: Site, models: Sequence[Fab], token: str = "") -> None:
    """Let a site answer as api.sketchfab.com/v3 does, and as the host of its archives.

    Args:
        site: Its address is the whole of the service's.
        models: What it has; a search finds those whose name or words have one of its words.
        token: That a download asks for.
    """

    def search(hit: Hit) -> Reply:
        if hit.query.get("type") != "models" or hit.query.get("downloadable") != "true":
            return said({"detail": "bad"}, 400)
        wanted = set(hit.query["q"].lower().split())
        found = [model for model in models if wanted & {*model.name.lower().split(), *model.words}]
        found = [model for model in found if hit.query.get("license", model.licence[0]) == model.licence[0]]
        return said({"cursors": {}, "next": None, "previous": None, "results": [result_of(each) for each in found]})

    def link(model: Fab) -> Any:
        def answer(hit: Hit) -> Reply:
            if token and hit.headers.get("authorization") != f"Token {token}":
                return said({"detail": "Authentication credentials were not provided."}, 401)
            url = f"{site.address}/archives/{model.uid}.zip?X-Amz-Signature=abc"
            return said({"gltf": {"url": url, "size": 2000, "expires": 300}, "usdz": {"url": url, "size": 1}})

        return answer

    site.pages["/search"] = search
    for model in models:
        site.pages[f"/models/{model.uid}/download"] = link(model)
        site.pages[f"/archives/{model.uid}.zip"] = Reply(zipped({**model.files, "license.txt": b"by"}))
