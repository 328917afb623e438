# Writes ar3d_viewer.h: style, body, three.js and scripts of the viewer's page as texts, and the hashes of its two scripts.
# Included by formats/CMakeLists.txt. All files are ASCII.
set(viewer_folder ${CMAKE_CURRENT_LIST_DIR})
ar3d_joined(viewer_style ${viewer_folder} page.css)
ar3d_joined(viewer_body ${viewer_folder} page.html)
ar3d_joined(viewer_three ${viewer_folder} three/three.min.js)
set(viewer_modules state.js data.js exact.js layers.js tubes.js cameras.js pick.js select.js ink.js panel.js frame.js page.js)  # apps/play, too
ar3d_joined(viewer_script ${viewer_folder} ${viewer_modules} main.js)
set(viewer_text "// Made from formats/drawings/viewer/ by formats/drawings/viewer/embed_viewer.cmake.\n#include <string_view>\nnamespace ar3d {\n")
ar3d_pieces(viewer_text kViewerStyle "${viewer_style}")
ar3d_pieces(viewer_text kViewerBody "${viewer_body}")
ar3d_pieces(viewer_text kViewerThree "${viewer_three}")
ar3d_pieces(viewer_text kViewerScript "${viewer_script}")
ar3d_script_hash(viewer_text kViewerThreeHash "\n${viewer_three}")  # a page has a line's end before it
ar3d_script_hash(viewer_text kViewerScriptHash "\n${viewer_script}")
string(APPEND viewer_text "}  // namespace ar3d\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/ar3d_viewer.new "${viewer_text}")
configure_file(${CMAKE_CURRENT_BINARY_DIR}/ar3d_viewer.new ${CMAKE_CURRENT_BINARY_DIR}/ar3d_viewer.h COPYONLY)
target_include_directories(ar3d_formats PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
