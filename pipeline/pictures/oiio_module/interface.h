/* The C interface between Barrido and the module that holds OpenImageIO. Both sides include this header and
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
#define BARRIDO_OIIO_INTERFACE_VERSION 2
#define BARRIDO_OIIO_ENTRY "barrido_oiio_functions"

/* What the file's header says. */
typedef struct BarridoOiioHeader {
  int32_t width, height;    /* pixels of the data window */
  int32_t channels;         /* that are read: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA */
  int32_t is_float;         /* the file holds floats (linear light), not integers */
  int32_t associated_alpha; /* colours are multiplied by alpha */
  int32_t orientation; /* 1..8 as TIFF 6.0 counts: 1 as stored, 4 bottom row first, 6 a quarter turn ... */
  int32_t row_step;    /* rows are read in multiples of this: 1, or the height of a tile */
} BarridoOiioHeader;

typedef enum BarridoOiioType { BARRIDO_OIIO_UINT8 = 0, BARRIDO_OIIO_FLOAT = 1 } BarridoOiioType;

typedef struct BarridoOiioReader BarridoOiioReader;

/* A picture to write: interleaved, top row first. */
typedef struct BarridoOiioPicture {
  int32_t width, height, channels; /* channels: 3 RGB or 4 RGBA */
  BarridoOiioType type;            /* of `pixels` */
  int32_t half_floats;             /* store 16-bit floats */
  int32_t associated_alpha;        /* colours are multiplied by alpha */
  const void* pixels;
} BarridoOiioPicture;

typedef struct BarridoOiioFunctions {
  int32_t version; /* BARRIDO_OIIO_INTERFACE_VERSION */
  /* Opens `path` with the reader called `format` (OpenImageIO's name) and no other, and reads its header
     alone. Null on failure. */
  BarridoOiioReader* (*open)(const char* path, const char* format, BarridoOiioHeader* header,
                             BarridoModuleError* error);
  /* Reads rows [begin, end), counted from the top, into `pixels`, which has room for width x rows x channels
     values of `type`. `begin` is a multiple of row_step, and so is `end` unless it is the height. 0 on
     failure. */
  int (*read_rows)(BarridoOiioReader* reader, int32_t begin, int32_t end, BarridoOiioType type, void* pixels,
                   BarridoModuleError* error);
  void (*close)(BarridoOiioReader* reader);
  /* Writes a whole file. 0 on failure; what was written of the file then stays. */
  int (*write)(const char* path, const char* format, const BarridoOiioPicture* picture,
               BarridoModuleError* error);
} BarridoOiioFunctions;

/* The module's one symbol. */
const BarridoOiioFunctions* barrido_oiio_functions(void);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-deprecated-headers,modernize-use-using) */
