# `cmake --install`: the programs, the libraries with their public headers, and a package for find_package(Barrido):
#   Barrido::barrido   renderer and rasterizer; needs GLM and oneTBB
#   Barrido::scene     the same with glTF and pictures; asked for with find_package(Barrido COMPONENTS scene)
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
add_library(barrido_scene_library INTERFACE)
target_link_libraries(barrido_scene_library INTERFACE barrido_library barrido_scene)
add_library(Barrido::scene ALIAS barrido_scene_library)

set_target_properties(barrido_library PROPERTIES EXPORT_NAME barrido)
set_target_properties(barrido_scene_library PROPERTIES EXPORT_NAME scene)
set_target_properties(barrido_raster PROPERTIES EXPORT_NAME raster)
set_target_properties(barrido_pipeline PROPERTIES EXPORT_NAME pipeline)
set_target_properties(barrido_scene PROPERTIES EXPORT_NAME scene_archive)

install(TARGETS barrido_library barrido_raster barrido_pipeline EXPORT BarridoTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS barrido_scene_library barrido_scene EXPORT BarridoSceneTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(program barrido barrido-view)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()

# Public headers; what they include is installed with them, the others are the modules' own.
set(BARRIDO_PUBLIC_HEADERS
    pipeline/assembled_frame.h pipeline/geometry.h pipeline/matrix.h pipeline/renderer.h pipeline/state.h
    pipeline/gltf/import_gltf.h
    pipeline/pictures/environment.h pipeline/pictures/image_io.h
    pipeline/scene/animate.h pipeline/scene/frame_observer.h pipeline/scene/render_scene.h pipeline/scene/scene.h
    raster/base/portable_math.h raster/base/simd_target.h raster/fragments/fragment_batch.h raster/rasterizer.h)
install(CODE "set(SOURCE_DIR \"${PROJECT_SOURCE_DIR}\")
set(HEADER_DIR \"${BARRIDO_HEADER_DIR}\")
set(PUBLIC_HEADERS \"${BARRIDO_PUBLIC_HEADERS}\")")
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/InstallHeaders.cmake)

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
