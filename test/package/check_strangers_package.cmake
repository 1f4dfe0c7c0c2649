# Installs the package into an empty folder, and there builds and runs a package of a stranger who
# has neither its sources nor its build; fails where that fails, or where the installed libraries
# show what is internal.
# usage: cmake -DBUILD=<build directory> -DFOLDER=<to work in> -DCXX=<compiler>
#              -DSANITIZE=<of the build> -DSOURCE_DIR=<package> -P check_strangers_package.cmake
file(REMOVE_RECURSE ${FOLDER})
set(prefix ${FOLDER}/prefix)

# run(<sentence> <command>...): says the sentence where the command fails.
function(run sentence)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${sentence}")
  endif()
endfunction()

run("the package cannot be installed"
  ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

set(options -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX}
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
if(SANITIZE)
  list(APPEND options -DCMAKE_CXX_FLAGS=-fsanitize=${SANITIZE})
endif()
run("the stranger's package cannot be configured"
  ${CMAKE_COMMAND} -S ${SOURCE_DIR}/test/package/strangers_package -B ${FOLDER}/build ${options})
run("the stranger's package does not build"
  ${CMAKE_COMMAND} --build ${FOLDER}/build)
run("the stranger's program fails"
  ${FOLDER}/build/stranger)

file(GLOB libraries ${prefix}/lib/libplace_memory_*.so)
list(FILTER libraries EXCLUDE REGEX "/libplace_memory_panel\\.so$")  # a plugin of rviz, which nobody links
list(LENGTH libraries count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "two libraries to be linked should be installed, not: ${libraries}")
endif()
find_program(NM nm)
foreach(library ${libraries})
  execute_process(COMMAND ${NM} -DC --defined-only ${library}
    OUTPUT_VARIABLE symbols RESULT_VARIABLE status)
  if(NOT status EQUAL 0 OR symbols MATCHES " T [^\n(]*(PlaceIndex|Recognizer|PlaceStore|YAML|ParameterReader)::")
    message(FATAL_ERROR "${library} shows what is internal")
  endif()
  file(READ_SYMLINK ${library} versioned)
  if(NOT versioned MATCHES "\\.so\\.[0-9]+\\.[0-9]+$")
    message(FATAL_ERROR "${library} has no version that other packages link to")
  endif()
endforeach()
