# What every target of this package has in common.

# Sanitizers, and what fuzzers and coverage count by, have to be on in everything that is linked
# together, so they are set for the directory.
set(place_memory_sanitizers ${PLACE_MEMORY_SANITIZE})
if(PLACE_MEMORY_FUZZ)
  list(APPEND place_memory_sanitizers fuzzer-no-link)
endif()
if(place_memory_sanitizers)
  string(REPLACE ";" "," place_memory_sanitizers "${place_memory_sanitizers}")
  # What is found ends the program, so that no test passes over it.
  add_compile_options(-fsanitize=${place_memory_sanitizers} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${place_memory_sanitizers})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # With them GCC takes members of std::function in std::regex for uninitialized.
    set(place_memory_unreliable_warnings -Wno-maybe-uninitialized)
  endif()
endif()
if(PLACE_MEMORY_COVERAGE)
  add_compile_options(-fprofile-instr-generate -fcoverage-mapping)
  add_link_options(-fprofile-instr-generate)
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
  add_dependencies(place_memory_ros ${PROJECT_NAME}_generate_messages_cpp ${PROJECT_NAME}_gencfg)
endmacro()

# place_memory_install(<target>...): executables, into lib/place_memory.
function(place_memory_install)
  install(TARGETS ${ARGN} RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
endfunction()

# place_memory_internal(<target>...): static libraries with all that other parts of this package and
# its tests link. What they are made of goes into shared libraries too, in which only what is marked
# PLACE_MEMORY_PUBLIC can be seen.
function(place_memory_internal)
  set_target_properties(${ARGN} PROPERTIES
    POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON
  )
endfunction()

# place_memory_add_shared(<part> <PUBLIC|PRIVATE target>...): the library for other packages, of the
# objects of the part's static library `place_memory_<part>`. It links the targets. Other packages
# call it place_memory::<part>.
function(place_memory_add_shared part)
  set(target place_memory_${part}_shared)
  add_library(${target} SHARED $<TARGET_OBJECTS:place_memory_${part}>)
  target_include_directories(${target} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:include>
  )
  target_compile_features(${target} INTERFACE cxx_std_17)
  target_link_libraries(${target} ${ARGN})
  target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL)
  # A minor version may change what is linked: its classes have members by value.
  set_target_properties(${target} PROPERTIES
    LINKER_LANGUAGE CXX
    OUTPUT_NAME place_memory_${part}
    EXPORT_NAME ${part}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  )
  add_library(place_memory::${part} ALIAS ${target})
  install(TARGETS ${target} EXPORT place_memory-targets
    LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
  )
endfunction()
