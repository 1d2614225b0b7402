# Installs the build in BUILD to WORK/prefix, then builds and runs the project OUTSIDE against that.
file(REMOVE_RECURSE "${WORK}")
foreach(step "--install;${BUILD};--prefix;${WORK}/prefix"
        "-S;${OUTSIDE};-B;${WORK}/build;-DCMAKE_PREFIX_PATH=${WORK}/prefix;-DCMAKE_BUILD_TYPE=Release;-DCMAKE_CXX_FLAGS=${FLAGS}"
        "--build;${WORK}/build")
  execute_process(COMMAND "${CMAKE_COMMAND}" ${step} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "cmake ${step}\n${output}")
  endif()
endforeach()
# Installed are the headers of include/, and no others.
file(GLOB_RECURSE installed RELATIVE "${WORK}/prefix/include" "${WORK}/prefix/include/*")
file(GLOB_RECURSE meant RELATIVE "${OUTSIDE}/../../../include" "${OUTSIDE}/../../../include/*")
if(NOT installed STREQUAL meant)
  message(FATAL_ERROR "installed: ${installed}\nof include/: ${meant}")
endif()
execute_process(COMMAND "${WORK}/build/outside" RESULT_VARIABLE result)
execute_process(COMMAND "${WORK}/prefix/bin/sigmasweep" --version RESULT_VARIABLE version_result)
if(NOT result EQUAL 0 OR NOT version_result EQUAL 0)
  message(FATAL_ERROR "the outside program: ${result}, the installed program: ${version_result}")
endif()
