# Compiles PROGRAM with nothing but the compiler and the headers below PREFIX, and runs it.
include(${CMAKE_CURRENT_LIST_DIR}/check_output.cmake)

file(REMOVE_RECURSE ${BUILD})
file(MAKE_DIRECTORY ${BUILD})
execute_process(COMMAND ${COMPILER} -std=c++20 -O1 -Wall -Wextra -Wpedantic -Werror
                        -I${PREFIX}/include -MD -MF ${BUILD}/headers -o ${BUILD}/host ${PROGRAM}
                COMMAND_ERROR_IS_FATAL ANY)

file(READ ${BUILD}/headers headers)
if(headers MATCHES "[^ ]*/(doctest|eigen3|Eigen|CLI|benchmark|nlohmann|boost)/[^ ]*")
  message(FATAL_ERROR "A simple program needs ${CMAKE_MATCH_0}")
endif()

check_output(${BUILD}/host)
