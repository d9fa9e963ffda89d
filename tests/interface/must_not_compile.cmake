# The compiler must refuse Simulator<...>, or Jointed<...> or a scheme with its fluid in it, in PROGRAM with each of the FAULTS, "MACRO=Model:atom:member",
# and say which atom of a concept the model lacks and which member that atom asks for. Usage:
#   cmake -DPROGRAM=... -DCOMPILE=... -DFAULTS=... -P must_not_compile.cmake
set(ENV{LC_ALL} C)
# The words of g++ and of clang++. An atom's name alone would prove nothing: the message may quote a
# line of concepts.hpp that lists all atoms, or blame a function deep inside the simulator.
set(refusal "(template constraint failure|constraints not satisfied) for [^\n]*(Simulator|Jointed|Flow)")
set(reason "(required for the satisfaction of|does not satisfy)")
foreach(fault IN LISTS FAULTS)
  string(REGEX MATCH "^(.*):(.*):(.*)$" matched ${fault})
  set(model ${CMAKE_MATCH_1})
  set(atom ${CMAKE_MATCH_2})
  set(member ${CMAKE_MATCH_3})
  execute_process(COMMAND ${COMPILE} -D${model} ${PROGRAM}
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE message)
  if(result EQUAL 0)
    message(SEND_ERROR "${model} compiles, without ${atom}")
  elseif(NOT (message MATCHES "${refusal}" AND message MATCHES "${reason} '${atom}[<']"))
    message(SEND_ERROR "${model} is refused, but not for its lack of ${atom}:\n${message}")
  elseif(NOT message MATCHES "(\\.|::)${member}[^_A-Za-z]")
    # As in 'law.springs(stiffness)': the atom's own name may contain the member's.
    message(SEND_ERROR "${model} is refused without a word about its ${member}:\n${message}")
  endif()
endforeach()
