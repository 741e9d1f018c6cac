"""Materials: metallic-roughness of glTF 2.0 as coefficients of fixed function, and the texture units (docs/scene.md)."""

import dataclasses
import math

import numpy as np

from glb import Glb

FILTERS = {9728: 0, 9729: 1, 9984: 2, 9985: 3, 9986: 4, 9987: 5}
WRAPS = {10497: 0, 33648: 1, 33071: 2}
MODULATE, ADD, COMBINE = 0, 2, 5


@dataclasses.dataclass
class SurfaceChoice:
    """What a call asks of all surfaces."""

    textures: bool = True
    linear: bool = True  # Light is linear and the frame in floats
    float_frame: bool = True
    phong: bool = False  # R·V in place of N·H
    material: dict = dataclasses.field(default_factory=dict)  # Of --material


@dataclasses.dataclass
class Unit:
    mode: int
    matrix: np.ndarray = dataclasses.field(default_factory=lambda: np.eye(3))  # Of (u, v, 1)
    set: int | None = None  # TEXCOORD_n
    color: np.ndarray | None = None  # Constant
    reflects: bool = False
    sampler: dict | None = None
    texel: np.ndarray | None = None  # RGB of the upper left one, as it is combined


@dataclasses.dataclass
class Surface:
    lit: bool = True
    color: np.ndarray = dataclasses.field(default_factory=lambda: np.ones(4))  # Constant, or what vertex colours are times
    ambient: np.ndarray | None = None
    diffuse: np.ndarray | None = None
    specular: np.ndarray | None = None
    emission: np.ndarray = dataclasses.field(default_factory=lambda: np.zeros(3))
    shininess: float = 0.0
    own_ambient: bool = False  # Vertex colours leave k_a alone.
    units: list[Unit] = dataclasses.field(default_factory=list)


def linear(encoded: np.ndarray) -> np.ndarray:
    """From sRGB (IEC 61966-2-1)."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055)**2.4)


def texture_matrix(info: dict) -> np.ndarray:
    """KHR_texture_transform: scale, then rotation, then offset. The angle turns counter-clockwise where v points down."""
    transform = info.get("extensions", {}).get("KHR_texture_transform", {})
    angle = transform.get("rotation", 0.0)
    rotation = np.array([[math.cos(angle), math.sin(angle), 0], [-math.sin(angle), math.cos(angle), 0], [0, 0, 1]])
    matrix = rotation @ np.diag([*transform.get("scale", [1, 1]), 1])
    matrix[:2, 2] = transform.get("offset", [0, 0])
    return matrix


class Materials:
    """The materials of a file as a call sees them."""

    def __init__(self, glb: Glb, choice: SurfaceChoice) -> None:
        self._glb, self._tree, self._choice = glb, glb.tree, choice

    def mean(self, info: dict, decode: bool) -> np.ndarray:
        pixels = self._glb.pictures[self._tree["textures"][info["index"]]["source"]][..., :3].reshape(-1, 3) / 255
        return (linear(pixels) if decode else pixels).mean(axis=0)

    def surface(self, index: int | None, has_normals: bool, has_colors: bool) -> Surface:
        source = self._tree["materials"][index] if index is not None else {}
        pbr = dict(source.get("pbrMetallicRoughness", {}))
        exact = dict(source.get("extras", {}).get("barrido", {}))
        given = self._choice.material
        if given.keys() & {"color", "metallic", "roughness"}:
            exact = {}
        exact |= {name: value for name, value in given.items() if name not in ("color", "metallic", "roughness")}
        base = np.array(pbr.get("baseColorFactor", [1, 1, 1, 1]), dtype=np.float64)
        base[:3] = given.get("color", base[:3])
        pbr["metallicFactor"] = given.get("metallic", pbr.get("metallicFactor", 1.0))
        pbr["roughnessFactor"] = given.get("roughness", pbr.get("roughnessFactor", 1.0))
        if "KHR_materials_unlit" in source.get("extensions", {}) or not has_normals:
            surface = Surface(lit=False, color=base)
            self._add_base_texture(surface, pbr)
        else:
            surface = self._lit(source, pbr, exact, base, has_colors)
        if source.get("alphaMode", "OPAQUE") == "OPAQUE":
            surface.color = np.append(surface.color[:3], 1.0)
            if surface.diffuse is not None:
                surface.diffuse = np.append(surface.diffuse[:3], 1.0)
        return surface

    def _unit(self, info: dict, mode: int, factor: np.ndarray | float = 1.0) -> Unit:
        texture = self._tree["textures"][info["index"]]
        sampler = self._tree["samplers"][texture["sampler"]] if "sampler" in texture else {}
        transform = info.get("extensions", {}).get("KHR_texture_transform", {})
        pixel = self._glb.pictures[texture["source"]][0, 0, :3] / 255
        texel = np.minimum((linear(pixel) if self._choice.linear else pixel) * factor, 1)
        return Unit(mode, texture_matrix(info), transform.get("texCoord", info.get("texCoord", 0)), sampler=sampler, texel=texel)

    def _add_base_texture(self, surface: Surface, pbr: dict) -> None:
        if self._choice.textures and "baseColorTexture" in pbr:
            surface.units.append(self._unit(pbr["baseColorTexture"], MODULATE))

    def _lit(self, source: dict, pbr: dict, exact: dict, base: np.ndarray, has_colors: bool) -> Surface:
        roughness, metalness = pbr["roughnessFactor"], pbr["metallicFactor"]
        if "metallicRoughnessTexture" in pbr:
            _, green, blue = self.mean(pbr["metallicRoughnessTexture"], decode=False)
            roughness, metalness = roughness * green, metalness * blue
        if has_colors:
            metalness = 0.0
        tint = np.ones(3)
        if self._choice.textures and "baseColorTexture" in pbr:
            tint = self.mean(pbr["baseColorTexture"], self._choice.linear)
        alpha_squared = roughness**4
        most = 2048 if self._choice.float_frame else 128
        n = min(2 / alpha_squared - 2, most) if alpha_squared > 0 else most
        f0 = 0.04 * (1 - metalness) + base[:3] * tint * metalness
        f0_untinted = 0.04 * (1 - metalness) + base[:3] * metalness
        specular = f0 * (1 - alpha_squared) * (n + 2) / 8
        diffuse = base[:3] * 0.96 * (1 - metalness) + f0_untinted * alpha_squared
        surface = Surface(shininess=n / 4 if self._choice.phong else n)
        reflects = metalness >= 0.05 and not exact.keys() & {"diffuse", "specular"}
        mirrored = np.zeros(3)
        if reflects:
            share = base[:3] * metalness if metalness >= 0.5 else f0
            mirrored = np.clip(share * (1 - alpha_squared), 0, 1)
        diffuse = diffuse / np.maximum(1 - mirrored, 1 / 16)
        self._set_coefficients(surface, exact, diffuse, specular, base[3])
        reflection = [Unit(COMBINE, color=mirrored, reflects=True)] if np.any(mirrored) else []
        surface.units += reflection if metalness >= 0.5 else []
        self._add_base_texture(surface, pbr)
        surface.units += reflection if metalness < 0.5 else []
        if has_colors:
            surface.color = surface.diffuse
        self._add_emission(surface, source, exact)
        return surface

    def _set_coefficients(self, surface: Surface, exact: dict, diffuse: np.ndarray, specular: np.ndarray, alpha: float) -> None:
        ambient = diffuse
        if "diffuse" in exact:
            ambient = diffuse = np.array(exact["diffuse"])
            specular = np.zeros(3)
        surface.diffuse = np.append(diffuse, alpha)
        surface.own_ambient = "ambient" in exact
        surface.ambient = np.array(exact.get("ambient", ambient))
        surface.specular = np.array(exact.get("specular", specular))
        surface.shininess = exact.get("shininess", surface.shininess)
        if not self._choice.float_frame:
            surface.specular = np.clip(surface.specular, 0, 1)

    def _add_emission(self, surface: Surface, source: dict, exact: dict) -> None:
        strength = source.get("extensions", {}).get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1.0)
        emission = np.array(source.get("emissiveFactor", [0, 0, 0]), dtype=np.float64) * strength
        emission = np.array(exact.get("emission", emission))
        if not np.any(emission):
            return
        if "emissiveTexture" in source:
            if self._choice.textures:
                surface.units.append(self._unit(source["emissiveTexture"], ADD, emission))
                return
            emission = emission * self.mean(source["emissiveTexture"], self._choice.linear)
        if surface.units:
            surface.units.append(Unit(COMBINE, color=emission))
        else:
            surface.emission = emission
