# Builds the kernels for aarch64 together with their test and runs it there; fails where it fails.
# usage: cmake -DCXX=<cross compiler> -DQEMU=<emulator> -DGTEST=<googletest sources>
#              -DSOURCE_DIR=<package> -DBINARY=<file to build> -P check_neon.cmake
execute_process(
  COMMAND ${CXX} -std=c++17 -O2 -static -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
          -I${SOURCE_DIR}/include -I${SOURCE_DIR}/src -isystem ${GTEST}/include -isystem ${GTEST}
          ${SOURCE_DIR}/src/core/kernels/block_kernel.cpp ${SOURCE_DIR}/src/core/kernels/cpu.cpp
          ${SOURCE_DIR}/src/core/kernels/block_kernel_neon.cpp
          ${SOURCE_DIR}/test/core/kernels/block_kernel_test.cc
          ${GTEST}/src/gtest-all.cc ${GTEST}/src/gtest_main.cc -pthread -o ${BINARY}
  RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the kernels do not build for aarch64")
endif()
execute_process(COMMAND ${QEMU} ${BINARY} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the kernels fail their test on aarch64")
endif()
