/* The C interface between Barrido and the module that holds libmeshoptimizer. Both sides include this header
   and nothing of each other; no C++ type, exception or allocation crosses it. */
#pragma once

/* NOLINTBEGIN(modernize-deprecated-headers,modernize-use-using): this is C */
#include <stddef.h>
#include <stdint.h>

#include "pipeline/files/module_interface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Raised whenever anything below changes its meaning. */
#define BARRIDO_MESHOPT_INTERFACE_VERSION 1
#define BARRIDO_MESHOPT_ENTRY "barrido_meshopt_functions"

typedef enum BarridoMeshoptMode {
  BARRIDO_MESHOPT_ATTRIBUTES = 0,
  BARRIDO_MESHOPT_TRIANGLES = 1,
  BARRIDO_MESHOPT_INDICES = 2
} BarridoMeshoptMode;

typedef enum BarridoMeshoptFilter {
  BARRIDO_MESHOPT_NONE = 0,
  BARRIDO_MESHOPT_OCTAHEDRAL = 1,
  BARRIDO_MESHOPT_QUATERNION = 2,
  BARRIDO_MESHOPT_EXPONENTIAL = 3
} BarridoMeshoptFilter;

/* A compressed buffer view, as EXT_meshopt_compression describes it; nothing of it need be true. */
typedef struct BarridoMeshoptView {
  BarridoMeshoptMode mode;
  BarridoMeshoptFilter filter;
  size_t count;  /* elements */
  size_t stride; /* bytes of an element */
  const unsigned char* bytes;
  size_t size; /* of `bytes` */
} BarridoMeshoptView;

typedef struct BarridoMeshoptFunctions {
  int32_t version; /* BARRIDO_MESHOPT_INTERFACE_VERSION */
  /* Decodes the view into `out`, which has room for count x stride bytes. 0 on failure; the contents of `out`
     are undefined then. */
  int (*decode)(const BarridoMeshoptView* view, void* out, BarridoModuleError* error);
} BarridoMeshoptFunctions;

/* The module's one symbol. */
const BarridoMeshoptFunctions* barrido_meshopt_functions(void);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-deprecated-headers,modernize-use-using) */
