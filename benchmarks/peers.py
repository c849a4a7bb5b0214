"""A scene of ours in the notations of POV-Ray and tachyon, as far as spheres, boxes and point lights go.

Both draw what lancer draws: a background colour, ambient, diffuse, Phong highlights, mirrors. Neither scales its light, so intensities are given
as lancer uses them. The field of view must be over the height.
"""
import math
import tomllib


def read(path):
    with open(path, "rb") as file:
        return tomllib.load(file)


def light_colors(scene):
    """Colour times share of each light; shares are scaled to sum to 1, as lancer does."""
    total = sum(light.get("intensity", 1.0) for light in scene["light"])
    return [[c * light.get("intensity", 1.0) / total for c in light["color"]] for light in scene["light"]]


def vector(values, separator):
    return separator.join(f"{v:.9g}" for v in values)


def to_povray(scene):
    camera, render = scene["camera"], scene["render"]
    width, height = render["size"]
    fov = math.degrees(2 * math.atan(math.tan(math.radians(camera["fov"]) / 2) * width / height))

    def finish(m):
        return (f"texture {{ pigment {{ color rgb <{vector(m['color'], ',')}> }} finish {{ ambient {m['ambient']} diffuse {m['diffuse']} "
                f"phong {m['highlight']} phong_size {m['shininess']} reflection {m['reflectivity']} }} }}")

    lines = ["#version 3.7;",
             f"global_settings {{ assumed_gamma 1.0 max_trace_level {render['bounces'] + 1} adc_bailout 0 ambient_light rgb 1 }}",
             f"background {{ color rgb <{vector(scene['background']['color'], ',')}> }}",
             f"camera {{ location <{vector(camera['position'], ',')}> up y right -x*image_width/image_height angle {fov:.6f} "
             f"look_at <{vector(camera['look_at'], ',')}> }}"]
    for light, color in zip(scene["light"], light_colors(scene)):
        lines.append(f"light_source {{ <{vector(light['position'], ',')}> color rgb <{vector(color, ',')}> }}")
    for sphere in scene["sphere"]:
        lines.append(f"sphere {{ <{vector(sphere['center'], ',')}>, {sphere['radius']} {finish(sphere['material'])} }}")
    for box in scene["box"]:
        lines.append(f"box {{ <{vector(box['min'], ',')}>, <{vector(box['max'], ',')}> {finish(box['material'])} }}")
    return "\n".join(lines) + "\n"


def to_tachyon(scene, samples):
    """Tachyon is left-handed: it gets the scene mirrored in x, which makes the same picture."""
    camera, render = scene["camera"], scene["render"]
    width, height = render["size"]

    def mirrored(v):
        return [-v[0], v[1], v[2]]

    eye, at = mirrored(camera["position"]), mirrored(camera["look_at"])
    way = [a - e for a, e in zip(at, eye)]
    size = math.sqrt(sum(w * w for w in way))
    zoom = 0.5 / math.tan(math.radians(camera["fov"]) / 2)

    def texture(m):
        return (f"TEXTURE AMBIENT {m['ambient']} DIFFUSE {m['diffuse']} SPECULAR {m['reflectivity']} OPACITY 1.0 "
                f"PHONG PLASTIC {m['highlight']} PHONG_SIZE {m['shininess']} COLOR {vector(m['color'], ' ')} TEXFUNC 0")

    lines = ["BEGIN_SCENE", f"RESOLUTION {width} {height}", "CAMERA", f" ZOOM {zoom:.6f}", " ASPECTRATIO 1.0",
             f" ANTIALIASING {samples - 1}", f" RAYDEPTH {render['bounces'] + 1}", f" CENTER {vector(eye, ' ')}",
             f" VIEWDIR {vector([w / size for w in way], ' ')}", " UPDIR 0 1 0", "END_CAMERA",
             f"BACKGROUND {vector(scene['background']['color'], ' ')}"]
    for light, color in zip(scene["light"], light_colors(scene)):
        lines.append(f"LIGHT CENTER {vector(mirrored(light['position']), ' ')} RAD 0.05 COLOR {vector(color, ' ')}")
    for sphere in scene["sphere"]:
        lines.append(f"SPHERE CENTER {vector(mirrored(sphere['center']), ' ')} RAD {sphere['radius']} {texture(sphere['material'])}")
    for box in scene["box"]:
        low, high = mirrored(box["min"]), mirrored(box["max"])
        low, high = [min(a, b) for a, b in zip(low, high)], [max(a, b) for a, b in zip(low, high)]
        lines.append(f"BOX MIN {vector(low, ' ')} MAX {vector(high, ' ')} {texture(box['material'])}")
    return "\n".join(lines + ["END_SCENE"]) + "\n"
