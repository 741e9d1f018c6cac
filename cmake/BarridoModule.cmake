# Instruction sets that kernels are not compiled for, as Highway names them. The sanitizer presets leave out more: an
# instrumented kernel takes minutes to compile for each.
set(BARRIDO_DISABLED_SIMD "(HWY_SSSE3)" CACHE STRING "Highway targets to leave out")

# barrido_module(NAME SOURCES...): a static library with the project's warnings and include root.
function(barrido_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
  if(BARRIDO_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

function(barrido_module target)
  add_library(${target} STATIC ${ARGN})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  # Highway: every kernel is compiled for each attainable target and chosen at run time. Before 12.3 g++'s automatic
  # vectorizer miscompiles Highway's portable target (GCC bug 106322), for which Highway then falls back to one lane
  # without 16-bit arithmetic. The kernels are vectors already, so the vectorizer is switched off instead.
  foreach(source ${ARGN})
    if(source MATCHES "/kernels/|/(highway_targets|simd_target)\\.cpp$")
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS HWY_COMPILE_ALL_ATTAINABLE HWY_BROKEN_EMU128=0
                                                    "HWY_DISABLED_TARGETS=${BARRIDO_DISABLED_SIMD}")
    endif()
  endforeach()
  target_compile_options(${target} PRIVATE -fno-tree-vectorize)
  barrido_warnings(${target})
endfunction()

# barrido_loaded_module(NAME SOURCES...): a shared object that is loaded on demand (pipeline/files/module_loader.h).
function(barrido_loaded_module target)
  add_library(${target} MODULE ${ARGN})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  set_target_properties(${target} PROPERTIES
    PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${BARRIDO_MODULE_BUILD_DIR})
  barrido_warnings(${target})
  install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/barrido)
endfunction()

# barrido_module_library(OPTION FOUND WHAT DEBIAN LOST RESULT): whether to build the module whose cache option is
# OPTION (AUTO, ON or OFF) and whose library was FOUND; tells what is LOST without it.
function(barrido_module_library option found what debian lost result)
  set(${result} FALSE PARENT_SCOPE)
  if(${option} STREQUAL "OFF")
    return()
  endif()
  if(${found})
    set(${result} TRUE PARENT_SCOPE)
  elseif(${option} STREQUAL "AUTO")
    message(STATUS "${what} not found: ${lost}")
  else()
    message(FATAL_ERROR "${option} is ON, but ${what} was not found (Debian: ${debian})")
  endif()
endfunction()
