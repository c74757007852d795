"""Materials, objects and strips that a person changed in Blender are taken over, stay, and never run code."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from storyblender.edits.pulling import Choice
from storyblender.memory.edits import CameraEdit
from storyblender.pipeline import compiling
from storyblender.project import read_project_graph
from storyblender.settings import Settings
from storyblender.studio import Studio
from tests.e2e.conftest import SMALL, made
from tests.e2e.test_pull import in_blender, project, pulled  # noqa: F401 - the fixture of the module

pytestmark = [pytest.mark.blender, pytest.mark.slow]

BASE = 'm.node_tree.nodes["Principled BSDF"].inputs["Base Color"]'
CONE = """
import bmesh
mesh, bm = bpy.data.meshes.new("cone"), bmesh.new()
bmesh.ops.create_cone(bm, cap_ends=True, segments=16, radius1=0.3, radius2=0.0, depth=0.9)
bm.to_mesh(mesh)
cone = bpy.data.objects.new("Party Hat", mesh)
scene.collection.objects.link(cone)
cone.location, cone.rotation_euler, cone.scale = (0.5, 0.3, 0.6), (0.4, 0.0, 1.0), (1, 1, 1.3)
"""


def seen(project: Path, code: str) -> list[str]:  # noqa: F811
    """Return what a line of code prints in the file that is compiled now."""
    text = f"import bpy, sys\nbpy.ops.wm.open_mainfile(filepath=sys.argv[1], use_scripts=False)\n{code}"
    ran = subprocess.run(
        [sys.executable, "-c", text, str(project / "story.blend")], check=True, capture_output=True, text=True
    )
    return [line[1:] for line in ran.stdout.splitlines() if line.startswith("=")]


def test_a_garment_that_is_recoloured_is_painted_on_its_wearer_alone(project: Path) -> None:  # noqa: F811
    code = "o = next(o for o in objects if o.name.endswith('jacket')); m = o.data.materials[0]; "
    in_blender(project / "story.blend", f"{code}{BASE}.default_value = (0.5, 0.02, 0.02, 1)")
    found = pulled(project)
    assert len(found.understood) == 1 and not found.kept and not found.conflicts, found
    [paint] = read_project_graph(project).paints
    assert paint.target.asset_id == "tom" and paint.look.color == pytest.approx((0.5, 0.02, 0.02), abs=1e-4)
    told = "o = next(o for o in bpy.data.objects if o.name.endswith('jacket')); m = o.data.materials[0]; "
    assert seen(project, f"{told}print('=%.2f' % {BASE}.default_value[0])") == ["0.50"]


def test_a_wall_is_painted_and_a_thing_gets_another_material(project: Path) -> None:  # noqa: F811
    code = """
bpy.data.materials["Wall tile"].diffuse_color = (0.1, 0.3, 0.2, 1)
cabinet = next(o for o in objects if o.get("node_id") == "set_cabinet_1")
cabinet.data.materials[0] = bpy.data.materials["Marble"]
"""
    in_blender(project / "story.blend", code)
    found = pulled(project)
    assert len(found.understood) == 2 and not found.kept, found
    looks = {paint.target.material: paint for paint in read_project_graph(project).paints}
    assert looks["wall_tile"].target.scene_id == 1 and looks["wood"].look.finish == "marble"
    assert looks["wood"].target.asset_id == "set_cabinet"


def test_an_object_that_was_made_in_blender_is_adopted_where_it_stands(project: Path) -> None:  # noqa: F811
    in_blender(project / "story.blend", CONE)
    found = pulled(project)
    assert len(found.understood) == 1 and not found.kept, found
    graph = read_project_graph(project)
    [asset] = [each for each in graph.assets if each.decision is not None and each.decision.adopted is not None]
    assert asset.canonical is not None and asset.canonical.source == "file" and asset.canonical.geometry_hash
    assert (project / "adopted" / asset.canonical.key).is_file()
    code = "o = bpy.data.objects['SC010.party_hat']; c = [o.matrix_world @ v.co for v in o.data.vertices]; "
    code += "tip = max(c, key=lambda p: p.z); print('=%.2f %.2f' % (tip.x, tip.z))"
    x, z = map(float, seen(project, code)[0].split())
    assert x == pytest.approx(0.69, abs=0.03) and z == pytest.approx(1.14, abs=0.03), "it leans as it did"


def test_what_is_sculpted_squeezed_or_tilted_is_a_model_of_its_own(project: Path) -> None:  # noqa: F811
    code = """
table = next(o for o in objects if o.get("node_id") == "table")
for vertex in table.data.vertices:
    vertex.co.z *= 1 + 0.25 * abs(vertex.co.x)
stove = next(o for o in objects if o.get("node_id") == "set_stove_1")
stove.scale = (1, 1, 1.5)
fridge = next(o for o in objects if o.get("node_id") == "set_fridge_1")
fridge.rotation_euler.x += 0.1
"""
    in_blender(project / "story.blend", code)
    found = pulled(project)
    assert len(found.understood) == 3 and not found.kept, found
    adopted = [each for each in read_project_graph(project).assets if each.decision and each.decision.adopted]
    assert {"table"} < {asset.asset_id for asset in adopted} and len(adopted) >= 3


def test_a_lamp_that_is_added_lights_the_scene(project: Path) -> None:  # noqa: F811
    code = """
lamp = bpy.data.objects.new("Neon sign", bpy.data.lights.new("Neon", "POINT"))
lamp.data.energy, lamp.data.color, lamp.location = 200, (0.2, 0.4, 1), (1, 1, 1.8)
scene.collection.objects.link(lamp)
"""
    in_blender(project / "story.blend", code)
    found = pulled(project)
    assert len(found.understood) == 1 and not found.kept, found
    lighting = read_project_graph(project).scenes[0].lighting
    assert lighting is not None and "neon_sign" in {light.name for light in lighting.lights}


def test_strips_of_the_cut_are_trimmed_muted_and_moved(project: Path) -> None:  # noqa: F811
    code = """
strips = {strip.name: strip for strip in bpy.data.scenes["EDIT"].sequence_editor.strips}
names = sorted(strips)
strips[names[2]].frame_final_duration -= 8
strips[names[1]].mute = True
"""
    in_blender(project / "story.blend", code)
    before = read_project_graph(project)
    found = pulled(project)
    assert len(found.understood) == 2 and not found.kept, found
    graph = read_project_graph(project)
    assert graph.shots[1].omitted and graph.shots[2].duration == before.shots[2].duration - 8


def test_a_conflict_waits_until_a_person_chooses(project: Path) -> None:  # noqa: F811
    name = "SC010_SH010"
    in_blender(project / "story.blend", f"scene.objects[{name!r}].data.lens = 77")
    with Studio(Settings.load(project=project)).open(project) as session:
        session.apply([CameraEdit.model_validate({"kind": "camera", "shot": name, "decision": {"lens": 24}})])
        session.render()  # pulls by itself, and writes the file anew
        assert session.waiting_conflicts == 1
        [conflict] = session.pull(apply=False).conflicts
        assert "77 mm" in conflict.words and conflict.project
        session.pull(choice=Choice(take=(conflict.id,)))
        shot = session.graph.shot(1, 1)
        assert shot.camera_decision is not None and shot.camera_decision.lens == 77
        assert not session.waiting_conflicts


def test_a_hostile_file_runs_no_code_and_a_broken_one_is_kept(project: Path, tmp_path: Path) -> None:  # noqa: F811
    ran = tmp_path / "ran"
    code = f"""{CONE}
text = bpy.data.texts.new("evil.py")
text.from_string("open({str(ran)!r}, 'w')")
text.use_module = True
cone.name = "../../x\\n\\U0001F680" + "y" * 50
driver = cone.driver_add("location", 0).driver
driver.type, driver.expression = "SCRIPTED", "open({str(ran)!r}, 'w') and 1"
m = bpy.data.materials.new("outside")
m.use_nodes = True
node = m.node_tree.nodes.new("ShaderNodeTexImage")
node.image = bpy.data.images.new("secret", 4, 4)
node.image.source, node.image.filepath = "FILE", "/etc/hostname"
m.node_tree.links.new(node.outputs["Color"], m.node_tree.nodes["Principled BSDF"].inputs["Base Color"])
mesh.materials.append(m)
"""
    in_blender(project / "story.blend", code)
    ran.unlink(missing_ok=True)
    found = pulled(project)
    assert not ran.exists() and found.understood
    assert all("\n" not in sentence for sentence in (*found.understood, *found.kept))
    story = project / "story.blend"
    story.write_bytes(story.read_bytes()[:5000])
    found = pulled(project)
    assert found.kept and not found.understood
    assert len(list(project.glob("story *.blend"))) >= 2


def test_a_story_in_several_files_loses_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    script = "INT. KITCHEN - DAY\n\nTom (60) sits at the table.\n\nEXT. PARK - DAY\n\nAda (25) waits by a bench.\n"
    (tmp_path / "two.fountain").write_text(script, encoding="utf-8")
    folder = tmp_path / "two.storyboard"
    made([tmp_path / "two.fountain", "--out", folder, "--no-animatic", *SMALL])
    monkeypatch.setattr(compiling, "MOST_SCENES", 1)
    monkeypatch.setattr(compiling, "SEQUENCE", 1)
    with Studio(Settings.load(project=folder)).open(folder) as session:
        session.render()
    assert (folder / "story" / "SEQ010.blend").is_file()
    in_blender(folder / "story" / "SEQ010.blend", "thing.location.x += 0.3")
    trim = "bpy.data.scenes['EDIT'].sequence_editor.strips[0].frame_final_duration -= 8"
    in_blender(folder / "story.blend", trim)
    found = pulled(folder)
    assert set(found.files) == {"story.blend", "story/SEQ010.blend"} and len(found.understood) == 2, found
