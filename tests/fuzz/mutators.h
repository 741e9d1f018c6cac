// Changes to inputs that keep their format, so that they get past parsers and checksums.
#pragma once

#include <string>

#include "targets.h"

namespace barrido::fuzz {

/// The text of a glTF document: numbers, keys, elements and the bytes of data URIs. Other text is returned as
/// it is.
std::string mutate_json_text(const std::string& text, unsigned seed);

std::size_t mutate_gltf(std::uint8_t* data, std::size_t size, std::size_t capacity, unsigned seed);
/// Chunk lengths are made right again.
std::size_t mutate_glb(std::uint8_t* data, std::size_t size, std::size_t capacity, unsigned seed);
/// Checksums of PNG chunks are made right again.
std::size_t mutate_image(std::uint8_t* data, std::size_t size, std::size_t capacity, unsigned seed);

}  // namespace barrido::fuzz

/// libFuzzer's: any change at all.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t capacity);
