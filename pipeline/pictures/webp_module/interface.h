/* The C interface between Barrido and the module that holds libwebp. Both sides include this header and
   nothing of each other; no C++ type, exception or allocation crosses it. */
#pragma once

/* NOLINTBEGIN(modernize-deprecated-headers,modernize-use-using): this is C */
#include <stddef.h>
#include <stdint.h>

#include "pipeline/files/module_interface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Raised whenever anything below changes its meaning. */
#define BARRIDO_WEBP_INTERFACE_VERSION 2
#define BARRIDO_WEBP_ENTRY "barrido_webp_functions"

typedef struct BarridoWebpWriter BarridoWebpWriter;

typedef struct BarridoWebpFunctions {
  int32_t version; /* BARRIDO_WEBP_INTERFACE_VERSION */
  /* Reads the size from the header alone. 0 on failure. */
  int (*read_size)(const uint8_t* bytes, size_t size, int32_t* width, int32_t* height,
                   BarridoModuleError* error);
  /* Decodes into `rgba`, which has room for width x height x 4 bytes: straight alpha, top row first. 0 on
     failure; the contents of `rgba` are undefined then. */
  int (*decode)(const uint8_t* bytes, size_t size, int32_t width, int32_t height, uint8_t* rgba,
                BarridoModuleError* error);
  /* An animation in memory that is repeated for ever; every frame is kept without loss. Null on failure. */
  BarridoWebpWriter* (*open)(int32_t width, int32_t height, BarridoModuleError* error);
  /* A frame of straight RGBA, top row first, seen from `begin_ms` on. 0 on failure. */
  int (*add)(BarridoWebpWriter* writer, const uint8_t* rgba, int32_t begin_ms, BarridoModuleError* error);
  /* The whole file, which belongs to the writer; the last frame is seen until `end_ms`. 0 on failure. */
  int (*finish)(BarridoWebpWriter* writer, int32_t end_ms, const uint8_t** bytes, size_t* size,
                BarridoModuleError* error);
  void (*close)(BarridoWebpWriter* writer);
} BarridoWebpFunctions;

/* The module's one symbol. */
const BarridoWebpFunctions* barrido_webp_functions(void);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-deprecated-headers,modernize-use-using) */
