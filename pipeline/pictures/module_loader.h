// Finds and loads the module that holds OpenImageIO. Must not know: pixels.
#pragma once

#include <string>

#include "pipeline/pictures/format.h"
#include "pipeline/pictures/oiio_module/interface.h"

namespace barrido::scene {

/// The module's functions; it is looked for once, in this order: the folders of the environment variable
/// BARRIDO_MODULE_PATH (separated by colons), beside the program or library that holds this code,
/// ../lib/barrido from there, the build tree when the program runs inside it, and the folder given by the
/// installation.
/// @throws InputError naming `name`: "reading EXR needs the module barrido_oiio.so, which …".
const BarridoOiioFunctions& openimageio_module(const std::string& name, const FormatTraits& format,
                                               const std::string& purpose);

}  // namespace barrido::scene
