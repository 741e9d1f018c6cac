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
#define BARRIDO_WEBP_INTERFACE_VERSION 1
#define BARRIDO_WEBP_ENTRY "barrido_webp_functions"

typedef struct BarridoWebpFunctions {
  int32_t version; /* BARRIDO_WEBP_INTERFACE_VERSION */
  /* Reads the size from the header alone. 0 on failure. */
  int (*read_size)(const uint8_t* bytes, size_t size, int32_t* width, int32_t* height,
                   BarridoModuleError* error);
  /* Decodes into `rgba`, which has room for width x height x 4 bytes: straight alpha, top row first. 0 on
     failure; the contents of `rgba` are undefined then. */
  int (*decode)(const uint8_t* bytes, size_t size, int32_t width, int32_t height, uint8_t* rgba,
                BarridoModuleError* error);
} BarridoWebpFunctions;

/* The module's one symbol. */
const BarridoWebpFunctions* barrido_webp_functions(void);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-deprecated-headers,modernize-use-using) */
