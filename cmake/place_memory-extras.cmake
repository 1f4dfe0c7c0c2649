# Defines place_memory::core and place_memory::config for a package that uses them.
include(${CMAKE_CURRENT_LIST_DIR}/place_memory-targets.cmake)
