# Takes out what `cmake --install` put in, and the folders of this package that are empty then.
#
#   cmake -D MANIFEST=build/install_manifest.txt -P .cmake/uninstall.cmake
if(NOT EXISTS ${MANIFEST})
  message(FATAL_ERROR "Nothing was installed from this build: ${MANIFEST} is missing; "
    "remove the prefix by hand, or install again first")
endif()
file(STRINGS ${MANIFEST} files)
set(folders "")
foreach(file IN LISTS files)
  file(REMOVE "$ENV{DESTDIR}${file}")
  get_filename_component(folder "$ENV{DESTDIR}${file}" DIRECTORY)
  while(folder MATCHES "/liggghts-ellipsoid(/|$)") # all others may be someone else's
    list(APPEND folders ${folder})
    get_filename_component(folder ${folder} DIRECTORY)
  endwhile()
endforeach()
list(REMOVE_DUPLICATES folders)
list(SORT folders ORDER DESCENDING) # what lies in a folder before the folder
foreach(folder IN LISTS folders)
  file(GLOB left ${folder}/*)
  if(NOT left)
    file(REMOVE_RECURSE ${folder})
  endif()
endforeach()
file(REMOVE ${MANIFEST})
list(LENGTH files count)
message(STATUS "${count} files taken out")
