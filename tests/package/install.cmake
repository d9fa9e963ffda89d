# Installs the project in BINARY_DIRECTORY to PREFIX, afresh, and compares the headers with SOURCES.
file(REMOVE_RECURSE ${PREFIX})
unset(ENV{DESTDIR})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BINARY_DIRECTORY} --prefix ${PREFIX}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE present RELATIVE ${SOURCES} ${SOURCES}/*)
file(GLOB_RECURSE installed RELATIVE ${PREFIX}/include ${PREFIX}/include/*)
if(NOT present STREQUAL installed)
  message(FATAL_ERROR "Headers present:\n${present}\nHeaders installed:\n${installed}")
endif()
