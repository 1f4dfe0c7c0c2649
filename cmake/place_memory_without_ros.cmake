# The core, the loader of presets and their tests, for whoever links them where there is no ROS.
include(CMakePackageConfigHelpers)
include(CTest)

add_subdirectory(src/support)
add_subdirectory(src/core)
add_subdirectory(src/config)
if(BUILD_TESTING)
  add_subdirectory(test)
endif()

set(folder lib/cmake/place_memory)
place_memory_install_exports(${folder})
install(FILES cmake/place_memory-extras.cmake
  DESTINATION ${folder}
  RENAME place_memoryConfig.cmake
)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/place_memoryConfigVersion.cmake
  COMPATIBILITY SameMinorVersion
)
install(FILES ${PROJECT_BINARY_DIR}/place_memoryConfigVersion.cmake DESTINATION ${folder})
