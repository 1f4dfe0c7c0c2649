# What every target of this package has in common.

# Sanitizers have to be on in everything that is linked together, so they are set for the directory.
if(PLACE_MEMORY_SANITIZE)
  string(REPLACE ";" "," place_memory_sanitizers "${PLACE_MEMORY_SANITIZE}")
  add_compile_options(-fsanitize=${place_memory_sanitizers} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${place_memory_sanitizers})
  # With them GCC takes members of std::function in std::regex for uninitialized.
  set(place_memory_unreliable_warnings -Wno-maybe-uninitialized)
endif()

# place_memory_warnings(<target>...): the warnings this package's own code must be free of.
function(place_memory_warnings)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                             ${place_memory_unreliable_warnings}
                                             $<$<BOOL:${PLACE_MEMORY_WERROR}>:-Werror>)
  endforeach()
endfunction()

# Defines place_memory_ros: link it to use ROS and this package's generated messages. Both are
# SYSTEM includes, so that their headers do not answer for our warnings.
macro(place_memory_add_ros_target)
  add_library(place_memory_ros INTERFACE)
  target_include_directories(place_memory_ros SYSTEM INTERFACE
    ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_INCLUDE_DESTINATION} ${catkin_INCLUDE_DIRS})
  target_link_libraries(place_memory_ros INTERFACE ${catkin_LIBRARIES})
  add_dependencies(place_memory_ros ${PROJECT_NAME}_generate_messages_cpp)
endmacro()

# place_memory_install(<target>...): libraries into lib, executables into lib/place_memory.
function(place_memory_install)
  install(TARGETS ${ARGN}
    ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}
  )
endfunction()
