/* What the C interfaces of all modules have in common. Both sides of an interface include it and nothing of
   each other; no C++ type, exception or allocation crosses. */
#pragma once

/* NOLINTBEGIN(modernize-use-using): this is C */

/* Where a failing function leaves its reason: one line, cut to fit, ending in zero. */
typedef struct BarridoModuleError {
  char text[512];
} BarridoModuleError;

/* NOLINTEND(modernize-use-using) */
