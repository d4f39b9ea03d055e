# Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
"""Every command and every option of ellipsoid-post stands in its page, and in its --help; each page has a figure or says why not; keys of
results carry their units."""
import os
import re
import struct

from _option_scenes import write_scenes
from _synthetic import json_of, post

PAGES = os.path.join(os.environ["ELLIPSOID_SOURCE"], "postprocess", "doc")


def page(name):
    with open(os.path.join(PAGES, name + ".md"), encoding="utf8") as file:
        return file.read()


def commands():
    text = post("--help")[0]
    return re.findall(r"^  ([a-z0-9]+)[, ]", text.split("Subcommands:")[1], re.MULTILINE)


UNITS = set("m m2 m3 mm s kg N J Pa deg rad rad2 b percent Hz K W".split())
PLAIN = re.compile("""run|timestep|id|id_[12]|type|surface|outline|axis|up|up_from|gravity_from|tracer|counted_by|is_.*|run_is_complete|
    particles.*|.*particles|strays|spheres|subspheres|contacts.*|wall_contacts|forces|rattlers|cells|inner_cells|pairs|forward|backward|appeared|vanished|
    .*count|lag_frames|lag_timesteps|residence_unknown|zpp.*|zss|z_type_.*|.*porosity.*|.*solid_fraction.*|.*packing_fraction.*|fabric.*|rose_.*_deg|
    .*order|.*_order_.*|director_[xyz]|cos.*|.*_index.*|gmmi.*|segregation_intensity.*|relative_standard_deviation.*|variance.*|tracer_mean|
    g|g2|neighbours|direction_correlation.*|density_at_.*|strong_.*|largest_eigenvalue|.*_share|cell_neighbours.*|cell_anisotropy.*|
    biaxial.*|flow_order|nematic.*|plane|sectors|.*axes?|flow_plane|subspheres_.*""".replace("\n    ", ""))


def has_unit(key):
    """Keys of numbers with a dimension end in a unit: m, m_per_s, kg_per_m2_s ..."""
    words = key.split("_")
    last = words[-1]
    if "per" in words:
        last = words[words.index("per") + 1]
        return re.sub(r"\d+$", "", last) in UNITS or last in UNITS
    return last in UNITS


def check_figure(name, text):
    """A picture that is there, or words why there is none."""
    figures = re.findall(r"!\[([^\]]+)\]\((figures/[^)]+)\)", text)
    if not figures:
        assert re.search(r"^No figure: .+", text, re.MULTILINE), name
    for words, file in figures:
        assert len(words) > 10, (name, file)
        with open(os.path.join(PAGES, file), "rb") as picture:
            head = picture.read(24)
        assert head[:8] == b"\x89PNG\r\n\x1a\n" and min(struct.unpack(">II", head[16:24])) >= 200, (name, file)


MEASURES = {"pile": ("plane",), "repose": ("plane",), "porosity": ("plane",), "coordination": ("space",), "heap": ("heap", "--sectors", 4),
            "bed": ("space", "--box", 0, 0.006, 0, 0.006, 0, 0.004, "--profile", "height"), "orientation": ("space",), "contacts": ("space",),
            "energy": ("space", "--gravity", 0, 0, -9.81), "fields": ("space", "--at", 0.002, 0.002, 0.002, "--contacts", "space/pairs.local", "--id-columns",
            "i", "j", "--point-columns", "px", "py", "pz", "--force-columns", "fx", "fy", "fz", "--normal-columns", "nx", "ny", "nz"),
            "voronoi": ("space", "--box", -0.002, 0.011, -0.002, 0.011, -0.002, 0.011), "mixing": ("space", "--type", 1), "pairs": ("space", "--gap", 5e-4),
            "trajectory": ("space", "--dt", 1e-5), "flow": ("space", "--through", 0, 0, 0.0038, 0, 0, 1, "--dt", 1e-5)}


def check_units():
    """Of every command that measures, every key of a number with a dimension ends in its unit."""
    os.makedirs("scenes")
    os.chdir("scenes")
    write_scenes()
    for command, (scene, *more) in MEASURES.items():
        rows = json_of(command, f"{scene}/all.dump", *more)
        keys = {key for row in rows for key, value in row.items() if not isinstance(value, str)}
        assert any(has_unit(key) for key in keys) or command in ("contacts", "orientation"), (command, keys)
        bare = [key for key in sorted(keys) if not has_unit(key) and not PLAIN.fullmatch(key)]
        assert not bare, (command, bare)


def main():
    shared = page("README")
    names = commands()
    assert len(names) >= 16, names
    for name in names:
        assert f"[{name}]({name}.md)" in shared, name
        text = page(name)
        check_figure(name, text)
        for heading in ("Syntax", "Examples", "Description", "Related commands", "References"):
            assert f"## {heading}\n" in text, (name, heading)
        options = re.findall(r"^ {2,4}(?:-\w,)?(--[a-z0-9-]+)", post(name, "--help")[0], re.MULTILINE)
        assert options, name
        for option in options:
            assert option == "--help" or option in text or option in shared, (name, option)
    pages = {file[:-3] for file in os.listdir(PAGES) if file.endswith(".md")} - {"README", "comparison", "python"}
    assert pages == set(names), pages ^ set(names)
    for name in names:
        assert f"[{name}]({name}.md)" in page("comparison"), name
    check_units()


main()
