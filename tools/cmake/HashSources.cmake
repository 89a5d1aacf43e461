# Writes a header with the hash of source files: cmake -DSOURCES=LIST_FILE -DTEMPLATE=.. -DOUTPUT=.. -P
file(STRINGS ${SOURCES} sources)
foreach(source IN LISTS sources)
  file(SHA256 ${source} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 GENERATOR_HASH "${hashes}")
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
