/* The C interface between Barrido and the module that holds giflib. Both sides include this header and
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
#define BARRIDO_GIF_INTERFACE_VERSION 1
#define BARRIDO_GIF_ENTRY "barrido_gif_functions"

typedef struct BarridoGifWriter BarridoGifWriter;

typedef struct BarridoGifFrame {
  const uint8_t* indices; /* width x height, top row first */
  const uint8_t* palette; /* 256 x R, G, B */
  int32_t transparent;    /* The index that shows what is behind, or -1 */
  int32_t delay_cs;       /* How long the frame is shown, in hundredths of a second */
} BarridoGifFrame;

typedef struct BarridoGifFunctions {
  int32_t version; /* BARRIDO_GIF_INTERFACE_VERSION */
  /* An animation in memory that is repeated for ever. Null on failure. */
  BarridoGifWriter* (*open)(int32_t width, int32_t height, BarridoModuleError* error);
  /* 0 on failure. */
  int (*add)(BarridoGifWriter* writer, const BarridoGifFrame* frame, BarridoModuleError* error);
  /* The whole file, which belongs to the writer. 0 on failure. */
  int (*finish)(BarridoGifWriter* writer, const uint8_t** bytes, size_t* size, BarridoModuleError* error);
  void (*close)(BarridoGifWriter* writer);
} BarridoGifFunctions;

/* The module's one symbol. */
const BarridoGifFunctions* barrido_gif_functions(void);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-deprecated-headers,modernize-use-using) */
