# The core, the loader of presets and their tests, for whoever links them where there is no ROS:
# what catkin says elsewhere, and what find_package() reads.
include(CMakePackageConfigHelpers)
include(CTest)

set(CATKIN_ENABLE_TESTING ${BUILD_TESTING})
set(CATKIN_PACKAGE_INCLUDE_DESTINATION include/place_memory)
set(CATKIN_PACKAGE_LIB_DESTINATION lib)
set(CATKIN_PACKAGE_SHARE_DESTINATION share/place_memory)

set(version_file ${PROJECT_BINARY_DIR}/place_memoryConfigVersion.cmake)
write_basic_package_version_file(${version_file} COMPATIBILITY SameMinorVersion)
install(FILES ${version_file} DESTINATION share/place_memory/cmake)
install(FILES cmake/place_memory-extras.cmake
  DESTINATION share/place_memory/cmake
  RENAME place_memoryConfig.cmake
)
