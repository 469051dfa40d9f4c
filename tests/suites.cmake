# Read by ctest when it starts, once for each program of tests: a ctest test for each of its suites. A process a suite, because a
# process a test took more time to start than most tests run, and drew every picture with shaders compiled anew.
# Given: program, room, folder, lock, emulator.
get_filename_component(name ${program} NAME)
if(NOT EXISTS ${program})
  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)
  return()
endif()
execute_process(COMMAND ${emulator} ${program} --gtest_list_tests WORKING_DIRECTORY ${folder}
  TIMEOUT 60 OUTPUT_VARIABLE listed RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${program} --gtest_list_tests ended with ${failed}.")
endif()
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\.[^\n]*" suites "${listed}")
foreach(line IN LISTS suites)
  string(REGEX MATCH "[A-Za-z0-9_/]+\\." suite "${line}")
  if(NOT suite MATCHES "(^|/)DISABLED_")
    string(REGEX REPLACE "\\.$" "" suite ${suite})
    add_test("${room}:${suite}" ${emulator} ${program} --gtest_filter=${suite}.*)
    set_tests_properties("${room}:${suite}" PROPERTIES WORKING_DIRECTORY ${folder} LABELS ${room}
      SKIP_RETURN_CODE 77 TIMEOUT 3000
      # Software GL with a thread a processor waits for itself more than it gains where tests run beside each other. The
      # pictures are the same to the bit.
      ENVIRONMENT LP_NUM_THREADS=1)
    if(lock)  # These wait for each other, so they begin first.
      set_tests_properties("${room}:${suite}" PROPERTIES RESOURCE_LOCK ${lock} COST 1000)
    endif()
  endif()
endforeach()
