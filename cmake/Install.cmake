# `cmake --install`: the programs, the libraries with their public headers, and a package for find_package(Barrido):
#   Barrido::barrido   renderer and rasterizer; needs GLM and oneTBB
#   Barrido::scene     glTF and pictures beside it; asked for with find_package(Barrido COMPONENTS scene)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(BARRIDO_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Barrido)
set(BARRIDO_HEADER_DIR ${CMAKE_INSTALL_INCLUDEDIR}/barrido)

# What users link. (`barrido` itself is the program.)
add_library(barrido_library INTERFACE)
target_link_libraries(barrido_library INTERFACE barrido_pipeline)
target_include_directories(barrido_library INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# Inline functions of the headers must round as the library does.
target_compile_options(barrido_library INTERFACE -ffp-contract=off)
target_compile_features(barrido_library INTERFACE cxx_std_20)
add_library(Barrido::barrido ALIAS barrido_library)
add_library(Barrido::scene ALIAS barrido_scene)

set_target_properties(barrido_library PROPERTIES EXPORT_NAME barrido)
set_target_properties(barrido_raster PROPERTIES EXPORT_NAME raster)
set_target_properties(barrido_pipeline PROPERTIES EXPORT_NAME pipeline)
set_target_properties(barrido_scene PROPERTIES EXPORT_NAME scene)

install(TARGETS barrido_library barrido_raster barrido_pipeline EXPORT BarridoTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS barrido_scene EXPORT BarridoSceneTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(program barrido barrido-view)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()

# Public headers; the others are the modules' own.
function(barrido_install_headers folder)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/${folder}/ OUTPUT_VARIABLE headers)
  install(FILES ${headers} DESTINATION ${BARRIDO_HEADER_DIR}/${folder})
endfunction()
barrido_install_headers(raster rasterizer.h)
barrido_install_headers(raster/base memory.h portable_math.h simd_target.h stage_profile.h)
barrido_install_headers(raster/fragments fragment_batch.h fragment_state.h primitive.h)
barrido_install_headers(raster/textures texture.h)
barrido_install_headers(raster/tiles framebuffer.h raster_statistics.h resolve.h)
barrido_install_headers(pipeline geometry.h matrix.h renderer.h state.h)
barrido_install_headers(pipeline/files budget.h error.h)
barrido_install_headers(pipeline/pictures environment.h image.h image_io.h)
barrido_install_headers(pipeline/scene animate.h render_scene.h scene.h)
barrido_install_headers(pipeline/gltf import_gltf.h)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT BarridoTargets NAMESPACE Barrido:: DESTINATION ${BARRIDO_PACKAGE_DIR})
install(EXPORT BarridoSceneTargets NAMESPACE Barrido:: DESTINATION ${BARRIDO_PACKAGE_DIR})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/BarridoConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/BarridoConfig.cmake
                              INSTALL_DESTINATION ${BARRIDO_PACKAGE_DIR}
                              NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/BarridoConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/BarridoConfig.cmake ${PROJECT_BINARY_DIR}/BarridoConfigVersion.cmake
        DESTINATION ${BARRIDO_PACKAGE_DIR})
