# Run at every build: writes HEADER with the revision of SOURCE_DIR, only if it changed. A tarball has no revision, even
# when it is unpacked inside another repository.
cmake_minimum_required(VERSION 3.22)
set(revision "unknown")
if(GIT_EXECUTABLE AND EXISTS "${SOURCE_DIR}/.git")
  execute_process(COMMAND "${GIT_EXECUTABLE}" describe --always --dirty --abbrev=40 --exclude=*
    WORKING_DIRECTORY "${SOURCE_DIR}" OUTPUT_VARIABLE described ERROR_QUIET RESULT_VARIABLE result
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(result EQUAL 0)
    set(revision "${described}")
  endif()
endif()
file(CONFIGURE OUTPUT "${HEADER}" CONTENT "#define SIGMASWEEP_GIT_REVISION \"@revision@\"\n" @ONLY)
