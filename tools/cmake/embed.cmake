# ar3d_text_literal(<file> <variable>): sets the variable to the text of the file as a C++ string literal, byte for
# byte, for a header that file(CONFIGURE) writes. A changed file configures again.
function(ar3d_text_literal file variable)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} text)
  string(FIND "${text}" ")embedded\"" ending)
  if(NOT ending EQUAL -1)
    message(FATAL_ERROR "${file}: it holds what ends an embedded text")
  endif()
  set(${variable} "R\"embedded(${text})embedded\"" PARENT_SCOPE)
endfunction()
