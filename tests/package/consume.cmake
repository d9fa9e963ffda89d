# Configures, builds and runs the host code in HOST in the folder BUILD: with the package below
# PREFIX, or with the sources in HFDEM_SOURCES.
include(${CMAKE_CURRENT_LIST_DIR}/check_output.cmake)

set(own_flags -O2)
set(options -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS=${own_flags})
# What tests, examples and benchmarks need is no business of a user.
foreach(package doctest Eigen3 CLI11 benchmark nlohmann_json Boost)
  list(APPEND options -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

file(REMOVE_RECURSE ${BUILD})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${HOST} -B ${BUILD} -G ${GENERATOR}
                        -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${PREFIX}
                        -DHFDEM_SOURCES=${HFDEM_SOURCES} ${options}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} COMMAND_ERROR_IS_FATAL ANY)

file(READ ${BUILD}/compile_commands.json commands)
string(REPLACE " ${own_flags} " " " commands "${commands}")
if(commands MATCHES " (-[WfmOD][^ ]*)")
  message(FATAL_ERROR "hfdem::hfdem forces ${CMAKE_MATCH_1} on its users:\n${commands}")
endif()

check_output(${BUILD}/wellbore)
