# Runs PROGRAM and looks at what it prints.
function(check_output program)
  execute_process(COMMAND ${program} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  if(NOT output MATCHES "^hfdem ${VERSION}: ([0-9.]+) MPa\n$")
    message(FATAL_ERROR "Expected \"hfdem ${VERSION}: <number> MPa\", got \"${output}\"")
  endif()
  # Fifty mechanical steps of at most 0.2 MPa each.
  if(NOT (CMAKE_MATCH_1 GREATER 0 AND CMAKE_MATCH_1 LESS_EQUAL 10))
    message(FATAL_ERROR "A pressure of ${CMAKE_MATCH_1} MPa is out of reach")
  endif()
endfunction()
