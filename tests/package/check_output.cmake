# Runs the host code PROGRAM and has REFERENCE judge the numbers of its last line.
function(check_output program)
  execute_process(COMMAND ${program} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  if(NOT output MATCHES "\nbreakdown at ([0-9.]+) MPa, with the walls ([0-9.]+) um apart\n$")
    message(FATAL_ERROR "Expected a breakdown in the last line of\n${output}")
  endif()
  execute_process(COMMAND ${REFERENCE} ${CMAKE_MATCH_1} ${CMAKE_MATCH_2}
                  OUTPUT_VARIABLE expected RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${CMAKE_MATCH_0}is not the ${expected}")
  endif()
endfunction()
