# What the project's own programs are built with; nothing of it reaches users of hfdem::hfdem.
add_library(hfdem_program INTERFACE)
target_link_libraries(hfdem_program INTERFACE hfdem::hfdem)
target_compile_options(hfdem_program INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow
  # No fused multiply-add behind our back: a * b - c * d must stay mirror-symmetric.
  -ffp-contract=off)

if(HFDEM_OPENMP)
  find_package(OpenMP COMPONENTS CXX)
  if(OpenMP_CXX_FOUND)
    target_link_libraries(hfdem_program INTERFACE OpenMP::OpenMP_CXX)
  else()
    message(STATUS "hfdem: no OpenMP found; the programs run on one thread")
  endif()
endif()
