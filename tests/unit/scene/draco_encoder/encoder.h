/* Draco's encoder behind a C interface, as a shared object of its own: the library brings a tinygltf of its
   own, which no program that has another may be linked with. */
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

struct DracoTestAttribute {
  std::int32_t kind;           /* 0 position, 1 normal, 2 texture coordinates, 3 colour, 4 anything */
  std::int32_t component_type; /* glTF's number */
  std::int32_t components;
  std::int32_t normalized;
  const void* elements; /* One for each point */
};

struct DracoTestMesh {
  std::uint32_t points, faces;
  const std::uint32_t* indices;
  const DracoTestAttribute* attributes;
  std::int32_t attribute_count;
  std::int32_t edgebreaker;       /* else sequential */
  std::int32_t speed;             /* 0 the smallest … 10 the fastest */
  std::int32_t quantization_bits; /* Of floats; 0: none */
};

/* Writes the stream and each attribute's number in it; returns its size, or 0 where it does not fit or cannot
   be made. */
using DracoTestEncode = std::size_t (*)(const DracoTestMesh* mesh, std::uint8_t* bytes, std::size_t room,
                                        std::uint32_t* ids);
std::size_t barrido_draco_test_encode(const DracoTestMesh* mesh, std::uint8_t* bytes, std::size_t room,
                                      std::uint32_t* ids);
}
