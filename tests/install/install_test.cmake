# Run by ctest; see CMakeLists.txt for the variables.
set(PREFIX ${WORK_DIR}/prefix)
file(REMOVE_RECURSE ${WORK_DIR})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
endfunction()

function(build_project source)
  get_filename_component(name ${source} NAME)
  run(${CMAKE_COMMAND} -S ${source} -B ${WORK_DIR}/${name} -G ${GENERATOR}
      -D CMAKE_PREFIX_PATH=${PREFIX} -D CMAKE_CXX_COMPILER=${CXX_COMPILER}
      "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" -D CMAKE_BUILD_TYPE=${BUILD_TYPE})
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/${name})
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX})
run(${PREFIX}/bin/barrido --version)

build_project(${SOURCE_DIR}/examples/triangle)
execute_process(COMMAND ${WORK_DIR}/triangle/triangle OUTPUT_FILE ${WORK_DIR}/triangle.ppm
                COMMAND_ERROR_IS_FATAL ANY)
run(${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/check_triangle.py ${WORK_DIR}/triangle.ppm)

build_project(${CMAKE_CURRENT_LIST_DIR}/consumer)
run(${WORK_DIR}/consumer/consumer ${SOURCE_DIR}/models/teapot.glb)

build_project(${SOURCE_DIR}/examples/model)
execute_process(COMMAND ${WORK_DIR}/model/model ${SOURCE_DIR}/models/teapot.glb OUTPUT_VARIABLE modes
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n?([a-z-]+) +[1-9][0-9]+ pixels, mean colour [1-9][^\n]* nearest depth 0\\.[0-9]+" lines "${modes}")
list(LENGTH lines count)
if(NOT count EQUAL 4)
  message(FATAL_ERROR "examples/model wrote:\n${modes}")
endif()
