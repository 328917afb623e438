# Does what "As a library" in README says, word for word: writes its two files, runs its commands (with HOME elsewhere).
cmake_minimum_required(VERSION 3.25)
set(home ${BUILD}/consumer-test)
file(REMOVE_RECURSE ${home})
file(READ ${README} page)
string(FIND "${page}" "### As a library" section)
string(SUBSTRING "${page}" ${section} -1 page)

# The first code block of that language.
function(code_block language result)
  string(FIND "${page}" "```${language}\n" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "README.md shows no ${language} under 'As a library'")
  endif()
  string(LENGTH "```${language}\n" skipped)
  math(EXPR begin "${begin} + ${skipped}")
  string(SUBSTRING "${page}" ${begin} -1 rest)
  string(FIND "${rest}" "```" end)
  string(SUBSTRING "${rest}" 0 ${end} text)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

code_block(cpp source)
code_block(cmake project)
code_block(sh commands)
file(WRITE ${home}/k5/k5.cpp "${source}")
file(WRITE ${home}/k5/CMakeLists.txt "${project}")
string(REGEX REPLACE "\\./ar3d [^\n]*" "" commands "${commands}")  # built already, in this folder:
string(REPLACE "build/release" "${BUILD}" commands "${commands}")
file(WRITE ${home}/commands "${commands}")
execute_process(COMMAND ${CMAKE_COMMAND} -E env HOME=${home} CXX=${CXX} "CXXFLAGS=${FLAGS}" CC=/no/C/compiler sh -e commands
                WORKING_DIRECTORY ${home} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${home}/ar3d/bin/ar3d --version COMMAND_ERROR_IS_FATAL ANY)
