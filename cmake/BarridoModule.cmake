# barrido_module(NAME SOURCES...): a static library with the project's warnings and include root.
function(barrido_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
  if(BARRIDO_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

function(barrido_module target)
  add_library(${target} STATIC ${ARGN})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                              $<INSTALL_INTERFACE:include/barrido>)
  # Highway: every kernel is compiled for each of these and chosen at run time.
  target_compile_definitions(${target} PRIVATE HWY_COMPILE_ALL_ATTAINABLE
                                               "HWY_DISABLED_TARGETS=(HWY_SSSE3)")
  barrido_warnings(${target})
endfunction()
