# Defines place_memory::core and place_memory::config for a package that uses them. In a workspace
# that builds both at once they are there already.
if(NOT TARGET place_memory::core)
  include(${place_memory_DIR}/place_memory-targets.cmake)
endif()
list(APPEND place_memory_LIBRARIES place_memory::config place_memory::core)
