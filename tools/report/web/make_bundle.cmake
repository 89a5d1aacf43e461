# cmake -D SOURCE=web -D WORK=folder -D OUTPUT=file.cpp -D NODE=... -D NPM=... -D MODE=AUTO|ON
#       -P make_bundle.cmake
# Installs what package-lock.json names and bundles src/. With MODE=AUTO a failure gives a bundle
# that says why it is empty; removing WORK and OUTPUT tries again.
function(give_up reason details)
  if(MODE STREQUAL "ON")
    message(FATAL_ERROR "EDVO_INTERACTIVE_REPORT=ON: ${reason}\n${details}")
  endif()
  message(STATUS "The HTML report has no interactive part: ${reason}\n${details}")
  configure_file(${SOURCE}/missing_bundle.cpp.in ${OUTPUT} @ONLY)
endfunction()

file(COPY ${SOURCE}/ DESTINATION ${WORK})
file(SHA256 ${SOURCE}/package-lock.json wanted)
set(installed "")
if(EXISTS ${WORK}/installed)
  file(READ ${WORK}/installed installed)
endif()
if(NOT installed STREQUAL wanted)
  execute_process(
    COMMAND ${NPM} ci --omit=dev --ignore-scripts --fetch-retries=1 --fetch-timeout=30000
    WORKING_DIRECTORY ${WORK} TIMEOUT 180 RESULT_VARIABLE failed
    OUTPUT_VARIABLE details ERROR_VARIABLE details)
  if(failed)
    give_up("the packages of package-lock.json could not be installed when the program was built"
            "${details}")
    return()
  endif()
  file(WRITE ${WORK}/installed ${wanted})
endif()

execute_process(COMMAND ${NODE} bundle.mjs ${OUTPUT} WORKING_DIRECTORY ${WORK}
                RESULT_VARIABLE failed OUTPUT_VARIABLE details ERROR_VARIABLE details)
if(failed)
  message(FATAL_ERROR "The HTML report's sources cannot be bundled\n${details}")
endif()
