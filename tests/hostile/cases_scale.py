"""Little files that ask for much: many of everything, everything shared by everything."""

import json
from collections.abc import Callable, Iterator

import pictures
from calls import Case
from cases_models import SMALL, model_case
from models import FLOAT, UBYTE, UINT, USHORT, Model, everything, textured, triangle


def grown(name: str, change: Callable[[Model], None], make: Callable[[], Model] = triangle, expect: str = "either",
          options: list[str] | None = None) -> Case:
    model = make()
    change(model)
    return model_case(name, model.gltf(), expect, options=options)


def raw(model: Model, **arrays: str) -> bytes:
    """Arrays as JSON text: faster than building millions of objects."""
    document = model.with_buffer()
    document.update({name: f"?{name}?" for name in arrays})
    text = json.dumps(document)
    for name, array in arrays.items():
        text = text.replace(f'"?{name}?"', array)
    return text.encode()


def repeated(item: str, count: int) -> str:
    return "[" + (item + ",") * (count - 1) + item + "]"


def counts() -> Iterator[Case]:
    million = 1_000_000
    roots = json.dumps([{"nodes": list(range(million))}])
    yield model_case("a million nodes", raw(triangle(), nodes=repeated('{"mesh":0}', million), scenes=roots))
    yield model_case("a million empty nodes", raw(triangle(), nodes=repeated("{}", million)))
    yield model_case("a million nodes, one child each",
                     raw(triangle(), nodes="[" + ",".join(f'{{"children":[{i + 1}]}}' for i in range(million)) + ',{"mesh":0}]',
                         scenes='[{"nodes":[0]}]'))
    for name, item in [("accessors", '{"componentType":5126,"count":1,"type":"SCALAR"}'), ("materials", "{}"), ("textures", "{}"),
                       ("samplers", "{}"), ("images", "{}"), ("scenes", "{}"), ("bufferViews", '{"buffer":0,"byteLength":1}'),
                       ("meshes", '{"primitives":[]}'), ("cameras", '{"type":"perspective","perspective":{"yfov":1,"znear":1}}'),
                       ("animations", '{"channels":[],"samplers":[]}'), ("skins", '{"joints":[0]}'), ("extras", "[]"),
                       ("buffers", '{"byteLength":1}')]:
        model = Model() if name in ("accessors", "bufferViews", "meshes", "buffers") else triangle()
        if name == "bufferViews":
            model.document["buffers"] = [{"byteLength": 1}]
        yield model_case(f"60,000 {name}", raw(model, **{name: repeated(item, 60_000)}))
    lights = repeated('{"type":"point"}', 100_000)
    nodes = "[" + ",".join(f'{{"extensions":{{"KHR_lights_punctual":{{"light":{i}}}}}}}' for i in range(100_000)) + ',{"mesh":0}]'
    yield model_case("100,000 lights", raw(triangle(), extensions=f'{{"KHR_lights_punctual":{{"lights":{lights}}}}}', nodes=nodes,
                                           scenes=json.dumps([{"nodes": list(range(100_001))}])))
    yield model_case("100,000 names that are told", raw(triangle(), extensionsUsed=json.dumps([f"EXT_{i}" for i in range(100_000)])))
    wraps = json.dumps([{"wrapS": 2 + i, "wrapT": 900_000 + i} for i in range(100_000)])
    textures = json.dumps([{"source": 0, "sampler": i} for i in range(100_000)])
    yield model_case("100,000 warnings", raw(textured(pictures.png(2, 2)), samplers=wraps, textures=textures))
    closed = json.dumps([{"extras": {"barrido": {f"p{i}": 0}}} for i in range(100_000)])
    yield model_case("100,000 slips of the pen", raw(triangle(), materials=closed))


def products() -> Iterator[Case]:
    """What a file has N times M of."""
    part = '{"attributes":{"POSITION":0},"indices":1}'
    mesh = f'[{{"primitives":{repeated(part, 20_000)}}}]'
    yield model_case("20,000 primitives in 50,000 nodes", raw(triangle(), meshes=mesh, nodes=repeated('{"mesh":0}', 50_000),
                                                             scenes=json.dumps([{"nodes": list(range(50_000))}])))

    model = triangle()
    model.document["nodes"] = [{"children": list(range(1, 30_001))}] + [{}] * 30_000
    model.document["scenes"] = [{"nodes": [0] * 200_000}]
    yield model_case("200,000 times the same root of 30,000 nodes", model.gltf())

    def shared_indices(model: Model) -> None:
        many = model.accessor([0, 1, 2] * 200_000, UBYTE, "SCALAR")
        model.document["meshes"][0]["primitives"] = [{"attributes": {"POSITION": 0}, "indices": many}] * 200

    yield grown("600,000 indices in 200 primitives", shared_indices)

    def shared_zero(model: Model) -> None:
        zeros = model.append("accessors", {"componentType": FLOAT, "type": "VEC3", "count": 400_000})
        model.document["meshes"][0]["primitives"] = [{"attributes": {"POSITION": zeros}}] * 200

    yield grown("400,000 vertices without bytes in 200 primitives", shared_zero)

    def many_zeros(model: Model) -> None:
        model.document["meshes"][0]["primitives"] = [
            {"attributes": {"POSITION": model.append("accessors", {"componentType": FLOAT, "type": "VEC3", "count": 1_000_000})}}
            for _ in range(60)]

    yield grown("60 times a million vertices without bytes", many_zeros)

    def morphs(model: Model) -> None:
        model.document["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": 0}] * 200_000

    yield grown("200,000 morph targets", morphs)

    def morph_animation(model: Model) -> None:
        morphs(model)
        model.document["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}], "samplers": [{
            "input": model.append("accessors", {"componentType": FLOAT, "type": "SCALAR", "count": 100}),
            "output": model.append("accessors", {"componentType": FLOAT, "type": "SCALAR", "count": 20_000_000})}]}]

    yield grown("20 million keys without bytes", morph_animation, options=[*SMALL, "--time", "0"])

    def channels(model: Model) -> None:
        keys = model.append("accessors", {"componentType": FLOAT, "type": "SCALAR", "count": 100_000})
        values = model.append("accessors", {"componentType": FLOAT, "type": "VEC3", "count": 100_000})
        model.document["animations"] = [{"samplers": [{"input": keys, "output": values}],
                                         "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}] * 5000}]

    yield grown("100,000 keys in 5000 channels", channels, options=[*SMALL, "--time", "0"])

    def instances(model: Model) -> None:
        many = model.accessor([0, 1, 2] * 100_000, UBYTE, "SCALAR")
        model.document["meshes"][0]["primitives"][0]["indices"] = many
        model.document["nodes"] = [{"mesh": 0, "scale": [1 + i / 1000, 1, 1]} for i in range(5000)]
        model.document["scenes"] = [{"nodes": list(range(5000))}]

    yield grown("100,000 triangles in 5000 nodes", instances)

    def deformed(model: Model) -> None:
        zeros = model.append("accessors", {"componentType": FLOAT, "type": "VEC3", "count": 200_000})
        part = model.document["meshes"][0]["primitives"][0]
        part.update({"attributes": {"POSITION": zeros}, "targets": [{"POSITION": zeros}]})
        del part["indices"]
        model.document["meshes"][0]["weights"] = [1]
        model.document["nodes"] = [{"mesh": 0}] * 1000
        model.document["scenes"] = [{"nodes": list(range(1000))}]

    yield grown("200,000 deformed vertices in 1000 nodes", deformed)

    def joints(model: Model) -> None:
        model.document["skins"][0]["joints"] = [1] * 300_000
        del model.document["skins"][0]["inverseBindMatrices"]
        model.document["nodes"] += [{"mesh": 0, "skin": 0}] * 3000
        model.document["scenes"][0]["nodes"] += list(range(7, 3007))

    yield grown("300,000 joints in 3000 nodes", joints, everything)

    def colors(model: Model) -> None:
        count = 300_000
        zeros = model.append("accessors", {"componentType": FLOAT, "type": "VEC3", "count": count})
        white = model.append("accessors", {"componentType": FLOAT, "type": "VEC4", "count": count})
        model.document["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, i / 2000, 1]}} for i in range(2000)]
        model.document["meshes"][0]["primitives"] = [{"attributes": {"POSITION": zeros, "NORMAL": zeros, "COLOR_0": white}, "material": i}
                                                     for i in range(2000)]

    yield grown("colours times 2000 materials", colors)


def drawing() -> Iterator[Case]:
    """Quick to read and long to draw."""
    def overdraw(mode: int, count: int) -> Callable[[Model], None]:
        def change(model: Model) -> None:
            part = model.document["meshes"][0]["primitives"][0]
            part["indices"] = model.accessor([0, 1, 2] * count, UBYTE, "SCALAR")
            part["mode"] = mode
            part["material"] = 0
            model.document["materials"] = [{"alphaMode": "BLEND", "doubleSided": True,
                                            "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.01]}}]
            model.document["nodes"] = [{"mesh": 0}] * 200
            model.document["scenes"] = [{"nodes": list(range(200))}]
        return change

    for mode in [0, 1, 4]:
        yield grown(f"200 times 100,000 over each other, mode {mode}", overdraw(mode, 100_000), options=["--resolution", "640,480"])


def materials() -> Iterator[Case]:
    """One picture, another texture for each of many materials."""
    model = textured(pictures.png(2048, 2048, 1, 0))
    model.document["materials"] = [{"emissiveTexture": {"index": 0}, "emissiveFactor": [1, 1, i / 200]} for i in range(200)]
    model.document["meshes"][0]["primitives"] = [{**model.document["meshes"][0]["primitives"][0], "material": i} for i in range(200)]
    yield model_case("a picture times 200 colours", model.gltf())
    model = textured(pictures.png(4096, 4096, 1, 0))
    image = model.document["images"][0]
    model.document["images"] = [image] * 40
    model.document["textures"] = [{"source": i} for i in range(40)]
    model.document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(40)]
    model.document["meshes"][0]["primitives"] = [{**model.document["meshes"][0]["primitives"][0], "material": i} for i in range(40)]
    yield model_case("a picture of 2 KB, 40 times", model.gltf())


def all_cases() -> Iterator[Case]:
    for part in [counts, products, materials, drawing]:
        yield from part()
