/* The C interface between Barrido and the module that holds Draco. Both sides include this header and nothing
   of each other; no C++ type, exception or allocation crosses it. */
#pragma once

/* NOLINTBEGIN(modernize-deprecated-headers,modernize-use-using): this is C */
#include <stddef.h>
#include <stdint.h>

#include "pipeline/files/module_interface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Raised whenever anything below changes its meaning. */
#define BARRIDO_DRACO_INTERFACE_VERSION 1
#define BARRIDO_DRACO_ENTRY "barrido_draco_functions"

typedef struct BarridoDracoMesh BarridoDracoMesh;

typedef struct BarridoDracoCounts {
  uint32_t points, faces;
} BarridoDracoCounts;

/* An attribute as it is wanted. */
typedef struct BarridoDracoAttribute {
  uint32_t id;            /* unique within the mesh */
  int32_t component_type; /* glTF's number: 5120 to 5126 */
  int32_t components;     /* 1 to 4 */
} BarridoDracoAttribute;

typedef struct BarridoDracoFunctions {
  int32_t version; /* BARRIDO_DRACO_INTERFACE_VERSION */
  /* Decodes a triangle mesh. The library takes at most `max_memory` bytes for it; counts that ask for more
     are a failure. Null on failure. */
  BarridoDracoMesh* (*decode)(const void* bytes, size_t size, size_t max_memory, BarridoDracoCounts* counts,
                              BarridoModuleError* error);
  /* Three for each face, each below the number of points. 0 on failure. */
  int (*read_indices)(const BarridoDracoMesh* mesh, uint32_t* indices, BarridoModuleError* error);
  /* One element for each point, tightly packed. 0 on failure. */
  int (*read_attribute)(const BarridoDracoMesh* mesh, const BarridoDracoAttribute* attribute, void* elements,
                        BarridoModuleError* error);
  void (*close)(BarridoDracoMesh* mesh);
} BarridoDracoFunctions;

/* The module's one symbol. */
const BarridoDracoFunctions* barrido_draco_functions(void);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-deprecated-headers,modernize-use-using) */
